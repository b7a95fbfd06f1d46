#include "app/session/motion_spec.h"

#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "acquisition/recording/text_file.h"

namespace searig::app {
namespace {

/// Reads the values of one file and names the place of what it cannot use.
class Reader {
 public:
  explicit Reader(std::string file) : file_(std::move(file)) {}

  [[noreturn]] void refuse(const toml::node& node, const std::string& what) const {
    throw std::invalid_argument(file_ + ": line " + std::to_string(node.source().begin.line) +
                                ": " + what);
  }

  /// A misspelled key must not be passed over in silence.
  void only(const toml::table& table, std::initializer_list<std::string_view> known) const {
    for (const auto& [key, node] : table) {
      if (std::ranges::find(known, key.str()) == known.end())
        refuse(node, "there is no " + std::string(key.str()) + " in a spec");
    }
  }

  void magnitude(const toml::table& table, const char* key, double& value) const {
    const auto* node = table.get(key);
    if (!node) return;
    const auto number = node->value<double>();
    if (!number || !(*number >= 0.0))
      refuse(*node, std::string(key) + " must be a number, not below 0");
    value = *number;
  }

  void list(const toml::table& table, const char* key, std::vector<double>& values) const {
    const auto* node = table.get(key);
    if (!node) return;
    values.clear();
    if (const auto* array = node->as_array()) {
      for (const auto& entry : *array) values.push_back(entry.value<double>().value_or(NAN));
    } else {
      values.push_back(node->value<double>().value_or(NAN));
    }
    const bool bad = std::ranges::any_of(values, [](double x) { return !std::isfinite(x); });
    if (values.empty() || bad) refuse(*node, std::string(key) + " must be numbers");
  }

 private:
  std::string file_;
};

estimator::PlannedMotion::Kind kind_of(const Reader& reader, const toml::node& node) {
  try {
    return estimator::kind_named(node.value<std::string>().value_or(""));
  } catch (const std::out_of_range&) {
    reader.refuse(node, "kind must be triangle, sine, multisine, staircase or hold");
  }
}

/// The tables [model.spring.linear] and so on as a model file of their own, each on the line that
/// it has here, so that a complaint names the right one.
std::string model_lines(const std::string& text) {
  std::istringstream lines(text);
  std::string out = "format = \"searig-model/1\"";
  bool inside = false;
  for (std::string line; std::getline(lines, line); out += '\n') {
    if (line.starts_with("[")) inside = line.starts_with("[model.");
    if (line.starts_with("[model.")) line.erase(1, 6);
    if (inside) out += line;
  }
  return out;
}

/// The model stands in a file beside the spec, or in the spec itself.
estimator::Model model_of(const Reader& reader, const toml::table& root, const std::string& text,
                          const std::filesystem::path& file) {
  const auto* node = root.get("model");
  if (!node) throw std::invalid_argument(file.string() + ": there is no model");
  if (const auto name = node->value<std::string>()) {
    const auto path = file.parent_path() / *name;
    return estimator::parse_model(acquisition::read_text_file(path), path.string());
  }
  if (!node->is_table())
    reader.refuse(*node, "model must be a file's name, or tables as [model.spring.linear]");
  return estimator::parse_model(model_lines(text), file.string());
}

void read_motion(const Reader& reader, const toml::table& table, estimator::PlannedMotion& motion) {
  reader.only(table, {"kind", "seconds", "amplitudes_rad", "frequencies_hz", "output_rad"});
  if (const auto* kind = table.get("kind")) motion.kind = kind_of(reader, *kind);
  reader.magnitude(table, "seconds", motion.seconds);
  reader.magnitude(table, "output_rad", motion.output_rad);
  reader.list(table, "amplitudes_rad", motion.amplitudes_rad);
  reader.list(table, "frequencies_hz", motion.frequencies_hz);
}

void read_tables(const Reader& reader, const toml::table& root, MotionSpec& spec) {
  if (const auto* motion = root["motion"].as_table()) read_motion(reader, *motion, spec.motion);
  if (const auto* rates = root["rates"].as_table()) {
    reader.only(*rates, {"module_hz", "loadcell_hz"});
    reader.magnitude(*rates, "module_hz", spec.module_hz);
    reader.magnitude(*rates, "loadcell_hz", spec.loadcell_hz);
  }
  if (const auto* noise = root["noise"].as_table()) {
    reader.only(*noise, {"loadcell_nm", "current_a", "seed"});
    reader.magnitude(*noise, "loadcell_nm", spec.noise.loadcell_nm);
    reader.magnitude(*noise, "current_a", spec.noise.current_a);
    spec.noise.seed = std::uint64_t((*noise)["seed"].value_or(std::int64_t(1)));
  }
  if (const auto* temperature = root["temperature"].as_table()) {
    reader.only(*temperature, {"spring_c", "winding_c"});
    reader.list(*temperature, "spring_c", spec.spring_c);
    reader.list(*temperature, "winding_c", spec.winding_c);
  }
}

}  // namespace

std::string to_toml(const estimator::PlannedMotion& motion, const estimator::Model& model) {
  std::string out = "format = \"searig-spec/1\"\n\n" + to_toml(motion);
  std::istringstream lines(to_toml(model));
  std::string line;
  std::getline(lines, line);  // the format of a model file
  while (std::getline(lines, line))
    out += (line.starts_with("[") ? "[model." + line.substr(1) : line) + "\n";
  return out;
}

MotionSpec read_motion_spec(const std::filesystem::path& file) {
  const std::string text = acquisition::read_text_file(file);
  toml::table root;
  try {
    root = toml::parse(text, file.string());
  } catch (const toml::parse_error& error) {
    throw std::invalid_argument(file.string() + ": line " +
                                std::to_string(error.source().begin.line) + ": " +
                                std::string(error.description()));
  }
  const Reader reader(file.string());
  reader.only(root, {"format", "model", "motion", "rates", "noise", "temperature"});
  if (root["format"].value_or(std::string()) != "searig-spec/1")
    throw std::invalid_argument(file.string() + ": format must be \"searig-spec/1\"");
  MotionSpec spec;
  spec.model = model_of(reader, root, text, file);
  read_tables(reader, root, spec);
  if (spec.motion.seconds < 1.0 || spec.module_hz < 10.0 || spec.loadcell_hz < 1.0)
    throw std::invalid_argument(file.string() +
                                ": at least 1 s, 10 Hz for the module and 1 Hz for the load cell");
  return spec;
}

}  // namespace searig::app
