// searig-bench: what one predict and update costs, in nanoseconds and as a ratio to straight-line
// code for the same number of states. All in one run, the repetitions interleaved and the least
// time taken, for other work on the machine only ever adds.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "tests/bench/rivals.h"

namespace searig::bench {
namespace {

/// A spring with a cubic and a viscous term at 1 kHz; a power of two of samples.
std::vector<Sample> stream() {
  std::mt19937 random(1);
  std::normal_distribution<double> normal(0, 0.05);
  std::vector<Sample> out(4096);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double A = 0.15, phase = 2 * M_PI * 0.5 * static_cast<double>(i) / 1000;
    const double theta = A * std::sin(phase);
    Sample& s = out[i];
    s = {{theta, theta * theta * theta / (A * A), A * std::cos(phase)}, normal(random), 1};
    s.T += 80 * s.phi[0] + 20 * s.phi[1] + 5 * s.phi[2];
  }
  return out;
}

template <class Filter>
void run(benchmark::State& state) {
  static const std::vector<Sample> samples = stream();
  Filter filter;
  std::size_t i = 0;
  for (auto _ : state) {
    filter.step(samples[i++ & 4095]);
    benchmark::ClobberMemory();
    benchmark::DoNotOptimize(filter);
  }
}

template <int n, class StraightLine>
void add() {
  const auto name = [](const char* what) { return std::string(what) + "/" + std::to_string(n); };
  benchmark::RegisterBenchmark(name("straight line").c_str(), run<StraightLine>);
  benchmark::RegisterBenchmark(name("searig ssukf").c_str(), run<Ours<n>>);
  benchmark::RegisterBenchmark(name("searig moments").c_str(), run<Moments<n>>);
  benchmark::RegisterBenchmark(name("searig linear").c_str(), run<Linear<n>>);
  benchmark::RegisterBenchmark(name("searig rls").c_str(), run<LeastSquares<n>>);
  benchmark::RegisterBenchmark(name("extended kalman").c_str(), run<Extended<n>>);
}

/// Keeps the least time of each benchmark.
class Least : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& r : runs) {
      if (r.run_type != Run::RT_Iteration || r.error_occurred) continue;
      const auto [it, is_new] = least_.try_emplace(r.run_name.function_name, 1e300);
      it->second = std::min(it->second, r.GetAdjustedCPUTime());
      if (is_new) order_.push_back(it->first);
    }
  }
  void print() {
    std::printf("one predict and update: least ns | ratio to straight-line code of the same n\n");
    std::printf("%-18s%18s%18s%18s\n", "", "n = 1", "n = 2", "n = 3");
    std::ranges::sort(order_, {}, [](const std::string& name) { return rank(name); });
    std::string row;
    for (const std::string& name : order_) {
      const auto slash = name.find('/');
      const std::string what = name.substr(0, slash), n = name.substr(slash + 1);
      if (what != row) std::printf("%s%-18s", row.empty() ? "" : "\n", what.c_str());
      row = what;
      std::printf("%10.1f (%5.2f)", least_[name], least_[name] / least_["straight line/" + n]);
    }
    std::printf("\n");
  }

 private:
  static std::pair<int, std::string> rank(const std::string& name) {
    static const std::vector<std::string> rows = {"straight line",  "searig ssukf",
                                                  "searig moments", "searig linear",
                                                  "searig rls",     "extended kalman"};
    const auto slash = name.find('/');
    const auto row = std::ranges::find(rows, name.substr(0, slash)) - rows.begin();
    return {static_cast<int>(row), name.substr(slash + 1)};
  }

  std::map<std::string, double> least_;
  std::vector<std::string> order_;
};

}  // namespace
}  // namespace searig::bench

int main(int argc, char** argv) {
  using namespace searig::bench;
  std::vector<char*> arguments(argv, argv + argc);
  std::string defaults[] = {"--benchmark_repetitions=25", "--benchmark_min_time=0.02",
                            "--benchmark_enable_random_interleaving=true"};
  for (std::string& option : defaults) arguments.insert(arguments.begin() + 1, option.data());
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 2;
  add<1, StraightLine1>();
  add<2, StraightLine2>();
  add<3, StraightLine3>();
  Least least;
  benchmark::RunSpecifiedBenchmarks(&least);
  least.print();
}
