// Exports in the programs that they are for: h5py, SciPy, Octave.
#include <gtest/gtest.h>

#include <cstdlib>

#include "acquisition/exchange/hdf5.h"
#include "acquisition/exchange/mat.h"
#include "tests/acquisition/exchange/a_recording.h"
#include "tests/temporary_folder.h"

namespace searig::acquisition::exchange {
namespace {

namespace fs = std::filesystem;

/// The recording's numbers as one binary file of doubles: module.t_s, module.current_a,
/// loadcell.force_n, table's torque_nm, one after the other with the count before each.
void write_numbers(const Recording& recording, const Contents& contents, const fs::path& path) {
  std::ofstream file(path, std::ios::binary);
  const auto put = [&](std::span<const double> values) {
    const double count = double(values.size());
    file.write(reinterpret_cast<const char*>(&count), sizeof count);
    file.write(reinterpret_cast<const char*>(values.data()), std::streamsize(values.size_bytes()));
  };
  put(recording.module.t_s);
  put(recording.module.channel("current_a"));
  put(recording.loadcell.channel("force_n"));
  put(contents.table.find("torque_nm")->values);
}

/// Runs `program script file numbers`; its exit code.
int run(const std::string& program, const std::string& script, const fs::path& file,
        const fs::path& numbers) {
  const std::string line =
      program + " " SEARIG_SCRIPTS "/" + script + " " + file.string() + " " + numbers.string();
  return WEXITSTATUS(std::system(line.c_str()));
}

struct Exported : TemporaryFolder {
  Recording recording = a_recording();
  fs::path mat = path() / "x.mat", hdf5 = path() / "x.h5", numbers = path() / "numbers";
  Exported() {
    const Contents contents = contents_of(recording);
    write_mat(contents, "searig test", mat);
    write_hdf5(contents, "searig test", hdf5);
    write_numbers(recording, contents, numbers);
  }
};

#ifdef SEARIG_PYTHON
void expect_python_reads(const fs::path& file, const Exported& exported) {
  constexpr int no_module = 77;  // the script's word for a package that is not there
  const int exit_code = run(SEARIG_PYTHON, "read_export.py", file, exported.numbers);
  if (exit_code == no_module) GTEST_SKIP() << "python3-h5py or python3-scipy is not installed";
  EXPECT_EQ(exit_code, 0);
}

TEST(OtherPrograms, H5pyReadsTheSameNumbersAndUnits) {
  const Exported exported;
  expect_python_reads(exported.hdf5, exported);
}

TEST(OtherPrograms, SciPyReadsTheSameNumbersAndUnits) {
  const Exported exported;
  expect_python_reads(exported.mat, exported);
}
#else
TEST(OtherPrograms, Python) {
  GTEST_SKIP() << "Debian's python3 is not installed";
}
#endif

#ifdef SEARIG_OCTAVE
TEST(OtherPrograms, OctaveReadsTheSameNumbersAndUnits) {
  const Exported exported;
  const std::string octave = SEARIG_OCTAVE " --no-gui --no-history --norc -q";
  EXPECT_EQ(run(octave, "read_export.m", exported.mat, exported.numbers), 0);
  EXPECT_EQ(run(octave, "read_export.m", exported.hdf5, exported.numbers), 0);
}
#else
TEST(OtherPrograms, Octave) {
  GTEST_SKIP() << "octave is not installed";
}
#endif

}  // namespace
}  // namespace searig::acquisition::exchange
