#include "tests/soak/edit_soak.h"

#include <sys/resource.h>

#include <QFile>
#include <cstdio>

#include "core/foundations/files/file.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/validate.h"
#include "tests/core/support/example_files.h"

namespace geargraph::soak {
namespace {

constexpr int kMaxLinks = 30;       // more only makes each edit slower
constexpr int kMaxFindings = 20;    // after that the rest would only repeat them
constexpr long kWholeWalk = 5'000;  // edits between two walks through the whole history

Edit takingOver(const QString& text, Mechanism mechanism) {
  return {text,
          [mechanism = std::move(mechanism)](const Mechanism&) -> Expected<Mechanism> { return mechanism; },
          0};
}

std::filesystem::path pathOf(const QString& name) {
  return QFile::encodeName(name).toStdString();
}

/// MB that the process held at most.
double peakMemory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

}  // namespace

EditSoak::EditSoak(const SoakOptions& options)
    : m_options(options),
      m_random(options.seed),
      m_path(m_folder.filePath(QStringLiteral("soak.geargraph"))) {
  openAnew();
}

EditSoak::~EditSoak() = default;

double EditSoak::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count();
}

std::string EditSoak::bytes() const {
  return writeMechanism(*m_document->mechanism());
}

void EditSoak::expect(bool holds, const std::string& what) {
  if (holds) return;
  ++m_findings;
  std::fprintf(stderr, "seed %llu, edit %ld, after %s: %s\n", static_cast<unsigned long long>(m_options.seed),
               m_edits, m_last.c_str(), what.c_str());
}

/// Every third one has room for some hundred steps only.
std::unique_ptr<Document> EditSoak::newDocument() {
  auto document = std::make_unique<Document>();
  m_limit = below(3) == 0 ? std::size_t{1} << 16 : Document::kHistoryLimit;
  document->setHistoryLimit(m_limit);
  QObject::connect(document.get(), &Document::historyShortened, document.get(), [this](int steps) {
    m_kept.erase(m_kept.begin(), m_kept.begin() + steps);
    m_shortened += steps;
  });
  return document;
}

/// Begins with one of the examples, or with nothing.
void EditSoak::openAnew() {
  const std::vector<std::string> names = test::exampleNames();
  const int choice = below(static_cast<int>(names.size()) + 1);
  Mechanism first =
      choice == 0 ? emptyMechanism() : test::example(names[static_cast<std::size_t>(choice - 1)]);
  if (m_autosave) m_autosave->discard();  // the person gives the document up
  m_autosave.reset();
  m_document = newDocument();
  m_onDisk = writeMechanism(first);
  expect(!writeFile(pathOf(m_path), m_onDisk), "The document could not be written.");
  m_document->replace(std::move(first), m_path);
  m_autosave = std::make_unique<Autosave>(m_document.get(), m_folder.path());
  m_kept.clear();
  keepPoint();
}

int EditSoak::run() {
  long nextWalk = kWholeWalk;
  while (!m_options.isEnough(m_edits, seconds()) && m_findings < kMaxFindings) {
    act();
    if (m_edits < nextWalk) continue;
    nextWalk += kWholeWalk;
    walkWholeHistory();
    std::printf("  %ld edits, history of %d steps, %d findings\n", m_edits, m_document->undoStack().count(),
                m_findings);
    std::fflush(stdout);
  }
  walkWholeHistory();
  crashAndRecover();
  for (const EditKind& kind : editKinds()) {
    std::printf("  %-22s %ld accepted\n", kind.function.c_str(), m_accepted[kind.function]);
  }
  std::printf(
      "soak_edits: seed %llu, %ld edits, %ld refused, %ld undos, %ld redos, %ld saves, %ld reloads, "
      "%ld recoveries, history of %.1f MB at most, %ld steps dropped, %.0f MB of memory, %.0f s, %d "
      "findings\n",
      static_cast<unsigned long long>(m_options.seed), m_edits, m_rejected, m_undos, m_redos, m_saves,
      m_reloads, m_recoveries, static_cast<double>(m_largestHistory) / 1e6, m_shortened, peakMemory(),
      seconds(), m_findings);
  return m_findings;
}

void EditSoak::act() {
  const int what = below(1000);
  if (what < 700) {
    edit();
  } else if (what < 970) {
    undoOrRedo();
  } else if (what < 985) {
    save();
  } else if (what < 997) {
    reload();
  } else if (what < 998) {
    crashAndRecover();
  } else if (below(10) == 0) {
    openAnew();
  }
}

// --- edits ------------------------------------------------------------------------------------------------

/// Takes much away, so that the document does not grow for ever.
Reduce EditSoak::shrink() {
  RandomArguments arguments(m_random, *m_document->mechanism());
  std::vector<ElementId> gone = arguments.elements(12);
  std::erase(gone, ElementId(m_document->mechanism()->links.front().id));
  return [gone](const Mechanism& before) { return withoutElements(before, gone); };
}

