// `editor_driver FOLDER`: what the window does with a document, without the window: opens
// FOLDER/document.geargraph, edits it without end, saves now and then, and keeps its unsaved changes in a
// side file. Each line that it prints is true when it is printed: "edited N", "kept N" (in the side file),
// "saved N", "not kept: WHY", "not saved: WHY". `editor_driver FOLDER EDITS` ends after so many edits and
// saves.

#include <QCoreApplication>
#include <QDir>
#include <QTimer>
#include <cstdio>
#include <cstdlib>

#include "core/foundations/files/file.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "tests/faults/versions.h"
#include "ui/document/document.h"
#include "ui/recovery/autosave.h"

using namespace geargraph;

namespace {

void say(const std::string& line) {
  std::printf("%s\n", line.c_str());
  std::fflush(stdout);
}

class Driver : public QObject {
 public:
  Driver(const QString& folder, int edits)
      : m_path(folder + QStringLiteral("/document.geargraph")),
        m_edits(edits),
        m_autosave(&m_document, folder) {
    connect(&m_autosave, &Autosave::upToDate, this, [this] {
      if (m_document.isModified() && !m_isFailing) say("kept " + std::to_string(m_number));
      m_isFailing = false;
      if (m_edits > 0 && m_document.isModified()) save();
    });
    connect(&m_autosave, &Autosave::failed, this, [this](const QString& why) {
      m_isFailing = true;
      say("not kept: " + why.toStdString());
    });
  }

  bool open() {
    const auto bytes = readFile(m_path.toStdString(), std::size_t{1} << 26U);
    if (!std::holds_alternative<std::string>(bytes)) return false;
    auto read = readMechanism(std::get<std::string>(bytes));
    if (!read) return false;
    m_number = test::versionOf(*read).value_or(-1);
    m_document.replace(std::move(read).value(), m_path);
    return m_number >= 0;
  }

  void edit() {
    ++m_number;
    const Mechanism next = test::version(m_number);
    m_document.apply(
        {QStringLiteral("Edit"), [next](const Mechanism&) { return Expected<Mechanism>(next); }, 0});
    say("edited " + std::to_string(m_number));
    if (m_edits > 0) return;  // goes on when it has been kept
    // Unsaved changes are kept in the pauses, 1 s after the first of them.
    constexpr int kCycle = 16, kSaved = 7, kBetween = 30, kPause = 1300;  // edits, ms
    if (m_number % kCycle == kSaved) save();
    QTimer::singleShot(m_number % kCycle == 0 ? kPause : kBetween, this, &Driver::edit);
  }

 private:
  void save() {
    const auto error = writeFile(m_path.toStdString(), writeMechanism(*m_document.mechanism()));
    if (error) {
      say("not saved: " + error->message);
    } else {
      m_document.markSaved(m_path);
      say("saved " + std::to_string(m_number));
    }
    if (m_edits <= 0) return;
    if (--m_edits == 0) return QCoreApplication::quit();
    QTimer::singleShot(0, this, &Driver::edit);
  }

  QString m_path;
  int m_edits;
  int m_number = 0;
  bool m_isFailing = false;
  Document m_document;
  Autosave m_autosave;
};

}  // namespace

int main(int count, char** words) {
  QCoreApplication application(count, words);
  if (count < 2) return 2;
  Driver driver(QString::fromLocal8Bit(words[1]), count > 2 ? std::atoi(words[2]) : 0);
  if (!driver.open()) return 2;
  QTimer::singleShot(0, &driver, &Driver::edit);
  return QCoreApplication::exec();
}
