// Where things are on the page.
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "app/desktop/diagnose/diagnose_page.h"
#include "app/desktop/diagnose/guided_motion.h"
#include "app/desktop/diagnose/map_view.h"
#include "app/desktop/plot/time_plot.h"
#include "app/desktop/work_bar.h"

namespace searig::app::desktop {
namespace {

constexpr int right_px = 420;

QPushButton* button(const char* words, const char* name, QWidget* parent) {
  auto* out = new QPushButton(QString::fromUtf8(words), parent);
  out->setObjectName(QLatin1String(name));
  out->setFocusPolicy(Qt::NoFocus);  // keys are the page's
  return out;
}

QScrollArea* scrolling(QWidget* inside, QWidget* parent) {
  auto* area = new QScrollArea(parent);
  area->setWidget(inside);
  area->setWidgetResizable(true);
  area->setFrameStyle(QFrame::NoFrame);
  return area;
}

}  // namespace

DiagnosePage::DiagnosePage(Shell& shell)
    : Page(QStringLiteral("Diagnose"), shell),
      work_(new WorkBar(this)),
      hint_(new QLabel(this)),
      model_(new QLabel(this)),
      verdict_(new QLabel(this)),
      finding_(new QLabel),
      residual_plot_(new TimePlot(QStringLiteral("What the model leaves out"),
                                  QStringLiteral("difference (N·m)"), this)),
      map_(new MapView(nullptr)),
      map_area_(scrolling(map_, this)),
      left_(new QStackedWidget(this)),
      guided_(new GuidedMotion(this)),
      diagnose_(button("Diagnose   D", "diagnose", this)),
      accept_(button("Accept   A", "accept", this)),
      next_(button("Next experiment   N", "next", this)),
      report_(button("Report…   P", "report", this)) {
  residual_plot_->setObjectName(QStringLiteral("residual"));
  residual_plot_->add_curve({}, Hue::vermilion);
  residual_plot_->add_curve({}, Hue::blue);
  residual_plot_->setMinimumHeight(220);
  make_layout();
  make_actions();
  connect(diagnose_, &QPushButton::clicked, this, [this] { diagnose(); });
  connect(accept_, &QPushButton::clicked, this, [this] { accept(); });
  connect(next_, &QPushButton::clicked, this, [this] { turn_to_experiment(); });
  connect(report_, &QPushButton::clicked, this, [this] { write_report(); });
  guided_->on_close([this] { turn_to_experiment(); });
  guided_->on_start(
      [this](const estimator::PlannedMotion& motion) { return this->Page::shell().lead(motion); });
  guided_->on_save([this] { save_experiment(); });
  work_->on_change([this] { follow_state(); });
  show_result(nullptr);
  say(QStringLiteral("Open a recording with Ctrl+O; then it can be diagnosed here."));
}

void DiagnosePage::make_layout() {
  for (QLabel* label : {hint_, verdict_}) {
    label->setWordWrap(true);
    label->setContentsMargins(14, 2, 14, 4);
  }
  hint_->setObjectName(QStringLiteral("hint"));
  verdict_->setObjectName(QStringLiteral("verdict"));
  QFont large = verdict_->font();
  large.setPointSizeF(12.0);
  large.setBold(true);
  verdict_->setFont(large);
  auto* buttons = new QHBoxLayout;
  buttons->setContentsMargins(14, 8, 14, 4);
  buttons->setSpacing(8);
  for (QPushButton* each : {diagnose_, accept_, next_, report_}) buttons->addWidget(each);
  model_->setEnabled(false);  // the palette's fainter text
  model_->setObjectName(QStringLiteral("model_in_use"));
  buttons->addWidget(model_, 1, Qt::AlignRight);

  auto* differences = new QWidget(this);
  auto* column = new QVBoxLayout(differences);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(1);
  column->addWidget(residual_plot_, 2);
  column->addWidget(map_area_, 3);
  left_->addWidget(differences);
  left_->addWidget(guided_);

  auto* row = new QHBoxLayout;
  row->setSpacing(0);
  row->addWidget(left_, 1);
  row->addWidget(make_right_side());
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addLayout(buttons);
  layout->addWidget(work_);
  layout->addWidget(verdict_);
  layout->addWidget(hint_);
  layout->addLayout(row, 1);
}

QWidget* DiagnosePage::make_right_side() {
  finding_->setObjectName(QStringLiteral("finding"));
  finding_->setWordWrap(true);
  finding_->setContentsMargins(14, 8, 14, 8);
  finding_->setAlignment(Qt::AlignTop);
  finding_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  QScrollArea* area = scrolling(finding_, this);
  area->setFixedWidth(right_px);
  return area;
}

}  // namespace searig::app::desktop
