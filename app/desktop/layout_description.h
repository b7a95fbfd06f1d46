// Where things are on the window, for tests that look at its pixels and its words.
#pragma once

#include <nlohmann/json.hpp>

class QWidget;

namespace searig::app::desktop {

/// Of what is visible: "plots" by object name, with the canvas in logical pixels of the window and
/// the ranges of its axes; "words" by object name, of labels and buttons that have one; "cut": the
/// words of labels and buttons that have less room than they need, which there should be none of.
nlohmann::json describe_layout(const QWidget& window);

}  // namespace searig::app::desktop
