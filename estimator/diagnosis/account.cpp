#include "estimator/diagnosis/account.h"

#include <algorithm>

#include "estimator/diagnosis/heldout.h"
#include "estimator/diagnosis/lasting_change.h"
#include "estimator/diagnosis/refine.h"
#include "estimator/physics/catalogue.h"

namespace searig::estimator {
namespace {

constexpr int most_changes = 6;
constexpr double tolerance = 0.003;        // of a held-out error: so much is chance
constexpr double price_of_joining = 20.0;  // in deviance: one place less to explain

class Accountant {
 public:
  Accountant(Bench& bench, Search& search, const Model& given, const Tell& tell)
      : bench_(bench), search_(search), given_(given), tell_(tell) {}

  Account run() {
    lay_base();
    tell_("looking at what is left", 0.1);
    find_missing();
    tell_("weighing rivals", 0.5);
    judge();
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
    const bool predicts = worse_by(bench_, rivals.hypothesis, beside.hypothesis) <= tolerance;
    out_.final = fits_better && predicts ? rivals : beside;
    refine_atoms();
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

  /// Atoms come from a coarse grid of places; what they tell is where.
  void refine_atoms() {
    for (std::size_t i = 0; i < out_.final.hypothesis.size(); ++i) {
      if (!out_.final.hypothesis[i].atom || joined(i)) continue;
      const Hypothesis rest = all_but(out_.final.hypothesis, i);
      out_.moved_atoms.push_back(refined(bench_, rest, *out_.final.hypothesis[i].atom));
      out_.final.hypothesis[i].atom = &out_.moved_atoms.back();
    }
  }

  /// Two changes of one kind, there and back, are one that lasts for a while.
  bool joined(std::size_t i) {
    const Atom& atom = *out_.final.hypothesis[i].atom;
    if (!atom.at_once) return false;
    Hypothesis rest = out_.final.hypothesis;
    const auto same = [&](const Piece& p) { return p.atom && p.atom->what == atom.what; };
    if (std::erase_if(rest, same) < 2) return false;
    const Atom one = refined(bench_, rest, atom);
    if (one.at_once) return false;
    out_.moved_atoms.push_back(one);
    rest.insert(rest.begin() + std::ptrdiff_t(std::min(i, rest.size())),
                {nullptr, {}, &out_.moved_atoms.back()});
    const double apart = bench_.fit(out_.final.hypothesis).solution.sse;
    if (bench_.fit(rest).solution.sse > apart + price_of_joining) return false;
    out_.final.hypothesis = rest;
    return true;
  }

  bool in_base(const Piece& piece) const {
    return std::ranges::any_of(out_.base.hypothesis, [&](const Piece& p) {
      return p.effect == piece.effect && p.shape.size() == piece.shape.size();
    });
  }

  /// Drops named pieces that do not hold once everything is in place, and lets rivals that fit
  /// better in their place take it.
  void judge() {
    search_.learn_noise(out_.final.hypothesis);
    out_.final = search_.score(out_.final.hypothesis);
    change_while_needed();
    if (names_came_first_ && add_what_stands_out()) change_while_needed();
    const double largest = largest_assessed();
    for (Assessment& a : out_.assessments) a.probability *= beyond_form(a.rho / largest);
    for (std::size_t i = 0; i < out_.final.hypothesis.size(); ++i)
      if (out_.final.hypothesis[i].atom) out_.near_names.merge(names_near(search_, out_.final, i));
  }

  void change_while_needed() {
    for (int changes = 0; changes < most_changes; ++changes)
      if (!change_one() && !drop_dwarfed() && !drop_misleading_atom()) return;
  }

  /// Names that predict better than what stood beside them need not explain all of it.
  bool add_what_stands_out() {
    names_came_first_ = false, atoms_stay_ = true;
    const Scored with = search_.add_unnamed(out_.final, 1);
    if (with.hypothesis.size() == out_.final.hypothesis.size()) return false;
    out_.final = with;
    refine_atoms();
    return true;
  }

  double largest_assessed() const {
    double largest = 0.0;
    for (const Assessment& a : out_.assessments) largest = std::max(largest, a.rho);
    return largest;
  }

  /// A piece that is small beside another one is what the other's form leaves over. The search
  /// could not see that while the largest was still to be found and all else counted as noise.
  bool drop_dwarfed() {
    const auto& all = out_.assessments;
    const auto least = std::ranges::min_element(all, {}, &Assessment::rho);
    if (least == all.end() || beyond_form(least->rho / largest_assessed()) >= 0.5) return false;
    out_.final = search_.score(least->without);
    return true;
  }

  bool drop_misleading_atom() {
    for (std::size_t i = 0; i < out_.final.hypothesis.size(); ++i) {
      const Atom* atom = out_.final.hypothesis[i].atom;
      if (!atom) continue;
      const Hypothesis rest = all_but(out_.final.hypothesis, i);
      if (!misleads(bench_, *atom, out_.final.hypothesis, rest)) continue;
      out_.final = search_.score(rest);
      return true;
    }
    return false;
  }

  bool change_one() {
    out_.assessments.clear();
    for (std::size_t i = 0; i < out_.final.hypothesis.size(); ++i) {
      const Piece piece = out_.final.hypothesis[i];
      if (piece.atom || in_base(piece)) continue;
      Assessment a = assess(search_, bench_, out_.final, i);
      const bool weak =
          a.gain < search_.criteria().least_gain || a.rho < search_.criteria().least_rho;
      if (!weak && !a.better && predicts(a, piece)) {
        out_.assessments.push_back(std::move(a));
        continue;
      }
      if (const auto alone = stronger_alone(a))
        out_.final = *alone, names_came_first_ = true;
      else
        out_.final = a.better ? *a.better : search_.score(a.without);
      return true;
    }
    return false;
  }

  /// A piece that is weak beside atoms may be weak because they took its place: where the names
  /// alone predict what no fit saw clearly better than the atoms without it, the names stay.
  std::optional<Scored> stronger_alone(const Assessment& a) {
    Hypothesis named = out_.final.hypothesis;
    const auto is_atom = [](const Piece& p) { return p.atom != nullptr; };
    if (atoms_stay_ || std::erase_if(named, is_atom) == 0 ||
        worse_by(bench_, named, a.without) > -tolerance)
      return std::nullopt;
    return search_.score(named);
  }

  /// Whether blocks that no fit saw are predicted no worse with the piece than without it.
  bool predicts(const Assessment& a, const Piece& piece) const {
    const auto with = heldout_residuals(bench_, out_.final.hypothesis);
    const auto without = heldout_residuals(bench_, a.without);
    const bool drive = piece.effect->path() == Path::drive || !bench_.experiment().has_spring();
    return rms_of(drive ? with.drive : with.spring) <=
           (1.0 + tolerance) * rms_of(drive ? without.drive : without.spring);
  }

  Bench& bench_;
  Search& search_;
  const Model& given_;
  const Tell& tell_;
  bool names_came_first_ = false, atoms_stay_ = false;
  Account out_;
};

}  // namespace

Account find_account(Bench& bench, Search& search, const Model& given, const Tell& tell) {
  return Accountant(bench, search, given, tell).run();
}

}  // namespace searig::estimator
