// A recording: its name, its notes, how it stands.
#pragma once

#include <QGroupBox>
#include <filesystem>
#include <string>

#include "app/rig/rig_session.h"

class QLabel;
class QLineEdit;
class QPushButton;

namespace searig::app::desktop {

class RecordPanel : public QGroupBox {
 public:
  explicit RecordPanel(QWidget* parent = nullptr);

  /// Where recordings are kept; it is made when it is needed.
  void set_folder(const std::filesystem::path& folder) { folder_ = folder; }
  const std::filesystem::path& folder() const { return folder_; }

  /// The file to record into: the name that was given, or the hour; never one that is there.
  std::filesystem::path next_file() const;
  std::string notes() const;

  void show_status(const RecordingStatus& status, bool connected);
  QLineEdit* name() const { return name_; }
  QLineEdit* notes_line() const { return notes_line_; }
  QPushButton* button() const { return button_; }
  QPushButton* marker() const { return marker_; }
  QPushButton* open() const { return open_; }

 private:
  std::filesystem::path folder_;
  QLineEdit *name_, *notes_line_;
  QLabel* status_;
  QPushButton *button_, *marker_, *open_;
};

}  // namespace searig::app::desktop
