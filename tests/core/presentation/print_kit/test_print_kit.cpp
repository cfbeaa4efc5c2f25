#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <set>

#include "core/machine/body_layout/derived_geometry.h"
#include "core/machine/teeth/wheel_kind.h"
#include "core/presentation/exporters/exporters.h"
#include "core/presentation/print_kit/kit_check.h"
#include "core/presentation/print_kit/kit_page.h"
#include "core/presentation/print_kit/kit_plates.h"
#include "core/presentation/print_kit/kit_poses.h"
#include "core/presentation/print_kit/kit_shell.h"
#include "core/presentation/print_kit/print_kit.h"
#include "core/theory/pose/joint_limits.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/snapshot_of.h"

using namespace geargraph;
using namespace geargraph::test;
using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using std::numbers::pi;

namespace {

constexpr std::array kExamples = {"spur-pair", "planetary-ring-held", "three-planets", "bevel-differential",
                                  "robot"};

std::variant<PrintKit, KitFailure> kitOf(const SnapshotPtr& snapshot, const KitOptions& options = {},
                                         const std::stop_token& stop = {}) {
  const DerivedGeometry& geometry = *snapshot->geometry;
  const auto loaded = exportTrain(snapshot);
  const auto& train = std::get<ExportTrain>(loaded);
  const std::vector<KitPose> poses = kitPoses(train.mechanism(), train.placed().kinematics, train.motions);
  return printKit(*snapshot->mechanism, geometry.placement(), train.train, *geometry.arrangement(), 1, poses,
                  options, stop);
}

/// A kit and what it was made from.
struct ExampleKit {
  SnapshotPtr snapshot;
  PrintKit kit;
};

const ExampleKit& kitExample(const std::string& name) {
  static std::map<std::string, ExampleKit> made;
  if (const auto known = made.find(name); known != made.end()) return known->second;
  ExampleKit fresh;
  fresh.snapshot = snapshotOf(example(name));
  auto kit = kitOf(fresh.snapshot);
  if (const auto* why = std::get_if<KitFailure>(&kit)) qWarning("%s: %s", name.c_str(), why->message.c_str());
  fresh.kit = std::get<PrintKit>(std::move(kit));
  return made[name] = std::move(fresh);
}

void addExamples() {
  QTest::addColumn<QString>("name");
  for (const char* const name : kExamples) QTest::newRow(name) << QString::fromLatin1(name);
}

/// How often edges between equal positions occur in excess of their opposites, and edges that occur twice.
int openEdges(const Solid& solid) {
  std::map<std::pair<Float3, Float3>, int> edges;
  for (const Triangle& t : solid.triangles) {
    for (std::size_t k = 0; k < 3; ++k) ++edges[{solid.positions[t[k]], solid.positions[t[(k + 1) % 3]]}];
  }
  int open = 0;
  for (const auto& [edge, count] : edges) {
    const auto back = edges.find({edge.second, edge.first});
    if (count != 1 || back == edges.end() || back->second != 1) ++open;
  }
  return open;
}

/// A point of a gear's pitch surface: the middle of a tooth, or half a tooth on.
double angleOf(const GearSpec& spec, double tooth) {
  return 2 * pi * tooth / spec.teeth;
}

}  // namespace

class TestPrintKit : public QObject {
  Q_OBJECT

 private slots:
  void polygonsWithHolesAreTriangulatedExactly();
  void partsAreClosedAndFlat_data() { addExamples(); }
  void partsAreClosedAndFlat();
  void partsFitTheirPlatesApart_data() { addExamples(); }
  void partsFitTheirPlatesApart();
  void nothingOverlapsAtRestAndInMotion_data() { addExamples(); }
  void nothingOverlapsAtRestAndInMotion();
  void markedTeethMeetMarkedSpaces_data() { addExamples(); }
  void markedTeethMeetMarkedSpaces();
  void playThinsTeethAndKeepsShifts();
  void firstLayersAreNarrower();
  void everyPartComesInOnAFreeWay_data() { addExamples(); }
  void everyPartComesInOnAFreeWay();
  void partsThatAreTooLargeAreRejected();
  void trainsWithoutPrintableFormAreRejected();
  void wrongOptionsAreRejected();
  void theFolderHasPlatesAssemblyAndPage();
  void aStopEndsIt();
};

