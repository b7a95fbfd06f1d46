// What the curves are at the two cursors, and how far apart.
#pragma once

#include <QWidget>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/desktop/replay/history_view.h"
#include "app/session/estimator_run.h"

class QGridLayout;
class QLabel;

namespace searig::app::desktop {

class CursorTable : public QWidget {
 public:
  explicit CursorTable(QWidget* parent);

  /// `second` may be null: its rows are then hidden.
  void show_values(const Cursors& cursors, const History* first, const History* second);

 private:
  struct Row {
    QLabel* name;
    std::array<QLabel*, 3> values;  ///< at A, at B, B - A
  };

  void add_row(const char* name, const char* object_name);
  void fill(Row& row, std::optional<double> a, std::optional<double> b, int decimals);

  QGridLayout* grid_;
  std::vector<Row> rows_;
};

}  // namespace searig::app::desktop
