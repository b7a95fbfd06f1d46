#include "acquisition/recorder/recorder.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <stdexcept>
#include <thread>
#include <utility>

#include "acquisition/source/decode.h"

namespace searig::acquisition {
namespace {

constexpr double look_every_s = 0.05;
constexpr double progress_every_s = 0.2;

std::string kept(double seconds) {
  char words[80];
  std::snprintf(words, sizeof words, " The %.1f s until then are kept.", seconds);
  return words;
}

void sleep_s(double seconds) {
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

}  // namespace

void Lines::start() {
  module.start();
  loadcell.start();
}

void Lines::stop() {
  module.stop();
  loadcell.stop();
}

Recorder::Recorder(RecorderOptions options, std::shared_ptr<Lines> lines)
    : options_(std::move(options)),
      file_(options_.file),
      lines_(std::move(lines)),
      module_(std::make_shared<Listener>(StreamId::module, framing_of(lines_->module.name()),
                                         std::nullopt, file_)),
      loadcell_(std::make_shared<Listener>(StreamId::loadcell, framing_of(lines_->loadcell.name()),
                                           options_.loadcell, file_)),
      started_s_(host_now_s()) {
  settings_.program = options_.file.program;
  settings_.started = options_.started;
  settings_.lever_arm_m = options_.lever_arm_m.value_or(1.0);
  settings_.calibration = options_.calibration;
  settings_.model_toml = options_.model_toml;
  settings_.recorded = options_.notes;
  settings_.module.source = lines_->module.name();
  settings_.loadcell.source = lines_->loadcell.name();
  settings_.module.baud = lines_->module.baud();
  settings_.loadcell.baud = lines_->loadcell.baud();
  std::vector<Entry> first{NewSettings{started_s_, settings_}};
  if (!options_.lever_arm_m)
    first.push_back(Event{started_s_, "loadcell", "lever arm",
                          "The lever arm was not given: it is taken as 1 m."});
  file_.push(first);
}

Recorder::Recorder(RecorderOptions options, std::unique_ptr<Source> module,
                   std::unique_ptr<Source> loadcell)
    : Recorder(std::move(options),
               std::make_shared<Lines>(std::move(module), std::move(loadcell))) {
  owns_lines_ = true;
}

/// The lines let go of the listeners before the file goes.
Recorder::~Recorder() {
  lines_->module.remove(module_);
  lines_->loadcell.remove(loadcell_);
}

RecorderState Recorder::run(const std::atomic<bool>& stop,
                            const std::function<void(const RecorderState&)>& progress) {
  lines_->module.add(module_);
  lines_->loadcell.add(loadcell_);
  lines_->start();
  watch(stop, progress);
  if (owns_lines_) lines_->stop();
  lines_->module.remove(module_);
  lines_->loadcell.remove(loadcell_);
  settle(host_now_s());
  const RecorderState end = state();
  file_.finish();
  if (const std::string why = file_.failure(); !why.empty())
    throw std::runtime_error(why + kept(end.seconds));
  refuse_silence(*module_, lines_->module, "module");
  refuse_silence(*loadcell_, lines_->loadcell, "load cell");
  return {end.seconds, end.module, end.loadcell, file_.clock(), file_.bytes_written()};
}

void Recorder::mark(const std::string& kind, const std::string& text) {
  std::vector<Entry> entries{Event{host_now_s(), "user", kind, text}};
  file_.push(entries);
}

void Recorder::watch(const std::atomic<bool>& stop,
                     const std::function<void(const RecorderState&)>& progress) {
  const double end_s = started_s_ + options_.seconds;
  double progress_s = started_s_;
  for (double now_s = started_s_; !stop && now_s < end_s && file_.failure().empty();
       now_s = host_now_s()) {
    settle(now_s);
    if (progress && now_s >= progress_s) {
      progress(state());
      progress_s = now_s + progress_every_s;
    }
    sleep_s(std::min(look_every_s, std::max(0.0, end_s - now_s)));
  }
}

/// What the devices say of themselves, once they have.
void Recorder::settle(double now_s) {
  const auto describe = [](const Listener::Report& report, mcap::StreamSettings& settings) {
    if (!report.identity) return false;
    const std::string words = words_of(*report.identity);
    return std::exchange(settings.device, words) != words;
  };
  const Listener::Report module = module_->report();
  bool news = describe(module, settings_.module);
  news = describe(loadcell_->report(), settings_.loadcell) || news;
  if (!news) return;
  if (module.identity && module.identity->gear_ratio > 0.0)
    settings_.gear_ratio = module.identity->gear_ratio;
  std::vector<Entry> entries{NewSettings{now_s, settings_}};
  file_.push(entries);
}

RecorderState Recorder::state() const {
  return {host_now_s() - started_s_, module_->report().counters, loadcell_->report().counters,
          file_.clock(), file_.bytes_written()};
}

void Recorder::refuse_silence(const Listener& listener, const Line& line, const char* name) const {
  const Listener::Report report = listener.report();
  if (report.counters.samples > 0) return;
  throw std::runtime_error(options_.file.path.string() + ": no sample came from the " + name +
                           " (" + line.name() + ")" +
                           (report.trouble.empty() ? "." : ": " + report.trouble));
}

}  // namespace searig::acquisition
