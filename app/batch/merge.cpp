#include "app/batch/merge.h"

#include <optional>
#include <string>

#include "acquisition/error.h"
#include "app/batch/journal.h"

namespace searig::app {
namespace {

namespace fs = std::filesystem;

void refuse_other_batch(const Plan& plan, const fs::path& folder, const Plan& first,
                        const fs::path& first_folder) {
  const auto refuse = [&](const std::string& what) {
    throw acquisition::InputError(folder.string() + ": has another " + what + " than " +
                                  first_folder.string() + "; they are no shards of one batch.");
  };
  if (plan.command != first.command) refuse("command");
  if (plan.settings != first.settings) refuse("setting or program version");
  if (plan.recordings != first.recordings || plan.list != first.list) refuse("list of recordings");
  if (plan.shard.of != first.shard.of) refuse("number of shards");
}

}  // namespace

Summary merge_shards(const std::vector<fs::path>& folders) {
  std::optional<Plan> first;
  std::vector<std::optional<nlohmann::json>> answers;
  for (const fs::path& folder : folders) {
    JournalText journal = read_journal(folder);
    if (!first) first = journal.plan;
    refuse_other_batch(journal.plan, folder, *first, folders.front());
    const auto& [number, of] = journal.plan.shard;
    answers.resize(first->recordings);
    for (Entry& entry : journal.entries)  // the later one of two is the newer
      if (entry.index < answers.size() && entry.index % of == number - 1)
        answers[entry.index] = std::move(entry.answer);
  }
  Summary summary{first->command, {}};
  std::size_t missing = 0, first_missing = 0;
  for (std::size_t i = answers.size(); i-- > 0;)
    if (!answers[i]) ++missing, first_missing = i;
  if (missing > 0) {
    const auto& of = first->shard.of;
    throw acquisition::InputError(std::to_string(missing) + " of " +
                                  std::to_string(answers.size()) +
                                  " recordings are not done yet; the first belongs to shard " +
                                  std::to_string(first_missing % of + 1) + "/" +
                                  std::to_string(of) + ", which --resume finishes.");
  }
  for (auto& answer : answers) summary.answers.push_back(std::move(*answer));
  return summary;
}

}  // namespace searig::app
