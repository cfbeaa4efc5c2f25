#include "app/editor/screenshot.h"

#include <QApplication>
#include <QPixmap>
#include <QThreadPool>

#include "ui/mainwindow/main_window.h"

namespace geargraph {
namespace {

/// Wherever the pointer happens to be, nothing shows it.
void forgetPointer(MainWindow& window) {
  for (QWidget* each : window.findChildren<QWidget*>()) {
    if (!each->underMouse()) continue;
    each->setAttribute(Qt::WA_UnderMouse, false);
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(each, &leave);
  }
  window.selection().unhover();
}

void takeScreenshot(MainWindow& window, const QString& file) {
  QThreadPool::globalInstance()->waitForDone();
  QCoreApplication::sendPostedEvents();  // the pictures of the start page
  forgetPointer(window);
  const bool written = window.grab().save(file);
  if (!written) qCritical("Cannot write %s.", qPrintable(file));
  QApplication::exit(written ? 0 : 1);
}

}  // namespace

int screenshot(const CommandLine& line) {
  MainWindow window;
  if (line.size) window.resize(*line.size);
  const QString document = line.documents.value(0);
  if (!document.isEmpty() && !window.openDocument(document)) {
    qCritical("Cannot open %s.", qPrintable(document));
    return 2;
  }
  if (line.drawing && !window.showDrawing(*line.drawing)) {
    qCritical("There is no drawing %s.", qPrintable(*line.drawing));
    return 2;
  }
  QObject::connect(
      &window, &MainWindow::settled, &window,
      [&] {
        // Behind the layout and paint events that the arrival has posted.
        QMetaObject::invokeMethod(
            &window, [&] { takeScreenshot(window, *line.screenshot); }, Qt::QueuedConnection);
      },
      Qt::QueuedConnection);
  window.show();
  if (document.isEmpty()) window.showStartPage(false);
  return QApplication::exec();
}

}  // namespace geargraph
