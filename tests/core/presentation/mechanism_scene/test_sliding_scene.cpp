#include <QTest>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>

#include "core/mechanism/document_format/mechanism_file.h"
#include "core/presentation/mechanism_scene/mechanism_scene.h"
#include "core/presentation/scene3d/motion_curves.h"
#include "tests/core/support/example_files.h"

namespace geargraph {
namespace {

/// The beam that a rack moves along x, and on it the quill that a screw moves along z.
SnapshotPtr gantryMoving() {
  std::ifstream file(test::sourcePath("tests/golden/files/gantry.geargraph"), std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  const auto read = readMechanism(bytes);
  if (!read) qFatal("%s", read.error().front().message.c_str());
  return analyzeLive(std::make_shared<const Mechanism>(*read));
}

}  // namespace

/// Joints that slide move in lengths, in playback as in plots.
class SlidingSceneTest : public QObject {
  Q_OBJECT

 private slots:
  void itStopsAtTheLimitsOfSlidesAndNeverWraps() {
    const SnapshotPtr gantry = gantryMoving();
    GearCache cache;
    const MechanismScenePtr stage = mechanismScene(*gantry, cache);
    QVERIFY(stage->range != nullptr);
    QCOMPARE(stage->period, 0.0);  // nothing comes back to where it was
    const std::vector<double> none(stage->inputSpeeds.size(), 0.0);
    const SceneRange range = stage->range(none);
    // The beam has 200 mm at 20 mm/s; the quill goes down at 5/pi mm/s from its upper end.
    QVERIFY(std::abs(range.to.time) < 1e-9 || std::abs(range.from.time) < 1e-9);
    const SceneLimit& far = std::abs(range.to.time) < 1e-9 ? range.from : range.to;
    QVERIFY(std::abs(std::abs(far.time) - 10) < 1e-9);
    QVERIFY2(far.text.starts_with("joint 6 at ") && far.text.ends_with("200 mm"), far.text.c_str());
    const SceneLimit& near = &far == &range.to ? range.from : range.to;
    QCOMPARE(near.text, std::string("joint 8 at 0 mm"));
  }

  void slidesAreOnASheetOfTheirOwn() {
    const SnapshotPtr gantry = gantryMoving();
    GearCache cache;
    const MechanismScenePtr stage = mechanismScene(*gantry, cache);
    const auto sheets = motionCurves(*stage, {}, {{}, false, 5});
    QCOMPARE(sheets.size(), std::size_t{2});
    QCOMPARE(sheets[0].unit, std::string("rad/s"));
    QCOMPARE(sheets[1].unit, std::string("mm/s"));
    QCOMPARE(sheets[0].curves.size(), std::size_t{2});
    QCOMPARE(sheets[1].curves.size(), std::size_t{2});
    QCOMPARE(sheets[1].curves[0].name, std::string("joint 6"));
    QVERIFY(std::abs(std::abs(sheets[1].curves[0].values.front()) - 20) < 1e-12);
    QVERIFY(std::abs(std::abs(sheets[1].curves[1].values.front()) - 5 / std::numbers::pi) < 1e-12);
    QVERIFY(curvesCsv(sheets[1]).starts_with("time s,\"joint 6 mm/s\",\"joint 8 mm/s\""));
  }

  void jointsTellWhichOfThemSlide() {
    const SnapshotPtr gantry = gantryMoving();
    GearCache cache;
    const MechanismScenePtr stage = mechanismScene(*gantry, cache);
    QCOMPARE(std::count_if(stage->joints.begin(), stage->joints.end(),
                           [](const SceneJoint& joint) { return joint.slides; }),
             std::ptrdiff_t{2});
  }
};

}  // namespace geargraph

QTEST_GUILESS_MAIN(geargraph::SlidingSceneTest)
#include "test_sliding_scene.moc"
