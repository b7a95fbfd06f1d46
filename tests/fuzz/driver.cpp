// Stands in for libFuzzer where there is none: seeded inputs, for a number of runs or of seconds.
//   decoder_fuzz --runs 3000 --seed 1
//   decoder_fuzz --seconds 60 --seed 2
//   decoder_fuzz FILE...               what a fuzzer found
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

using Bytes = std::vector<std::uint8_t>;

/// Random bytes, or a former input with some of its bytes changed, left out or doubled.
Bytes next_input(std::mt19937_64& random, const Bytes& former) {
  Bytes bytes;
  if (former.empty() || random() % 3 == 0) {
    bytes.resize(random() % 2000);
    const std::uint64_t span = 1 + random() % 256;
    for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random() % span);
    return bytes;
  }
  bytes = former;
  for (std::uint64_t change = random() % 20; change > 0 && !bytes.empty(); --change) {
    const auto at = bytes.begin() + static_cast<std::ptrdiff_t>(random() % bytes.size());
    switch (random() % 3) {
      case 0:
        *at = static_cast<std::uint8_t>(random());
        break;
      case 1:
        bytes.erase(at);
        break;
      default:
        bytes.insert(at, *at);
    }
  }
  return bytes;
}

double now_s() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

}  // namespace

int main(int argc, char** argv) {
  std::uint64_t runs = ~std::uint64_t{0}, seed = 1, done = 0;
  double seconds = 1e9;
  bool replayed = false;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--runs" && i + 1 < argc) {
      runs = std::strtoull(argv[++i], nullptr, 10);
    } else if (word == "--seconds" && i + 1 < argc) {
      seconds = std::strtod(argv[++i], nullptr);
    } else if (word == "--seed" && i + 1 < argc) {
      seed = std::strtoull(argv[++i], nullptr, 10);
    } else {
      std::ifstream file(word, std::ios::binary);
      const Bytes bytes{std::istreambuf_iterator<char>(file), {}};
      LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
      replayed = true;
    }
  }
  if (replayed) return 0;
  std::mt19937_64 random(seed);
  Bytes input;
  for (const double end_s = now_s() + seconds; done < runs && now_s() < end_s; ++done) {
    input = next_input(random, input);
    LLVMFuzzerTestOneInput(input.data(), input.size());
  }
  std::printf("%llu inputs, none of them broke it\n", static_cast<unsigned long long>(done));
}
