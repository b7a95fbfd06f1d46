// What takes confidence from findings, or takes them back.
#pragma once

#include "estimator/diagnosis/diagnosis.h"
#include "estimator/diagnosis/search/account.h"

namespace searig::estimator {

/// Where something without a name is left in the same residuals, and it is not small beside a
/// finding, the name may be the nearest one only. A straight drift under a wandering zero is void.
void doubt_beside_unexplained(Diagnosis& out);

/// What is as likely nameless, or contradicts itself between the residuals, is not asserted.
void withdraw_contradicted(const Account& account, Diagnosis& out);

/// A constant between drive and spring is a current offset, or one of the deflection (a number,
/// not physics). With the load cell's own zero free, only parsimony tells: the one that leaves the
/// load cell's zero at nothing. Returns that zero in N*m where it is one, else 0.
double settle_offsets(const Bench& bench, const Hypothesis& final, const Fit& fit, Diagnosis& out);

/// A load cell that is late by little more than the clock map leaves open stays undecided.
void leave_to_the_clock(const Bench& bench, Diagnosis& out);

/// Delay and lag are one finding: the load cell answers late. The larger time names it.
void merge_late(Diagnosis& out);

}  // namespace searig::estimator
