#include "acquisition/recording/mapped_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

#include "acquisition/error.h"

namespace searig::acquisition {

MappedFile::MappedFile(const std::filesystem::path& path) {
  const auto refuse = [&](const char* why) {
    throw InputError(path.string() + ": cannot be read: " + why + ".");
  };
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) refuse(std::strerror(errno));
  struct stat status {};
  const bool regular = fstat(file, &status) == 0 && S_ISREG(status.st_mode);
  size_ = regular ? static_cast<std::size_t>(status.st_size) : 0;
  if (size_ > 0) start_ = mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, file, 0);
  const int error = errno;
  close(file);  // the mapping stays
  if (!regular) refuse("it is no file");
  if (start_ == MAP_FAILED) refuse(std::strerror(error));
}

void MappedFile::forget(std::size_t bytes) const {
  const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  if (bytes >= page) madvise(start_, bytes / page * page, MADV_DONTNEED);
}

MappedFile::~MappedFile() {
  if (start_) munmap(start_, size_);
}

}  // namespace searig::acquisition