void EditSoak::edit() {
  const MechanismPtr before = m_document->mechanism();
  const EditKind& kind = randomKind(m_random);
  RandomArguments arguments(m_random, *before);
  m_last = kind.function;
  Reduce reduce = before->n() > kMaxLinks && below(2) == 0 ? shrink() : kind.make(arguments);
  if (!reduce) return;
  // Some edits in a row are one gesture, as in a drag.
  if (below(8) == 0) m_gesture = below(3) == 0 ? m_document->newGesture() : 0;
  if (!m_document->apply({QString::fromStdString(kind.function), reduce, m_gesture})) {
    expect(m_document->mechanism() == before, "a refused edit changed the document");
    ++m_rejected;
    return;
  }
  ++m_edits;
  ++m_accepted[kind.function];
  if (m_document->mechanism() == before) return;  // an equal document makes no step
  const std::size_t history = m_document->historyBytes();
  m_largestHistory = std::max(m_largestHistory, history);
  expect(history <= m_limit || m_document->undoStack().count() == 1, "the history is beyond its limit");
  const Diagnostics wrong = wellFormedDiagnostics(*m_document->mechanism());
  if (!wrong.empty()) expect(false, "the document is not well formed: " + wrong.front().message);
  keepPoint();
  if (m_edits % 8 == 0) checkFile();
}

void EditSoak::keepPoint() {
  m_kept.resize(static_cast<std::size_t>(m_document->undoStack().index()) + 1);
  m_kept.back() = std::hash<std::string>()(bytes());
}

void EditSoak::checkPoint(const char* after) {
  const auto index = static_cast<std::size_t>(m_document->undoStack().index());
  expect(index < m_kept.size() && m_kept[index] == std::hash<std::string>()(bytes()),
         std::string("other bytes after ") + after);
}

/// What would be saved reads back as this document, and is written as the same bytes again.
void EditSoak::checkFile() {
  const std::string written = bytes();
  const Expected<Mechanism> read = readMechanism(written);
  if (!read) return expect(false, "what was written cannot be read: " + read.error().front().message);
  expect(*read == *m_document->mechanism(), "what was written reads as another document");
  expect(writeMechanism(*read) == written, "what was read is written as other bytes");
}

void EditSoak::undoOrRedo() {
  QUndoStack& stack = m_document->undoStack();
  m_gesture = 0;
  if (below(40) == 0) {
    stack.setIndex(std::max(0, stack.index() - below(100)));
    return checkPoint("a jump");
  }
  const int steps = 1 + below(below(4) == 0 ? 40 : 3);
  for (int i = 0; i < steps && stack.canUndo(); ++i, ++m_undos) {
    stack.undo();
    checkPoint("undo");
  }
  if (below(3) == 0) return;  // the next edit cuts off what was undone
  for (int i = 0; i < steps && stack.canRedo(); ++i, ++m_redos) {
    stack.redo();
    checkPoint("redo");
  }
}

void EditSoak::walkWholeHistory() {
  QUndoStack& stack = m_document->undoStack();
  const int here = stack.index();
  m_last = "a walk through the whole history";
  m_gesture = 0;
  for (; stack.canUndo() && m_findings < kMaxFindings; ++m_undos) {
    stack.undo();
    checkPoint("undo");
  }
  for (; stack.canRedo() && m_findings < kMaxFindings; ++m_redos) {
    stack.redo();
    checkPoint("redo");
  }
  stack.setIndex(here);
}

// --- files ------------------------------------------------------------------------------------------------

void EditSoak::save() {
  m_last = "saving";
  m_onDisk = bytes();
  expect(!writeFile(pathOf(m_path), m_onDisk), "the document could not be written");
  m_document->markSaved(m_path);
  expect(!m_document->isModified(), "saved, and modified");
  ++m_saves;
}

/// Revert to the file: an edit that can be undone.
void EditSoak::reload() {
  m_last = "reloading";
  const auto read = readFile(pathOf(m_path), kLargestFile);
  const auto* text = std::get_if<std::string>(&read);
  if (text == nullptr) return expect(false, "the saved file cannot be read");
  expect(*text == m_onDisk, "the file holds other bytes than were saved");
  Expected<Mechanism> document = readMechanism(*text);
  if (!document) return expect(false, "the saved file is broken");
  const MechanismPtr before = m_document->mechanism();
  m_document->apply(takingOver(QStringLiteral("Revert to the file"), std::move(document).value()));
  expect(bytes() == m_onDisk, "reverted, and other bytes than in the file");
  m_document->markSaved(m_path);
  if (m_document->mechanism() != before) keepPoint();
  ++m_reloads;
}

/// The program ends without saving. The next one finds the unsaved changes and restores them.
void EditSoak::crashAndRecover() {
  m_last = "recovering";
  const std::string before = bytes();
  const bool unsaved = m_document->isModified();
  m_autosave.reset();  // its thread ends what is being written
  SideFiles left = recoverableFilesOf(m_path, m_folder.path());
  expect(
      left.size() == (unsaved ? 1U : 0U),
      std::to_string(left.size()) + (unsaved ? " side files with unsaved changes" : " side files without"));
  if (left.empty()) {
    m_autosave = std::make_unique<Autosave>(m_document.get(), m_folder.path());
    return;
  }
  const std::optional<SideDocument> side = left.front()->read();
  if (!side) return expect(false, "the side file cannot be read");
  expect(writeMechanism(side->mechanism) == before, "the side file holds other bytes");

  std::unique_ptr<Document> restored = newDocument();
  Expected<Mechanism> saved = readMechanism(m_onDisk);
  if (!saved) return expect(false, "the saved file is broken");
  restored->replace(std::move(saved).value(), m_path);
  m_document = std::move(restored);
  m_kept.clear();
  keepPoint();
  m_autosave = std::make_unique<Autosave>(m_document.get(), m_folder.path());
  m_document->apply(takingOver(QStringLiteral("Restore unsaved changes"), side->mechanism));
  m_autosave->adopt(std::move(left.front()), side->note);
  keepPoint();
  expect(bytes() == before, "restored, and other bytes than before");
  ++m_recoveries;
}

}  // namespace geargraph::soak
