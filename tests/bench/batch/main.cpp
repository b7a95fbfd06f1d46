// searig-bench-batch [length|number|all] [HOURS] [RECORDINGS]
//   length: one recording of 1 min, 10 min, 1 h ... HOURS (10) at 1 kHz, as a folder and as .mcap,
//           against reading and checksumming the same bytes
//   number: 1, 10, 100 ... RECORDINGS (5000) of one minute at 100 Hz: growth, speed-up on two
//   cores,
//           and whether a batch that was killed half-way ends with the same bytes
// Wall times need an idle machine; CPU times stand beside them.
#include <openssl/evp.h>
#include <signal.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "acquisition/recorder/output_file.h"
#include "acquisition/recording/mcap/import.h"
#include "acquisition/recording/recording.h"
#include "tests/bench/batch/made_recording.h"
#include "tests/bench/batch/process.h"
#include "tests/temporary_folder.h"

namespace {

namespace fs = std::filesystem;

const std::string program = SEARIG_PROGRAM;

/// Reads the files of a recording through a small buffer and takes their SHA-256, in a process of
/// its own: searig-bench-batch checksum FILE...
int checksum(int files, char** names) {
  std::vector<char> buffer(1 << 20);
  for (int i = 0; i < files; ++i) {
    const std::unique_ptr<EVP_MD_CTX, void (*)(EVP_MD_CTX*)> hash(EVP_MD_CTX_new(),
                                                                  EVP_MD_CTX_free);
    EVP_DigestInit_ex(hash.get(), EVP_sha256(), nullptr);
    std::ifstream file(names[i], std::ios::binary);
    while (file.read(buffer.data(), std::streamsize(buffer.size())), file.gcount() > 0)
      EVP_DigestUpdate(hash.get(), buffer.data(), std::size_t(file.gcount()));
  }
  return 0;
}

std::vector<std::string> files_of(const fs::path& recording) {
  if (!fs::is_directory(recording)) return {recording.string()};
  return {(recording / "module.csv").string(), (recording / "loadcell.csv").string()};
}

double megabytes(const fs::path& recording) {
  double sum = 0;
  for (const std::string& file : files_of(recording)) sum += double(fs::file_size(file)) / 1e6;
  return sum;
}

Cost best_of(int times, const std::vector<std::string>& command) {
  Cost best;
  for (int i = 0; i < times; ++i) {
    const Cost cost = run(command);
    if (i > 0 && cost.cpu_s >= best.cpu_s) continue;
    best = cost;
  }
  return best;
}

void print_length(const char* self, const fs::path& recording, double minutes, double& before) {
  std::vector<std::string> own{self, "checksum"}, coreutils{"sha256sum"};
  for (const std::string& file : files_of(recording))
    own.push_back(file), coreutils.push_back(file);
  const int times = minutes > 100 ? 1 : 3;
  const Cost openssl = best_of(times, own), sha256sum = best_of(times, coreutils);
  const Cost evaluated = best_of(times, {program, "evaluate", recording.string()});
  std::printf("%7.0f  %-6s %8.0f %8.2f %8.2f %6.0f  %9.1f %9.1f  %9.1f %9.1f  %7.2f\n", minutes,
              fs::is_directory(recording) ? "folder" : ".mcap", megabytes(recording),
              evaluated.wall_s, evaluated.cpu_s, evaluated.peak_mb,
              evaluated.wall_s / sha256sum.wall_s, evaluated.cpu_s / sha256sum.cpu_s,
              evaluated.wall_s / openssl.wall_s, evaluated.cpu_s / openssl.cpu_s,
              before > 0 ? evaluated.cpu_s / minutes / before : 1.0);
  std::fflush(stdout);
  before = evaluated.cpu_s / minutes;
  if (evaluated.exit_code != 0) std::printf("evaluating failed: %d\n", evaluated.exit_code);
}

/// The numbers alone: an import would attach the CSV files, which are read at no cost.
void write_mcap_of(const fs::path& recording, const fs::path& file) {
  using namespace searig::acquisition;
  OutputFile out(file);
  mcap::write_mcap(read_recording(recording), {}, "bench",
                   [&](std::string_view bytes) { out.append(bytes); });
}

void lengths(const char* self, const fs::path& scratch, double hours) {
  std::printf(
      "                                                   evaluate / sha256sum  "
      "evaluate / OpenSSL   per minute,\n"
      "minutes         megabytes   wall s   CPU s  peak MB     wall       CPU       wall       "
      "CPU   of the last\n");
  double folder_before = 0, mcap_before = 0;
  for (double minutes : {1.0, 10.0, 60.0, 600.0}) {
    if (minutes > 60 * hours) break;
    const fs::path recording = scratch / "recording", file = scratch / "recording.mcap";
    write_folder(recording, 60 * minutes, 1000, 1);
    print_length(self, recording, minutes, folder_before);
    write_mcap_of(recording, file);
    print_length(self, file, minutes, mcap_before);
    fs::remove_all(recording);
    fs::remove(file);
  }
}

std::string bytes_of(const fs::path& out) {
  std::ostringstream all;
  for (const char* file : {"evaluation.json", "summary.csv", "report.html"})
    all << std::ifstream(out / file, std::ios::binary).rdbuf();
  return all.str();
}

std::size_t lines_of(const fs::path& file) {
  std::ifstream text(file, std::ios::binary);
  return std::size_t(std::count(std::istreambuf_iterator<char>(text), {}, '\n'));
}

void numbers(const fs::path& scratch, unsigned most) {
  std::printf("recordings   jobs   wall s    CPU s   peak MB   wall ms each\n");
  const fs::path all = scratch / "all";
  unsigned made = 0;
  std::string whole;
  for (unsigned count = 1; count <= most;
       count = count * 10 > most && count < most ? most : count * 10) {
    for (; made < count; ++made) write_folder(all / std::to_string(10000 + made), 60, 100, made);
    double one_job = 0;
    for (const char* jobs : {"1", "2"}) {
      fs::remove_all(scratch / "out");
      const Cost cost = run(
          {program, "evaluate", all.string(), "--jobs", jobs, "--out", (scratch / "out").string()});
      std::printf("%10u  %5s  %7.2f  %7.2f  %8.0f  %13.2f", count, jobs, cost.wall_s, cost.cpu_s,
                  cost.peak_mb, 1e3 * cost.wall_s / count);
      if (*jobs == '1')
        one_job = cost.wall_s;
      else
        std::printf("   %.2f times as fast", one_job / cost.wall_s);
      std::printf("\n");
      std::fflush(stdout);
      const std::string bytes = bytes_of(scratch / "out");
      if (*jobs == '2' && bytes != whole) std::printf("The bytes differ from those of one job.\n");
      whole = bytes;
    }
  }
  const fs::path killed = scratch / "killed";
  run({program, "evaluate", all.string(), "--out", killed.string()}, [&](pid_t child) {
    if (lines_of(killed / "batch.jsonl") < made / 2) return false;
    kill(child, SIGKILL);
    return true;
  });
  const std::size_t kept = lines_of(killed / "batch.jsonl") - 1;
  run({program, "evaluate", all.string(), "--resume", "--out", killed.string()});
  std::printf("Killed after %zu of %u and resumed: %s\n", kept, made,
              bytes_of(killed) == whole ? "the same bytes" : "OTHER BYTES");
}

}  // namespace

int main(int argc, char** argv) {
  const std::string what = argc > 1 ? argv[1] : "all";
  if (what == "checksum") return checksum(argc - 2, argv + 2);
  const double hours = argc > 2 ? std::atof(argv[2]) : 10;
  const unsigned recordings = argc > 3 ? unsigned(std::atoi(argv[3])) : 5000;
  const searig::TemporaryFolder folder;
  const fs::path& scratch = folder.path();
  double load[1] = {0};
  getloadavg(load, 1);
  std::printf("Load when this began: %.1f\n", load[0]);
  if (what != "number") lengths(argv[0], scratch, hours);
  if (what != "length") numbers(scratch, recordings);
  return 0;
}
