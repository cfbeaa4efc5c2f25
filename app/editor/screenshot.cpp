#include "app/editor/screenshot.h"

#include <QApplication>
#include <QPixmap>

#include "ui/mainwindow/main_window.h"

namespace geargraph {
namespace {

void takeScreenshot(MainWindow& window, const QString& file) {
  window.selection().unhover();  // wherever the pointer happens to be
  const bool written = window.grab().save(file);
  if (!written) qCritical("Cannot write %s.", qPrintable(file));
  QApplication::exit(written ? 0 : 1);
}

}  // namespace

void screenshotWhenReady(MainWindow& window, const QString& file) {
  QObject::connect(
      &window, &MainWindow::settled, &window,
      [&window, file] {
        // Behind the layout and paint events that the arrival has posted.
        QMetaObject::invokeMethod(
            &window, [&window, file] { takeScreenshot(window, file); }, Qt::QueuedConnection);
      },
      Qt::QueuedConnection);
}

}  // namespace geargraph
