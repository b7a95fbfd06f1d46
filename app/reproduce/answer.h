// What the reproduction found: as JSON for machines, in lines for people.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/reproduce/figure.h"

namespace searig::app::reproduce {

/// {"format":"searig-reproduction/1", "table_1":..., "targets":..., "hand_drags":...,
///  "trials":[...], "figures":[...]}; files are named as in the folder.
nlohmann::json to_json(const Reproduction& all, const std::vector<Figure>& figures);

std::vector<std::string> describe(const Reproduction& all);

/// The targets of one variant, a sentence each, with what was measured.
std::vector<std::string> target_sentences(const Targets& targets, int trials);

}  // namespace searig::app::reproduce
