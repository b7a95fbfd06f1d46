// Every key there is, over the window.
#pragma once

#include <QWidget>
#include <vector>

class QLabel;
class QMenu;

namespace searig::app::desktop {

/// Covers its parent until the next key or click. What it says is read from the menus, so that it
/// is never out of date.
class Help : public QWidget {
 public:
  explicit Help(QWidget* parent);

  void show_keys(const std::vector<QMenu*>& menus);

 protected:
  bool event(QEvent* event) override;

 private:
  QLabel* keys_;
};

}  // namespace searig::app::desktop
