#pragma once

#include "tests/proving/plan/stratum.h"
#include "tests/proving/random.h"
#include "tests/proving/rig/motion.h"

namespace searig::proving {

/// Segments in which the item's effects can show, or, for poor and masked ones, can hardly.
MotionPlan draw_motion(const Item& item, Random random);

/// Where, in seconds of motion, the segment of this name runs; {0, 0} when it does not.
std::pair<double, double> segment_interval(const MotionPlan& plan, const std::string& name,
                                           double duration_s);

}  // namespace searig::proving
