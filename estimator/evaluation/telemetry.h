// Telemetry that is gone through from its beginning to its end: it need not fit into memory.
#pragma once

#include <cstddef>
#include <functional>

#include "estimator/signals.h"

namespace searig::estimator {

/// The rows [from, to) of `rows`, with what lies around them.
struct TelemetryBlock {
  const ModuleSignals& rows;
  std::size_t from = 0, to = 0;
};

class Telemetry {
 public:
  using Take = std::function<void(const TelemetryBlock&)>;
  virtual ~Telemetry() = default;

  /// Calls `take` for one block after the other; each row is in [from, to) of exactly one, and all
  /// blocks have the same channels. Around that lie at least the rows within context_s and six on
  /// each side, as far as there are any: enough that a local fit comes out to the bit as over the
  /// whole. May be called again, and gives the same.
  virtual void go_through(double context_s, const Take& take) const = 0;
};

/// Telemetry that is in memory, as one block unless fewer rows are wanted at once. The signals must
/// outlive it.
class WholeTelemetry : public Telemetry {
 public:
  explicit WholeTelemetry(const ModuleSignals& module)
      : WholeTelemetry(module, module.t_s.size()) {}
  WholeTelemetry(const ModuleSignals& module, std::size_t rows_at_once)
      : module_(module), rows_at_once_(rows_at_once) {}
  void go_through(double context_s, const Take& take) const override;

 private:
  const ModuleSignals& module_;
  std::size_t rows_at_once_;
};

/// Turns rows that come in pieces into blocks with context.
class BlockMaker {
 public:
  BlockMaker(double context_s, Telemetry::Take take)
      : context_s_(context_s), take_(std::move(take)) {}

  /// The next rows; all pieces have the same channels.
  void add(const ModuleSignals& rows);
  /// After the last.
  void finish();

 private:
  ModuleSignals kept_;    // context before, and rows that wait for the context behind them
  std::size_t from_ = 0;  // the first that was not given yet
  double context_s_;
  Telemetry::Take take_;
};

}  // namespace searig::estimator
