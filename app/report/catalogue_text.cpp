#include "app/report/catalogue_text.h"

#include <algorithm>
#include <cmath>

#include "app/report/quantity.h"
#include "estimator/physics/catalogue.h"

namespace searig::app {
namespace {

using estimator::Effect;
using estimator::Path;

struct Chapter {
  Path path;
  const char* title;
  const char* words;
};

constexpr Chapter chapters[] = {
    {Path::spring, "The spring",
     "Terms of the torque that the spring passes on, T_spring = k*theta + these. They show in the "
     "load cell and in the motor current alike."},
    {Path::drive, "The drive",
     "Terms of the torque that the motor brings to the spring, T_drive = "
     "efficiency*(torque_constant*I - j*a) - friction. They show in the motor current only."},
    {Path::rig, "The rig",
     "Torques between the spring and the load cell. They show in the load cell only."},
    {Path::observation, "The load cell's view",
     "When and how sharply the load cell sees the torque. A delay is asserted only beyond what the "
     "clocks leave open."},
};

std::string bounds(const estimator::Parameter& p) {
  const auto side = [](double value) {
    return std::isinf(value) ? std::string("any") : figures(value, 2);
  };
  if (side(p.lower) == "any" && side(p.upper) == "any") return "any";
  if (side(p.upper) == "any") return "from " + side(p.lower);
  return side(p.lower) + " to " + side(p.upper);
}

void add_line(std::string& out, const char* what, const std::string& text) {
  if (!text.empty()) out += std::string("- ") + what + ": " + text + "\n";
}

void add_parameters(std::string& out, const Effect& effect) {
  out += "\n| parameter | unit | bounds | meaning | where absent |\n|---|---|---|---|---|\n";
  for (const auto& p : effect.parameters()) {
    const std::string unit = quantity_of(p.name).unit;
    out += "| `" + p.name + "` | " + (unit.empty() ? "–" : unit) + " | " + bounds(p) + " | " +
           p.meaning + " | " + (p.fallback ? figures(*p.fallback, 2) : "required") + " |\n";
  }
  if (effect.has_branches()) {
    out += "\nFurther branches follow with numbers: the same names with 2, 3 and so on.\n";
  }
}

void add_effect(std::string& out, const Effect& effect) {
  const auto& about = effect.about();
  out +=
      "\n### " + about.name + "\n\n" + capital(about.title) + ".\n\n    " + about.equation + "\n\n";
  add_line(out, "looks like", about.looks_like);
  add_line(out, "confused with", about.confused_with);
  add_line(out, "told apart by", about.separated_by);
  add_line(out, "local in", "`" + about.channel + "`");
  add_line(out, "source", about.source);
  add_parameters(out, effect);
}

}  // namespace

std::string catalogue_markdown() {
  std::string out =
      "# Catalogue of effects\n\n"
      "What searig can simulate, find missing, name and fit. Written by `searig effects "
      "--markdown` from the catalogue itself; each effect is one file in "
      "`estimator/physics/effects`.\n\n"
      "theta is the deflection of the spring, q_i the angle before it with velocity w and "
      "acceleration a, q_o the angle behind it, I the motor current.\n";
  for (const auto& chapter : chapters) {
    out += std::string("\n## ") + chapter.title + "\n\n" + chapter.words + "\n";
    for (const Effect* effect : estimator::catalogue())
      if (effect->path() == chapter.path) add_effect(out, *effect);
  }
  return out;
}

std::string catalogue_lines() {
  std::string out;
  for (const Effect* effect : estimator::catalogue()) {
    std::string name = effect->name();
    name.resize(std::max<std::size_t>(36, name.size() + 1), ' ');
    out += name + effect->about().title + "\n";
  }
  return out;
}

}  // namespace searig::app
