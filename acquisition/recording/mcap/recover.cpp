#include "acquisition/recording/mcap/recover.h"

#include <algorithm>
#include <memory>

namespace searig::acquisition::mcap {
namespace {

class Copier : public Handler {
 public:
  Copier(const std::string& program, const Writer::Sink& sink) : program_(program), sink_(sink) {}

  void channel(const Channel& channel, const Schema& schema) override {
    if (!out_) out_ = std::make_unique<Writer>(sink_, program_);
    ids_[channel.id] = out_->add_channel(channel, schema);
    topics_[channel.id] = channel.topic;
  }
  void message(const Message& message) override {
    out_->add(ids_.at(message.channel), message.log_time_ns, message.data);
    const std::uint64_t at = message.log_time_ns;
    first_ns_ = recovered_.messages.empty() ? at : std::min(first_ns_, at);
    last_ns_ = std::max(last_ns_, at);
    ++recovered_.messages[topics_.at(message.channel)];
  }
  void chunk_ended() override {
    if (out_) out_->end_chunk();
  }
  void attachment(const Attachment& attachment) override {
    if (out_) out_->attach(attachment);
  }

  Recovered finish(Ending ending) {
    recovered_.ending = std::move(ending);
    recovered_.seconds = 1e-9 * static_cast<double>(last_ns_ - first_ns_);
    if (!out_) return recovered_;
    out_->add_metadata("searig",
                       {{"program", program_},
                        {"recovered", recovered_.ending.end == End::whole
                                          ? "from a whole file"
                                          : "from a file that " + recovered_.ending.why}});
    out_->finish();
    return recovered_;
  }

 private:
  std::string program_;
  const Writer::Sink& sink_;
  std::unique_ptr<Writer> out_;
  std::map<std::uint16_t, std::uint16_t> ids_;
  std::map<std::uint16_t, std::string> topics_;
  std::uint64_t first_ns_ = 0, last_ns_ = 0;
  Recovered recovered_;
};

}  // namespace

Recovered recover(std::string_view bytes, const std::string& program, const Writer::Sink& sink) {
  Copier copier(program, sink);
  return copier.finish(read(bytes, copier));
}

}  // namespace searig::acquisition::mcap
