// Answers that two copies of a recording must share.
#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/system/run_program.h"

namespace searig {

/// What `searig COMMAND RECORDING` says, but for where the recording and its files lie.
inline nlohmann::json answer_wherever(const std::string& command, const std::string& recording) {
  const Ran ran = run_program("searig " + command + " " + recording + " --json -");
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  auto out = nlohmann::json::parse(ran.out, nullptr, false);
  EXPECT_TRUE(out.is_object()) << ran.out;
  if (out.contains("streams"))
    for (auto& stream : out.at("streams")) stream.erase("file");
  if (out.contains("recordings"))
    for (auto& one : out.at("recordings")) one.erase("path");
  return out;
}

}  // namespace searig
