#include <matio.h>

#include <memory>
#include <utility>

#include "acquisition/error.h"
#include "acquisition/exchange/facts.h"
#include "acquisition/exchange/mat.h"

namespace searig::acquisition::exchange {
namespace {

using File = std::unique_ptr<mat_t, int (*)(mat_t*)>;
using Variable = std::unique_ptr<matvar_t, void (*)(matvar_t*)>;

Variable variable(mat_t* file, const char* name) {
  Variable read(Mat_VarRead(file, name), &Mat_VarFree);
  if (!read || read->class_type != MAT_C_STRUCT)
    throw InputError("has no struct " + std::string(name) +
                     ", or not all of it; only what searig export wrote can be read back.");
  return read;
}

const matvar_t* field(const Variable& structure, const std::string& name) {
  const matvar_t* value = Mat_VarGetStructFieldByName(structure.get(), name.c_str(), 0);
  if (!value) throw InputError("has no " + std::string(structure->name) + "." + name + ".");
  return value;
}

std::string facts_in(mat_t* file) {
  const Variable provenance = variable(file, "provenance");
  const matvar_t* facts = field(provenance, "facts");
  if (facts->class_type != MAT_C_CHAR || !facts->data || facts->data_size != 1)
    throw InputError("has facts in provenance that are no text.");
  return {static_cast<const char*>(facts->data), facts->nbytes};
}

void read_columns(mat_t* file, const std::string& id, ReadGroup& group) {
  const Variable structure = variable(file, id.c_str());
  const std::vector<std::string> ids = identifiers(names_of(group.columns));
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const matvar_t* value = field(structure, ids[i]);
    const std::size_t bytes = group.rows * sizeof(double);
    if (value->class_type != MAT_C_DOUBLE || value->data_type != MAT_T_DOUBLE || value->isComplex ||
        value->nbytes != bytes || (bytes > 0 && !value->data))
      throw InputError("has " + id + "." + ids[i] + ", but not as " + std::to_string(group.rows) +
                       " doubles.");
    const auto* numbers = static_cast<const double*>(value->data);
    group.columns[i].values.assign(numbers, numbers + group.rows);
  }
}

}  // namespace

Recording read_mat(const std::filesystem::path& path) {
  const File file(Mat_Open(path.c_str(), MAT_ACC_RDONLY), &Mat_Close);
  try {
    if (!file) throw InputError("cannot be read as a MATLAB file.");
    const std::string facts = facts_in(file.get());
    std::vector<ReadGroup> groups = groups_of(facts);
    const std::vector<std::string> ids = identifiers(names_of(groups));
    for (std::size_t i = 0; i < ids.size(); ++i) read_columns(file.get(), ids[i], groups[i]);
    return recording_of(facts, std::move(groups));
  } catch (const InputError& error) {
    throw InputError(path.string() + ": " + error.what());
  }
}

}  // namespace searig::acquisition::exchange
