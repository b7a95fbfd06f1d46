#include "estimator/diagnosis/fit/bench.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstring>

#include "estimator/physics/catalogue.h"
#include "estimator/physics/observation.h"
#include "estimator/physics/single_amplitude.h"

namespace searig::estimator {
namespace {

const Observation* as_observation(const Piece& piece) {
  return dynamic_cast<const Observation*>(piece.effect);
}

std::string key_of(const Piece& piece, double delay_s, double lag_s) {
  std::string key(sizeof(void*) * 2 + sizeof(double) * (piece.shape.size() + 2), '\0');
  char* at = key.data();
  const auto put = [&at](const void* from, std::size_t n) {
    if (n > 0) std::memcpy(at, from, n);  // an effect without a shape has no data to point to
    at += n;
  };
  put(&piece.effect, sizeof piece.effect);
  put(&piece.atom, sizeof piece.atom);
  put(&delay_s, sizeof delay_s);
  put(&lag_s, sizeof lag_s);
  put(piece.shape.data(), piece.shape.size() * sizeof(double));
  return key;
}

}  // namespace

Hypothesis all_but(Hypothesis hypothesis, std::size_t piece) {
  hypothesis.erase(hypothesis.begin() + std::ptrdiff_t(piece));
  return hypothesis;
}

Seen seen_by(const Hypothesis& hypothesis) {
  Seen seen;
  for (const auto& piece : hypothesis)
    if (piece.effect && piece.effect->path() == Path::observation)
      (piece.effect->name() == "rig.delay" ? seen.delay_s : seen.lag_s) = piece.shape[0];
  return seen;
}

Bench::Bench(Experiment experiment, Method method)
    : experiment_(std::move(experiment)), method_(method) {
  torque_ = Eigen::VectorXd::Zero(Eigen::Index(experiment_.motion.size()));
}

Eigen::MatrixXd Bench::stack(Path path, const Eigen::MatrixXd& features, double delay_s,
                             double lag_s) const {
  const Experiment& e = experiment_;
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(total_rows(), features.cols());
  const Eigen::Index split = e.loadcell_rows();
  if (e.has_spring() && path != Path::drive) {
    Eigen::MatrixXd at_loadcell = features;
    if (lag_s != 0.0)
      for (Eigen::Index c = 0; c < features.cols(); ++c)
        at_loadcell.col(c) = static_cast<const Observation*>(find_effect("rig.lag"))
                                 ->seen(e.motion.t, features.col(c), lag_s);
    out.topRows(split) =
        delay_s == 0.0
            ? e.at_loadcell.columns(at_loadcell)
            : Sampler(e.motion.t, e.loadcell_t, e.loadcell_width_s, -delay_s).columns(at_loadcell);
  }
  if (e.has_drive() && path == Path::drive)
    out.middleRows(split, e.drive_rows()) = e.at_drive.columns(features);
  if (e.has_drive() && path == Path::spring && e.has_spring())
    out.middleRows(split, e.drive_rows()) = -e.at_drive.columns(features);
  if (!e.has_spring() && path == Path::rig)
    out.middleRows(split, e.drive_rows()) = e.at_drive.columns(features);
  return out;
}

const Eigen::MatrixXd& Bench::raw_columns(const Piece& piece, double delay_s, double lag_s) const {
  const std::string key = key_of(piece, delay_s, lag_s);
  const auto it = raw_cache_.find(key);
  if (it != raw_cache_.end()) return it->second;
  auto made = piece.atom
                  ? stack(piece.atom->path, piece.atom->feature, delay_s, lag_s)
                  : stack(piece.effect->path(),
                          piece.effect->features(experiment_.motion, piece.shape), delay_s, lag_s);
  return raw_cache_.emplace(key, std::move(made)).first->second;
}

const Eigen::MatrixXd& Bench::columns(const Piece& piece, double delay_s, double lag_s) const {
  const std::string key = key_of(piece, delay_s, lag_s);
  const auto it = cache_.find(key);
  if (it != cache_.end()) return it->second;
  return cache_.emplace(key, (*whitening_)(raw_columns(piece, delay_s, lag_s))).first->second;
}

Eigen::MatrixXd Bench::screening_columns(const Piece& piece) const {
  if (const auto* observation = as_observation(piece)) {
    const Eigen::VectorXd change =
        observation->seen(experiment_.motion.t, torque_, piece.shape[0]) - torque_;
    return (*whitening_)(stack(Path::rig, change, 0.0, 0.0));
  }
  return columns(piece, 0.0, 0.0);
}

void Bench::learn_torque(const Hypothesis& hypothesis) {
  const Seen seen = seen_by(hypothesis);
  late_s_ = std::abs(seen.delay_s) + seen.lag_s;
  if (experiment_.has_spring()) {
    const Fit fitted = fit(hypothesis);
    Eigen::VectorXd spring = Eigen::VectorXd::Zero(torque_.size()), rig = spring;
    for (std::size_t i = 0; i < hypothesis.size(); ++i) {
      const Piece& piece = hypothesis[i];
      const Path path = piece.atom ? piece.atom->path : piece.effect->path();
      if (path != Path::spring && path != Path::rig) continue;
      const Eigen::MatrixXd features =
          piece.atom ? Eigen::MatrixXd(piece.atom->feature)
                     : piece.effect->features(experiment_.motion, piece.shape);
      (path == Path::spring ? spring : rig) += features * fitted.amplitudes(i);
    }
    experiment_.motion.spring_nm.assign(spring.begin(), spring.end());
    torque_ = spring + rig;
  }
  raw_cache_.clear();
  raw_nuisance_ = nuisances();
  set_noise(*whitening_);
}

void Bench::set_noise(Whitening whitening) {
  whitening_.emplace(std::move(whitening));
  cache_.clear();
  nuisance_ = (*whitening_)(raw_nuisance_);
}

void Bench::take_noise_of(const Bench& other) {
  if (raw_nuisance_.size() == 0) raw_nuisance_ = nuisances();
  gain_ = other.gain_;
  set_noise(Whitening(experiment_, other.whitening().loadcell(), other.whitening().drive()));
}

std::vector<int> Bench::blocks(double seconds) const {
  const double whole = experiment_.motion.t.back();
  const int n = std::max(2, int(std::lround(whole / seconds)));
  std::vector<int> out(std::size_t(total_rows()), -1);
  for (Eigen::Index i = 0; i < experiment_.rows(); ++i)
    out[std::size_t(i)] = std::clamp(int(n * experiment_.time(i) / whole), 0, n - 1);
  return out;
}

}  // namespace searig::estimator
