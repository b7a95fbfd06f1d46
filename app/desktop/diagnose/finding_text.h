// The diagnosis as the page says it: findings, rivals, errors before and after.
#pragma once

#include <QString>

#include "app/session/examine.h"

namespace searig::app::desktop {

/// Rich text: a table of the errors, then the sentences of report/diagnosis_words.h after the
/// headline.
QString finding_text(const Examined& examined);

}  // namespace searig::app::desktop
