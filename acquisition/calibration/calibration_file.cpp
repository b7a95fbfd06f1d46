// A calibration as TOML: written to be read by people too, every number with all of its digits.
#include <toml++/toml.h>

#include <cmath>

#include "acquisition/calibration/loadcell_calibration.h"
#include "acquisition/error.h"
#include "acquisition/recording/text_file.h"

namespace searig::acquisition {
namespace {

constexpr std::string_view format = "searig-calibration/1";

std::string number(double value) {
  std::string text;
  append_number(text, value);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";  // TOML tells 1 from 1.0
  return text;
}

std::string quoted(const std::string& text) {
  return std::string("\"").append(text).append("\"");
}

std::string list(const std::vector<double>& values) {
  std::string text = "[";
  for (const double value : values) text.append(text.size() > 1 ? ", " : "").append(number(value));
  return text.append("]");
}

class Reading {
 public:
  Reading(const toml::table& table, const std::string& file) : table_(table), file_(file) {}

  [[noreturn]] void refuse(const std::string& what) const {
    throw InputError(file_ + ": " + what + ".");
  }
  double number(std::string_view key) const {
    const auto value = table_[key].value<double>();
    if (!value || !std::isfinite(*value)) refuse(std::string(key) + " must be a finite number");
    return *value;
  }
  std::vector<double> numbers(std::string_view key) const {
    std::vector<double> values;
    const toml::array* array = table_[key].as_array();
    if (!array) refuse(std::string(key) + " must be a list of numbers");
    for (const toml::node& node : *array) {
      const auto value = node.value<double>();
      if (!value || !std::isfinite(*value)) refuse(std::string(key) + " must hold numbers");
      values.push_back(*value);
    }
    return values;
  }

 private:
  const toml::table& table_;
  const std::string& file_;
};

}  // namespace

std::string to_toml(const LoadcellCalibration& c) {
  std::vector<double> forces, counts;
  for (const KnownWeight& weight : c.weights) {
    forces.push_back(weight.force_n);
    counts.push_back(weight.counts);
  }
  std::string toml = "# " + describe(c) + "\n";
  const auto put = [&](const char* key, const std::string& value) {
    toml.append(key).append(" = ").append(value).append("\n");
  };
  put("format", quoted(std::string(format)));
  put("date", quoted(c.date));
  put("tare_counts", number(c.tare_counts));
  put("tare_ci95_counts", number(c.tare_ci95_counts));
  put("newton_per_count", number(c.newton_per_count));
  put("newton_per_count_ci95", number(c.newton_per_count_ci95));
  put("residual_sd_n", number(c.residual_sd_n));
  put("lever_arm_m", number(c.lever_arm_m));
  put("known_force_n", list(forces));
  put("read_counts", list(counts));
  put("residuals_n", list(c.residuals_n));
  return toml;
}

LoadcellCalibration parse_calibration(std::string_view text, const std::string& file) {
  toml::table table;
  try {
    table = toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    throw InputError(file + ", line " + std::to_string(error.source().begin.line) + ": " +
                     std::string(error.description()) + ".");
  }
  const Reading read(table, file);
  if (table["format"].value<std::string>() != format)
    read.refuse("format must be \"" + std::string(format) + "\"");
  LoadcellCalibration out;
  out.date = table["date"].value_or(std::string());
  out.tare_counts = read.number("tare_counts");
  out.tare_ci95_counts = read.number("tare_ci95_counts");
  out.newton_per_count = read.number("newton_per_count");
  out.newton_per_count_ci95 = read.number("newton_per_count_ci95");
  out.residual_sd_n = read.number("residual_sd_n");
  out.lever_arm_m = read.number("lever_arm_m");
  if (out.newton_per_count == 0.0) read.refuse("newton_per_count must not be zero");
  if (out.lever_arm_m == 0.0) read.refuse("lever_arm_m must not be zero");
  const std::vector<double> forces = read.numbers("known_force_n");
  const std::vector<double> counts = read.numbers("read_counts");
  out.residuals_n = read.numbers("residuals_n");
  if (forces.size() != counts.size() || forces.size() != out.residuals_n.size())
    read.refuse("known_force_n, read_counts and residuals_n must be of one length");
  for (std::size_t i = 0; i < forces.size(); ++i) out.weights.push_back({forces[i], counts[i]});
  return out;
}

}  // namespace searig::acquisition
