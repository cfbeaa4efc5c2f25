#pragma once

#include <QMenu>
#include <QStringList>

namespace geargraph {

/// The recently opened or saved files, newest first, stored in the settings; and their menu.
class RecentFiles : public QMenu {
  Q_OBJECT

 public:
  static constexpr int kMax = 10;

  explicit RecentFiles(QWidget* parent = nullptr);

  static void add(const QString& path);
  static void forget(const QString& path);
  [[nodiscard]] static QStringList paths();

 signals:
  void chosen(const QString& path);

 private:
  void fill();
};

}  // namespace geargraph
