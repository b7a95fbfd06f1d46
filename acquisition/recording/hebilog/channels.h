// What the fields of a HEBI module's feedback are, and what they are called here.
//
// The names of the quantities are HEBI's (hebi.h, HebiFeedbackFloatField and its kin); which number
// bears which was found in the log, where the quantities give themselves away: 11.9.3 is -40.000
// times 11.9.4 in every row (effort, deflection), 11.9.5 is 272 times 11.9.2 (motor and output
// velocity), 10.9.2 is the derivative of 10.9.1 (commands), and 11.9.10 is heated by the square of
// 11.9.11 while 11.9.9 is heated by 11.9.10 (winding and housing; current). Inferred by their order
// alone: 11.1 (the LED), 11.11 (orientation), 11.9.13. What is not known keeps its numbers:
// "field_14_3".
#pragma once

#include <optional>
#include <string>

#include "acquisition/recording/hebilog/message.h"

namespace searig::acquisition::hebilog {

inline constexpr Path module_id = "1"_path;
inline constexpr Path hardware_received_us = "3"_path;  ///< the request, on the module's clock
inline constexpr Path hardware_sent_us = "5"_path;      ///< the feedback
inline constexpr Path host_sent_us = "8.1"_path;        ///< the request, on the host's clock
inline constexpr Path sequence = "8.2"_path;
inline constexpr Path deflection = "11.9.4"_path;  ///< HEBI's: output less input

inline constexpr Path name = "20.1.1"_path;
inline constexpr Path family = "20.1.2"_path;
inline constexpr Path serial_number = "1012.1"_path;
inline constexpr Path mechanical_type = "1012.6"_path;

/// Whether a field of bytes is a message that is read further.
bool is_message(Path path);

/// What a field's channel is called; none where it is no channel (the times, the sequence).
std::optional<std::string> channel_of(Path path);

/// Whether the field is what the module was told to do.
bool is_command(Path path);

}  // namespace searig::acquisition::hebilog
