// `soak_kills [--seed N] [--runs N | --minutes M]`: kills a program that edits and saves (editor_driver) at
// random moments. After each kill the document is whole, no older than what was reported as saved, and what
// was reported as kept is in the side file. Findings are printed and kept in a folder; exit status 1.

#include <QCoreApplication>
#include <algorithm>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <random>
#include <thread>

#include "core/foundations/files/file.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "tests/faults/child.h"
#include "tests/faults/soak_options.h"
#include "tests/faults/versions.h"
#include "ui/recovery/side_file.h"

using namespace geargraph;

namespace {

namespace fs = std::filesystem;

/// The largest number after a word at the start of a line, or `least`.
int lastOf(std::string_view word, const std::string& output, int least) {
  for (std::size_t begin = 0; begin < output.size();) {
    const std::size_t end = std::min(output.find('\n', begin), output.size());
    const std::string_view line(output.data() + begin, end - begin);
    int number = 0;
    if (line.starts_with(word)) {
      std::from_chars(line.data() + word.size(), line.data() + line.size(), number);
      least = std::max(least, number);
    }
    begin = end + 1;
  }
  return least;
}

class Kills {
 public:
  Kills() : m_document(m_folder.path() + "/document.geargraph") {
    if (writeFile(m_document, writeMechanism(test::version(0)))) std::exit(3);
  }

  void one(std::mt19937_64& random) {
    constexpr int kMaxLength = 2000, kShort = 400;  // ms; the side file is written 1 s after an edit
    test::Child driver({GEARGRAPH_EDITOR_DRIVER, m_folder.path()});
    const bool afterKept = m_kills % 3 == 0;
    if (afterKept && !driver.waitFor("kept ")) finding("Unsaved changes were not kept.");
    std::this_thread::sleep_for(std::chrono::milliseconds(random() % (afterKept ? kShort : kMaxLength)));
    driver.kill();
    const test::Ended ended = driver.ended();
    if (ended.status >= 0) finding("The driver ended by itself: " + ended.errors);
    const int saved = lastOf("saved ", ended.output, m_version), kept = lastOf("kept ", ended.output, saved);
    const int edited = lastOf("edited ", ended.output, saved);
    m_edits += edited - m_version;
    checkDocument(saved, edited);
    checkSideFile(kept, edited);
    ++m_kills;
  }

  [[nodiscard]] long kills() const { return m_kills; }
  [[nodiscard]] bool isFine() const { return m_findings == 0 && m_sideFiles > 0; }
  void summary() const {
    if (m_sideFiles == 0) std::printf("No side file was there after any kill: nothing was tried.\n");
    std::printf("soak_kills: %ld kills, %ld edits, %d saved versions, %ld side files, %ld findings\n",
                m_kills, m_edits, m_version, m_sideFiles, m_findings);
  }

 private:
  void finding(const std::string& what) {
    ++m_findings;
    const fs::path kept = fs::current_path() / ("kill-finding-" + std::to_string(m_findings));
    std::error_code error;
    fs::copy(m_folder.path(), kept, fs::copy_options::recursive, error);
    std::fprintf(stderr, "%s (kept in %s)\n", what.c_str(), kept.c_str());
  }

  /// The version on the disk, at least `saved`.
  void checkDocument(int saved, int edited) {
    const auto bytes = readFile(m_document, kLargestFile);
    const auto* text = std::get_if<std::string>(&bytes);
    const auto read = text != nullptr ? readMechanism(*text) : Expected<Mechanism>(Diagnostics{});
    const auto version = read ? test::versionOf(*read) : std::nullopt;
    if (!version) return finding("The document is not whole.");
    if (*version < saved || *version > edited) {
      finding("The document is version " + std::to_string(*version) + ", but " + std::to_string(saved) +
              " was reported as saved.");
    }
    m_version = *version;
  }

  void checkSideFile(int kept, int edited) {
    const QString folder = QString::fromStdString(m_folder.path());
    int newest = m_version;
    for (const auto& side : recoverableFilesOf(QString::fromStdString(m_document), folder)) {
      const auto document = side->read();
      const auto version = document ? test::versionOf(document->mechanism) : std::nullopt;
      if (!version || *version > edited) {
        finding("The side file is not whole.");
      } else {
        newest = std::max(newest, *version);
        ++m_sideFiles;
      }
      side->remove();
    }
    if (newest < kept)
      finding("Version " + std::to_string(kept) + " was reported as kept, but is neither file.");
  }

  static constexpr std::size_t kLargestFile = std::size_t{1} << 26U;

  test::TemporaryFolder m_folder;
  std::string m_document;
  int m_version = 0;
  long m_kills = 0, m_edits = 0, m_sideFiles = 0, m_findings = 0;
};

}  // namespace

int main(int count, char** words) {
  QCoreApplication application(count, words);
  const test::SoakOptions options(count, words, 5);
  std::mt19937_64 random(options.seed);
  Kills kills;
  while (options.goesOn(kills.kills())) kills.one(random);
  kills.summary();
  return kills.isFine() ? 0 : 1;
}
