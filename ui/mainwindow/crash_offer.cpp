#include "ui/mainwindow/crash_offer.h"

#include <QApplication>
#include <QClipboard>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFile>
#include <QFontDatabase>
#include <QLocale>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/mainwindow/main_window.h"
#include "ui/mainwindow/notice_bar.h"
#include "ui/mainwindow/status_line.h"
#include "ui/recovery/crash_report.h"

namespace geargraph {
namespace {

void copy(const CrashReport& report) {
  QApplication::clipboard()->setText(report.text);
  keepCrashReport(report);
}

void showReport(const CrashReport& report, MainWindow* window) {
  auto* dialog = new QDialog(window);
  dialog->setObjectName(QStringLiteral("crashReport"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(MainWindow::tr("Crash report"));
  auto* text = new QPlainTextEdit(report.text, dialog);
  text->setReadOnly(true);
  text->setLineWrapMode(QPlainTextEdit::NoWrap);
  text->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, dialog);
  auto* copyButton = buttons->addButton(MainWindow::tr("Copy"), QDialogButtonBox::ActionRole);
  auto* deleteButton = buttons->addButton(MainWindow::tr("Delete"), QDialogButtonBox::DestructiveRole);
  copyButton->setAutoDefault(false);
  deleteButton->setAutoDefault(false);
  buttons->button(QDialogButtonBox::Close)->setDefault(true);
  auto* layout = new QVBoxLayout(dialog);
  layout->addWidget(text);
  layout->addWidget(buttons);
  QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::close);
  QObject::connect(copyButton, &QPushButton::clicked, dialog, [copyButton, report] {
    QApplication::clipboard()->setText(report.text);
    copyButton->setText(MainWindow::tr("Copied"));
  });
  QObject::connect(deleteButton, &QPushButton::clicked, dialog, [dialog, report] {
    QFile::remove(report.path);
    dialog->close();
  });
  // Closing the dialog by any other way keeps the report.
  QObject::connect(dialog, &QDialog::finished, window, [report] {
    if (QFile::exists(report.path)) keepCrashReport(report);
  });
  dialog->resize(720, 480);
  dialog->show();
}

}  // namespace

void offerCrashReports(const QString& folder, MainWindow& window) {
  for (const CrashReport& report : newCrashReports(folder)) {
    const QString time = QLocale().toString(report.time, QLocale::ShortFormat);
    MainWindow* shown = &window;
    window.notices().post(
        {report.path,
         Severity::warning,
         MainWindow::tr("GearGraph crashed on %1. A report says where in the program; it names neither "
                        "documents nor what is in them.")
             .arg(time),
         {{MainWindow::tr("Show report"), MainWindow::tr("Read it, and decide then"),
           [report, shown] { showReport(report, shown); }},
          {MainWindow::tr("Copy"), MainWindow::tr("For a message to the developers"),
           [report, shown] {
             copy(report);
             shown->statusLine().showNote(MainWindow::tr("The crash report was copied."));
           }},
          {MainWindow::tr("Delete"), MainWindow::tr("For good"), [report] { QFile::remove(report.path); }},
          {MainWindow::tr("Later"), MainWindow::tr("It will be offered again"), {}}}});
  }
}

}  // namespace geargraph
