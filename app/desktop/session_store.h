// What the window keeps from one session to the next.
#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>
#include <memory>
#include <optional>

class QSettings;

namespace searig::app::desktop {

class SessionStore {
 public:
  /// Keeps nothing: for pictures and most tests.
  SessionStore();
  /// Keeps it in this file. What cannot be read or written there is as if it had never been.
  explicit SessionStore(const QString& file);
  ~SessionStore();
  SessionStore(SessionStore&&) noexcept;
  SessionStore& operator=(SessionStore&&) noexcept;

  /// $SEARIG_SETTINGS, else the user's place for such files.
  static QString usual_place();

  QByteArray geometry() const;
  QString page() const;
  std::optional<bool> dark() const;
  /// Recordings, the last one first.
  QStringList recent() const { return recent_; }

  /// What of the last recording was in view: its range and the cursors, seconds; "low high a b"
  /// with "-" for what there is not. Empty where nothing was kept.
  QString view() const;
  void keep_view(const QString& view);

  void keep_window(const QByteArray& geometry, const QString& page, bool dark);
  void add_recent(const QString& recording);

 private:
  std::unique_ptr<QSettings> file_;
  QStringList recent_;
};

}  // namespace searig::app::desktop
