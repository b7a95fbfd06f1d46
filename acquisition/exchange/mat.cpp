#include "acquisition/exchange/mat.h"

#include <matio.h>

#include <cstdint>
#include <cstring>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "acquisition/error.h"
#include "acquisition/recording/mapped_file.h"

namespace searig::acquisition::exchange {
namespace {

constexpr std::size_t most_bytes = (std::size_t{1} << 31) - (1 << 20);  // of a variable

using File = std::unique_ptr<mat_t, int (*)(mat_t*)>;
using Variable = std::unique_ptr<matvar_t, void (*)(matvar_t*)>;

Variable checked(matvar_t* variable) {
  if (!variable) throw std::bad_alloc();
  return {variable, &Mat_VarFree};
}

/// A view of the values: nothing is copied.
Variable doubles(std::span<const double> values) {
  std::size_t size[2] = {values.size(), 1};
  return checked(Mat_VarCreate(nullptr, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, size,
                               const_cast<double*>(values.data()), MAT_F_DONT_COPY_DATA));
}

/// In ASCII; what is none becomes a question mark.
Variable text(std::string words) {
  for (char& c : words)
    if (static_cast<unsigned char>(c) > 0x7e) c = '?';
  std::size_t size[2] = {words.empty() ? 0u : 1u, words.size()};
  return checked(Mat_VarCreate(nullptr, MAT_C_CHAR, MAT_T_UINT8, 2, size, words.data(), 0));
}

/// Fields in their order; taken over.
Variable structure(const char* name, std::vector<std::pair<std::string, Variable>> fields) {
  std::vector<const char*> names;
  for (const auto& [field, value] : fields) names.push_back(field.c_str());
  std::size_t size[2] = {1, 1};
  Variable out = checked(Mat_VarCreateStruct(name, 2, size, names.data(), unsigned(names.size())));
  for (std::size_t i = 0; i < fields.size(); ++i)
    Mat_VarSetStructFieldByIndex(out.get(), i, 0, fields[i].second.release());
  return out;
}

using Fields = std::vector<std::pair<std::string, Variable>>;

Variable group_variable(const char* name, const Group& group,
                        const std::function<Variable(const Column&)>& value) {
  const std::vector<std::string> ids = identifiers(names_of(group.columns));
  Fields fields;
  for (std::size_t i = 0; i < ids.size(); ++i) fields.emplace_back(ids[i], value(group.columns[i]));
  return structure(name, std::move(fields));
}

/// As units and how are: GROUP.COLUMN is a text.
Variable said_of_columns(const char* name, const std::vector<Group>& groups,
                         std::string Column::*what) {
  const std::vector<std::string> ids = identifiers(names_of(groups));
  Fields fields;
  for (std::size_t i = 0; i < ids.size(); ++i)
    fields.emplace_back(ids[i], group_variable(nullptr, groups[i], [&](const Column& column) {
                          return text(column.*what);
                        }));
  return structure(name, std::move(fields));
}

Variable provenance(const Contents& contents, const std::string& program) {
  std::string clocks;
  for (const std::string& clock : contents.clocks) clocks += clock + "\n";
  Fields fields;
  fields.emplace_back("program", text(program));
  fields.emplace_back("recording", text(contents.name));
  fields.emplace_back("clocks", text(clocks));
  fields.emplace_back("facts", text(contents.facts));
  return structure("provenance", std::move(fields));
}

void write(mat_t* file, const Variable& variable, const std::filesystem::path& path) {
  if (Mat_VarWrite(file, variable.get(), MAT_COMPRESSION_NONE) != 0)
    throw std::runtime_error(path.string() + ": cannot be written.");
}

/// Whether these bytes are elements of such a file, each as long as it says and all within it.
bool elements_fit(std::string_view bytes) {
  while (!bytes.empty()) {
    std::uint32_t tag[2] = {};  // type, bytes
    if (bytes.size() < sizeof tag) return false;
    std::memcpy(tag, bytes.data(), sizeof tag);
    bytes.remove_prefix(sizeof tag);
    if (tag[0] >> 16 != 0) continue;  // a small element: it is in its tag
    const std::size_t padded = (std::size_t{tag[1]} + 7) / 8 * 8;
    if (padded > bytes.size()) return false;
    if (tag[0] == MAT_T_MATRIX && !elements_fit(bytes.substr(0, tag[1]))) return false;
    bytes.remove_prefix(padded);
  }
  return true;
}

/// matio does not say where the disk took only a part; the lengths in the file do.
void refuse_cut(const std::filesystem::path& path) {
  constexpr std::size_t header = 128;
  const MappedFile file(path);
  if (file.bytes().size() <= header || !elements_fit(file.bytes().substr(header)))
    throw std::runtime_error(path.string() + ": could not be written whole; is the disk full?");
}

/// Groups that have columns, the table last.
std::vector<Group> all_groups(const Contents& contents) {
  std::vector<Group> groups = contents.groups;
  if (!contents.table.columns.empty()) groups.push_back(contents.table);
  return groups;
}

void refuse_large(const std::vector<Group>& groups) {
  for (const Group& group : groups)
    if (group.rows() * group.columns.size() * sizeof(double) >= most_bytes)
      throw InputError(group.name + " has " + std::to_string(group.rows()) +
                       " rows, more than a variable of a MATLAB 5 file can hold (2 GB); " +
                       "--format hdf5 has no such limit.");
}

}  // namespace

void write_mat(const Contents& contents, const std::string& program,
               const std::filesystem::path& path) {
  const std::vector<Group> groups = all_groups(contents);
  refuse_large(groups);
  const std::string header = "MATLAB 5.0 MAT-file, written by " + program;  // and no date
  File file(Mat_CreateVer(path.c_str(), header.c_str(), MAT_FT_MAT5), &Mat_Close);
  if (!file) throw std::runtime_error(path.string() + ": cannot be made.");
  const std::vector<std::string> ids = identifiers(names_of(groups));
  for (std::size_t i = 0; i < ids.size(); ++i)
    write(file.get(),
          group_variable(ids[i].c_str(), groups[i],
                         [](const Column& column) { return doubles(column.values); }),
          path);
  write(file.get(), said_of_columns("units", groups, &Column::unit), path);
  write(file.get(), said_of_columns("how", groups, &Column::how), path);
  write(file.get(), provenance(contents, program), path);
  file.reset();
  refuse_cut(path);
}

}  // namespace searig::acquisition::exchange
