#include <QFile>
#include <QSaveFile>
#include <QTest>
#include <algorithm>
#include <set>
#include <vector>

#include "tests/core/support/example_files.h"
#include "tests/quality/format_files.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

QString pathOf(const char* file) {
  return QString::fromStdString(sourcePath(file));
}

std::string read(const char* file) {
  QFile source(pathOf(file));
  if (!source.open(QIODevice::ReadOnly)) qFatal("Cannot read %s", file);
  return source.readAll().toStdString();
}

/// Holds a file against what follows from the description; with GEARGRAPH_UPDATE_GOLDEN in the environment it
/// is written instead.
void compare(const char* file, const std::string& expected) {
  const std::string found = read(file);
  if (found == expected) return;
  if (qEnvironmentVariableIntValue("GEARGRAPH_UPDATE_GOLDEN") != 0) {
    QSaveFile written(pathOf(file));
    QVERIFY(written.open(QIODevice::WriteOnly));
    written.write(QByteArray::fromStdString(expected));
    QVERIFY(written.commit());
    return;
  }
  const auto line =
      1 + std::count(found.begin(),
                     std::mismatch(found.begin(), found.end(), expected.begin(), expected.end()).first, '\n');
  QFAIL(qPrintable(QStringLiteral("%1 is not what fields.h describes, from line %2 on: run this test with "
                                  "GEARGRAPH_UPDATE_GOLDEN=1 and read the difference")
                       .arg(QLatin1String(file))
                       .arg(line)));
}

/// The text with what is between two marks replaced; both stay.
std::string withBetween(const std::string& text, const std::string& begin, const std::string& end,
                        std::size_t from, const std::string& inside) {
  const std::size_t first = text.find(begin, from);
  if (first == std::string::npos) qFatal("There is no %s", begin.c_str());
  const std::size_t start = first + begin.size();
  const std::size_t stop = text.find(end, start);
  if (stop == std::string::npos) qFatal("There is no %s", end.c_str());
  return text.substr(0, start) + inside + text.substr(stop);
}

constexpr const char* kBegin = "\n    # Members of the document, from core/mechanism/model/fields.h.\n";
constexpr const char* kEnd = "\n    # End of members.\n";

/// A class of _elements.py with its properties, from its head to the next class.
std::string withProperties(const std::string& source, const char* name, DocumentPart part) {
  const std::size_t begin = source.find("\nclass " + std::string(name) + "(");
  if (begin == std::string::npos) qFatal("There is no class %s", name);
  const std::size_t end = std::min(source.find("\nclass ", begin + 1), source.size());
  const std::string own = withBetween(source.substr(begin, end - begin), kBegin, kEnd, 0, "");
  return source.substr(0, begin) + withBetween(own, kBegin, kEnd, 0, pythonProperties(part, own)) +
         source.substr(end);
}

}  // namespace

/// Files that follow from the description of the document are those in the tree.
class FormatFilesTest : public QObject {
  Q_OBJECT

 private slots:
  void schema() { compare("resources/schema/geargraph.schema.json", documentSchema()); }

  void page() {
    constexpr const char* kPage = "resources/schema/README.md";
    compare(kPage, withBetween(read(kPage), "<!-- members -->\n", "<!-- end of members -->\n", 0,
                               "\n" + memberTables() + "\n"));
  }

  void pythonClasses() {
    constexpr const char* kClasses = "app/python/geargraph/_elements.py";
    const std::vector<std::pair<const char*, DocumentPart>> classes = {
        {"Link", DocumentPart::link},
        {"Axis", DocumentPart::axis},
        {"TurningJoint", DocumentPart::turningJoint},
        {"GearMesh", DocumentPart::gearMesh},
        {"Coupling", DocumentPart::coupling}};
    std::string source = read(kClasses);
    for (const auto& [name, part] : classes) source = withProperties(source, name, part);
    compare(kClasses, source);
  }

  /// The comparison has to be able to fail: a class without a property differs.
  void aMissingPropertyIsFound() {
    const std::string source = "\nclass Axis(_Handle):" + std::string(kBegin) + kEnd;
    QVERIFY(withProperties(source, "Axis", DocumentPart::axis) != source);
    const std::string written = "    def point(self):\n    def direction(self):\n    def pinned(self):\n";
    QCOMPARE(pythonProperties(DocumentPart::axis, written), std::string());
  }

  /// Each member says what it means, and names of an object are different.
  void membersAreDescribed() {
    for (const DocumentPart part : documentParts()) {
      std::set<std::string_view> names;
      for (const MemberInfo& info : membersOf(part)) {
        QVERIFY2(!info.meaning.empty(), std::string(info.name).c_str());
        QVERIFY2(names.insert(info.name).second, std::string(info.name).c_str());
        QVERIFY(info.since >= 1);
      }
      QCOMPARE(listedMembersOf(part).size(), membersOf(part).size());
    }
  }
};

QTEST_APPLESS_MAIN(FormatFilesTest)
#include "test_format_files.moc"
