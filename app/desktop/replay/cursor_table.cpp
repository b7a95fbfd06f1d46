#include "app/desktop/replay/cursor_table.h"

#include <QGridLayout>
#include <QLabel>

#include "app/report/axis.h"

namespace searig::app::desktop {
namespace {

enum Place { time, measured, torque, weight, stiffness, second_torque, second_weight, second_k };

constexpr int row_of_names = 0;

}  // namespace

CursorTable::CursorTable(QWidget* parent) : QWidget(parent), grid_(new QGridLayout(this)) {
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setHorizontalSpacing(8);
  grid_->setVerticalSpacing(3);
  grid_->setColumnStretch(0, 1);
  int column = 0;
  for (const char* words : {"at the cursors", "A", "B", "B − A"}) {
    auto* label = new QLabel(QStringLiteral("<b>%1</b>").arg(QString::fromUtf8(words)), this);
    grid_->addWidget(label, row_of_names, column, column ? Qt::AlignRight : Qt::AlignLeft);
    ++column;
  }
  add_row("time (s)", "time");
  add_row("measured (N·m)", "measured");
  add_row("estimated (N·m)", "torque");
  add_row("trust", "weight");
  add_row("k (N·m/rad)", "stiffness");
  add_row("second (N·m)", "second_torque");
  add_row("second: trust", "second_weight");
  add_row("second: k", "second_stiffness");
}

void CursorTable::add_row(const char* name, const char* object_name) {
  const int at = int(rows_.size()) + row_of_names + 1;
  Row row{new QLabel(QString::fromUtf8(name), this), {}};
  grid_->addWidget(row.name, at, 0);
  const char* of[] = {"a", "b", "difference"};
  for (int i = 0; i < 3; ++i) {
    row.values[i] = new QLabel(QStringLiteral("–"), this);
    row.values[i]->setObjectName(
        QStringLiteral("%1_%2").arg(QLatin1String(object_name), QLatin1String(of[i])));
    row.values[i]->setMinimumWidth(48);
    row.values[i]->setAlignment(Qt::AlignRight);
    grid_->addWidget(row.values[i], at, i + 1);
  }
  rows_.push_back(row);
}

void CursorTable::fill(Row& row, std::optional<double> a, std::optional<double> b, int decimals) {
  const auto words = [decimals](const std::optional<double>& value) {
    return value ? QString::fromStdString(number(*value, decimals)) : QStringLiteral("–");
  };
  row.values[0]->setText(words(a));
  row.values[1]->setText(words(b));
  row.values[2]->setText(words(a && b ? std::optional(*b - *a) : std::nullopt));
}

void CursorTable::show_values(const Cursors& cursors, const History* first, const History* second) {
  const auto at = [](const std::optional<double>& t_s, const History* history) {
    return t_s && history ? values_at(*history, *t_s) : RunValues{};
  };
  const RunValues a = at(cursors.a_s, first), b = at(cursors.b_s, first);
  const RunValues a2 = at(cursors.a_s, second), b2 = at(cursors.b_s, second);
  fill(rows_[time], cursors.a_s, cursors.b_s, 3);
  fill(rows_[measured], a.measured_nm, b.measured_nm, 3);
  fill(rows_[torque], a.estimated_nm, b.estimated_nm, 3);
  fill(rows_[weight], a.weight, b.weight, 2);
  fill(rows_[stiffness], a.stiffness_nm_per_rad, b.stiffness_nm_per_rad, 2);
  fill(rows_[second_torque], a2.estimated_nm, b2.estimated_nm, 3);
  fill(rows_[second_weight], a2.weight, b2.weight, 2);
  fill(rows_[second_k], a2.stiffness_nm_per_rad, b2.stiffness_nm_per_rad, 2);
  for (std::size_t i = second_torque; i < rows_.size(); ++i) {
    rows_[i].name->setVisible(second != nullptr);
    for (QLabel* value : rows_[i].values) value->setVisible(second != nullptr);
  }
}

}  // namespace searig::app::desktop
