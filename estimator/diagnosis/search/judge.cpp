#include "estimator/diagnosis/search/judge.h"

#include <algorithm>

#include "estimator/diagnosis/fit/heldout.h"
#include "estimator/diagnosis/search/move_atoms.h"

namespace searig::estimator {
namespace {

constexpr int most_changes = 6;

class Judge {
 public:
  Judge(Bench& bench, Search& search, Account& account)
      : bench_(bench), search_(search), account_(account) {}

  void run() {
    search_.learn_noise(account_.final.hypothesis);
    account_.final = search_.score(account_.final.hypothesis);
    change_while_needed();
    if (names_came_first_ && add_what_stands_out()) change_while_needed();
    const double largest = largest_assessed();
    for (Assessment& a : account_.assessments) a.probability *= beyond_form(a.rho / largest);
    for (std::size_t i = 0; i < account_.final.hypothesis.size(); ++i)
      if (account_.final.hypothesis[i].atom)
        account_.near_names.merge(names_near(search_, account_.final, i));
  }

 private:
  bool in_base(const Piece& piece) const {
    return std::ranges::any_of(account_.base.hypothesis, [&](const Piece& p) {
      return p.effect == piece.effect && p.shape.size() == piece.shape.size();
    });
  }

  void change_while_needed() {
    for (int changes = 0; changes < most_changes; ++changes)
      if (!change_one() && !drop_dwarfed() && !drop_misleading_atom()) return;
  }

  /// Names that predict better than what stood beside them need not explain all of it.
  bool add_what_stands_out() {
    names_came_first_ = false, atoms_stay_ = true;
    const Scored with = search_.add_unnamed(account_.final, 1);
    if (with.hypothesis.size() == account_.final.hypothesis.size()) return false;
    account_.final = with;
    move_atoms(bench_, account_);
    return true;
  }

  double largest_assessed() const {
    double largest = 0.0;
    for (const Assessment& a : account_.assessments) largest = std::max(largest, a.rho);
    return largest;
  }

  /// A piece that is small beside another one is what the other's form leaves over. The search
  /// could not see that while the largest was still to be found and all else counted as noise.
  bool drop_dwarfed() {
    const auto& all = account_.assessments;
    const auto least = std::ranges::min_element(all, {}, &Assessment::rho);
    if (least == all.end() || beyond_form(least->rho / largest_assessed()) >= 0.5) return false;
    account_.final = search_.score(least->without);
    return true;
  }

  bool drop_misleading_atom() {
    for (std::size_t i = 0; i < account_.final.hypothesis.size(); ++i) {
      const Atom* atom = account_.final.hypothesis[i].atom;
      if (!atom) continue;
      const Hypothesis rest = all_but(account_.final.hypothesis, i);
      if (!misleads(bench_, *atom, account_.final.hypothesis, rest)) continue;
      account_.final = search_.score(rest);
      return true;
    }
    return false;
  }

  bool change_one() {
    account_.assessments.clear();
    for (std::size_t i = 0; i < account_.final.hypothesis.size(); ++i) {
      const Piece piece = account_.final.hypothesis[i];
      if (piece.atom || in_base(piece)) continue;
      Assessment a = assess(search_, bench_, account_.final, i);
      const bool weak =
          a.gain < search_.criteria().least_gain || a.rho < search_.criteria().least_rho;
      if (!weak && !a.better && predicts(a, piece)) {
        account_.assessments.push_back(std::move(a));
        continue;
      }
      if (const auto alone = stronger_alone(a))
        account_.final = *alone, names_came_first_ = true;
      else
        account_.final = a.better ? *a.better : search_.score(a.without);
      return true;
    }
    return false;
  }

  /// A piece that is weak beside atoms may be weak because they took its place: where the names
  /// alone predict what no fit saw clearly better than the atoms without it, the names stay.
  std::optional<Scored> stronger_alone(const Assessment& a) {
    Hypothesis named = account_.final.hypothesis;
    const auto is_atom = [](const Piece& p) { return p.atom != nullptr; };
    if (atoms_stay_ || std::erase_if(named, is_atom) == 0 ||
        worse_by(bench_, named, a.without) > -heldout_chance)
      return std::nullopt;
    return search_.score(named);
  }

  /// Whether blocks that no fit saw are predicted no worse with the piece than without it.
  bool predicts(const Assessment& a, const Piece& piece) const {
    const auto with = heldout_residuals(bench_, account_.final.hypothesis);
    const auto without = heldout_residuals(bench_, a.without);
    const bool drive = piece.effect->path() == Path::drive || !bench_.experiment().has_spring();
    return rms_of(drive ? with.drive : with.spring) <=
           (1.0 + heldout_chance) * rms_of(drive ? without.drive : without.spring);
  }

  Bench& bench_;
  Search& search_;
  Account& account_;
  bool names_came_first_ = false, atoms_stay_ = false;
};

}  // namespace

void judge(Bench& bench, Search& search, Account& account) {
  Judge(bench, search, account).run();
}

}  // namespace searig::estimator
