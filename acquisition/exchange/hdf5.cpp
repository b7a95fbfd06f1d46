#include "acquisition/exchange/hdf5.h"

#include <algorithm>
#include <string>

#include "acquisition/exchange/hdf5_handle.h"

namespace searig::acquisition::exchange {
namespace {

constexpr const char* full = "could not be written whole; is the disk full?";

void set_attribute(hid_t of, const char* name, const std::string& text) {
  const Handle type(H5Tcopy(H5T_C_S1), &H5Tclose, full);
  demand(H5Tset_size(type, H5T_VARIABLE), full);
  demand(H5Tset_cset(type, H5T_CSET_UTF8), full);
  const Handle space(H5Screate(H5S_SCALAR), &H5Sclose, full);
  const Handle attribute(H5Acreate2(of, name, type, space, H5P_DEFAULT, H5P_DEFAULT), &H5Aclose,
                         full);
  const char* words = text.c_str();
  demand(H5Awrite(attribute, type, &words), full);
}

/// Without times, so that the same recording makes the same bytes; not filled before it is written.
Handle dataset_properties() {
  Handle properties(H5Pcreate(H5P_DATASET_CREATE), &H5Pclose, full);
  demand(H5Pset_obj_track_times(properties, false), full);
  demand(H5Pset_fill_time(properties, H5D_FILL_TIME_NEVER), full);
  return properties;
}

Handle group_properties() {
  Handle properties(H5Pcreate(H5P_GROUP_CREATE), &H5Pclose, full);
  demand(H5Pset_obj_track_times(properties, false), full);
  return properties;
}

void write_column(hid_t group, const char* name, const Column& column) {
  const hsize_t size = column.values.size();
  const Handle space(H5Screate_simple(1, &size, nullptr), &H5Sclose, full);
  const Handle properties = dataset_properties();
  Handle dataset(
      H5Dcreate2(group, name, H5T_IEEE_F64LE, space, H5P_DEFAULT, properties, H5P_DEFAULT),
      &H5Dclose, full);
  if (size > 0)
    demand(
        H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, column.values.data()),
        full);
  set_attribute(dataset, "units", column.unit);
  set_attribute(dataset, "how", column.how);
  dataset.close(full);  // what waited in memory goes out
}

void write_group(hid_t file, const std::string& id, const Group& group) {
  const Handle properties = group_properties();
  const Handle handle(H5Gcreate2(file, id.c_str(), H5P_DEFAULT, properties, H5P_DEFAULT), &H5Gclose,
                      full);
  set_attribute(handle, "about", group.about);
  const std::vector<std::string> ids = identifiers(names_of(group.columns));
  for (std::size_t i = 0; i < ids.size(); ++i)
    write_column(handle, ids[i].c_str(), group.columns[i]);
}

void write_facts(hid_t file, const std::string& facts) {
  const Handle type(H5Tcopy(H5T_C_S1), &H5Tclose, full);
  demand(H5Tset_size(type, facts.size()), full);
  const Handle space(H5Screate(H5S_SCALAR), &H5Sclose, full);
  const Handle properties = dataset_properties();
  Handle dataset(H5Dcreate2(file, "facts", type, space, H5P_DEFAULT, properties, H5P_DEFAULT),
                 &H5Dclose, full);
  demand(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, facts.data()), full);
  dataset.close(full);
}

void write_all(hid_t file, const Contents& contents, const std::string& program) {
  std::string clocks;
  for (const std::string& clock : contents.clocks) clocks += clock + "\n";
  set_attribute(file, "program", program);
  set_attribute(file, "recording", contents.name);
  set_attribute(file, "clocks", clocks);
  std::vector<Group> groups = contents.groups;
  if (!contents.table.columns.empty()) groups.push_back(contents.table);
  const std::vector<std::string> ids = identifiers(names_of(groups));
  for (std::size_t i = 0; i < ids.size(); ++i) write_group(file, ids[i], groups[i]);
  write_facts(file, contents.facts);
}

}  // namespace

void write_hdf5(const Contents& contents, const std::string& program,
                const std::filesystem::path& path) {
  keep_quiet();
  try {
    Handle file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), &H5Fclose,
                "cannot be made.");
    write_all(file, contents, program);
    demand(H5Fflush(file, H5F_SCOPE_GLOBAL), full);
    file.close(full);
  } catch (const Hdf5Refusal& refusal) {
    throw std::runtime_error(path.string() + ": " + refusal.what());
  }
}

}  // namespace searig::acquisition::exchange
