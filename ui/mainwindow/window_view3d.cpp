// What the window does for its 3D view: the commands of its menus, the files it writes.

#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>

#include "core/io/file.h"
#include "ui/mainwindow/main_window.h"
#include "ui/mainwindow/status_line.h"
#include "ui/view3d/view3d.h"

namespace geargraph {

void MainWindow::wireView3DCommands() {
  connect(m_view3d, &View3D::noteMade, m_status, &StatusLine::showNote);
  connect(m_view3d, &View3D::traceFileWanted, this, &MainWindow::chooseAndSaveTrace);
  // The part that the menu is about is selected, so the commands of the menu bar mean it.
  connect(m_view3d, &View3D::menuOpening, this, [this](QMenu* menu, const std::optional<ElementId>& element) {
    if (!element) return;
    menu->addSeparator();
    menu->addActions({m_actions->drive, m_actions->makeGround, m_actions->rename});
    menu->addAction(tr("Properties"), this, [this] {
      auto* dock = findChild<QDockWidget*>(QStringLiteral("dock.properties"));
      dock->show();
      dock->raise();
    });
  });
}

void MainWindow::chooseAndSaveTrace() {
  if (m_view3d->traces().empty()) return;
  const QString path = QFileDialog::getSaveFileName(this, tr("Save the traced path"), tr("path.csv"),
                                                    tr("CSV files (*.csv);;All files (*)"));
  if (!path.isEmpty()) saveTrace(path);
}

bool MainWindow::saveTrace(const QString& path) {
  const std::string csv = pathCsv(m_view3d->traces().back().path, m_view3d->stage()->unit);
  if (const auto error = writeFile(path.toStdString(), csv)) {
    m_status->showRefusal(QString::fromStdString(error->message));
    return false;
  }
  m_status->showNote(tr("Saved %1").arg(QFileInfo(path).fileName()));
  return true;
}

}  // namespace geargraph
