// A recording evaluated without being loaded, where that can be done.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "estimator/evaluation/evaluation.h"
#include "estimator/model/model.h"

namespace searig::app {

struct EvaluatedRecording {
  estimator::Evaluation evaluation;
  std::vector<std::string> notes;  ///< the evaluation's, and what is to be said of the file
  bool streamed = false;           ///< whether it was not loaded
};

/// What open_session(), find_model() and evaluate_session() give, without the online estimate's
/// track. The module's rows are gone through and not kept in memory, unless something befell them
/// (see acquisition::NotInOrder), there are further devices, or the options need it; then all is
/// loaded. Throws as those do. `read_ahead` puts the reading into a thread of its own: for one
/// recording on a machine with nothing else to do.
EvaluatedRecording evaluate_recording(const std::filesystem::path& recording,
                                      const std::optional<std::filesystem::path>& model_file,
                                      const estimator::EvaluationOptions& options,
                                      bool read_ahead = false);

}  // namespace searig::app
