// Whether a window can be opened at all.
#pragma once

namespace searig::app::desktop {

/// Qt ends the whole process where its display does not answer, so that nothing can be said; a
/// child tries it first. To be called before the first thread, and before Qt.
bool display_answers(int argc, char** argv);

}  // namespace searig::app::desktop
