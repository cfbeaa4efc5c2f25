// Where the numbers of links stand in 3D pictures: on what is seen of their links, checked by picks.

#include <QTest>
#include <algorithm>

#include "core/presentation/gl_renderer/egl_host.h"
#include "core/presentation/mechanism_scene/mechanism_scene.h"
#include "core/presentation/scene3d/label_places.h"
#include "core/presentation/scene3d/scene_view.h"
#include "tests/core/support/example_files.h"
#include "tests/ui/view3d/toy_stage.h"

using namespace geargraph;

namespace {

constexpr Viewport kSize{640, 480};

MechanismScenePtr exampleStage(const std::string& name) {
  GearCache cache;
  return mechanismScene(*analyzeLive(std::make_shared<const Mechanism>(test::example(name))), cache);
}

/// A stage seen from somewhere, with what its picture shows where.
class Shown {
 public:
  explicit Shown(MechanismScenePtr stage) : m_stage(std::move(stage)), m_seen(m_stage) {
    m_host = std::move(EglHost::create()).value();
    m_host->setScene(m_stage->scene);
  }

  SceneView view;
  LabelPlaces places;

  std::vector<LabelPlate> labels() {
    m_seen.show(view);
    const Viewport cells = labelCells(kSize, 1);
    m_map = m_host->seen(m_seen.frame(kSize, 1), cells.width, cells.height);
    return places.find({*m_stage, m_seen.poses(), m_seen.visibility(), view.camera, kSize, 1, &m_map});
  }
  /// As while the camera moves: what is seen was looked up before.
  std::vector<LabelPlate> labelsWithOldMap() {
    m_seen.show(view);
    return places.find({*m_stage, m_seen.poses(), m_seen.visibility(), view.camera, kSize, 1, nullptr});
  }
  /// With the same picture, every cell of which shows the instance of this number.
  std::vector<LabelPlate> labelsWithAllCellsOf(std::uint32_t number) {
    std::fill(m_map.numbers.begin(), m_map.numbers.end(), number);
    return places.find({*m_stage, m_seen.poses(), m_seen.visibility(), view.camera, kSize, 1, &m_map});
  }
  void fit(double yaw, double pitch) {
    m_seen.show(view);
    view.camera = Camera::from(yaw, pitch).fitted(m_seen.corners(), kSize);
  }
  [[nodiscard]] std::optional<Hit> pick(const Eigen::Vector2d& at) {
    return m_host->pick(m_seen.frame(kSize, 1), at.x(), at.y());
  }
  /// Is the link seen there, or in the same cell of the map, which is four pixels wide?
  [[nodiscard]] bool isSeenAbout(const Eigen::Vector2d& place, const ElementId& link) {
    for (int right = -2; right <= 2; ++right) {
      for (int down = -2; down <= 2; ++down) {
        const auto hit = pick(place + Eigen::Vector2d(right, down));
        if (hit && hit->element == link) return true;
      }
    }
    return false;
  }
  [[nodiscard]] const VisibilityBuffer& map() const { return m_map; }
  [[nodiscard]] const MechanismScene& stage() const { return *m_stage; }
  /// Is something of the link in the map?
  [[nodiscard]] bool isSeen(const ElementId& link) const {
    return std::any_of(m_map.numbers.begin(), m_map.numbers.end(), [&](std::uint32_t number) {
      return number > 0 && m_stage->scene.instances[number - 1].element == link;
    });
  }

 private:
  MechanismScenePtr m_stage;
  SeenStage m_seen;
  std::unique_ptr<EglHost> m_host;
  VisibilityBuffer m_map;
};

const LabelPlate* plateOf(const Shown& shown, const std::vector<LabelPlate>& plates, const ElementId& link) {
  const auto plate = std::find_if(plates.begin(), plates.end(), [&](const LabelPlate& candidate) {
    return shown.stage().labels[candidate.label].element == link;
  });
  return plate == plates.end() ? nullptr : &*plate;
}

}  // namespace

class LabelsTest : public QObject {
  Q_OBJECT

 private slots:
  void everyNumberSpeaksOfItsLink_data() {
    QTest::addColumn<QString>("name");
    for (const std::string& name : test::exampleNames()) {
      if (name != "robot-to-mend")  // its joints close a loop: it has no stage
        QTest::newRow(name.c_str()) << QString::fromStdString(name);
    }
  }
  void everyNumberSpeaksOfItsLink() {
    QFETCH(QString, name);
    const MechanismScenePtr stage = exampleStage(name.toStdString());
    QVERIFY(stage != nullptr);
    Shown shown(stage);
    int plated = 0;
    for (const double yaw : {-2.2, 0.4, 1.7}) {
      shown.fit(yaw, 0.5);
      const auto plates = shown.labels();
      for (const SceneLabel& label : stage->labels) {
        if (label.kind != LabelKind::link) continue;
        const LabelPlate* plate = plateOf(shown, plates, label.element);
        QCOMPARE(plate != nullptr, shown.isSeen(label.element));
        if (plate == nullptr) continue;
        ++plated;
        QVERIFY2(shown.isSeenAbout(plate->anchor, label.element), label.text.c_str());
        QVERIFY(plate->hasLine() || (plate->middle - plate->anchor).norm() <= kLabelRadius + 1);
      }
    }
    QVERIFY(plated > 0);
  }

