#include <QApplication>
#include <QFile>

#include "app/editor/command_line.h"
#include "app/editor/screenshot.h"
#include "ui/mainwindow/about_dialog.h"
#include "ui/mainwindow/main_window.h"
#include "ui/mainwindow/screen_fit.h"
#include "ui/mainwindow/start_page.h"
#include "ui/mainwindow/window_help.h"
#include "ui/mainwindow/window_set.h"
#include "ui/recovery/action_recorder.h"
#include "ui/recovery/crash_handler.h"
#include "ui/settings/languages.h"
#include "ui/theme/application_theme.h"
#include "ui/view3d/view3d.h"

int main(int argc, char** argv) {
  using namespace geargraph;
  // --help is asked for over remote lines, too.
  if (onlyPrints(argc, argv) && !qEnvironmentVariableIsSet("QT_QPA_PLATFORM"))
    qputenv("QT_QPA_PLATFORM", "offscreen");
  View3D::prepareApplication();
  QApplication application(argc, argv);
  QApplication::setOrganizationName(QStringLiteral("GearGraph"));
  QApplication::setApplicationName(QStringLiteral("GearGraph"));
  QApplication::setDesktopFileName(QStringLiteral("org.geargraph.geargraph"));  // its icon, for Wayland
  QApplication::setApplicationVersion(QStringLiteral(GEARGRAPH_VERSION));

  const CommandLine line = readCommandLine(QApplication::arguments());
  const QString usual = line.screenshot ? QStringLiteral("en") : savedLanguage();
  const QString language = line.language.value_or(usual);
  useLanguage(language.isEmpty() ? systemLanguage() : language);
  applyTheme(application, line.theme.value_or(line.screenshot ? Theme::light : savedTheme()));

  if (line.screenshot) return screenshot(line);
  installCrashHandler(QFile::encodeName(WindowSet::defaultFolder()).toStdString(),
                      programDetails().toStdString());
  const ActionRecorder recorder(nullptr);
  const ScreenFit screenFit;
  WindowSet windows(WindowSet::defaultFolder());
  windows.start(line.documents);
  if (windows.windows().empty()) return 0;
  // Where nothing was asked for and nothing is opened again, this may be the first time that the program is
  // used.
  if (MainWindow* first = windows.windows().front();
      line.documents.isEmpty() && first->startPage().isVisible())
    first->help().offerTour();
  if (line.size) {
    for (MainWindow* window : windows.windows()) window->resize(*line.size);
  }
  return QApplication::exec();
}
