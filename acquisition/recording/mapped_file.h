// A whole file as bytes without a copy of it in memory.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>

namespace searig::acquisition {

class MappedFile {
 public:
  /// Throws InputError where the file is not there, is no regular file or may not be read.
  explicit MappedFile(const std::filesystem::path& path);
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  /// As long as the file was when it was opened; a recorder may append meanwhile.
  std::string_view bytes() const { return {static_cast<const char*>(start_), size_}; }

  /// Gives the memory of the first `bytes` back; whoever reads them again has them read anew.
  void forget(std::size_t bytes) const;

 private:
  void* start_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace searig::acquisition
