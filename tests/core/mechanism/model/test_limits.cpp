#include <QTest>

#include "core/mechanism/document_format/mechanism_file.h"
#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/limits.h"
#include "core/mechanism/model/shift_edits.h"
#include "core/mechanism/model/validate.h"
#include "tests/core/support/mechanisms.h"

namespace geargraph {

class LimitsTest : public QObject {
  Q_OBJECT

  const Mechanism robot = test::robotTopology();
  const std::string longest = std::string(kMaxNameLength, 'x');

  /// The diagnostic that keeps a document from being opened is known before it is saved.
  static void checkRejected(const Mechanism& mechanism, const std::string& pointer) {
    const Diagnostics beyond = limitDiagnostics(mechanism);
    QCOMPARE(beyond.size(), std::size_t{1});
    QCOMPARE(beyond.front().code, Code::schema);
    QCOMPARE(beyond.front().pointer, pointer);
    QVERIFY(!wellFormedDiagnostics(mechanism).empty());
    const auto read = readMechanism(writeMechanism(mechanism));
    QVERIFY(!read);
    QCOMPARE(read.error().front().pointer, pointer);
  }

 private slots:
  void theRobotIsWithinThem() { QVERIFY(limitDiagnostics(robot).empty()); }

  void namesHaveALongest() {
    const Mechanism fine = *withName(robot, robot.links[2].id, longest);
    QVERIFY(limitDiagnostics(fine).empty());
    QVERIFY(*readMechanism(writeMechanism(fine)) == fine);
    checkRejected(*withName(robot, robot.links[2].id, longest + "x"), "/links/2/name");
    checkRejected(*withStateRenamed(*withState(robot), 0, longest + "x"), "/states/0/name");
    Mechanism named = robot;
    named.name = longest + "x";
    checkRejected(named, "/name");
  }

  void charactersCountAndNotBytes() {
    std::string gears;
    for (std::size_t i = 0; i < kMaxNameLength; ++i) gears += "齿";
    QVERIFY(limitDiagnostics(*withName(robot, robot.links[1].id, gears)).empty());
    checkRejected(*withName(robot, robot.links[1].id, gears + "齿"), "/links/1/name");
  }

  /// Texts of what an element holds, too.
  void pathsOf3DFilesHaveALongest() {
    Mechanism dressed = robot;
    dressed.links[1].shapes.push_back({longest, {}, {}, {}, {}});
    QVERIFY(limitDiagnostics(dressed).empty());
    dressed.links[1].shapes.push_back({longest + "x", {}, {}, {}, {}});
    checkRejected(dressed, "/links/1/shapes/1/file");
  }

  void idsHaveALongest() { checkRejected(*withName(robot, robot.axes[0].id, longest + "x"), "/axes/0/id"); }

  /// An id may be empty in a document that is about to be refused.
  void aNodeBeyondThemIsPointedAt() {
    for (const std::string& id : {std::string("3"), std::string()}) {
      Mechanism far = robot;
      far.view.nodes[LinkId(id)] = {0, 1e17};
      const Diagnostics beyond = limitDiagnostics(far);
      QCOMPARE(beyond.size(), std::size_t{1});
      QCOMPARE(beyond.front().pointer, "/view/nodes/" + id + "/1");
      QVERIFY(beyond.front().elements == std::vector<ElementId>{LinkId(id)});
    }
  }

  void anAxisIsNotPlacedBeyondThem() {
    const NumberTriple far{Number::fromDouble(1e200), Number(0), Number(0)};
    for (const auto& rejected : {withAxisPlaced(robot, robot.axes[0].id, far, {}),
                                 withAxisPlaced(robot, robot.axes[0].id, {}, far)}) {
      QVERIFY(!rejected);
      QCOMPARE(rejected.error().front().code, Code::schema);
      QVERIFY(rejected.error().front().pointer.empty());
    }
  }

  void listsHaveALongest() {
    Mechanism many = emptyMechanism();
    for (std::size_t i = 1; i <= kMaxListLength; ++i)
      many.links.push_back({LinkId(std::to_string(i)), {}, {}});
    checkRejected(many, "/links");
  }
};

}  // namespace geargraph

QTEST_GUILESS_MAIN(geargraph::LimitsTest)
#include "test_limits.moc"
