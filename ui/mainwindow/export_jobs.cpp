#include "ui/mainwindow/export_jobs.h"

#include <QFile>
#include <QFileInfo>

#include "core/foundations/files/file.h"
#include "ui/mainwindow/notice_bar.h"

namespace geargraph {
namespace {

const QString kKey = QStringLiteral("exports");

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
    emit finished(job.path);
    const QStringList notes = job.notes ? job.notes() : QStringList();
    if (!notes.empty()) emit told(notes.join(QLatin1Char(' ')));
  } else {
    emit failed(
        stopped ? tr("The export of %1 was stopped; nothing was written.").arg(QFileInfo(job.path).fileName())
                : why);
  }
  if (!m_isBusy) startNext();  // whoever heard of it may have added one
}

}  // namespace geargraph

#include "moc_export_jobs.cpp"
