// Features without a name, each kind by its own rule: bumps, hinges, waves, events, episodes.
#pragma once

#include <string>
#include <vector>

#include "estimator/diagnosis/fit/bench.h"

namespace searig::estimator {

/// Appends atoms to a list. Carriers are on the motion's samples; without one it is 1. Channels
/// that the recording lacks, and features that are zero throughout, add nothing.
class AtomCollector {
 public:
  using Array = Eigen::ArrayXd;

  /// The atoms keep a reference to the motion.
  AtomCollector(const Motion& motion, std::vector<Atom>& out) : m_(motion), out_(out) {}

  /// Something that happens only near one value of x: a notch, a snag, a missing code.
  void bumps(const std::vector<double>& x, const std::string& channel, Path path, int count,
             const Array& carrier = {},
             const std::string& what = "something that happens only near one value");

  /// Something that begins beyond a value of x: a stop, a snag to one side, saturation.
  void hinges(const std::vector<double>& x, const std::string& channel, Path path);

  /// A wave over an angle: an eccentric encoder, a guide that binds once per turn.
  void waves(const std::vector<double>& angle, const std::string& channel, Path path, int count,
             const Array& carrier = {}, double first = 1.0);

  /// Something that changes at one time: a step, or another size from then on.
  void events(const std::string& what, Path path, const Array& carrier, int count);

  /// Something that lasts for a while only.
  void episodes(Path path, int count, const Array& carrier);

  void shaped(std::string what, Path path, std::string channel, const std::vector<double>& x,
              const Array& feature);

 private:
  using Make = decltype(Atom::at);

  void add(std::string what, Path path, std::string channel, double from, double to,
           const Array& feature, Make at = {});
  void add(std::string what, Path path, std::string channel, double from, double to,
           const Make& at);

  const Motion& m_;
  std::vector<Atom>& out_;
};

}  // namespace searig::estimator
