// What Qt says on stderr.
#pragma once

#include <QString>
#include <QtGlobal>
#include <iostream>

namespace searig::app::desktop {

/// For qInstallMessageHandler: the offscreen platform complains of things that do not matter there.
inline void drop_noise(QtMsgType, const QMessageLogContext&, const QString& message) {
  if (message.contains(QLatin1String("propagateSizeHints")) ||
      message.contains(QLatin1String("XDG_RUNTIME_DIR"))) {
    return;
  }
  std::cerr << message.toStdString() << '\n';
}

}  // namespace searig::app::desktop