void TestPrintKit::polygonsWithHolesAreTriangulatedExactly() {
  const std::vector<KitOutline> outlines = {circleOutline({0, 0}, 20), reversed(circleOutline({5, 0}, 3)),
                                            reversed(circleOutline({-8, 4}, 2)),
                                            reversed(boxOutline({0, -12}, Vector2d(1, 0), 6, 2))};
  std::vector<Vector2d> points;
  double area = 0;
  for (const KitOutline& outline : outlines) {
    area += doubledArea(outline) / 2;
    points.insert(points.end(), outline.begin(), outline.end());
  }
  double sum = 0;
  const std::vector<Triangle> triangles = triangulated(outlines);
  for (const Triangle& t : triangles) {
    const KitOutline one{points[t[0]], points[t[1]], points[t[2]]};
    QVERIFY(doubledArea(one) > 0);
    sum += doubledArea(one) / 2;
  }
  QVERIFY(std::abs(sum - area) < 1e-3);
  // Euler: a disc with h holes and n points has n + 2 (h - 1) triangles.
  QCOMPARE(triangles.size(), points.size() + 4);
}

void TestPrintKit::partsAreClosedAndFlat() {
  QFETCH(QString, name);
  for (const KitPart& part : kitExample(name.toStdString()).kit.parts) {
    QVERIFY2(openEdges(*part.solid) == 0, part.name.c_str());
    QVERIFY2(signedVolume(*part.solid) > 0, part.name.c_str());
    QVERIFY2(boundsOf(*part.solid).min().z() == 0, part.name.c_str());
    double onBed = 0;  // area of the faces on the bed
    for (const Triangle& t : part.solid->triangles) {
      const Float3 &a = part.solid->positions[t[0]], &b = part.solid->positions[t[1]],
                   &c = part.solid->positions[t[2]];
      if (a[2] != 0 || b[2] != 0 || c[2] != 0) continue;
      onBed += std::abs((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
    }
    QVERIFY2(onBed > 15, part.name.c_str());  // mm²
  }
}

void TestPrintKit::partsFitTheirPlatesApart() {
  QFETCH(QString, name);
  const PrintKit& kit = kitExample(name.toStdString()).kit;
  std::multiset<std::size_t> laid;
  for (const KitPlate& plate : kit.plates) {
    std::vector<Eigen::AlignedBox2d> boxes;
    for (const PlacedPart& placed : plate.parts) {
      laid.insert(placed.part);
      const Eigen::Rotation2Dd turn(placed.turn);
      Eigen::AlignedBox2d box;
      for (const Float3& p : kit.parts[placed.part].solid->positions)
        box.extend(placed.at + turn * Vector2d(p[0], p[1]));
      QVERIFY(box.min().x() >= 0 && box.min().y() >= 0);
      QVERIFY(box.max().x() <= kit.options.bedX && box.max().y() <= kit.options.bedY);
      for (const Eigen::AlignedBox2d& other : boxes)
        QVERIFY(other.exteriorDistance(box) > kit.options.gap - 1e-6);
      boxes.push_back(box);
    }
  }
  QCOMPARE(laid.size(), kit.parts.size());
  QCOMPARE(std::set<std::size_t>(laid.begin(), laid.end()).size(), kit.parts.size());
}

void TestPrintKit::nothingOverlapsAtRestAndInMotion() {
  QFETCH(QString, name);
  const auto& [snapshot, kit] = kitExample(name.toStdString());
  KitAssembly assembly;
  for (const KitPart& part : kit.parts) assembly.add(part);
  QVERIFY(!assembly.overlap({}));
  const auto loaded = exportTrain(snapshot);
  const auto& train = std::get<ExportTrain>(loaded);
  const PlacedTrain placed = train.placed();
  const std::vector<double> reference(train.motions.front().size(), 0);
  std::vector<double> rates;
  for (const Rational& rate : train.motions.back()) rates.push_back(rate.toDouble());
  const double fastest = std::abs(*std::max_element(
      rates.begin(), rates.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }));
  const MotionRange range = motionRange(angleLimits(train.mechanism()), reference, rates);
  // Other poses than those that the kit looked at itself.
  for (int frame = 1; frame <= 12; ++frame) {
    const double time = std::min(1.31 * frame / fastest, 0.99 * range.to);
    std::vector<double> angles;
    for (const double rate : rates) angles.push_back(rate * time);
    const auto poses = placed.kinematics.poses(angles);
    for (std::size_t a = 0; a < kit.parts.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        const LinkOrdinal one = kit.parts[a].link, other = kit.parts[b].link;
        if (one == other) continue;
        const bool meet = assembly.overlaps(a, b, poses[one], poses[other]);
        QVERIFY2(!meet, (kit.parts[a].name + ", " + kit.parts[b].name).c_str());
      }
    }
  }
}

