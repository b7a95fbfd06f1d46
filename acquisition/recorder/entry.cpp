#include "acquisition/recorder/entry.h"

namespace searig::acquisition {
namespace {

struct Writing {
  mcap::RecordingWriter& out;

  void operator()(const RawPiece& raw) const {
    out.raw(raw.device, raw.host_s,
            {reinterpret_cast<const char*>(raw.bytes.data()), raw.bytes.size()});
  }
  void operator()(const Columns& columns) const { out.set_columns(columns.device, columns.names); }
  void operator()(const SampleRow& row) const { out.sample(row.device, row.host_s(), row.values); }
  void operator()(const CountersRow& row) const {
    out.counters(row.device, counter_names, row.values);
  }
  void operator()(const PingRow& row) const { out.ping(row.device, ping_names, row.values); }
  void operator()(const Event& event) const { out.event(event); }
  void operator()(const NewSettings& s) const { out.settings(s.settings, s.host_s); }
};

}  // namespace

void write_entry(const Entry& entry, mcap::RecordingWriter& out) {
  std::visit(Writing{out}, entry);
}

}  // namespace searig::acquisition
