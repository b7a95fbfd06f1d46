#include "estimator/diagnosis/search/move_atoms.h"

#include <algorithm>

#include "estimator/diagnosis/search/refine.h"

namespace searig::estimator {
namespace {

constexpr double price_of_joining = 20.0;  // in deviance: one place less to explain

/// Two changes of one kind, there and back, are one that lasts for a while.
bool joined(const Bench& bench, Account& account, std::size_t i) {
  const Atom& atom = *account.final.hypothesis[i].atom;
  if (!atom.at_once) return false;
  Hypothesis rest = account.final.hypothesis;
  const auto same = [&](const Piece& p) { return p.atom && p.atom->what == atom.what; };
  if (std::erase_if(rest, same) < 2) return false;
  const Atom one = refined(bench, rest, atom);
  if (one.at_once) return false;
  account.moved_atoms.push_back(one);
  rest.insert(rest.begin() + std::ptrdiff_t(std::min(i, rest.size())),
              {nullptr, {}, &account.moved_atoms.back()});
  const double apart = bench.fit(account.final.hypothesis).solution.sse;
  if (bench.fit(rest).solution.sse > apart + price_of_joining) return false;
  account.final.hypothesis = rest;
  return true;
}

}  // namespace

void move_atoms(const Bench& bench, Account& account) {
  for (std::size_t i = 0; i < account.final.hypothesis.size(); ++i) {
    if (!account.final.hypothesis[i].atom || joined(bench, account, i)) continue;
    const Hypothesis rest = all_but(account.final.hypothesis, i);
    account.moved_atoms.push_back(refined(bench, rest, *account.final.hypothesis[i].atom));
    account.final.hypothesis[i].atom = &account.moved_atoms.back();
  }
}

}  // namespace searig::estimator
