// A file that is there whole or not at all, whatever it is written with.
#pragma once

#include <filesystem>

namespace searig::acquisition::exchange {

/// Write to temporary(), a name beside the file's, then keep(). Without that the temporary file
/// goes away with this, and nothing has changed.
class NewFile {
 public:
  /// Throws std::runtime_error with one sentence, as keep() does, where the file is there already
  /// and `overwrite` is not said.
  NewFile(std::filesystem::path file, bool overwrite);
  ~NewFile();
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  const std::filesystem::path& temporary() const { return temporary_; }

  /// Waits until it is on the disk, then gives it its name.
  void keep();

 private:
  std::filesystem::path file_, temporary_;
  bool overwrite_;
};

}  // namespace searig::acquisition::exchange
