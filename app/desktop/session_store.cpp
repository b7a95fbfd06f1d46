#include "app/desktop/session_store.h"

#include <QSettings>
#include <QStandardPaths>

namespace searig::app::desktop {
namespace {

constexpr int most_recent = 9;  // what keys 1 to 9 reach

const auto geometry_key = QStringLiteral("window/geometry");
const auto page_key = QStringLiteral("window/page");
const auto dark_key = QStringLiteral("window/dark");
const auto view_key = QStringLiteral("recordings/view");
const auto recent_key = QStringLiteral("recordings/recent");

}  // namespace

SessionStore::SessionStore() = default;
SessionStore::~SessionStore() = default;
SessionStore::SessionStore(SessionStore&&) noexcept = default;
SessionStore& SessionStore::operator=(SessionStore&&) noexcept = default;

SessionStore::SessionStore(const QString& file)
    : file_(std::make_unique<QSettings>(file, QSettings::IniFormat)),
      recent_(file_->value(recent_key).toStringList()) {}

QString SessionStore::usual_place() {
  const QString named = qEnvironmentVariable("SEARIG_SETTINGS");
  if (!named.isEmpty()) return named;
  return QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation) +
         QStringLiteral("/searig/window.ini");
}

QByteArray SessionStore::geometry() const {
  return file_ ? file_->value(geometry_key).toByteArray() : QByteArray();
}

QString SessionStore::page() const {
  return file_ ? file_->value(page_key).toString() : QString();
}

std::optional<bool> SessionStore::dark() const {
  if (!file_ || !file_->contains(dark_key)) return std::nullopt;
  return file_->value(dark_key).toBool();
}

QString SessionStore::view() const {
  return file_ ? file_->value(view_key).toString() : QString();
}

void SessionStore::keep_view(const QString& view) {
  if (file_) file_->setValue(view_key, view);
}

void SessionStore::keep_window(const QByteArray& geometry, const QString& page, bool dark) {
  if (!file_) return;
  file_->setValue(geometry_key, geometry);
  file_->setValue(page_key, page);
  file_->setValue(dark_key, dark);
  file_->sync();
}

void SessionStore::add_recent(const QString& recording) {
  recent_.removeAll(recording);
  recent_.prepend(recording);
  while (recent_.size() > most_recent) recent_.removeLast();
  if (!file_) return;
  file_->setValue(recent_key, recent_);
  file_->sync();
}

}  // namespace searig::app::desktop
