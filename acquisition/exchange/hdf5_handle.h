// What the HDF5 library hands out, closed by itself.
#pragma once

#include <hdf5.h>

#include <stdexcept>
#include <utility>

namespace searig::acquisition::exchange {

/// Thrown where the library refuses; the caller knows the file and says it.
struct Hdf5Refusal : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class Handle {
 public:
  Handle(hid_t id, herr_t (*closer)(hid_t), const char* what) : id_(id), close_(closer) {
    if (id < 0) throw Hdf5Refusal(what);
  }
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;

  operator hid_t() const { return id_; }  // NOLINT: it stands for the id in every call

  /// Closing a file is when its last bytes are written; here that may fail.
  void close(const char* what) {
    if (close_(std::exchange(id_, -1)) < 0) throw Hdf5Refusal(what);
  }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

inline void demand(herr_t result, const char* what) {
  if (result < 0) throw Hdf5Refusal(what);
}

/// To be called before anything else of the library. It prints its own stack of errors unless told
/// not to, and at exit it goes once more over a file that the disk did not take, and crashes.
inline void keep_quiet() {
  H5dont_atexit();
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

}  // namespace searig::acquisition::exchange
