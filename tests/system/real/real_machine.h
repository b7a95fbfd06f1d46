// Recordings of real machines in ../shared/data: found, mapped, read for a score of the test's own.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/system/run_program.h"

namespace searig {

inline const std::filesystem::path kRealMachines =
    std::filesystem::path(SEARIG_SHARED_DIR) / "data";

/// A CSV file's columns as numbers; what is none becomes NaN.
inline std::vector<std::vector<double>> columns_of(const std::filesystem::path& file, bool header) {
  std::vector<std::vector<double>> columns;
  std::ifstream in(file);
  std::string line;
  if (header) std::getline(in, line);
  while (std::getline(in, line)) {
    std::istringstream fields(line);
    std::size_t i = 0;
    for (std::string field; std::getline(fields, field, ','); ++i) {
      if (columns.size() <= i) columns.emplace_back();
      columns[i].push_back(std::strtod(field.c_str(), nullptr));
    }
  }
  return columns;
}

inline double mean(const std::vector<double>& x) {
  double sum = 0.0;
  for (const double v : x) sum += v;
  return sum / double(x.size());
}

inline double rms(const std::vector<double>& x) {
  double sum = 0.0;
  for (const double v : x) sum += v * v;
  return std::sqrt(sum / double(x.size()));
}

inline std::string quoted(const std::filesystem::path& file) {
  return "\"" + file.string() + "\"";
}

inline nlohmann::json diagnosed(const std::string& arguments) {
  const Ran ran = run_program("searig diagnose " + arguments + " --json -");
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  return ran.exit_code == 0 ? nlohmann::json::parse(ran.out) : nlohmann::json();
}

inline std::set<std::string> names_of(const nlohmann::json& diagnosis) {
  std::set<std::string> names;
  for (const auto& finding : diagnosis.at("findings")) names.insert(finding.at("effect"));
  return names;
}

/// The finding of that name; fails the test where there is none.
inline nlohmann::json finding(const nlohmann::json& diagnosis, const std::string& effect) {
  for (const auto& found : diagnosis.at("findings"))
    if (found.at("effect") == effect) return found;
  ADD_FAILURE() << effect << " is not among " << diagnosis.at("findings");
  return {};
}

inline double parameter(const nlohmann::json& found, const std::string& name) {
  for (const auto& p : found.at("parameters"))
    if (p.at("name") == name) return p.at("value");
  ADD_FAILURE() << name << " is not in " << found;
  return NAN;
}

}  // namespace searig
