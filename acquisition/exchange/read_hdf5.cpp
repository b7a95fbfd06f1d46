#include <string>
#include <utility>

#include "acquisition/error.h"
#include "acquisition/exchange/facts.h"
#include "acquisition/exchange/hdf5.h"
#include "acquisition/exchange/hdf5_handle.h"

namespace searig::acquisition::exchange {
namespace {

std::string facts_in(hid_t file) {
  const char* none = "has no facts; only what searig export wrote can be read back.";
  const Handle dataset(H5Dopen2(file, "facts", H5P_DEFAULT), &H5Dclose, none);
  const Handle type(H5Dget_type(dataset), &H5Tclose, none);
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) != 0) throw Hdf5Refusal(none);
  std::string facts(H5Tget_size(type), '\0');
  const Handle space(H5Dget_space(dataset), &H5Sclose, none);
  if (H5Sget_simple_extent_npoints(space) != 1) throw Hdf5Refusal(none);
  demand(H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, facts.data()), none);
  return facts;
}

void read_column(hid_t file, const std::string& path, std::size_t rows,
                 std::vector<double>& values) {
  const std::string what = "has no " + path + " of " + std::to_string(rows) + " numbers.";
  const Handle dataset(H5Dopen2(file, path.c_str(), H5P_DEFAULT), &H5Dclose, what.c_str());
  const Handle space(H5Dget_space(dataset), &H5Sclose, what.c_str());
  if (H5Sget_simple_extent_npoints(space) != static_cast<hssize_t>(rows)) throw Hdf5Refusal(what);
  values.resize(rows);
  if (rows > 0)
    demand(H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
           what.c_str());
}

Recording read_all(hid_t file) {
  const std::string facts = facts_in(file);
  std::vector<ReadGroup> groups = groups_of(facts);
  const std::vector<std::string> ids = identifiers(names_of(groups));
  for (std::size_t i = 0; i < ids.size(); ++i) {
    ReadGroup& group = groups[i];
    const std::vector<std::string> columns = identifiers(names_of(group.columns));
    for (std::size_t j = 0; j < columns.size(); ++j)
      read_column(file, ids[i] + "/" + columns[j], group.rows, group.columns[j].values);
  }
  return recording_of(facts, std::move(groups));
}

}  // namespace

Recording read_hdf5(const std::filesystem::path& path) {
  keep_quiet();
  try {
    const Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), &H5Fclose,
                      "cannot be read as an HDF5 file.");
    return read_all(file);
  } catch (const Hdf5Refusal& refusal) {
    throw InputError(path.string() + ": " + refusal.what());
  } catch (const InputError& error) {
    throw InputError(path.string() + ": " + error.what());
  }
}

}  // namespace searig::acquisition::exchange