  // Close to the eye: what is beside the picture has no plate at its edge, with a line that leads out of it.
  void whatIsBesideThePictureHasNoPlate() {
    Shown shown(exampleStage("robot"));
    shown.places.setShown(LabelKind::joint, true);
    shown.places.setShown(LabelKind::axis, true);
    shown.fit(0.7, 0.5);
    const std::size_t all = shown.labels().size();
    const Eigen::AlignedBox2d picture(Eigen::Vector2d(-30, -30),
                                      Eigen::Vector2d(kSize.width + 30, kSize.height + 30));
    std::size_t fewest = all;
    for (int step = 0; step < 12; ++step) {
      shown.view.camera = shown.view.camera.zoomed(1.7, shown.view.camera.atTargetDepth(500, 90, kSize));
      for (const bool isLookedAt : {false, true}) {  // with the map from before, and with its own
        const auto plates = isLookedAt ? shown.labels() : shown.labelsWithOldMap();
        for (const LabelPlate& plate : plates)
          QVERIFY2(picture.contains(plate.anchor), shown.stage().labels[plate.label].text.c_str());
        fewest = std::min(fewest, plates.size());
      }
    }
    QVERIFY(all > 10 && fewest < all / 2);
  }

  // Parts without a label up to the border of the picture: the room of a cell is measured within the map.
  void aMapFullOfPartsWithoutALabelHasNoPlates() {
    Shown shown(test::toyStage());
    shown.fit(0.7, 0.5);
    QVERIFY(!shown.labels().empty());
    QVERIFY(shown.labelsWithAllCellsOf(1'000'000).empty());
  }

  void theMapShowsWhatPicksFind() {
    Shown shown(test::toyStage());
    shown.fit(0.7, 0.5);
    QVERIFY(!shown.labels().empty());
    const VisibilityBuffer& map = shown.map();
    int met = 0;
    for (int row = 0; row < map.rows; row += 3) {
      for (int column = 0; column < map.columns; column += 3) {
        const auto number = map.numbers[map.at(column, row)];
        const auto around = [&](int right, int down) {
          const int x = std::clamp(column + right, 0, map.columns - 1);
          const int y = std::clamp(row + down, 0, map.rows - 1);
          return map.numbers[map.at(x, y)] == number;
        };
        if (!around(-1, 0) || !around(1, 0) || !around(0, -1) || !around(0, 1)) continue;  // at a border
        const auto hit = shown.pick({4 * column + 2.0, 4 * row + 2.0});
        QCOMPARE(hit ? hit->instance + 1 : 0, static_cast<std::size_t>(number));
        if (!hit) continue;
        ++met;
        QVERIFY((hit->point - map.point(column, row)).norm() < 1.0);
      }
    }
    QVERIFY(met > 50);
  }

  void whatASectionTakesAwayHasNoNumber() {
    Shown shown(test::toyStage());
    shown.fit(0.7, 0.5);
    QCOMPARE(shown.labels().size(), std::size_t{3});
    shown.view.section = SectionChoice{1, 0.4, false};  // across the box, between the two wheels
    const std::size_t half = shown.labels().size();
    shown.view.section->isTurned = true;
    const std::size_t otherHalf = shown.labels().size();
    QVERIFY(half < 3 || otherHalf < 3);
    QVERIFY(plateOf(shown, shown.labels(), LinkId("1")) == nullptr ||
            plateOf(shown, shown.labels(), LinkId("2")) == nullptr);
  }

  void aNumberStaysWhileItsWheelTurnsAndGoesWithAPartThatMoves() {
    Shown shown(test::toyStage());
    shown.fit(0.7, 0.9);
    const auto first = shown.labels();
    const Eigen::Vector2d wheel = plateOf(shown, first, LinkId("1"))->middle;
    const Eigen::Vector2d box = plateOf(shown, first, LinkId("3"))->middle;
    shown.view.time = 0.6;  // the wheel has turned by about 50 degrees, the box has swung by 8 mm
    const auto later = shown.labels();
    QVERIFY((plateOf(shown, later, LinkId("1"))->middle - wheel).norm() < 0.5);
    QVERIFY((plateOf(shown, later, LinkId("3"))->middle - box).norm() > 10);
  }

  void aNarrowPartHasItsNumberBesideIt() {
    auto stage = std::make_shared<MechanismScene>();
    stage->scene.solids.push_back(std::make_shared<const Solid>(cylinderSolid(0.6, -20, 20)));
    Instance rod;
    rod.element = LinkId("1");
    stage->scene.instances.push_back(rod);
    SceneLabel label;
    label.text = "1";
    label.element = rod.element;
    label.instance = 0;
    stage->labels.push_back(label);
    Shown shown(stage);
    shown.fit(0, 0);
    const auto plates = shown.labels();
    QCOMPARE(plates.size(), std::size_t{1});
    QVERIFY(plates[0].hasLine());
    QVERIFY(shown.pick(plates[0].anchor).has_value());
    for (int angle = 0; angle < 360; angle += 10) {
      const Eigen::Vector2d rim =
          plates[0].middle +
          (kLabelRadius - 1) * Eigen::Vector2d(std::cos(angle * 0.01745), std::sin(angle * 0.01745));
      QVERIFY(!shown.pick(rim));
    }
  }

  void platesTouchNeitherEachOtherNorTheBorders() {
    Shown shown(test::toyStage());
    shown.places.setBorders(30, 20);  // buttons above, the playback bar below
    for (double yaw = -3; yaw < 3; yaw += 0.5) {
      shown.fit(yaw, 0.3);
      const auto plates = shown.labels();
      QVERIFY(plates.size() >= 2);
      for (const LabelPlate& a : plates) {
        QVERIFY(a.middle.x() >= kLabelRadius && a.middle.x() <= kSize.width - kLabelRadius);
        QVERIFY(a.middle.y() >= 30 + kLabelRadius && a.middle.y() <= kSize.height - 20 - kLabelRadius);
        for (const LabelPlate& b : plates)
          QVERIFY(&a == &b || (a.middle - b.middle).norm() > 2 * kLabelRadius - 0.5);
      }
    }
  }
};

QTEST_GUILESS_MAIN(LabelsTest)
#include "test_labels.moc"
