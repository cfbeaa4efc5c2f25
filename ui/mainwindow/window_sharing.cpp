// One file in several windows or programs: the first one writes it, the others are read-only.

#include <QFile>
#include <QFileInfo>

#include "core/foundations/files/file.h"
#include "core/foundations/files/file_identity.h"
#include "ui/mainwindow/notice_bar.h"
#include "ui/mainwindow/window_files.h"

namespace geargraph {
namespace {

const QString kReadOnlyKey = QStringLiteral("read-only");
const QString kOpenElsewhereKey = QStringLiteral("open elsewhere");

std::filesystem::path nativePath(const QString& path) {
  return QFile::encodeName(path).toStdString();
}

}  // namespace

/// Which other window has a file open and writes it: one of this program, or one of another.
struct WindowFiles::Elsewhere {
  WindowFiles* files = nullptr;
  DocumentHolder holder;  ///< if there is no such window
};

std::optional<WindowFiles::Elsewhere> WindowFiles::openElsewhere(const QString& path) const {
  if (m_windows == nullptr) return std::nullopt;
  for (WindowFiles* files : m_windows->filesWith(path, this)) {
    if (!files->isReadOnly()) return Elsewhere{files, {}};
  }
  if (auto holder = m_windows->documents().holderOf(path)) return Elsewhere{nullptr, std::move(*holder)};
  return std::nullopt;
}

bool WindowFiles::isOwnFile(const QString& path) const {
  return isSameFile(nativePath(path), nativePath(m_document->filePath()));
}

/// The document belongs to this file from now on, and this window writes it unless another one does.
void WindowFiles::claim(const QString& path) {
  m_notices->withdraw(kReadOnlyKey);
  m_notices->withdraw(kOpenElsewhereKey);
  if (m_windows == nullptr) return;
  const auto elsewhere = openElsewhere(path);
  const QString absolute = path.isEmpty() ? QString() : QFileInfo(path).absoluteFilePath();
  const bool isFree = !elsewhere || elsewhere->files == nullptr;
  const auto holder = m_windows->documents().claim(this, isFree ? absolute : QString());
  m_isReadOnly = elsewhere.has_value() || holder.has_value();
  if (m_isReadOnly) {
    postReadOnly(tr("%1 is open in another window of GearGraph. Here it is read-only.").arg(title()));
  }
}

void WindowFiles::postReadOnly(const QString& problem) {
  const QString path = m_document->filePath();
  m_notices->post({kReadOnlyKey,
                   Severity::warning,
                   problem,
                   {{tr("Show that window"), tr("And close this one if nothing is changed in it"),
                     [this, path] { showElsewhere(path); }},
                    {tr("Read-only"), tr("Look at it here; changes can be saved under another name"), {}}},
                   true});
}

/// True, with a notice, if another window writes this file.
bool WindowFiles::rejectIfOpenElsewhere(const QString& path) {
  if (!openElsewhere(path)) return false;
  const QString name = QFileInfo(path).fileName();
  const QString why = tr("%1 was not saved: %2 is open in another window of GearGraph.").arg(title(), name);
  emit rejected(why);
  m_notices->post({kOpenElsewhereKey,
                   Severity::warning,
                   why,
                   {{tr("Show that window"), {}, [this, path] { showElsewhere(path); }},
                    {tr("Save as…"), tr("Save under another name"), [this] { chooseAndSave(); }},
                    {tr("Later"), tr("The document stays open, with its changes"), {}}},
                   true});
  return true;
}

void WindowFiles::showElsewhere(const QString& path) {
  const auto elsewhere = openElsewhere(path);
  if (!elsewhere) {
    if (!isOwnFile(path)) return;
    claim(m_document->filePath());
    emit titleChanged();
    return emit noted(
        tr("%1 is not open in another window any more. This one writes to it now.").arg(title()));
  }
  if (elsewhere->files != nullptr) {
    elsewhere->files->raiseWindow();
    return leaveToOther(path);
  }
  m_windows->documents().show(elsewhere->holder, this, [this, path](bool isShown) {
    if (isShown) return leaveToOther(path);
    postReadOnly(tr("The other window with %1 does not answer.").arg(QFileInfo(path).fileName()));
  });
}

void WindowFiles::leaveToOther(const QString& path) {
  if (m_isReadOnly && isOwnFile(path) && !m_document->isModified()) m_window->close();
}

/// A program that was killed while it wrote a file with several names leaves a whole copy beside it.
void WindowFiles::offerInterrupted(const QString& path) {
  if (m_windows == nullptr) return;
  for (const auto& copy : interruptedWrites(nativePath(path))) {
    const QString left = QFile::decodeName(copy.c_str());
    m_notices->post(
        {left,
         Severity::warning,
         tr("Saving %1 was interrupted, so the file may be damaged. What was to be saved is in %2.")
             .arg(QFileInfo(path).fileName(), QFileInfo(left).fileName()),
         {{tr("Open the copy"), {}, [this, left] { openByUser(left); }},
          {tr("Delete the copy"), tr("The file is as it should be"), [left] { QFile::remove(left); }},
          {tr("Later"), tr("It will be offered again"), {}}}});
  }
}

}  // namespace geargraph
