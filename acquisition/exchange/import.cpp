#include "acquisition/exchange/import.h"

#include <array>
#include <fstream>
#include <string_view>

#include "acquisition/exchange/csv.h"
#include "acquisition/exchange/hdf5.h"
#include "acquisition/exchange/mat.h"
#include "acquisition/exchange/read_csv.h"
#include "acquisition/recording/hebilog/read_hebilog.h"

namespace searig::acquisition::exchange {
namespace {

Recording read_as(Kind kind, const std::filesystem::path& path,
                  std::optional<std::size_t> hebi_module) {
  switch (kind) {
    case Kind::csv_long:
      return read_csv_long(path);
    case Kind::mat:
      return read_mat(path);
    case Kind::hdf5:
      return read_hdf5(path);
    case Kind::hebilog:
      return hebilog::read_hebilog(path, hebi_module);
    default:
      return read_recording(path);
  }
}

}  // namespace

Kind kind_of(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return Kind::recording;
  std::array<char, csv_first_line.size()> first{};
  std::ifstream(path, std::ios::binary).read(first.data(), first.size());
  const std::string_view begin(first.data(), first.size());
  if (begin == csv_first_line) return Kind::csv_long;
  if (begin.starts_with("MATLAB 5.0 MAT")) return Kind::mat;
  if (begin.starts_with("\x89HDF\r\n\x1a\n")) return Kind::hdf5;
  return hebilog::is_hebilog(path) ? Kind::hebilog : Kind::recording;
}

Recording read_any(const std::filesystem::path& path, std::optional<std::size_t> hebi_module) {
  const Kind kind = kind_of(path);
  Recording recording = read_as(kind, path, hebi_module);
  if (kind == Kind::recording) return recording;
  recording.path = recording.module.file = recording.loadcell.file = path;
  for (Device& device : recording.devices) device.stream.file = path;
  return recording;
}

}  // namespace searig::acquisition::exchange
