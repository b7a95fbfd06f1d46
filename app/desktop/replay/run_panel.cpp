#include "app/desktop/replay/run_panel.h"

#include <QComboBox>
#include <QDoubleValidator>
#include <QFileDialog>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <utility>

#include "app/desktop/wording.h"

namespace searig::app::desktop {
namespace {

struct Kind {
  RunKind kind;
  const char* words;
};
constexpr Kind kinds[] = {
    {RunKind::online, "online (the paper's)"},   {RunKind::linear, "Kalman, several states"},
    {RunKind::rls, "least squares, recursive"},  {RunKind::moments, "paper's, closed form"},
    {RunKind::paper, "paper's, several states"}, {RunKind::simulation, "the model's simulation"}};

struct States {
  const char* words;
  std::vector<std::string> names;
};
const std::vector<States>& states_to_choose() {
  static const std::vector<States> all = {
      {"stiffness", {"spring.linear"}},
      {"and damping", {"spring.linear", "spring.viscous"}},
      {"and softening", {"spring.linear", "spring.mullins"}},
      {"and hardening (cubic)", {"spring.linear", "spring.cubic"}},
      {"and relaxation", {"spring.linear", "spring.relaxation"}},
      {"damping, softening", {"spring.linear", "spring.viscous", "spring.mullins"}}};
  return all;
}

QString run_words(const EstimatorRun& run) {
  QString words = QStringLiteral("<b>%1</b><br>torque error %2")
                      .arg(QString::fromStdString(run.history.estimated_from).toHtmlEscaped(),
                           error_words(run.history, false));
  if (!run.history.stiffness_nm_per_rad.empty())
    words += QStringLiteral(", k %1").arg(stiffness_words(run.history));
  return words;
}

}  // namespace

RunPanel::RunPanel(QWidget* parent)
    : QWidget(parent),
      kind_(new QComboBox(this)),
      states_(new QComboBox(this)),
      initial_k_(new QLineEdit(this)),
      model_(new QComboBox(this)),
      run_(new QPushButton(QStringLiteral("Run again   R"), this)),
      take_away_(new QPushButton(QStringLiteral("Take away   X"), this)),
      runs_(new QLabel(this)) {
  kind_->setObjectName(QStringLiteral("kind"));
  states_->setObjectName(QStringLiteral("states"));
  initial_k_->setObjectName(QStringLiteral("initial_k"));
  model_->setObjectName(QStringLiteral("model"));
  run_->setObjectName(QStringLiteral("run_again"));
  take_away_->setObjectName(QStringLiteral("take_away"));
  runs_->setObjectName(QStringLiteral("runs"));
  make_form();
  set_enabled(false);
  follow_kind();
  show_runs(nullptr, nullptr);
}

void RunPanel::make_form() {
  for (const Kind& kind : kinds) kind_->addItem(QString::fromUtf8(kind.words));
  for (const States& states : states_to_choose()) states_->addItem(QString::fromUtf8(states.words));
  auto* above_zero = new QDoubleValidator(1e-3, 1e6, 6, initial_k_);
  above_zero->setLocale(QLocale::c());
  initial_k_->setValidator(above_zero);
  initial_k_->setPlaceholderText(QStringLiteral("a good one, N·m/rad"));
  model_->addItems({QStringLiteral("the recording's own"), QStringLiteral("another file…")});
  for (QComboBox* box : {kind_, states_, model_}) {
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(14);
  }
  auto* form = new QFormLayout;
  form->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
  form->addRow(QStringLiteral("estimator"), kind_);
  form->addRow(QStringLiteral("states"), states_);
  form->addRow(QStringLiteral("first k"), initial_k_);
  form->addRow(QStringLiteral("model"), model_);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(run_);
  buttons->addWidget(take_away_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(new QLabel(QStringLiteral("<b>the estimator with other settings</b>"), this));
  layout->addLayout(form);
  layout->addLayout(buttons);
  layout->addWidget(runs_);
  runs_->setWordWrap(true);
  connect(kind_, qOverload<int>(&QComboBox::activated), this, [this] { follow_kind(); });
  connect(model_, qOverload<int>(&QComboBox::activated), this,
          [this](int place) { choose_model(place); });
}

void RunPanel::follow_kind() {
  const RunKind kind = kinds[kind_->currentIndex()].kind;
  states_->setEnabled(kind != RunKind::online && kind != RunKind::simulation);
  initial_k_->setEnabled(kind != RunKind::simulation);
}

/// The last place is for a file that is not in the list yet.
void RunPanel::choose_model(int place) {
  if (place + 1 < model_->count()) {
    chosen_model_ = place;
    return;
  }
  model_->setCurrentIndex(chosen_model_);
  const QString file = QFileDialog::getOpenFileName(this, QStringLiteral("A model file"), {},
                                                    QStringLiteral("Models (*.toml)"));
  if (!file.isEmpty()) use_model(file.toStdString());
}

void RunPanel::use_model(const std::filesystem::path& file) {
  const QString path = QString::fromStdString(file.string());
  int place = model_->findData(path);
  if (place < 0) {
    place = model_->count() - 1;
    model_->insertItem(place, QString::fromStdString(file.filename().string()), path);
  }
  model_->setItemData(place, path, Qt::ToolTipRole);
  model_->setCurrentIndex(chosen_model_ = place);
}

RunSettings RunPanel::settings() const {
  RunSettings out;
  out.kind = kinds[kind_->currentIndex()].kind;
  if (states_->isEnabled())
    out.states = states_to_choose()[std::size_t(states_->currentIndex())].names;
  bool is_number = false;
  const double k = QLocale::c().toDouble(initial_k_->text(), &is_number);
  if (is_number && k > 0.0 && initial_k_->isEnabled()) out.initial_k_nm_per_rad = k;
  const QString file = model_->currentData().toString();
  if (!file.isEmpty()) out.model_file = file.toStdString();
  return out;
}

void RunPanel::show_runs(const EstimatorRun* first, const EstimatorRun* second) {
  QString words;
  if (first) words = run_words(*first);
  if (second) words += QStringLiteral("<br><br>") + run_words(*second);
  runs_->setText(words);
  take_away_->setEnabled(second != nullptr);
}

void RunPanel::set_enabled(bool there_is_a_recording) {
  run_->setEnabled(there_is_a_recording);
}

void RunPanel::on_run(std::function<void()> run) {
  connect(run_, &QPushButton::clicked, this, std::move(run));
}

void RunPanel::on_take_away(std::function<void()> take_away) {
  connect(take_away_, &QPushButton::clicked, this, std::move(take_away));
}

}  // namespace searig::app::desktop
