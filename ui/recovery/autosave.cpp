#include "ui/recovery/autosave.h"

#include <QFile>
#include <QTimer>
#include <cstdlib>

#include "core/foundations/files/file.h"

namespace geargraph::inline recovery {

Autosave::Autosave(Document* document, QString folder, QObject* parent)
    : QObject(parent),
      m_document(document),
      m_folder(std::move(folder)),
      m_timer(new QTimer(this)),
      m_thread([this](const std::stop_token& quit) { run(quit); }) {
  m_timer->setSingleShot(true);
  m_timer->setInterval(kDelay);
  connect(m_timer, &QTimer::timeout, this, &Autosave::save);
  connect(m_document, &Document::changed, this, &Autosave::onChanged);
  connect(m_document, &Document::modifiedChanged, this, &Autosave::onChanged);
  // Saved under another name: what is beside the old one is not its side file any more.
  connect(m_document, &Document::filePathChanged, this, &Autosave::removeSideFile);
}

Autosave::~Autosave() {
  requestStop();
}

void Autosave::requestStop() {
  if (m_timer->isActive()) save();
  m_thread.requestStop();
}

void Autosave::onChanged() {
  if (!m_document->isModified()) return removeSideFile();
  ++m_wanted;
  // From the first edit on, not from the last: one who never pauses is safe too.
  if (!m_timer->isActive()) m_timer->start();
}

int Autosave::edits() const {
  const QUndoStack& stack = m_document->undoStack();
  const int clean = stack.cleanIndex();
  return m_editsBefore + (clean < 0 ? stack.index() : std::abs(stack.index() - clean));
}

void Autosave::save() {
  m_timer->stop();
  if (!m_side) m_side = freshSideFile(m_document->filePath(), m_folder);
  if (!m_side) {
    return finished(m_wanted, tr("Unsaved changes cannot be kept: no file can be written beside the document "
                                 "or in %1.")
                                  .arg(m_folder));
  }
  const SideNote note{m_document->filePath(), m_title, edits(), QDateTime::currentDateTime()};
  enqueue({m_side, m_document->mechanism(), note, m_wanted});
}

void Autosave::adopt(std::unique_ptr<SideFile> side, const SideNote& note) {
  if (m_side) enqueue({std::move(m_side), nullptr, {}, m_wanted});
  m_side = std::move(side);
  // The restored changes are one edit of this document.
  m_editsBefore = std::max(0, note.edits - 1);
}

void Autosave::discard() {
  removeSideFile();
}

void Autosave::removeSideFile() {
  m_timer->stop();
  m_editsBefore = 0;
  m_written = m_wanted;
  if (m_side) enqueue({std::move(m_side), nullptr, {}, m_wanted});
  m_side.reset();
}

void Autosave::enqueue(Job job) {
  {
    const std::lock_guard lock(m_mutex);
    // A state that nobody has written yet is not worth writing when there is a newer one.
    if (!m_jobs.empty() && m_jobs.back().side == job.side) m_jobs.pop_back();
    m_jobs.push_back(std::move(job));
  }
  m_wake.notify_one();
}

void Autosave::run(const std::stop_token& quit) {
  for (;;) {
    Job job;
    {
      std::unique_lock lock(m_mutex);
      m_wake.wait(lock, quit, [this] { return !m_jobs.empty(); });
      if (m_jobs.empty()) return;  // all is written, and the owner goes
      job = std::move(m_jobs.front());
      m_jobs.pop_front();
    }
    if (!job.mechanism) {
      job.side->remove();
      continue;
    }
    const auto error =
        writeFile(QFile::encodeName(job.side->path()).toStdString(), sideFileBytes(*job.mechanism, job.note));
    const QString why = error ? QString::fromStdString(error->message) : QString();
    QMetaObject::invokeMethod(this, [this, number = job.number, why] { finished(number, why); });
  }
}

void Autosave::finished(quint64 number, const QString& error) {
  m_written = std::max(m_written, number);
  const bool wasFailing = std::exchange(m_failing, !error.isEmpty());
  if (m_failing && !wasFailing) emit failed(error);
  if (isUpToDate()) emit upToDate();
}

}  // namespace geargraph::inline recovery
