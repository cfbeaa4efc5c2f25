#include "ui/mainwindow/recent_files.h"

#include <QFileInfo>

#include "ui/mainwindow/thumbnails.h"
#include "ui/settings/settings.h"
#include "ui/theme/application_theme.h"

namespace geargraph {
namespace {
const QString kKey = QStringLiteral("recentFiles");
}

RecentFiles::RecentFiles(QWidget* parent) : QMenu(tr("Open &recent"), parent) {
  setToolTipsVisible(true);
  connect(this, &QMenu::aboutToShow, this, &RecentFiles::fill);
  fill();
}

QStringList RecentFiles::paths() {
  return savedSetting(kKey).toStringList();
}

void RecentFiles::add(const QString& path) {
  const QString absolute = QFileInfo(path).absoluteFilePath();
  QStringList list = paths();
  list.removeAll(absolute);
  list.prepend(absolute);
  saveSetting(kKey, QStringList(list.mid(0, kMax)));
}

void RecentFiles::forget(const QString& path) {
  QStringList list = paths();
  list.removeAll(path);
  saveSetting(kKey, list);
}

void RecentFiles::fill() {
  clear();
  const QStringList list = paths();
  for (const QString& path : list) {
    QAction* action = addAction(QFileInfo(path).fileName(), this, [this, path] { emit chosen(path); });
    const QString picture = Thumbnails::keptPath(path, themeOf(palette()));
    action->setToolTip(!QFileInfo::exists(picture) ? path
                                                   : QStringLiteral("<img src=\"%1\" width=\"%2\"><br>%3")
                                                         .arg(picture)
                                                         .arg(Thumbnails::kSize.width())
                                                         .arg(path.toHtmlEscaped()));
  }
  if (!list.isEmpty()) return;
  QAction* none = addAction(tr("No file has been opened yet"));
  none->setEnabled(false);
}

}  // namespace geargraph

#include "moc_recent_files.cpp"
