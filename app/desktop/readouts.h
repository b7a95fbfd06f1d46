// The row of numbers above the plots: stiffness first, then whether to believe it.
#pragma once

#include <QLabel>
#include <QWidget>
#include <vector>

namespace searig::app::desktop {

class Readouts : public QWidget {
 public:
  explicit Readouts(QWidget* parent = nullptr);

  /// Adds a number with the words under it; returns its place.
  std::size_t add(const QString& name, bool large = false);
  void set(std::size_t place, const QString& value, const QString& note = {});

 private:
  struct Readout {
    QLabel* value;
    QLabel* note;
    QString name;
  };
  std::vector<Readout> readouts_;
};

}  // namespace searig::app::desktop
