// The log of a HEBI module, as HEBI's own software writes it, as a recording.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "acquisition/recording/recording.h"

namespace searig::acquisition::hebilog {

/// By the file's first bytes.
bool is_hebilog(const std::filesystem::path& file);

/// A recording of the module alone. t_s: hardware transmit time; host_s: log time; pings: the four
/// times of every feedback. Channels as channels.h names them, SI units, with two things done so
/// that they mean what they mean elsewhere here:
/// - deflection_rad is input less output, which is minus HEBI's, so that effort = k * deflection;
/// - input_angle_rad is output_angle_rad + deflection_rad, the angle before the spring.
/// Channels that not every feedback has (HEBI's NaN is none) are further devices on the module's
/// clock: device.command, device.partial. Feedback with information has a sequence of its own and
/// is left out but for what the module says it is; gear_ratio is not in the log and stays 1.
///
/// What is whole of a damaged or cut file is read, and an event tells what is not. `module`, from
/// 1: which of several, in order of their addresses. Throws InputError.
Recording read_hebilog(const std::filesystem::path& file,
                       std::optional<std::size_t> module = std::nullopt);

/// The same of bytes in memory; what is refused is half a sentence to put behind a name.
Recording recording_of(std::string_view bytes, std::optional<std::size_t> module);

}  // namespace searig::acquisition::hebilog
