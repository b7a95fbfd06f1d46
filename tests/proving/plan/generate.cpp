#include "tests/proving/plan/generate.h"

#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <fstream>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "tests/proving/truth/write.h"

namespace searig::proving {

void generate(const std::vector<Item>& items, const std::filesystem::path& directory, int threads) {
  std::filesystem::create_directories(directory / "recordings");
  std::vector<nlohmann::json> answers(items.size());
  std::atomic<std::size_t> next{0}, done{0};
  const bool talk = isatty(STDERR_FILENO) != 0;
  std::mutex guard;
  std::string failure;
  const auto work = [&] {
    for (std::size_t i = next++; i < items.size(); i = next++) {
      try {
        const Case c = make_case(items[i]);
        write_recording(c, directory / "recordings" / items[i].name);
        answers[i] = answer_for(c);
      } catch (const std::exception& e) {
        const std::scoped_lock lock(guard);
        failure = items[i].name + ": " + e.what();
        next = items.size();
      }
      if (talk)
        std::fprintf(stderr, "\r%zu of %zu%s", ++done, items.size(),
                     done == items.size() ? "\n" : "");
    }
  };
  std::vector<std::jthread> pool;
  for (int i = 0; i < threads; ++i) pool.emplace_back(work);
  pool.clear();
  if (!failure.empty()) throw std::runtime_error(failure);
  nlohmann::json sealed = nlohmann::json::object();
  for (std::size_t i = 0; i < items.size(); ++i) sealed[items[i].name] = answers[i];
  std::ofstream(directory / "answers.json") << sealed.dump(1) << '\n';
}

}  // namespace searig::proving
