// searig-bench-export [MINUTES]: how long an export takes, as a ratio to NumPy, SciPy and h5py that
// write the same arrays. A 1 kHz module with nine columns and a 50 Hz load cell, an hour of them.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <random>
#include <string>

#include "acquisition/exchange/csv.h"
#include "acquisition/exchange/hdf5.h"
#include "acquisition/exchange/mat.h"
#include "acquisition/recorder/output_file.h"
#include "acquisition/recording/mcap/import.h"
#include "tests/temporary_folder.h"

namespace {

namespace fs = std::filesystem;
using namespace searig::acquisition;

/// Values as they are measured: a motion and noise, microseconds for time.
Recording recording_of(double minutes) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(0.0, 1e-3);
  std::exponential_distribution<double> latency(500.0);
  const auto stream = [&](const char* name, double hz, std::vector<std::string> channels) {
    Stream out;
    out.name = name;
    const auto rows = std::size_t(minutes * 60.0 * hz);
    for (const std::string& channel : channels) out.channels.push_back({channel, {}});
    for (std::size_t row = 0; row < rows; ++row) {
      const double t = std::round(1e6 * double(row) / hz) / 1e6;
      out.t_s.push_back(t);
      out.host_s.push_back(1e4 + t + latency(random));
      for (std::size_t i = 0; i < channels.size(); ++i)
        out.channels[i].values.push_back(std::sin(double(i + 1) * t) + noise(random));
    }
    out.counts.received = rows;
    return out;
  };
  Recording recording;
  recording.name = "hour";
  recording.module = stream("module", 1000.0,
                            {"input_angle_rad", "output_angle_rad", "deflection_rad", "current_a",
                             "motor_angle_rad", "commanded_angle_rad", "winding_temperature_c"});
  recording.loadcell = stream("loadcell", 50.0, {"force_n"});
  return recording;
}

/// The best of some times; `before` each of them is not in it.
double seconds(int times, const std::function<void()>& before, const std::function<void()>& work) {
  double best = 1e300;
  for (int i = 0; i < times; ++i) {
    before();
    const auto start = std::chrono::steady_clock::now();
    work();
    best = std::min(
        best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return best;
}

void write_arrays(const exchange::Contents& contents, const fs::path& folder) {
  const auto write = [&](const exchange::Group& group) {
    fs::create_directories(folder / group.name);
    for (const exchange::Column& column : group.columns)
      std::ofstream(folder / group.name / (column.name + ".f64"), std::ios::binary)
          .write(reinterpret_cast<const char*>(column.values.data()),
                 std::streamsize(column.values.size_bytes()));
  };
  for (const exchange::Group& group : contents.groups) write(group);
  write(contents.table);
}

void write_csv(void (*write)(const exchange::Contents&, const exchange::Sink&),
               const exchange::Contents& contents, const fs::path& path) {
  OutputFile file(path);
  write(contents, [&](std::string_view piece) { file.append(piece); });
}

std::string output_of(const std::string& command) {
  std::FILE* pipe = popen(command.c_str(), "r");
  std::string text;
  for (int c; (c = std::fgetc(pipe)) != EOF;) text += char(c);
  return pclose(pipe) == 0 ? text : "";
}

}  // namespace

int main(int argc, char** argv) {
  const double minutes = argc > 1 ? std::atof(argv[1]) : 60.0;
  const searig::TemporaryFolder temporary;
  const fs::path& folder = temporary.path();
  {
    const Recording recording = recording_of(minutes);
    const auto contents = exchange::contents_of(recording, synchronise(recording), {});
    write_arrays(contents, folder);
    OutputFile file(folder / "hour.mcap");
    mcap::write_mcap(recording, {}, "bench", [&](std::string_view piece) { file.append(piece); });
    const fs::path out = folder / "out";
    const auto anew = [&] { fs::remove(out); };
    nlohmann::json ours{
        {"csv table",
         seconds(3, anew, [&] { write_csv(exchange::write_csv_table, contents, out); })},
        {"csv --long",
         seconds(1, anew, [&] { write_csv(exchange::write_csv_long, contents, out); })},
        {"mat", seconds(5, anew, [&] { exchange::write_mat(contents, "bench", out); })},
        {"hdf5", seconds(5, anew, [&] { exchange::write_hdf5(contents, "bench", out); })}};
    std::ofstream(folder / "ours.json") << ours;
  }
  const auto ours = nlohmann::json::parse(std::ifstream(folder / "ours.json"));
  const auto python = nlohmann::json::parse(
      output_of(std::string(SEARIG_PYTHON) + " " SEARIG_SCRIPT " " + folder.string()), nullptr,
      false);
  std::printf("%.0f minutes   writing, s   Python, s   Python/searig   whole command, s\n",
              minutes);
  for (const auto& [what, its] : ours.items()) {
    const std::string format = what.substr(0, what.find(' '));
    const double whole = seconds(
        1, [] {},
        [&] {
          const std::string command = std::string(SEARIG_PROGRAM) + " export " +
                                      (folder / "hour.mcap").string() + " --overwrite --format " +
                                      format + (what.ends_with("long") ? " --long" : "") +
                                      " --out " + (folder / "whole").string() + " >/dev/null";
          if (std::system(command.c_str()) != 0) std::printf("failed: %s\n", command.c_str());
        });
    const double theirs = python.is_discarded() ? NAN : python.at(what).get<double>();
    std::printf("%-11s %10.2f  %10.2f  %14.1f  %17.2f\n", what.c_str(), its.get<double>(), theirs,
                theirs / its.get<double>(), whole);
  }
  return python.is_discarded() ? 1 : 0;
}
