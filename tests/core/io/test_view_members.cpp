#include <QtTest>

#include "core/io/mechanism_file.h"
#include "core/io/view_members.h"
#include "tests/core/io/support.h"
#include "tests/core/support/example_files.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

Mechanism robot() {
  return example("robot");
}

Mechanism wearing(const std::string& shapes) {
  return readMechanism(R"({"format": "geargraph", "version": 1, "links": [{"id": "0", "shapes": )" + shapes +
                       "}]}")
      .value();
}

}  // namespace

/// What only views use of a document, kept in members that the mechanism does not know.
class TestViewMembers : public QObject {
  Q_OBJECT

 private slots:
  void theCameraSurvivesTheFile() {
    Mechanism m = robot();
    QVERIFY(!viewCamera(m.view));
    const ViewCamera camera{{1.5, -2, 0.25}, -30, 20.5, 400};
    m.view = withCamera(m.view, camera);
    m.view = withCamera(m.view, camera);  // one, however often
    const Mechanism back = readMechanism(writeMechanism(m)).value();
    QVERIFY(back == m);
    QVERIFY(viewCamera(back.view) == camera);
    QVERIFY(writeMechanism(m).find("\"camera\": {\"target\": [1.5, -2, 0.25], \"azimuth\": -30") !=
            std::string::npos);
  }

  void aCameraOfAnotherKindIsKeptUntilAnotherTakesItsPlace() {
    for (const char* camera :
         {R"({"zoom": 2})", "7", R"({"target": [0, 0, 0], "azimuth": 1, "elevation": 2, "distance": 0})",
          R"({"target": [0, 0], "azimuth": 1, "elevation": 2, "distance": 3})",
          R"({"target": [0, "x", 0], "azimuth": 1, "elevation": 2, "distance": 3})"}) {
      View view;
      view.unknown = {{"grid", "true"}, {"camera", camera}};
      QVERIFY(!viewCamera(view));
      const View changed = withCamera(view, {{}, 0, 0, 5});
      QCOMPARE(viewCamera(changed)->distance, 5.0);
      QCOMPARE(changed.unknown.size(), std::size_t{2});
    }
  }

  void whatALinkWearsSurvivesTheFile() {
    LinkShape arm{"parts/arm.stl"};
    arm.orientation = NumberTriple{Number(0), *Number::fromText("22.5"), Number(-90)};
    arm.scale = *Number::fromText("1/3");
    arm.unknown = {{"finish", "\"matt\""}};
    const LinkShape box{"b.obj", NumberTriple{Number(1), Number(2), Number(3)}};
    const Mechanism dressed = withShapes(robot(), LinkId("2"), {arm, box}).value();
    const Mechanism back = readMechanism(writeMechanism(dressed)).value();
    QVERIFY(back == dressed);
    QVERIFY(linkShapes(*back.find(LinkId("2"))).value() == (std::vector{arm, box}));
    QVERIFY(linkShapes(*back.find(LinkId("1"))).value().empty());
    QVERIFY(withShapes(dressed, LinkId("2"), {}).value() == robot());
  }

  void pathsOutOfTheFolderAndScalesBelowZeroAreRefused() {
    for (const char* path :
         {"", "/etc/arm.stl", "\\\\host\\arm.stl", "C:\\arm.stl", "..", "../parts/arm.stl",
          "parts/../../arm.stl", "..\\arm.stl", "./../arm.stl", "a/b/../../../c/d/arm.stl"})
      QCOMPARE(withShapes(robot(), LinkId("1"), {LinkShape{path}}).error()[0].code, Code::schema);
    for (const char* path :
         {"arm.stl", "parts/arm.stl", "parts/../arm.stl", "./arm.stl", "..arm.stl", "a//b/..c"})
      QVERIFY2(withShapes(robot(), LinkId("1"), {LinkShape{path}}).has_value(), path);
    LinkShape shape{"arm.stl"};
    shape.scale = Number(0);
    QCOMPARE(withShapes(robot(), LinkId("1"), {shape}).error()[0].code, Code::schema);
    QCOMPARE(withShapes(robot(), LinkId("77"), {}).error()[0].code, Code::unknownId);
  }

  void shapesThatMakeNoSenseAreSaid() {
    const auto problems = [](const std::string& shapes) {
      const auto read = linkShapes(wearing(shapes).links[0]);
      return read ? std::string() : read.error().front().pointer;
    };
    QCOMPARE(problems(R"([{"file": "a.stl"}])"), std::string());
    QCOMPARE(problems(R"([{"file": "/etc/passwd"}])"), std::string("/shapes/0/file"));
    QCOMPARE(problems(R"([{"file": "../a.stl"}])"), std::string("/shapes/0/file"));
    QCOMPARE(problems(R"([{"file": "a.stl"}, {"scale": 1}])"), std::string("/shapes/1/file"));
    QCOMPARE(problems(R"([{"file": "a.stl", "scale": 0}])"), std::string("/shapes/0/scale"));
    QCOMPARE(problems(R"([{"file": "a.stl", "position": [0, 0]}])"), std::string("/shapes/0/position"));
    QVERIFY(!linkShapes(wearing("7").links[0]));
  }
};

QTEST_APPLESS_MAIN(TestViewMembers)
#include "test_view_members.moc"
