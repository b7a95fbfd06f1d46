#include "acquisition/exchange/new_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string>
#include <utility>

namespace searig::acquisition::exchange {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& why) {
  throw std::runtime_error(file.string() + ": " + why + ".");
}

constexpr const char* there_already = "is there already; --overwrite replaces it";

}  // namespace

NewFile::NewFile(std::filesystem::path file, bool overwrite)
    : file_(std::move(file)), overwrite_(overwrite) {
  std::error_code not_there;
  if (!overwrite && std::filesystem::exists(file_, not_there)) refuse(file_, there_already);
  temporary_ = file_;
  temporary_.replace_filename(std::string(1, '.') + file_.filename().string() + '.' +
                              std::to_string(getpid()) + ".part");
  const int made = open(temporary_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (made < 0) refuse(file_, std::string("cannot be made: ") + std::strerror(errno));
  close(made);  // said before the work; the writer makes it anew
}

NewFile::~NewFile() {
  std::error_code ignored;
  std::filesystem::remove(temporary_, ignored);
}

void NewFile::keep() {
  const int file = open(temporary_.c_str(), O_RDONLY | O_CLOEXEC);
  const bool written = file >= 0 && fdatasync(file) == 0;
  if (file >= 0) close(file);
  if (!written)
    refuse(file_, std::string("cannot be brought to the disk: ") + std::strerror(errno));
  const unsigned how = overwrite_ ? 0 : RENAME_NOREPLACE;
  int failed = renameat2(AT_FDCWD, temporary_.c_str(), AT_FDCWD, file_.c_str(), how);
  if (failed && errno == EINVAL)  // a file system that knows no such rename
    failed = std::rename(temporary_.c_str(), file_.c_str());
  if (failed) refuse(file_, errno == EEXIST ? there_already : std::strerror(errno));
}

}  // namespace searig::acquisition::exchange