void TestPrintKit::markedTeethMeetMarkedSpaces() {
  QFETCH(QString, name);
  const auto& [snapshot, kit] = kitExample(name.toStdString());
  const GearTrain& train = *snapshot->geometry->train();
  QCOMPARE(kit.marks.size(), train.meshes.size());
  for (const KitMark& mark : kit.marks) {
    const TrainGear &a = train.gears[mark.toothGear], &b = train.gears[mark.spaceGear];
    // The middles of tooth and space on the pitch cylinders or cones, at mid face.
    const auto middle = [&](const TrainGear& gear, double tooth) {
      const double angle = angleOf(gear.spec, tooth);
      const double cone = isConical(gear.spec) ? gear.spec.coneAngle : pi / 2;
      const double reach =
          isConical(gear.spec) ? coneDistance(gear.spec) - gear.spec.faceWidth / 2 : pitchRadius(gear.spec);
      return Vector3d(gear.pose * (reach * Vector3d(std::sin(cone) * std::cos(angle),
                                                    std::sin(cone) * std::sin(angle), std::cos(cone))));
    };
    const Vector3d tooth = middle(a, mark.tooth), space = middle(b, mark.space + 0.5);
    // Within half a pitch of the pitch point they differ by the curvature of the pitch circles only.
    const double pitch = pi * a.spec.module;
    QVERIFY2((tooth - space).norm() < 0.12 * pitch, (a.name + ", " + b.name).c_str());
    QVERIFY(mark.isToothMarked && mark.isSpaceMarked);
    for (const KitMark& other : kit.marks) {
      if (other.mesh == mark.mesh) continue;
      const std::set<int> gears{int{mark.toothGear}, int{mark.spaceGear}};
      if (gears.contains(int{other.toothGear}) || gears.contains(int{other.spaceGear}))
        QVERIFY(other.count != mark.count);
    }
  }
}

void TestPrintKit::playThinsTeethAndKeepsShifts() {
  const auto& [snapshot, kit] = kitExample("three-planets");
  const GearTrain& train = *snapshot->geometry->train();
  for (const GearOrdinal g : train.gears.ordinals()) {
    const GearSpec &drawn = train.gears[g].spec, &printed = kit.gears[static_cast<std::size_t>(int{g})];
    QCOMPARE(printed.profileShift, drawn.profileShift);
    QCOMPARE(printed.module, drawn.module);
    QVERIFY(std::abs(printed.backlashAllowance * printed.module - kit.options.play) < 1e-12);
  }
  // Measured on the sun: the width of a tooth on the pitch circle, at the upper face.
  for (const KitPart& part : kit.parts) {
    if (part.kind != KitPartKind::wheel || part.name.find("1-wheel") != 0) continue;
    const GearSpec& spec = kit.gears[static_cast<std::size_t>(int{*part.gear})];
    std::vector<double> crossings;
    const double radius = pitchRadius(spec), top = boundsOf(*part.solid).max().z();
    for (const std::vector<Vector2d>& line : topLines(*part.solid)) {
      for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const double from = line[i].norm() - radius, to = line[i + 1].norm() - radius;
        if ((from < 0) == (to < 0)) continue;
        const Vector2d p = line[i] + from / (from - to) * (line[i + 1] - line[i]);
        crossings.push_back(std::atan2(p.y(), p.x()));
      }
    }
    QVERIFY(top > 0);
    QCOMPARE(crossings.size(), static_cast<std::size_t>(2 * spec.teeth));
    std::sort(crossings.begin(), crossings.end());
    std::vector<double> widths;
    for (std::size_t i = 0; i + 1 < crossings.size(); ++i)
      widths.push_back((crossings[i + 1] - crossings[i]) * radius);
    const double wanted = pi * spec.module / 2 - kit.options.play;
    for (const double width : widths) {
      const double tooth = width < pi * spec.module / 2 ? width : pi * spec.module - width;
      QVERIFY2(std::abs(tooth - wanted) < 0.02, qPrintable(QString::number(tooth)));
    }
  }
}

void TestPrintKit::firstLayersAreNarrower() {
  for (const KitPart& part : kitExample("three-planets").kit.parts) {
    if (part.kind != KitPartKind::wheel && part.kind != KitPartKind::base) continue;
    double onBed = 0, above = 0;
    for (const Float3& p : part.solid->positions) {
      const double radius = std::hypot(p[0], p[1]);
      if (p[2] == 0) onBed = std::max(onBed, radius);
      if (p[2] > 1) above = std::max(above, radius);
    }
    QVERIFY2(std::abs(above - onBed - 0.4) < 0.1, part.name.c_str());
  }
}

