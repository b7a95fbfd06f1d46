#include "app/batch/columns.h"

#include <limits>

#include "acquisition/recording/text_file.h"

namespace searig::app {
namespace {

using nlohmann::json;

std::string joined(const json& texts) {
  std::string all;
  for (const json& text : texts)
    all.append(all.empty() ? "" : "; ").append(text.get<std::string>());
  return all;
}

std::string notes_of(const json& answer) {
  return joined(answer.value("notes", json::array()));
}

/// "spring.viscous; drive.coulomb": what a diagnosis asserts.
std::string effects_of(const json& answer) {
  json names = json::array();
  for (const json& finding : answer.value("findings", json::array()))
    names.push_back(finding.at("effect"));
  return joined(names);
}

/// How many effects cannot be told apart.
std::string undecidable_of(const json& answer) {
  if (!answer.contains("undecidable")) return {};
  return std::to_string(answer.at("undecidable").size());
}

/// The stiffness that fits the recording, of the diagnosis's model.
constexpr const char* diagnosed_k = "/model/spring.linear/k_nm_per_rad";

}  // namespace

double number_at(const json& answer, const std::string& pointer) {
  const json::json_pointer place(pointer);
  if (!answer.contains(place) || !answer.at(place).is_number())
    return std::numeric_limits<double>::quiet_NaN();
  return answer.at(place);
}

std::string SummaryColumn::text(const json& answer) const {
  if (special) return special(answer);
  const json::json_pointer place(pointer);
  if (!answer.contains(place)) return {};
  const json& value = answer.at(place);
  if (value.is_string()) return value;
  if (value.is_boolean()) return value ? "1" : "0";
  std::string number;
  if (value.is_number()) acquisition::append_number(number, value);
  return number;
}

const std::vector<SummaryColumn>& columns_of(const std::string& command) {
  static const std::vector<SummaryColumn> evaluation{
      {"path", nullptr, "/path"},
      {"name", nullptr, "/name"},
      {"seconds", nullptr, "/seconds"},
      {"best_fit_k_nm_per_rad", nullptr, "/models/best_fit/k_nm_per_rad"},
      {"best_fit_offset_nm", nullptr, "/models/best_fit/offset_nm"},
      {"best_fit_error_percent", nullptr, "/models/best_fit/error_percent"},
      {"best_fit_rmse_nm", nullptr, "/models/best_fit/rmse_nm"},
      {"online_initial_k_nm_per_rad", nullptr, "/models/online/initial_k_nm_per_rad"},
      {"online_k_nm_per_rad", nullptr, "/models/online/k_nm_per_rad"},
      {"online_error_percent", nullptr, "/models/online/error_percent"},
      {"online_rmse_nm", nullptr, "/models/online/rmse_nm"},
      {"online_trust_weight_s", nullptr, "/models/online/trust_weight_s"},
      {"online_converged_after_s", nullptr, "/models/online/converged_after_s"},
      {"current_gain_nm_per_a", nullptr, "/models/current/gain_nm_per_a"},
      {"current_offset_nm", nullptr, "/models/current/offset_nm"},
      {"current_error_percent", nullptr, "/models/current/error_percent"},
      {"current_rmse_nm", nullptr, "/models/current/rmse_nm"},
      {"current_independent_of_loadcell", nullptr, "/models/current/independent_of_loadcell"},
      {"notes", notes_of, nullptr},
      {"failed", nullptr, "/why"}};
  static const std::vector<SummaryColumn> diagnoses{
      {"path", nullptr, "/path"},
      {"name", nullptr, "/name"},
      {"verdict", nullptr, "/verdict"},
      {"findings", effects_of, nullptr},
      {"first_probability", nullptr, "/findings/0/probability"},
      {"undecidable", undecidable_of, nullptr},
      {"unexplained_share", nullptr, "/unexplained/share"},
      {"k_nm_per_rad", nullptr, diagnosed_k},
      {"spring_as_given_nm", nullptr, "/paths/spring/heldout_rmse_nm/as_given"},
      {"spring_before_nm", nullptr, "/paths/spring/heldout_rmse_nm/before"},
      {"spring_after_nm", nullptr, "/paths/spring/heldout_rmse_nm/after"},
      {"spring_noise_floor_nm", nullptr, "/paths/spring/noise_floor_nm"},
      {"drive_as_given_nm", nullptr, "/paths/drive/heldout_rmse_nm/as_given"},
      {"drive_before_nm", nullptr, "/paths/drive/heldout_rmse_nm/before"},
      {"drive_after_nm", nullptr, "/paths/drive/heldout_rmse_nm/after"},
      {"drive_noise_floor_nm", nullptr, "/paths/drive/noise_floor_nm"},
      {"notes", notes_of, nullptr},
      {"failed", nullptr, "/why"}};
  return command == "evaluate" ? evaluation : diagnoses;
}

}  // namespace searig::app
