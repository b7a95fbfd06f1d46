// What the paper's figures show, what ours show, and what agrees.
#pragma once

#include "app/reproduce/figure.h"
#include "app/reproduce/window.h"

namespace searig::app::reproduce {

/// Fills paper, ours and verdict of all figures, by their names.
void say(std::vector<Figure>& figures, const Reproduction& all, const Window& good,
         const Window& poor);

}  // namespace searig::app::reproduce
