#include <QTest>

#include "core/mechanism/document_format/mechanism_file.h"
#include "core/mechanism/model/difference.h"
#include "core/mechanism/model/shapes.h"
#include "core/mechanism/model/validate.h"
#include "tests/core/mechanism/document_format/support.h"
#include "tests/core/support/example_files.h"

using namespace geargraph;
using namespace geargraph::test;

/// The members of the document that only views use: the camera and the 3D files of links.
class ViewMembersTest : public QObject {
  Q_OBJECT

 private slots:
  void theCameraSurvivesTheFile() {
    Mechanism m = example("robot");
    QVERIFY(!m.view.camera);
    m.view.camera = ViewCamera{{1.5, -2, 0.25}, -30, 20.5, 400, {{"lens", "35"}}};
    QVERIFY(readMechanism(writeMechanism(m)).value() == m);
    QVERIFY(writeMechanism(m).find(R"("camera": {"target": [1.5, -2, 0.25], "azimuth": -30, )"
                                   R"("elevation": 20.5, "distance": 400, "lens": 35})") !=
            std::string::npos);
    QVERIFY(isSameButForView(m, example("robot")));
    QVERIFY(differenceOf(example("robot"), m).other);
  }

  void notesSurviveTheFile() {
    Mechanism m = example("robot");
    m.view.notes = {{NoteId("N1"), "two lines\n\"quoted\" ↦ عربي", {1.5, -2}, {{"color", "\"red\""}}},
                    {NoteId("mine"), "x", {-0.0, 4}}};
    QVERIFY(readMechanism(writeMechanism(m)).value() == m);
    const std::string written =
        "{\"id\": \"N1\", \"text\": \"two lines\\n\\\"quoted\\\" ↦ عربي\", "
        "\"at\": [1.5, -2], \"color\": \"red\"}";
    QVERIFY(writeMechanism(m).find(written) != std::string::npos);
    QVERIFY(isSameButForView(m, example("robot")));  // nothing is analysed anew for a note
    QVERIFY(differenceOf(example("robot"), m).other);
  }

  void whatIsAttachedToALinkSurvivesTheFile() {
    LinkShape arm{"parts/arm.stl"};
    arm.orientation = NumberTriple{Number(0), *Number::fromText("22.5"), Number(-90)};
    arm.scale = *Number::fromText("1/3");
    arm.unknown = {{"finish", "\"matt\""}};
    const LinkShape box{"b.obj", NumberTriple{Number(1), Number(2), Number(3)}};
    const Mechanism dressed = withShapes(example("robot"), LinkId("2"), {arm, box}).value();
    const Mechanism back = readMechanism(writeMechanism(dressed)).value();
    QVERIFY(back == dressed);
    QVERIFY(back.find(LinkId("2"))->shapes == (std::vector{arm, box}));
    QVERIFY(back.find(LinkId("1"))->shapes.empty());
    QVERIFY(withShapes(dressed, LinkId("2"), {}).value() == example("robot"));
  }

  void pathsOutOfTheFolderAndScalesBelowZeroAreRejected() {
    for (const char* path :
         {"", "/etc/arm.stl", "\\\\host\\arm.stl", "C:\\arm.stl", "..", "../parts/arm.stl",
          "parts/../../arm.stl", "..\\arm.stl", "./../arm.stl", "a/b/../../../c/d/arm.stl"})
      QCOMPARE(withShapes(example("robot"), LinkId("1"), {LinkShape{path}}).error()[0].code, Code::schema);
    for (const char* path :
         {"arm.stl", "parts/arm.stl", "parts/../arm.stl", "./arm.stl", "..arm.stl", "a//b/..c"})
      QVERIFY2(withShapes(example("robot"), LinkId("1"), {LinkShape{path}}).has_value(), path);
    LinkShape shape{"arm.stl"};
    shape.scale = Number(0);
    QCOMPARE(withShapes(example("robot"), LinkId("1"), {shape}).error()[0].code, Code::schema);
    QCOMPARE(withShapes(example("robot"), LinkId("77"), {}).error()[0].code, Code::unknownId);
  }

  /// A mechanism that was built in memory is held to the same rules as one from a file.
  void wellFormedDiagnosticsKnowTheViewsMembers() {
    Mechanism m = example("robot");
    m.links[1].shapes = {LinkShape{"/etc/arm.stl", {}, {}, Number(-1)}};
    m.view.camera = ViewCamera{{}, 0, 0, 0};
    QCOMPARE(summary(wellFormedDiagnostics(m)),
             std::string("schema /links/1/shapes/0/file [links:1]; schema /links/1/shapes/0/scale [links:1]; "
                         "schema /view/camera/distance"));
  }
};

QTEST_APPLESS_MAIN(ViewMembersTest)
#include "test_view_members.moc"
