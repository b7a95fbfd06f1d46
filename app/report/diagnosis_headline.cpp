// The diagnosis in one or two sentences, by its verdict.
#include <string>
#include <vector>

#include "app/report/diagnosis_sentences.h"
#include "app/report/diagnosis_words.h"
#include "app/report/quantity.h"

namespace searig::app {
namespace {

using estimator::Diagnosis;
using estimator::Finding;
using estimator::PathErrors;
using estimator::Verdict;

std::string missing_headline(const Diagnosis& d) {
  std::string out = "The simulation leaves something out: ";
  if (d.findings.size() == 1) {
    const Finding& f = d.findings.front();
    out += title_of(f.effect) + ". This is " + how_sure(f.probability) + ".";
  } else {
    std::vector<std::string> names;
    for (const Finding& f : d.findings) {
      names.push_back(title_of(f.effect) + ", " + how_sure(f.probability));
    }
    out += joined(names, "; and ", "; ") + ".";
  }
  const PathErrors* path = clearest(d);
  if (path && path->after < path->before) {
    out += (d.findings.size() == 1 ? " With it, " : " With them, ") +
           improvement(path->before, path->after) + ".";
  }
  if (d.unexplained) out += " Something more remains that has no name in the catalogue.";
  return out;
}

std::string consistent_headline(const Diagnosis& d) {
  const PathErrors* path = first_of(d);
  std::string out = "Nothing is missing, and the numbers of the model hold";
  if (!path) return out + ".";
  out += ": what is left, " + with_unit(path->after, "N·m", 2) + ", is noise.";
  if (path->as_given && *path->as_given > 1.3 * path->before) {
    out += " As it came it was off by " + with_unit(*path->as_given, "N·m", 2) +
           ": the sensors' zeros and clocks had to be fitted.";
  }
  return out;
}

std::string recalibrate_headline(const Diagnosis& d) {
  const PathErrors* path = first_of(d);
  std::string out = "No physics is missing, but numbers of the model are off.";
  if (path && path->as_given && *path->as_given > path->before) {
    out += " With the right ones the error falls from " + figures(*path->as_given, 2) + " to " +
           with_unit(path->after, "N·m", 2) + ", which is noise.";
  }
  return out;
}

std::string unexplained_headline(const Diagnosis& d) {
  std::string out =
      "The simulation leaves something out, and nothing in the catalogue explains it best.";
  if (!d.unexplained) return out;
  if (const std::string place = where(d.unexplained->located); !place.empty()) {
    out += " It shows at " + place + ".";
  }
  return out;
}

}  // namespace

std::string headline(const Diagnosis& d) {
  switch (d.verdict) {
    case Verdict::consistent:
      return consistent_headline(d);
    case Verdict::recalibrate:
      return recalibrate_headline(d);
    case Verdict::missing_physics:
      return missing_headline(d);
    case Verdict::unexplained:
      return unexplained_headline(d);
  }
  return "";
}

}  // namespace searig::app
