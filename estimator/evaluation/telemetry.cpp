#include "estimator/evaluation/telemetry.h"

#include <algorithm>
#include <vector>

namespace searig::estimator {
namespace {

constexpr std::size_t least_context = 6;  // rows: a local cubic reaches for four where they are few

/// work(column) for the time and each channel.
template <typename Work>
void for_each_column(Work work) {
  work(&ModuleSignals::t_s);
  for (const ModuleChannel& channel : module_channels) work(channel.values);
}

}  // namespace

void WholeTelemetry::go_through(double context_s, const Take& take) const {
  const std::size_t rows = module_.t_s.size();
  if (rows <= rows_at_once_) return take({module_, 0, rows});
  BlockMaker blocks(context_s, take);
  for (std::size_t from = 0; from < rows; from += rows_at_once_)
    blocks.add(rows_of(module_, from, std::min(rows, from + rows_at_once_)));
  blocks.finish();
}

void BlockMaker::add(const ModuleSignals& rows) {
  for_each_column([&](auto column) {
    auto& to = kept_.*column;
    const auto& more = rows.*column;
    to.insert(to.end(), more.begin(), more.end());
  });
  const std::vector<double>& t = kept_.t_s;
  if (t.size() < from_ + 2 * least_context) return;
  const auto known = std::lower_bound(t.begin(), t.end(), t.back() - context_s_);
  const std::size_t to = std::min(std::size_t(known - t.begin()), t.size() - least_context);
  if (to <= from_) return;
  take_({kept_, from_, to});
  const auto needed = std::lower_bound(t.begin(), t.end(), t[to] - context_s_);
  const std::size_t drop =
      std::min(std::size_t(needed - t.begin()), to - std::min(to, least_context));
  for_each_column([&](auto column) {
    auto& values = kept_.*column;
    if (!values.empty()) values.erase(values.begin(), values.begin() + std::ptrdiff_t(drop));
  });
  from_ = to - drop;
}

void BlockMaker::finish() {
  take_({kept_, from_, kept_.t_s.size()});
}

}  // namespace searig::estimator
