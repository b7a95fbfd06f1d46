// Noise that is correlated in time: an autoregressive model per block of rows, and whitening by it.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "estimator/diagnosis/rows/experiment.h"

namespace searig::estimator {

/// e_i = (x_i - sum_k phi_k x_{i-k}) / sd is white with unit variance.
struct Autoregression {
  Eigen::VectorXd phi;
  double sd = 1.0;
};

/// Share of the noise's power that the means over so many rows keep: 1/rows where it is white.
double slow_share(const Autoregression& noise, Eigen::Index rows);

/// Yule-Walker on the residual's own neighbours; rows that are not usable take no part.
Autoregression fit_autoregression(const Eigen::VectorXd& residual, const std::vector<bool>& usable,
                                  int order);

/// Whitens stacked columns block by block. A row counts where it and the `order` rows before it
/// are usable and no row is missing between them; other rows become zero.
class Whitening {
 public:
  static constexpr int order = 5;

  /// Noise that is known already, as of another experiment at the same rates.
  Whitening(const Experiment& experiment, Autoregression loadcell, Autoregression drive);
  /// Without memory the noise is taken to be white.
  Whitening(const Experiment& experiment, const Eigen::VectorXd& residual, bool memory = true);

  Eigen::MatrixXd operator()(const Eigen::MatrixXd& columns) const;
  const std::vector<bool>& counts() const { return counts_; }
  Eigen::Index used_rows() const;
  Eigen::Index split() const { return split_; }  ///< first drive row
  const Autoregression& loadcell() const { return loadcell_; }
  const Autoregression& drive() const { return drive_; }

 private:
  Autoregression loadcell_, drive_;
  Eigen::Index split_, rows_;
  std::vector<bool> counts_;
  std::vector<double> weight_;
};

}  // namespace searig::estimator
