#include "estimator/diagnosis/search/account.h"

#include <algorithm>

#include "estimator/diagnosis/fit/heldout.h"
#include "estimator/diagnosis/search/judge.h"
#include "estimator/diagnosis/search/lasting_change.h"
#include "estimator/diagnosis/search/move_atoms.h"
#include "estimator/physics/catalogue.h"

namespace searig::estimator {
namespace {

class Accountant {
 public:
  Accountant(Bench& bench, Search& search, const Model& given, const Tell& tell)
      : bench_(bench), search_(search), given_(given), tell_(tell) {}

  Account run() {
    lay_base();
    tell_("looking at what is left", 0.1);
    find_missing();
    tell_("weighing rivals", 0.5);
    judge(bench_, search_, out_);
    return std::move(out_);
  }

 private:
  void lay_base() {
    const Experiment& e = bench_.experiment();
    Hypothesis base;
    for (const auto& term : given_.terms) {
      const Effect* effect = find_effect(term.effect);
      if (effect->applies(e.motion) && has_rows(effect->path()))
        base.push_back({effect, effect->shape(term), nullptr});
      else
        out_.switched_off.push_back(term.effect +
                                    " is switched off: the recording lacks its channels");
    }
    if (!e.has_drive()) out_.switched_off.push_back("no drive path: no current with a velocity");
    if (!e.has_spring()) out_.switched_off.push_back("no spring path: no deflection");
    search_.learn_noise(base);
    bench_.learn_torque(base);
    search_.learn_noise(base);
    out_.base = search_.score(base);
    out_.final = out_.base;
  }

  bool has_rows(Path path) const {
    const Experiment& e = bench_.experiment();
    return path == Path::drive ? e.has_drive() : path != Path::spring || e.has_spring();
  }

  void find_missing() {
    std::vector<Step> trail;
    const Scored named = search_.add_named(out_.base, trail);
    out_.final = named;
    const Step& last = trail.back();
    // A named effect that is too small to assert, yet fits as well, is the likelier remainder.
    const auto likelier = std::ranges::find_if(
        last.named, [&](const Contender& c) { return search_.predicts(c, last.before); });
    const bool rest_has_no_name =
        !last.unnamed.empty() && search_.stands_out(last.unnamed.front(), last.before) &&
        (likelier == last.named.end() || last.unnamed.front().gain > 1.1 * likelier->gain);
    if (!rest_has_no_name) return add_lasting_change();
    // Something without a name is there. Did it push a wrong name forward? Let both kinds compete
    // from the start, and keep whichever account is the better one.
    tell_("something is left that has no name", 0.35);
    const Scored beside = search_.add_unnamed(named, 3);
    const Scored rivals = search_.add_either(out_.base, 4);
    search_.learn_noise(beside.hypothesis);  // to compare them under one noise
    const bool fits_better =
        search_.score(rivals.hypothesis).cost() < search_.score(beside.hypothesis).cost();
    const bool predicts = worse_by(bench_, rivals.hypothesis, beside.hypothesis) <= heldout_chance;
    out_.final = fits_better && predicts ? rivals : beside;
    move_atoms(bench_, out_);
  }

  /// Only where nothing has a name: between recordings of several motions an effect that has one
  /// changes, too, and would give way to the change.
  void add_lasting_change() {
    const bool named = out_.final.hypothesis.size() > out_.base.hypothesis.size();
    if (named || !bench_.method().looks_for_nameless) return;
    const auto change = lasting_change(bench_, out_.final.hypothesis);
    if (!change) return;
    out_.moved_atoms.push_back(*change);
    out_.final.hypothesis.push_back({nullptr, {}, &out_.moved_atoms.back()});
  }

  Bench& bench_;
  Search& search_;
  const Model& given_;
  const Tell& tell_;
  Account out_;
};

}  // namespace

Account find_account(Bench& bench, Search& search, const Model& given, const Tell& tell) {
  return Accountant(bench, search, given, tell).run();
}

}  // namespace searig::estimator
