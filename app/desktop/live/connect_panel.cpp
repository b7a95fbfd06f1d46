#include "app/desktop/live/connect_panel.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QLineEdit>
#include <QPushButton>

#include "acquisition/recording/text_file.h"
#include "acquisition/source/port_list.h"

namespace searig::app::desktop {
namespace {

constexpr int look_every_ms = 2000;

/// The name of a source as it is chosen from the list, or typed.
std::string chosen(const QComboBox& box) {
  const int listed = box.findText(box.currentText());
  return (listed >= 0 ? box.itemData(listed).toString() : box.currentText().trimmed())
      .toStdString();
}

void set(QComboBox& box, const std::string& source) {
  const QString name = QString::fromStdString(source);
  const int listed = box.findData(name);
  listed >= 0 ? box.setCurrentIndex(listed) : box.setEditText(name);
  box.lineEdit()->home(false);  // its beginning says most
}

/// Keeps what is chosen; an open list is not changed under the user's hand.
void fill(QComboBox& box, const QString& first, const std::vector<acquisition::ListedPort>& ports) {
  if (box.count() == int(ports.size()) + 1) return;
  const std::string before = box.count() > 0 ? chosen(box) : simulated;
  box.clear();
  box.addItem(first, QString::fromLatin1(simulated));
  for (const auto& port : ports)
    box.addItem(QString::fromStdString(port.words), QString::fromStdString(port.source));
  set(box, before);
}

/// A button that bears a file's name, as much of it as there is room for.
void name(QPushButton& button, const std::string& file) {
  constexpr int room = 140;  // pixels
  const QString whole = QString::fromStdString(file);
  const QString last = QFileInfo(whole).fileName();
  button.setText(button.fontMetrics().elidedText(last, Qt::ElideMiddle, room));
  button.setToolTip(whole);
}

QComboBox* new_box(const QString& name, const QString& tip) {
  auto* box = new QComboBox;
  box->setObjectName(name);
  box->setEditable(true);
  box->setInsertPolicy(QComboBox::NoInsert);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(12);
  box->setToolTip(tip);
  box->setFocusPolicy(Qt::ClickFocus);  // single keys are the page's
  return box;
}

}  // namespace

ConnectPanel::ConnectPanel(QWidget* parent)
    : QGroupBox(QStringLiteral("Rig"), parent),
      loadcell_(new_box(QStringLiteral("loadcell"),
                        QStringLiteral("serial:DEVICE, udp://HOST:PORT, or chosen from the list"))),
      module_(new_box(QStringLiteral("module"),
                      QStringLiteral("udp://HOST:PORT, serial:DEVICE, or chosen from the list"))),
      lever_arm_(new QDoubleSpinBox),
      calibration_(new QPushButton(QStringLiteral("its own"))),
      model_(new QPushButton),
      button_(new QPushButton) {
  model_->setObjectName(QStringLiteral("model"));
  lever_arm_->setObjectName(QStringLiteral("lever arm"));
  lever_arm_->setRange(-10.0, 10.0);
  lever_arm_->setDecimals(4);
  lever_arm_->setSingleStep(0.01);
  lever_arm_->setSuffix(QStringLiteral(" m"));
  lever_arm_->setSpecialValueText(QStringLiteral("as known"));
  lever_arm_->setValue(lever_arm_->minimum());
  lever_arm_->setToolTip(QStringLiteral(
      "From the joint to the load cell; negative where it pulls the other way. As known: the "
      "calibration's, or the simulated rig's, else 1 m."));
  button_->setObjectName(QStringLiteral("connect"));
  auto* form = new QFormLayout(this);
  form->setContentsMargins(8, 4, 8, 8);
  form->setVerticalSpacing(4);
  form->addRow(QStringLiteral("Load cell"), loadcell_);
  form->addRow(QStringLiteral("Module"), module_);
  form->addRow(QStringLiteral("Lever arm"), lever_arm_);
  form->addRow(QStringLiteral("Calibration"), calibration_);
  form->addRow(QStringLiteral("Model"), model_);
  form->addRow(button_);
  const QString toml = QStringLiteral("TOML (*.toml);;All files (*)");
  connect(calibration_, &QPushButton::clicked, this, [this, toml] {
    choose_file(QStringLiteral("The load cell's calibration"), toml, calibration_file_,
                calibration_);
  });
  connect(model_, &QPushButton::clicked, this, [this, toml] {
    choose_file(QStringLiteral("The model of the actuator"), toml, model_file_, model_);
  });
  connect(&ports_, &QTimer::timeout, this, [this] { look_for_ports(); });
  connect(module_, &QComboBox::currentTextChanged, this, [this] { show_model(); });
  ports_.setInterval(look_every_ms);
  look_for_ports();
  show_state(State::away);
}

void ConnectPanel::look_for_ports() {
  const auto ports = acquisition::list_serial_ports();
  fill(*loadcell_, QStringLiteral("Simulated load cell"), ports);
  fill(*module_, QStringLiteral("Simulated module"), ports);
}

void ConnectPanel::choose_file(const QString& title, const QString& filter, std::string& file,
                               QPushButton* on) {
  const QString chosen_file = QFileDialog::getOpenFileName(this, title, {}, filter);
  if (chosen_file.isEmpty()) return;
  file = chosen_file.toStdString();
  name(*on, file);
}

void ConnectPanel::show_model() {
  if (!model_file_.empty()) return name(*model_, model_file_);
  model_->setText(chosen(*module_) == simulated ? QStringLiteral("its own")
                                                : QStringLiteral("none"));
}

void ConnectPanel::choose(const std::string& module, const std::string& loadcell) {
  set(*module_, module);
  set(*loadcell_, loadcell);
}

void ConnectPanel::set_calibration(const std::string& file) {
  calibration_file_ = file;
  name(*calibration_, file);
}

void ConnectPanel::set_model(const std::string& file) {
  model_file_ = file;
  show_model();
}

RigOptions ConnectPanel::options() const {
  RigOptions options;
  options.module = chosen(*module_);
  options.loadcell = chosen(*loadcell_);
  options.simulation = simulation_;
  if (lever_arm_->value() > lever_arm_->minimum()) options.lever_arm_m = lever_arm_->value();
  if (!calibration_file_.empty())
    options.calibration = acquisition::read_text_file(calibration_file_);
  if (!model_file_.empty())
    options.model = estimator::parse_model(acquisition::read_text_file(model_file_), model_file_);
  return options;
}

std::vector<QWidget*> ConnectPanel::fields() const {
  return {loadcell_, module_, lever_arm_};
}

void ConnectPanel::show_state(State state) {
  for (QWidget* widget :
       std::initializer_list<QWidget*>{loadcell_, module_, lever_arm_, calibration_, model_})
    widget->setEnabled(state == State::away);
  button_->setEnabled(state != State::connecting);
  button_->setText(state == State::away         ? QStringLiteral("Connect   Ctrl+R")
                   : state == State::connecting ? QStringLiteral("Connecting…")
                                                : QStringLiteral("Disconnect   Ctrl+R"));
  state == State::away ? ports_.start() : ports_.stop();
}

}  // namespace searig::app::desktop
