#pragma once

#include <QTemporaryDir>
#include <chrono>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "tests/soak/random_edits.h"
#include "tests/soak/soak_options.h"
#include "ui/document/document.h"
#include "ui/recovery/autosave.h"

namespace geargraph::soak {

/// Random edits of a document, undone and redone, saved, reloaded, and recovered as after a crash. At every
/// step of the history the bytes of the document are those that it had when the step was made.
class EditSoak {
 public:
  explicit EditSoak(const SoakOptions& options);
  ~EditSoak();

  /// The number of findings; each is printed with what repeats it.
  int run();

 private:
  void act();
  void edit();
  [[nodiscard]] Reduce shrink();
  void undoOrRedo();
  void walkWholeHistory();
  void save();
  void reload();
  void crashAndRecover();
  void openAnew();
  [[nodiscard]] std::unique_ptr<Document> newDocument();

  [[nodiscard]] int below(int limit) {
    return static_cast<int>(m_random() % static_cast<std::uint64_t>(limit));
  }
  [[nodiscard]] std::string bytes() const;
  void keepPoint();
  void checkPoint(const char* after);
  void checkFile();
  void expect(bool holds, const std::string& what);
  [[nodiscard]] double seconds() const;

  SoakOptions m_options;
  std::mt19937_64 m_random;
  QTemporaryDir m_folder;
  QString m_path;
  std::unique_ptr<Document> m_document;
  std::unique_ptr<Autosave> m_autosave;
  std::vector<std::size_t> m_kept;  ///< hashes of the bytes, by index of the history
  std::string m_onDisk;
  std::size_t m_limit = 0;  ///< of the history, in bytes
  std::size_t m_largestHistory = 0;
  long m_shortened = 0;  ///< steps
  quint64 m_gesture = 0;
  std::string m_last;  ///< what was done last
  std::map<std::string, long> m_accepted;
  std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();

  long m_edits = 0;
  long m_rejected = 0;
  long m_undos = 0;
  long m_redos = 0;
  long m_saves = 0;
  long m_reloads = 0;
  long m_recoveries = 0;
  int m_findings = 0;
};

}  // namespace geargraph::soak
