#include "ui/recovery/autosave.h"

#include <QFile>
#include <QTimer>
#include <cstdlib>

#include "core/foundations/files/file.h"

namespace geargraph {

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
  if (!m_place) m_place = std::make_shared<Place>(Place{m_document->filePath(), nullptr});
  const SideNote note{m_document->filePath(), m_title, edits(), QDateTime::currentDateTime()};
  enqueue({m_place, m_document->mechanism(), note, m_wanted});
}

void Autosave::adopt(std::unique_ptr<SideFile> side, const SideNote& note) {
  if (m_place) enqueue({std::move(m_place), nullptr, {}, m_wanted});
  m_sidePath = side->path();
  m_place = std::make_shared<Place>(Place{note.filePath, std::move(side)});
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
  if (m_place) enqueue({std::move(m_place), nullptr, {}, m_wanted});
  m_place.reset();
  m_sidePath.clear();
}

void Autosave::enqueue(Job job) {
  {
    const std::lock_guard lock(m_mutex);
    // A state that nobody has written yet is not worth writing when there is a newer one.
    if (!m_jobs.empty() && m_jobs.back().place == job.place) m_jobs.pop_back();
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
      if (job.place->side) job.place->side->remove();
      continue;
    }
    const QString why = write(job);
    const QString path = job.place->side ? job.place->side->path() : QString();
    QMetaObject::invokeMethod(this, [this, job = std::move(job), path, why] { finished(job, path, why); });
  }
}

/// @return why not; empty if it was written
QString Autosave::write(const Job& job) const {
  std::unique_ptr<SideFile>& side = job.place->side;
  if (!side) side = freshSideFile(job.place->filePath, m_folder);
  if (!side)
    return tr("Unsaved changes cannot be kept: no file can be written beside the document or in %1.")
        .arg(m_folder);
  const auto error =
      writeFile(QFile::encodeName(side->path()).toStdString(), sideFileBytes(*job.mechanism, job.note));
  return error ? QString::fromStdString(error->message) : QString();
}

void Autosave::finished(const Job& job, const QString& path, const QString& error) {
  m_written = std::max(m_written, job.number);
  if (m_place == job.place) m_sidePath = path;
  const bool wasFailing = std::exchange(m_failing, !error.isEmpty());
  if (m_failing && !wasFailing) emit failed(error);
  if (isUpToDate()) emit upToDate();
}

}  // namespace geargraph

#include "moc_autosave.cpp"
