#include "app/desktop/live/calibration_panel.h"

#include <QDate>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include "acquisition/recording/text_file.h"
#include "app/report/axis.h"

namespace searig::app::desktop {
namespace {

constexpr double gravity = 9.80665;  // m/s^2

QString said(double value, int decimals) {
  return QString::fromStdString(number(value, decimals));
}

QDoubleSpinBox* new_number(const char* name, double low, double high, int decimals,
                           const QString& unit) {
  auto* box = new QDoubleSpinBox;
  box->setObjectName(QString::fromLatin1(name));
  box->setRange(low, high);
  box->setDecimals(decimals);
  box->setSuffix(unit);
  return box;
}

QLabel* new_label(const char* name, double points) {
  auto* label = new QLabel;
  label->setObjectName(QString::fromLatin1(name));
  label->setWordWrap(true);
  QFont font = label->font();
  font.setPointSizeF(points);
  label->setFont(font);
  return label;
}

QPushButton* new_button(const char* name, const char* words) {
  auto* button = new QPushButton(QString::fromUtf8(words));
  button->setObjectName(QString::fromLatin1(name));
  return button;
}

}  // namespace

CalibrationPanel::CalibrationPanel(QWidget* parent)
    : QWidget(parent),
      step_(new_label("step", 16.0)),
      result_(new_label("fit", 11.0)),
      counts_(new_label("counts", 16.0)),
      mass_(new_number("mass", 0.0, 1000.0, 4, QStringLiteral(" kg"))),
      lever_arm_(new_number("calibrated lever arm", -10.0, 10.0, 4, QStringLiteral(" m"))),
      readings_(new QTableWidget(0, 4)),
      read_(new_button("read", "Take reading   Return")),
      forget_(new_button("forget", "Forget the last")),
      save_(new_button("save", "Save and use")),
      leave_(new_button("leave", "Back   Esc")) {
  readings_->setHorizontalHeaderLabels({QStringLiteral("mass (kg)"), QStringLiteral("force (N)"),
                                        QStringLiteral("counts (–)"),
                                        QStringLiteral("residual (N)")});
  readings_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  readings_->verticalHeader()->hide();
  readings_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  auto* row = new QHBoxLayout;
  row->addWidget(new QLabel(QStringLiteral("Mass")));
  row->addWidget(mass_);
  row->addWidget(read_);
  row->addWidget(forget_);
  row->addStretch(1);
  auto* last = new QHBoxLayout;
  last->addWidget(new QLabel(QStringLiteral("Lever arm")));
  last->addWidget(lever_arm_);
  last->addWidget(save_);
  last->addWidget(leave_);
  last->addStretch(1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(24, 16, 24, 16);
  layout->setSpacing(12);
  layout->addWidget(step_);
  layout->addLayout(row);
  layout->addWidget(counts_);
  layout->addWidget(readings_, 1);
  layout->addWidget(result_);
  layout->addLayout(last);
  connect(read_, &QPushButton::clicked, this, [this] { read_weight(); });
  connect(lever_arm_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this] { fit(); });
  connect(save_, &QPushButton::clicked, this, [this] { save(); });
  connect(leave_, &QPushButton::clicked, this, [this] { leave(); });
  connect(forget_, &QPushButton::clicked, this, [this] {
    if (!weights_.empty()) weights_.pop_back();
    fit();
  });
}

void CalibrationPanel::begin(const std::filesystem::path& folder, double lever_arm_m) {
  folder_ = folder;
  weights_.clear();
  weighing_.reset();
  lever_arm_->setValue(lever_arm_m);
  mass_->setValue(0.0);
  fit();
  mass_->setFocus();
  mass_->selectAll();
}

void CalibrationPanel::keyPressEvent(QKeyEvent* event) {
  const int key = event->key();
  if (key == Qt::Key_Escape) return leave();
  if ((key == Qt::Key_Return || key == Qt::Key_Enter) && read_->isEnabled()) return read_weight();
  QWidget::keyPressEvent(event);
}

void CalibrationPanel::read_weight() {
  mass_kg_ = mass_->value();
  weighing_.emplace(mass_kg_ * gravity);
  hung_ = false;
  read_->setEnabled(false);
}

void CalibrationPanel::take(const LiveNews& news, RigSession& rig) {
  if (!news.counts.empty())
    counts_->setText(QStringLiteral("now %1 counts").arg(said(news.counts.back(), 0)));
  if (!weighing_) return;
  if (!hung_) {
    (void)rig.command_board("hold " + std::to_string(mass_kg_ * gravity));
    hung_ = true;
    return;  // what has come was before
  }
  const auto weight = weighing_->take(news.counts);
  counts_->setText(QStringLiteral("reading… %1 %").arg(int(100.0 * weighing_->progress())));
  if (!weight) return;
  weights_.push_back(*weight);
  weighing_.reset();
  (void)rig.command_board("release");
  fit();
}

void CalibrationPanel::fit() {
  read_->setEnabled(!weighing_);
  calibration_.reset();
  QString words;
  if (weights_.size() >= 3) {
    try {
      calibration_ = acquisition::calibrate(weights_);
      calibration_->lever_arm_m = lever_arm_->value();
      calibration_->date = QDate::currentDate().toString(Qt::ISODate).toStdString();
      words = QString::fromStdString(acquisition::describe(*calibration_));
      for (const std::string& doubt : acquisition::doubts(*calibration_))
        words += QStringLiteral("\nLook at this: %1.").arg(QString::fromStdString(doubt));
    } catch (const std::exception& error) {
      words = QString::fromUtf8(error.what());
    }
  }
  result_->setText(words);
  save_->setEnabled(calibration_.has_value());
  forget_->setEnabled(!weights_.empty());
  say(weights_.empty()
          ? QStringLiteral("1. Take everything off the load cell, then take a reading.")
      : weights_.size() < 3
          ? QStringLiteral("2. Hang a known mass, say which, and take a reading. %1 more at least.")
                .arg(3 - weights_.size())
          : QStringLiteral(
                "3. More masses make it surer; or save it, and it is used from now on."));
  show_readings();
}

void CalibrationPanel::show_readings() {
  readings_->setRowCount(int(weights_.size()));
  for (int i = 0; i < int(weights_.size()); ++i) {
    const auto& weight = weights_[std::size_t(i)];
    const QString residual =
        calibration_ ? said(calibration_->residuals_n[std::size_t(i)], 3) : QStringLiteral("–");
    const QString cells[] = {said(weight.force_n / gravity, 4), said(weight.force_n, 3),
                             said(weight.counts, 1), residual};
    for (int column = 0; column < 4; ++column)
      readings_->setItem(i, column, new QTableWidgetItem(cells[column]));
  }
}

void CalibrationPanel::save() {
  std::filesystem::path file = folder_ / ("loadcell-" + calibration_->date + ".toml");
  for (int again = 2; std::filesystem::exists(file); ++again)
    file = folder_ / ("loadcell-" + calibration_->date + "-" + std::to_string(again) + ".toml");
  try {
    std::filesystem::create_directories(folder_);
    acquisition::write_text_file(file, acquisition::to_toml(*calibration_));
  } catch (const std::exception& error) {
    return say(QString::fromUtf8(error.what()));
  }
  use(file);
}

void CalibrationPanel::say(const QString& words) {
  step_->setText(words);
}

}  // namespace searig::app::desktop
