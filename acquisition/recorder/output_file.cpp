#include "acquisition/recorder/output_file.h"

#include <fcntl.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace searig::acquisition {
namespace {

std::uint64_t free_bytes_of(const struct statvfs& disk) {
  return std::uint64_t(disk.f_bavail) * disk.f_frsize;
}

constexpr std::uint64_t unknown = std::numeric_limits<std::uint64_t>::max();

}  // namespace

OutputFile::OutputFile(std::filesystem::path path) : path_(std::move(path)) {
  file_ = open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
  if (file_ >= 0) return;
  if (errno == EEXIST)
    throw std::runtime_error(path_.string() + ": is there already; nothing is recorded over.");
  throw std::runtime_error(path_.string() + ": cannot be made: " + std::strerror(errno) + ".");
}

OutputFile::~OutputFile() {
  close(file_);
}

void OutputFile::append(std::string_view bytes) {
  for (std::string_view rest = bytes; !rest.empty();) {
    const ssize_t written = write(file_, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) refuse(written < 0 ? errno : ENOSPC);
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
  size_ += bytes.size();
}

void OutputFile::refuse(int error) const {
  // A torn piece would be found by its CRC; without it the file ends cleanly.
  const bool cut = ftruncate(file_, static_cast<off_t>(size_)) == 0;
  (void)cut;
  throw std::runtime_error(path_.string() + ": cannot be written further: " + std::strerror(error) +
                           ".");
}

void OutputFile::sync() {
  if (fdatasync(file_) != 0 && errno != EINVAL)  // EINVAL: a device that knows no such thing
    throw std::runtime_error(path_.string() +
                             ": cannot be brought to the disk: " + std::strerror(errno) + ".");
}

std::uint64_t OutputFile::free_bytes() const {
  struct statvfs disk {};
  return fstatvfs(file_, &disk) == 0 ? free_bytes_of(disk) : unknown;
}

std::uint64_t free_bytes_beside(const std::filesystem::path& file) {
  struct statvfs disk {};
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  return statvfs(folder.c_str(), &disk) == 0 ? free_bytes_of(disk) : unknown;
}

}  // namespace searig::acquisition
