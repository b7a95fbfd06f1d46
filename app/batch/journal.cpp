#include "app/batch/journal.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "acquisition/error.h"
#include "acquisition/recording/csv_row.h"
#include "acquisition/recording/text_file.h"

namespace searig::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* format = "searig-batch/1";

json to_line(const Plan& plan) {
  return {{"format", format},          {"command", plan.command},
          {"settings", plan.settings}, {"recordings", plan.recordings},
          {"list", plan.list},         {"shard", {plan.shard.number, plan.shard.of}}};
}

Plan plan_of(const json& line) {
  return {line.at("command"),
          line.at("settings"),
          line.at("recordings"),
          line.at("list"),
          {line.at("shard").at(0), line.at("shard").at(1)}};
}

Entry entry_of(const json& line) {
  return {line.at("index"), line.at("path"), line.at("fingerprint"), line.at("answer")};
}

/// Non-UTF-8 in a path is replaced, here and where it is looked up.
std::string text_of(const json& line) {
  return line.dump(-1, ' ', false, json::error_handler_t::replace);
}

std::string key_of(const std::string& path) {
  return text_of(json(path));
}

[[noreturn]] void refuse(const fs::path& file, const std::string& why) {
  throw std::runtime_error(file.string() + ": " + why + ".");
}

/// Without a command where there is no whole line of a plan.
JournalText parse_journal(const fs::path& file) {
  const std::string text = acquisition::read_text_file(file);
  JournalText out;
  bool planned = false;
  for (std::size_t at = 0; at < text.size();) {
    const std::string_view line = acquisition::line_at(text, at, at);
    if (text[at - 1] != '\n') break;  // torn: what it was about is done again
    out.whole_bytes = at;
    try {
      const json parsed = json::parse(line);
      if (!parsed.contains("format")) {
        if (planned) out.entries.push_back(entry_of(parsed));
        continue;
      }
      Plan plan = plan_of(parsed);
      if (plan.command != out.plan.command || plan.settings != out.plan.settings)
        out.entries.clear();
      out.plan = std::move(plan);
      planned = parsed.at("format") == format;
    } catch (const json::exception&) {  // a line that the disk has spoilt
    }
  }
  return out;
}

}  // namespace

JournalText read_journal(const fs::path& folder) {
  const fs::path file = folder / journal_name;
  JournalText out = parse_journal(file);
  if (out.plan.command.empty())
    throw acquisition::InputError(file.string() + ": is no journal of a batch.");
  return out;
}

Journal::Journal(const fs::path& folder, const Plan& plan, bool resume)
    : file_(folder / journal_name) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) refuse(folder, "cannot be made: " + error.message());
  descriptor_ = open(file_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor_ < 0) refuse(file_, std::string("cannot be written: ") + std::strerror(errno));
  try {
    if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0) refuse(file_, "another batch is writing it");
    if (fs::file_size(file_) > 0) {
      if (!resume) refuse(folder, "holds a batch already; --resume goes on with it");
      JournalText before = parse_journal(file_);
      if (before.plan.command.empty() && before.whole_bytes > 0)
        refuse(file_, "is no journal of a batch");
      if (ftruncate(descriptor_, off_t(before.whole_bytes)) != 0)
        refuse(file_, std::string("cannot be cut back: ") + std::strerror(errno));
      const bool same =
          before.plan.command == plan.command && before.plan.settings == plan.settings;
      for (Entry& entry : before.entries)
        if (same && !entry.failed()) kept_[key_of(entry.path)] = std::move(entry);
    }
    write_line(to_line(plan));
  } catch (...) {
    close(descriptor_);
    throw;
  }
}

Journal::~Journal() {
  fdatasync(descriptor_);
  close(descriptor_);
}

const Entry* Journal::find(const std::string& path, const std::string& fingerprint) const {
  const auto found = kept_.find(key_of(path));
  if (found == kept_.end() || found->second.fingerprint != fingerprint) return nullptr;
  return &found->second;
}

void Journal::append(const Entry& entry) {
  const json line{{"index", entry.index},
                  {"path", entry.path},
                  {"fingerprint", entry.fingerprint},
                  {"answer", entry.answer}};
  const std::scoped_lock lock(mutex_);
  write_line(line);
}

void Journal::write_line(const json& line) {
  const std::string text = text_of(line) + '\n';
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t wrote = write(descriptor_, text.data() + done, text.size() - done);
    if (wrote < 0 && errno == EINTR) continue;
    if (wrote < 0) refuse(file_, std::string("cannot be written: ") + std::strerror(errno));
    done += std::size_t(wrote);
  }
  const auto now_s = std::chrono::duration_cast<std::chrono::seconds>(
                         std::chrono::steady_clock::now().time_since_epoch())
                         .count();
  if (std::exchange(synced_at_s_, now_s) != now_s) fdatasync(descriptor_);
}

}  // namespace searig::app
