#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QTest>
#include <set>

#include "tests/core/support/example_files.h"
#include "tests/soak/random_edits.h"

namespace geargraph::soak {
namespace {

/// Functions that return a document and are no edit of one.
const std::set<QString> kNoEdits = {
    "emptyMechanism",  // the first document
    "familyTrain",     // trains on which both methods are counted
    "fragmentOf",      // what withFragment takes
    "readMechanism",
    "readDocument",
    "readView",
    "readMechanismTable",
    "readMechanismOrTable",  // how documents come in
    "unlessBroken",
    "fitAxes",
    "unplaced",  // parts of the fitted edits
    "checkedEdit",
    "checkedLimits",
    "withAxisLettersAsBefore",  // the parts that edits end with
};

/// The names of all functions of headers that return a mechanism or its view.
std::set<QString> editFunctions() {
  static const QRegularExpression kFunction(
      QStringLiteral(R"(^\[\[nodiscard\]\]\s+(?:Expected<(?:Placed)?Mechanism>|Mechanism|View)\s+(\w+)\()"),
      QRegularExpression::MultilineOption);
  std::set<QString> names;
  for (const char* folder : {"core", "ui"}) {
    QDirIterator headers(QString::fromStdString(test::sourcePath(folder)), {QStringLiteral("*.h")},
                         QDir::Files, QDirIterator::Subdirectories);
    while (headers.hasNext()) {
      QFile header(headers.next());
      if (!header.open(QIODevice::ReadOnly)) continue;
      const QString text = QString::fromUtf8(header.readAll());
      for (auto matches = kFunction.globalMatch(text); matches.hasNext();)
        names.insert(matches.next().captured(1));
    }
  }
  return names;
}

}  // namespace

/// The random edits cover every edit that the program can make.
class EditKindsTest : public QObject {
  Q_OBJECT
 private slots:
  void everyEditFunctionHasAGenerator() {
    std::set<QString> known = kNoEdits;
    for (const EditKind& kind : editKinds()) known.insert(QString::fromStdString(kind.function));
    const std::set<QString> functions = editFunctions();
    QVERIFY(functions.contains(QStringLiteral("withTurningJoint")));  // the pattern finds what it looks for
    for (const QString& function : functions) {
      QVERIFY2(known.contains(function), qPrintable(function + QStringLiteral(" has no random edits.")));
    }
    for (const QString& name : kNoEdits) QVERIFY2(functions.contains(name), qPrintable(name));
  }

  void everyKindIsNamedOnce() {
    std::set<std::string> names;
    for (const EditKind& kind : editKinds())
      QVERIFY2(names.insert(kind.function).second, kind.function.c_str());
  }

  void theSameSeedGivesTheSameEdits() {
    const Mechanism robot = test::example("robot");
    std::vector<Mechanism> results[2];
    for (auto& each : results) {
      std::mt19937_64 random(7);
      for (int i = 0; i < 300; ++i) {
        const EditKind& kind = randomKind(random);
        RandomArguments arguments(random, robot);
        const Reduce reduce = kind.make(arguments);
        const Expected<Mechanism> next = reduce ? reduce(robot) : Expected<Mechanism>(robot);
        if (next) each.push_back(*next);
      }
    }
    QVERIFY(results[0].size() > 100);
    QVERIFY(results[0] == results[1]);
  }
};

}  // namespace geargraph::soak

QTEST_GUILESS_MAIN(geargraph::soak::EditKindsTest)
#include "test_edit_kinds.moc"
