#include "ui/mainwindow/about_dialog.h"

#include <QApplication>
#include <QClipboard>
#include <QMessageBox>
#include <QPushButton>
#include <QSysInfo>

#include "ui/view3d/view3d.h"

namespace geargraph {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("MainWindow", text);
}

}  // namespace

QString programDetails() {
  // Not translated: who reads it need not have the user's language.
  return QStringLiteral(
             "Version: %1\nQt: %2 (built with %3)\nSystem: %4, %5 %6, %7\nPlatform: %8\nOpenGL: %9\n")
      .arg(QApplication::applicationVersion(), QString::fromLatin1(qVersion()),
           QStringLiteral(QT_VERSION_STR), QSysInfo::prettyProductName(), QSysInfo::kernelType(),
           QSysInfo::kernelVersion(), QSysInfo::currentCpuArchitecture(), QApplication::platformName(),
           View3D::driver());
}

void showAboutDialog(QWidget* parent) {
  const QString details = programDetails();
  auto* box =
      new QMessageBox(QMessageBox::NoIcon, tr("About GearGraph"),
                      tr("<b>GearGraph %1</b><p>Draw, analyse and see geared mechanisms by the matroid "
                         "and the T–T graph methods "
                         "(Amirinezhad and Uyguroğlu, 2014).</p><p>MIT licence.</p>")
                          .arg(QApplication::applicationVersion()),
                      QMessageBox::Ok, parent);
  box->setObjectName(QStringLiteral("about"));
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setModal(false);
  box->setIconPixmap(parent->windowIcon().pixmap(64, 64));
  box->setInformativeText(details.trimmed());
  QPushButton* copy = box->addButton(tr("Copy details"), QMessageBox::ActionRole);
  box->setEscapeButton(QMessageBox::Ok);  // with two buttons Esc and the frame's cross would do nothing
  copy->disconnect();                     // copying does not close the box
  QObject::connect(copy, &QPushButton::clicked, copy, [copy, details] {
    QApplication::clipboard()->setText(details);
    copy->setText(tr("Copied"));
  });
  box->show();
}

}  // namespace geargraph
