#include "ui/mainwindow/export_jobs.h"

#include <QDesktopServices>
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QFileInfo>
#include <QLocale>
#include <QUrl>

#include "core/foundations/files/file.h"
#include "ui/mainwindow/notice_bar.h"

namespace geargraph {
namespace {

const QString kKey = QStringLiteral("exports");
const QString kWrittenKey = QStringLiteral("exports.written");

/// "robot.stl (2.1 MB)", "robot-mjcf (a folder with 9 files, 3 MB)".
QString describedFile(const QString& path) {
  const QFileInfo info(path);
  const auto sizeOf = [](qint64 bytes) {
    return QLocale().formattedDataSize(bytes, 1, QLocale::DataSizeSIFormat);
  };
  if (!info.isDir()) return QStringLiteral("%1 (%2)").arg(info.fileName(), sizeOf(info.size()));
  int files = 0;
  qint64 bytes = 0;
  QDirIterator each(path, QDir::Files, QDirIterator::Subdirectories);
  for (; each.hasNext(); ++files) bytes += QFileInfo(each.next()).size();
  return ExportJobs::tr("%1 (a folder with %2 files, %3)").arg(info.fileName()).arg(files).arg(sizeOf(bytes));
}

}  // namespace

QString writingError(const QString& path, const std::string& bytes) {
  const auto error = writeFile(QFile::encodeName(path).toStdString(), bytes);
  return error ? QString::fromStdString(error->message) : QString();
}

ExportJobs::ExportJobs(NoticeBar* notices, QObject* parent) : QObject(parent), m_notices(notices) {}

ExportJobs::~ExportJobs() {
  requestStop();
}

void ExportJobs::requestStop() {
  m_waiting.clear();
  stop();
}

void ExportJobs::add(Job job) {
  m_waiting.push_back(std::move(job));
  if (!m_isBusy) startNext();
}

void ExportJobs::stop() {
  m_thread.request_stop();
}

void ExportJobs::startNext() {
  if (m_waiting.empty()) return;
  const Job job = std::move(m_waiting.front());
  m_waiting.pop_front();
  m_isBusy = true;
  const QString name = QFileInfo(job.path).fileName();
  if (job.isLong) {
    m_notices->post({kKey,
                     Severity::info,
                     tr("Exporting %1.").arg(name),
                     {{tr("Stop"), tr("Give up this export; nothing is written"), [this] { stop(); }}}});
  }
  // The one before has said its last word, so joining it waits for nothing.
  m_thread = std::jthread([this, job, name](const std::stop_token& stop) {
    const Progress progress = [this, name, inPercent = job.isInPercent](int done, int all) {
      QMetaObject::invokeMethod(
          this,
          [this, name, inPercent, done, all] {
            m_notices->setText(
                kKey, inPercent ? tr("Exporting %1: %2 %.").arg(name).arg(done)
                                : tr("Exporting %1: %2 of %3 pictures.").arg(name).arg(done).arg(all));
          },
          Qt::QueuedConnection);
    };
    const QString why = job.run(progress, stop);
    QMetaObject::invokeMethod(
        this, [this, job, why, stopped = stop.stop_requested()] { onDone(job, why, stopped); },
        Qt::QueuedConnection);
  });
}

void ExportJobs::onDone(const Job& job, const QString& why, bool stopped) {
  m_isBusy = false;
  if (job.isLong) m_notices->withdraw(kKey);
  if (why.isEmpty()) {
    const QStringList notes = job.notes ? job.notes() : QStringList();
    if (!job.path.isEmpty()) tellWritten(job.path, notes);
    emit finished(job.path);
    if (!notes.empty()) emit told(notes.join(QLatin1Char(' ')));
  } else {
    emit failed(
        stopped ? tr("The export of %1 was stopped; nothing was written.").arg(QFileInfo(job.path).fileName())
                : why);
  }
  if (!m_isBusy) startNext();  // whoever heard of it may have added one
}

/// Its place is told, so that it is found without the notice too.
void ExportJobs::tellWritten(const QString& path, const QStringList& notes) {
  const QString folder = QFileInfo(path).absolutePath();
  QString text = tr("Exported %1 into %2.").arg(describedFile(path), QDir::toNativeSeparators(folder));
  if (!notes.isEmpty()) text += QLatin1Char(' ') + notes.join(QLatin1Char(' '));
  m_notices->post(
      {kWrittenKey,
       Severity::info,
       text,
       {{tr("Open"), tr("Opens it with the program of this kind of file"), [this, path] { open(path); }},
        {tr("Show in folder"), tr("Opens the folder it is in"), [this, folder] { open(folder); }},
        {tr("Close"), tr("The file stays where it is"), {}}},
       false,
       true});
}

void ExportJobs::forgetWritten() {
  m_notices->withdraw(kWrittenKey);
}

void ExportJobs::open(const QString& path) {
  if (!QFileInfo::exists(path)) {
    emit failed(tr("%1 is no longer there.").arg(path));
  } else if (!QDesktopServices::openUrl(QUrl::fromLocalFile(path))) {
    emit failed(tr("No program opens %1 here.").arg(QFileInfo(path).fileName()));
  }
}

}  // namespace geargraph

#include "moc_export_jobs.cpp"