void TestPrintKit::everyPartComesInOnAFreeWay() {
  QFETCH(QString, name);
  const PrintKit& kit = kitExample(name.toStdString()).kit;
  std::set<std::size_t> seen;
  for (const KitStep& step : kit.steps) {
    QVERIFY(step.isFree);
    for (const std::size_t part : step.parts) QVERIFY(seen.insert(part).second);
  }
  QCOMPARE(seen.size(), kit.parts.size());
  QVERIFY(kit.parts[kit.steps.front().parts.front()].kind == KitPartKind::base);
}

void TestPrintKit::partsThatAreTooLargeAreRejected() {
  KitOptions options;
  options.bedX = 100;
  options.bedY = 100;
  const auto made = kitOf(snapshotOf(example("three-planets")), options);
  const auto* why = std::get_if<KitFailure>(&made);
  QVERIFY(why != nullptr && why->kind == KitFailure::Kind::bed);
  options.scale = 0.55;
  const auto smaller = kitOf(snapshotOf(example("three-planets")), options);
  if (const auto* still = std::get_if<KitFailure>(&smaller)) QVERIFY(still->kind != KitFailure::Kind::bed);
}

void TestPrintKit::trainsWithoutPrintableFormAreRejected() {
  const auto made = kitOf(snapshotOf(example("simpson")));
  const auto* why = std::get_if<KitFailure>(&made);
  QVERIFY(why != nullptr && why->kind == KitFailure::Kind::layout && !why->message.empty());
}

void TestPrintKit::wrongOptionsAreRejected() {
  const Exporter* const kit = exporterWithId("kit");
  QVERIFY(kit != nullptr);
  const QTemporaryDir folder;
  const auto errorWith = [&](const std::string& option, const std::string& value, const std::string& path) {
    ExportSource source;
    source.read = [] { return std::variant<Mechanism, ExportError>(example("spur-pair")); };
    ExportContext context(std::move(source));
    OptionValues given;
    given.options[option] = {value};
    const ExportResult result = kit->write(context, given, {path}, {});
    const auto* error = std::get_if<ExportError>(&result);
    return error == nullptr ? std::optional<ExportError>() : *error;
  };
  const std::string out = folder.filePath("kit").toStdString();
  for (const auto& [option, value] : std::vector<std::pair<std::string, std::string>>{{"--bed", "220by220"},
                                                                                      {"--bed", "10x10"},
                                                                                      {"--bed", "x"},
                                                                                      {"--play", "-0.1"},
                                                                                      {"--play", "2"},
                                                                                      {"--clearance", "3"},
                                                                                      {"--chamfer", "2"},
                                                                                      {"--scale", "0"}}) {
    const auto error = errorWith(option, value, out);
    QVERIFY2(error && error->kind == ExportError::Kind::usage, (option + ' ' + value).c_str());
    QVERIFY(!std::filesystem::exists(out));
  }
  QVERIFY(errorWith("--play", "0.2", "-")->kind == ExportError::Kind::usage);
  const auto tooLarge = errorWith("--bed", "60x60", out);
  QVERIFY(tooLarge && tooLarge->kind == ExportError::Kind::limit && tooLarge->code == "bed");
}

void TestPrintKit::theFolderHasPlatesAssemblyAndPage() {
  const auto& [snapshot, kit] = kitExample("bevel-differential");
  const auto grey = [](int) { return Float3{0.5F, 0.5F, 0.5F}; };
  const auto made = kitFiles(kit, *snapshot->mechanism, *snapshot->geometry->train(), grey);
  const auto& files = std::get<0>(made);
  QCOMPARE(files.size(), kit.plates.size() + 2);
  QCOMPARE(files.front().first, std::string("plate-1.3mf"));
  QCOMPARE(files[kit.plates.size()].first, std::string("assembly.3mf"));
  const std::string& page = files.back().second;
  for (const KitPart& part : kit.parts)
    QVERIFY2(page.find(part.name) != std::string::npos, part.name.c_str());
  QVERIFY(page.find("http://") == std::string::npos && page.find("https://") == std::string::npos);
  QVERIFY(page.find("<svg") != std::string::npos);
}

void TestPrintKit::aStopEndsIt() {
  std::stop_source source;
  source.request_stop();
  const auto made = kitOf(snapshotOf(example("robot")), {}, source.get_token());
  const auto* why = std::get_if<KitFailure>(&made);
  QVERIFY(why != nullptr && why->kind == KitFailure::Kind::stopped);
}

QTEST_APPLESS_MAIN(TestPrintKit)
#include "test_print_kit.moc"
