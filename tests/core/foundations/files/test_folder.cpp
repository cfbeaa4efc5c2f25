#include <QTemporaryDir>
#include <QTest>
#include <filesystem>

#include "core/foundations/files/folder.h"

namespace geargraph {
namespace {

namespace fs = std::filesystem;

const FolderFiles kFiles{{"index.txt", "first"}, {"parts/a.txt", "second"}};

std::string contents(const fs::path& path) {
  const auto read = readFile(path, 1000);
  const auto* text = std::get_if<std::string>(&read);
  return text != nullptr ? *text : "none";
}

}  // namespace

class FolderTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_place;
  [[nodiscard]] fs::path at(const char* name) const { return fs::path(m_place.path().toStdString()) / name; }
  [[nodiscard]] std::size_t entries() const {
    const fs::directory_iterator all(m_place.path().toStdString());
    return static_cast<std::size_t>(std::distance(begin(all), end(all)));
  }

 private slots:
  void init() { m_place = QTemporaryDir(); }

  void aNewFolderIsMadeWithItsFiles() {
    QVERIFY(!writeFolder(at("deep") / "export", kFiles));
    QCOMPARE(contents(at("deep") / "export" / "index.txt"), std::string("first"));
    QCOMPARE(contents(at("deep") / "export" / "parts" / "a.txt"), std::string("second"));
  }

  void whatIsThereIsOverwrittenOnlyOnDemand() {
    QVERIFY(!writeFolder(at("export"), {{"parts/a.txt", "old"}, {"other.txt", "kept"}}));
    const auto error = writeFolder(at("export"), kFiles);
    QVERIFY(error && !error->isStopped);
    QVERIFY(error->message.find("parts/a.txt") != std::string::npos);
    QCOMPARE(contents(at("export") / "index.txt"), std::string("none"));  // nothing was written
    FolderOptions options;
    options.overwrite = true;
    QVERIFY(!writeFolder(at("export"), kFiles, options));
    QCOMPARE(contents(at("export") / "parts" / "a.txt"), std::string("second"));
    QCOMPARE(contents(at("export") / "other.txt"), std::string("kept"));
  }

  void aStoppedFolderIsNotThere() {
    std::stop_source stop;
    FolderOptions options;
    options.stop = stop.get_token();
    options.progress = [&](double part) {
      if (part < 1) stop.request_stop();
    };
    const auto error = writeFolder(at("export"), kFiles, options);
    QVERIFY(error && error->isStopped);
    QCOMPARE(entries(), std::size_t{0});
  }

  void aFileInThePlaceOfTheFolderIsAnError() {
    QVERIFY(!writeFile(at("export"), "a file"));
    const auto error = writeFolder(at("export"), kFiles);
    QVERIFY(error && error->message.find("could not be made") != std::string::npos);
    QCOMPARE(contents(at("export")), std::string("a file"));
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::FolderTest)
#include "test_folder.moc"
