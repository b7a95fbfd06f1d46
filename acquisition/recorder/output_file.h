// A file that only grows, piece by piece, each piece whole or not at all.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace searig::acquisition {

class OutputFile {
 public:
  /// Makes the file. What is there already is never overwritten. Throws std::runtime_error with one
  /// sentence, as all here does.
  explicit OutputFile(std::filesystem::path path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Hands the bytes to the system, so that they outlive this process. Where that fails (the disk
  /// is full) the file is cut back to where it ended before.
  void append(std::string_view bytes);

  /// Waits until all is on the disk, so that it outlives the machine's power.
  void sync();

  std::uint64_t size() const { return size_; }

  /// How much more the disk takes.
  std::uint64_t free_bytes() const;

 private:
  [[noreturn]] void refuse(int error) const;

  std::filesystem::path path_;
  int file_ = -1;
  std::uint64_t size_ = 0;
};

/// What the disk takes on which a file would be made.
std::uint64_t free_bytes_beside(const std::filesystem::path& file);

}  // namespace searig::acquisition
