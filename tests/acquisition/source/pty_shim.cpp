// Makes libserialport 0.1.1 take a pseudo terminal for a serial port, so that its real code runs
// under test. It asks three things that a pseudo terminal cannot answer: an entry in /sys/class/tty
// (lstat, readlink) and modem lines (ioctl TIOCM*). Linked before libserialport, or preloaded.
#include <dlfcn.h>
#include <stdarg.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <termios.h>
#include <unistd.h>

namespace {

constexpr char kEntry[] = "/sys/class/tty/pts/";
constexpr char kTarget[] = "../../devices/virtual/tty/pts";

bool asked_about_pty(const char* path) {
  return strncmp(path, kEntry, sizeof kEntry - 1) == 0;
}

int be_a_link(struct stat* status) {
  memset(status, 0, sizeof *status);
  status->st_mode = S_IFLNK | 0777;
  return 0;
}

template <typename Function>
Function next(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" int lstat(const char* path, struct stat* status) noexcept {
  if (asked_about_pty(path)) return be_a_link(status);
  return next<int (*)(const char*, struct stat*)>("lstat")(path, status);
}

/// What lstat is called in programs built before glibc 2.33, as Debian's libserialport was.
extern "C" int __lxstat(int version, const char* path, struct stat* status) {
  if (asked_about_pty(path)) return be_a_link(status);
  return next<int (*)(int, const char*, struct stat*)>("__lxstat")(version, path, status);
}

extern "C" ssize_t readlink(const char* path, char* to, size_t size) noexcept {
  if (!asked_about_pty(path)) {
    return next<ssize_t (*)(const char*, char*, size_t)>("readlink")(path, to, size);
  }
  const size_t count = size < sizeof kTarget - 1 ? size : sizeof kTarget - 1;
  memcpy(to, kTarget, count);
  return static_cast<ssize_t>(count);
}

extern "C" int ioctl(int handle, unsigned long request, ...) noexcept {
  va_list arguments;
  va_start(arguments, request);
  void* const argument = va_arg(arguments, void*);
  va_end(arguments);
  const auto real = next<int (*)(int, unsigned long, ...)>("ioctl");
  if (request != TIOCMGET && request != TIOCMSET && request != TIOCMBIS && request != TIOCMBIC) {
    return real(handle, request, argument);
  }
  // Still an error where the line is gone.
  int waiting = 0;
  if (real(handle, TIOCINQ, &waiting) != 0) return -1;
  if (request == TIOCMGET) *static_cast<int*>(argument) = TIOCM_DTR | TIOCM_RTS;
  return 0;
}
