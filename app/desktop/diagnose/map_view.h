// The mismatch maps, one below the other.
#pragma once

#include <QWidget>
#include <memory>
#include <string>
#include <vector>

#include "app/desktop/theme.h"
#include "app/session/examine.h"

namespace searig::app::desktop {

class MapView : public QWidget {
 public:
  explicit MapView(QWidget* parent);

  /// Null: nothing has been diagnosed.
  void show_map(std::shared_ptr<const Examined> examined);
  void set_theme(const Theme& theme);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  bool both() const;

  std::shared_ptr<const Examined> examined_;
  Theme theme_{false};
};

}  // namespace searig::app::desktop
