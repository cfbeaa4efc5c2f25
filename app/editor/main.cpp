#include <QApplication>
#include <QSettings>
#include <memory>
#include <vector>

#include "app/editor/command_line.h"
#include "app/editor/screenshot.h"
#include "ui/mainwindow/document_files.h"
#include "ui/mainwindow/main_window.h"
#include "ui/theme/application_theme.h"
#include "ui/view3d/view3d.h"

int main(int argc, char** argv) {
  using namespace geargraph;
  View3D::prepareApplication();
  QApplication application(argc, argv);
  QApplication::setOrganizationName(QStringLiteral("GearGraph"));
  QApplication::setApplicationName(QStringLiteral("GearGraph"));
  QApplication::setApplicationVersion(QStringLiteral(GEARGRAPH_VERSION));

  const CommandLine line = readCommandLine(QApplication::arguments());
  const bool savedDark = QSettings().value(QStringLiteral("dark"), false).toBool() && !line.screenshot;
  applyTheme(application, line.theme.value_or(savedDark ? Theme::dark : Theme::light));

  const QStringList documents = line.documents.isEmpty() ? QStringList{robotExamplePath()} : line.documents;
  std::vector<std::unique_ptr<MainWindow>> windows;
  for (const QString& path : documents) {
    windows.push_back(std::make_unique<MainWindow>());
    MainWindow& window = *windows.back();
    if (!line.screenshot) window.restoreLayout();
    if (line.size) window.resize(*line.size);
    const bool opened = window.openDocument(path);
    if (line.screenshot && !opened) {
      qCritical("Cannot open %s.", qPrintable(path));
      return 2;
    }
    if (line.screenshot) screenshotWhenReady(window, *line.screenshot);
    window.show();
  }
  return QApplication::exec();
}
