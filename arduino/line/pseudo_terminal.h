// A pseudo terminal that plays a USB-serial adapter: plugged in under a name, pulled out, in again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace searig::line {

class PseudoTerminal {
 public:
  /// `link`: a symbolic link to the terminal while it is plugged in, or empty.
  explicit PseudoTerminal(std::filesystem::path link);
  ~PseudoTerminal();
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;

  /// Throws acquisition::InputError.
  void plug();
  void unplug();

  bool plugged() const { return master_ >= 0; }
  int handle() const { return master_; }  ///< to be polled for input, or -1
  const std::string& path() const { return path_; }

  /// What the host has sent.
  std::vector<std::uint8_t> read();

  /// To the host. As on a real line what nobody listens to is gone; what finds the terminal's queue
  /// full is lost and counted.
  void write(std::span<const std::uint8_t> bytes);
  std::uint64_t lost() const { return lost_; }

 private:
  bool listened_to() const;

  std::filesystem::path link_;
  std::string path_;
  int master_ = -1;
  std::uint64_t lost_ = 0;
};

}  // namespace searig::line
