// A metal torsion spring against a force/torque sensor (I. Tregear, Imperial College, 2023): what
// its straight line lacks is found on some amplitudes and shown on others, which no fit has seen.
#include "tests/system/real/real_machine.h"

namespace searig {
namespace {

namespace fs = std::filesystem;

const fs::path kRecorded = kRealMachines / "sea_metal_spring/stiffness";

/// The file of one amplitude, "kt-5-...".
fs::path file_of(int amplitude) {
  const std::string begin = "kt-" + std::to_string(amplitude) + "-";
  for (const auto& entry : fs::directory_iterator(kRecorded))
    if (entry.path().filename().string().starts_with(begin)) return entry.path();
  return {};
}

fs::path folder_of(const TemporaryFolder& folder, int amplitude) {
  return folder.path() / ("m" + std::to_string(amplitude));
}

/// Folders that map the files; returns their paths, separated by spaces.
std::string mapped(const TemporaryFolder& folder, const std::vector<int>& amplitudes) {
  std::string out;
  for (const int amplitude : amplitudes) {
    const fs::path path = folder_of(folder, amplitude);
    fs::create_directories(path);
    std::ofstream(path / "recording.toml")
        << "format = \"searig-recording/1\"\n[module]\nfile = " << quoted(file_of(amplitude))
        << "\n[module.columns]\nt_s = { column = \"time\" }\n"
           "deflection_rad = { column = \"displacement\", unit = \"deg\" }\n[loadcell]\nfile = "
        << quoted(file_of(amplitude))
        << "\n[loadcell.columns]\nt_s = { column = \"time\" }\n"
           "torque_nm = { column = \"torque_out\" }\n";
    out += path.string() + " ";
  }
  return out;
}

/// Deflection, rad, and torque, N*m, of one recording, each less its mean: every recording has a
/// zero of its own.
struct Loop {
  std::vector<double> theta, torque;
};

std::vector<double> centred(std::vector<double> x) {
  const double middle = mean(x);
  for (double& v : x) v -= middle;
  return x;
}

Loop loop_of(int amplitude) {
  const auto columns = columns_of(file_of(amplitude), true);
  Loop out{centred(columns.at(4)), centred(columns.at(3))};
  for (double& angle : out.theta) angle *= M_PI / 180.0;
  return out;
}

/// rms that a straight spring leaves on `shown`, fitted to `fitted`.
double left_by_a_line(const std::vector<int>& fitted, const std::vector<int>& shown) {
  double xy = 0.0, xx = 0.0;
  for (const int amplitude : fitted) {
    const Loop loop = loop_of(amplitude);
    for (std::size_t i = 0; i < loop.theta.size(); ++i)
      xy += loop.theta[i] * loop.torque[i], xx += loop.theta[i] * loop.theta[i];
  }
  std::vector<double> left;
  for (const int amplitude : shown) {
    const Loop loop = loop_of(amplitude);
    for (std::size_t i = 0; i < loop.theta.size(); ++i)
      left.push_back(loop.torque[i] - xy / xx * loop.theta[i]);
  }
  return rms(left);
}

/// The same of a model file, by what `searig simulate` says the sensor would have read.
double left_by(const std::string& model, const TemporaryFolder& folder,
               const std::vector<int>& shown) {
  std::vector<double> left;
  for (const int amplitude : shown) {
    const fs::path out = folder.path() / ("simulated" + std::to_string(amplitude));
    const Ran ran = run_program("searig simulate " + model + " --like " +
                                folder_of(folder, amplitude).string() + " --out " + out.string());
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    const auto simulated = centred(columns_of(out / "loadcell.csv", true).at(1));
    const auto measured = loop_of(amplitude).torque;
    EXPECT_EQ(simulated.size(), measured.size());
    for (std::size_t i = 0; i < std::min(measured.size(), simulated.size()); ++i)
      left.push_back(measured[i] - simulated[i]);
  }
  return rms(left);
}

void expect_found_and_shown(const std::vector<int>& fitted, const std::vector<int>& shown) {
  if (!fs::exists(kRecorded)) GTEST_SKIP() << kRecorded << " is not there";
  const TemporaryFolder folder;
  const std::string model = (folder.path() / "found.toml").string();
  const auto diagnosis = diagnosed(mapped(folder, fitted) + " --write-model " + model);
  EXPECT_GT(finding(diagnosis, "spring.hysteresis").at("probability"), 0.8);
  mapped(folder, shown);
  const double line = left_by_a_line(fitted, shown), extended = left_by(model, folder, shown);
  EXPECT_GT(line, 0.8);
  EXPECT_LT(extended, 0.6 * line);
  testing::Test::RecordProperty("line_mnm", int(1e3 * line));
  testing::Test::RecordProperty("extended_mnm", int(1e3 * extended));
}

TEST(MetalSpring, OddAmplitudesShowTheEvenOnes) {
  expect_found_and_shown({1, 3, 5, 7, 9}, {2, 4, 6, 8});
}

TEST(MetalSpring, TwoAmplitudesShowTheOtherSeven) {
  expect_found_and_shown({3, 7}, {1, 2, 4, 5, 6, 8, 9});
}

}  // namespace
}  // namespace searig
