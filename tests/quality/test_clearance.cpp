#include <QTest>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <random>
#include <set>

#include "core/design/synthesis/bevel_sets.h"
#include "core/machine/body_layout/complete_train.h"
#include "core/machine/solids/gear_solid.h"
#include "core/mechanism/graph/digraph.h"
#include "core/theory/pose/forward_kinematics.h"
#include "core/theory/pose/turning_lines.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/train_sketch.h"
#include "tests/quality/rolling_rates.h"

using namespace geargraph;
using Eigen::Vector3d;

namespace {

constexpr double kPlay = 0.15;  // modules: chords of coarse solids may cut in a little

Mechanism example(const QString& name) {
  return test::example(name.toStdString());
}

/// A part in its own frame, with the triangles under each cell of a grid across z.
class Part {
  static Vector3d wide(const Float3& p) { return Eigen::Map<const Eigen::Vector3f>(p.data()).cast<double>(); }

 public:
  Part(int link, Solid solid, Eigen::Isometry3d pose)
      : m_link(link), m_solid(std::move(solid)), m_pose(pose) {
    m_box = boundsOf(m_solid);
    for (std::size_t t = 0; t < m_solid.triangles.size(); ++t) {
      Eigen::AlignedBox2d flat;
      for (const std::uint32_t v : m_solid.triangles[t]) flat.extend(point(v).head<2>());
      for (int x = cell(flat.min().x(), 0); x <= cell(flat.max().x(), 0); ++x) {
        for (int y = cell(flat.min().y(), 1); y <= cell(flat.max().y(), 1); ++y) m_cells[x][y].push_back(t);
      }
    }
  }

  /// Points of the surface: its edges, cut into pieces of at most `step`.
  void sample(double step) {
    std::set<std::array<Float3, 2>> seen;
    for (const Triangle& t : m_solid.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        Float3 from = m_solid.positions[t[k]], to = m_solid.positions[t[(k + 1) % 3]];
        if (to < from) std::swap(from, to);
        if (!seen.insert({from, to}).second) continue;
        const Vector3d a = wide(from), b = wide(to);
        const int pieces = std::max(1, static_cast<int>(std::ceil((b - a).norm() / step)));
        for (int i = 0; i < pieces; ++i) m_samples.emplace_back(a + (b - a) * i / pieces);
      }
    }
  }

  /// Turns of the surface about the point, from the crossings of the ray along z: above 0 is inside.
  [[nodiscard]] bool contains(Vector3d p) const {
    p += 1e-4 * Vector3d(0.8134, 0.4127, 0);  // off the axes, where a ray would run along edges
    if (!m_box.contains(p)) return false;
    int turns = 0;
    for (const std::size_t t : m_cells[cell(p.x(), 0)][cell(p.y(), 1)]) {
      const Triangle& tri = m_solid.triangles[t];
      const Vector3d a = point(tri[0]) - p, b = point(tri[1]) - p, c = point(tri[2]) - p;
      const auto side = [](const Vector3d& u, const Vector3d& v) { return u.x() * v.y() - u.y() * v.x(); };
      const double ab = side(a, b), bc = side(b, c), ca = side(c, a);
      if (!((ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0)) || ab + bc + ca == 0)
        continue;
      const double height = (a.z() * bc + b.z() * ca + c.z() * ab) / (ab + bc + ca);
      if (height > 0) turns += ab + bc + ca > 0 ? 1 : -1;
    }
    return turns > 0;
  }

  [[nodiscard]] Vector3d point(std::size_t v) const { return wide(m_solid.positions[v]); }
  [[nodiscard]] const std::vector<Vector3d>& samples() const { return m_samples; }
  [[nodiscard]] const Eigen::AlignedBox3d& box() const { return m_box; }
  [[nodiscard]] int link() const { return m_link; }
  [[nodiscard]] const Eigen::Isometry3d& pose() const { return m_pose; }

 private:
  static constexpr int kCells = 64;
  [[nodiscard]] int cell(double x, int axis) const {
    const double part = (x - m_box.min()[axis]) / std::max(m_box.sizes()[axis], 1e-12);
    return std::clamp(static_cast<int>(part * kCells), 0, kCells - 1);
  }
  int m_link;
  Solid m_solid;
  Eigen::Isometry3d m_pose;
  Eigen::AlignedBox3d m_box;
  std::vector<Vector3d> m_samples;
  std::vector<std::size_t> m_cells[kCells][kCells];
};

/// Is some point of `a`'s surface inside `b`, deeper than the play? All six directions around it must be
/// inside, too.
bool cuts(const Part& a, const Part& b, const Eigen::Isometry3d& step, double play) {
  const Eigen::AlignedBox3d seen = Eigen::AlignedBox3d(a.box()).transformed(step);
  if (!seen.intersects(b.box())) return false;
  return std::any_of(a.samples().begin(), a.samples().end(), [&](const Vector3d& sample) {
    const Vector3d p = step * sample;
    if (!b.box().contains(p) || !b.contains(p)) return false;
    for (int axis = 0; axis < 3; ++axis) {
      for (const double side : {-play, play}) {
        Vector3d q = p;
        q[axis] += side;
        if (!b.contains(q)) return false;
      }
    }
    return true;
  });
}

std::vector<std::unique_ptr<Part>> partsOf(const GearTrain& train) {
  std::vector<std::unique_ptr<Part>> parts;
  for (const TrainGear& gear : train.gears) {
    parts.push_back(std::make_unique<Part>(gear.link, *gearSolid(gear.spec, kFarTolerance), gear.pose));
  }
  for (const LinkBody& body : train.bodies) {
    parts.push_back(std::make_unique<Part>(body.link, body.solid(), Eigen::Isometry3d::Identity()));
  }
  for (const auto& part : parts) part->sample(train.gears.front().spec.module);
  return parts;
}

/// What cuts into what, in `frames` poses of a motion that turns every joint it can.
QStringList cutsOf(const Mechanism& mechanism, int frames) {
  const Placement placement = placementOf(mechanism);
  const GearTrain train = trainOf(mechanism, placement);
  if (train.gears.empty()) return {"it has no gears: nothing could be checked"};
  const Eigen::VectorXd rates = test::rollingRates(mechanism, placement, train, {1, 0.3, -0.4, 0.7, 0.2});
  const Digraph graph(mechanism);
  const ForwardKinematics kinematics(*SpanningTree::of(graph), turningLines(placement));
  const auto parts = partsOf(train);
  const auto what = [&](std::size_t p) {
    return p < train.gears.size() ? QString::fromStdString("gear " + train.gears[p].name)
                                  : QString("body of %1").arg(parts[p]->link());
  };
  std::set<std::pair<std::size_t, std::size_t>> meshing;  // those are measured by test_teeth_mesh
  for (const TrainMesh& mesh : train.meshes) {
    const auto a = static_cast<std::size_t>(mesh.tailGear), b = static_cast<std::size_t>(mesh.headGear);
    meshing.insert({{a, b}, {b, a}});
  }
  QStringList found;
  for (int frame = 0; frame < frames; ++frame) {
    const Eigen::VectorXd angles = rates * (1.37 * frame);
    const auto poses = kinematics.poses({angles.data(), static_cast<std::size_t>(angles.size())});
    for (std::size_t i = 0; i < parts.size(); ++i) {
      for (std::size_t k = 0; k < parts.size(); ++k) {
        const Part& a = *parts[i];
        const Part& b = *parts[k];
        if (a.link() == b.link()) continue;
        const QString line = QString("%1 in %2").arg(what(i), what(k));
        if (found.contains(line) || meshing.contains({i, k})) continue;
        const Eigen::Isometry3d step = (poses[static_cast<std::size_t>(b.link())] * b.pose()).inverse() *
                                       poses[static_cast<std::size_t>(a.link())] * a.pose();
        if (cuts(a, b, step, kPlay * train.gears.front().spec.module)) found << line;
      }
    }
  }
  return found;
}

/// Two or three planetary sets on one axis whose members are linked at random, one perhaps held; places open.
Mechanism linkedSets(unsigned seed) {
  std::mt19937 random(seed);
  const auto below = [&](unsigned n) { return static_cast<int>(random() % n); };
  const int sets = 2 + below(2);
  std::vector<int> member(static_cast<std::size_t>(3 * sets));  // sun, ring and carrier of each set: its link
  for (std::size_t m = 0; m < member.size(); ++m) member[m] = static_cast<int>(m);
  const auto joined = [&](int a, int b) {
    for (int& m : member) m = m == b ? a : m;
  };
  for (int links = sets - 1 + below(2); links > 0; --links) {
    const int a = below(static_cast<unsigned>(3 * sets)), b = below(static_cast<unsigned>(3 * sets));
    const auto meet = [&](int x, int y) {  // two members of one set on one link would lock it
      for (int s = 0; s < sets; ++s) {
        int count = 0;
        for (int k = 0; k < 3; ++k) {
          const int m = member[static_cast<std::size_t>(3 * s + k)];
          count += m == x || m == y ? 1 : 0;
        }
        if (count > 1) return true;
      }
      return false;
    };
    const int x = member[static_cast<std::size_t>(a)], y = member[static_cast<std::size_t>(b)];
    if (x != y && !meet(x, y)) joined(x, y);
  }
  std::map<int, int> number;
  if (below(2) == 0) number[member[static_cast<std::size_t>(below(static_cast<unsigned>(3 * sets)))]] = 0;
  int links = 0;
  for (const int m : member) {
    if (!number.contains(m)) number[m] = ++links;
  }
  test::TrainSketch sketch(links + sets);
  for (int l = 1; l <= links; ++l) sketch.joint(0, l, "a");
  for (int s = 0; s < sets; ++s) {
    const auto link = [&](int k) { return number[member[static_cast<std::size_t>(3 * s + k)]]; };
    sketch.joint(link(2), links + 1 + s, "b" + std::to_string(s));
    const int sun = 21 + below(30), planet = 17 + below(14);
    sketch.mesh(link(0), links + 1 + s, sun, planet, MeshKind::external);
    sketch.mesh(links + 1 + s, link(1), planet, sun + 2 * planet, MeshKind::internal);
  }
  return sketch.build();
}

/// What students draw, with tooth counts at random: links, joints and meshes, no places.
class DrawnTrains {
 public:
  explicit DrawnTrains(unsigned seed) : m_random(seed) {}

  /// Two to six wheels on axes of the frame, each meshing with the next.
  Mechanism chain() {
    const int n = 2 + below(5);
    test::TrainSketch sketch(n);
    for (int l = 1; l <= n; ++l) sketch.joint(0, l, "a" + std::to_string(l));
    for (int l = 1; l < n; ++l) {
      const int a = teeth(), b = teeth(), kind = below(6);
      if (kind == 1 && l == n - 1) {
        sketch.mesh(l, l + 1, a, a + 20 + below(40), MeshKind::internal);
      } else {
        sketch.mesh(l, l + 1, a, b, kind == 0 ? MeshKind::bevel : MeshKind::external);
      }
    }
    return sketch.build();
  }

  /// Two stages between two shafts and back, and a third from there.
  Mechanism reverted(int form) {
    test::TrainSketch sketch(4);
    sketch.joint(0, 1, "a").joint(0, 2, "b").joint(0, 3, "a").joint(0, 4, form == 0 ? "b" : "c");
    const int a = teeth(), b = teeth(), c = (a + b) / 2 - 3;
    sketch.mesh(1, 2, a, b, MeshKind::external).mesh(2, 3, c, a + b - c, MeshKind::external);
    if (form == 0) {
      sketch.mesh(3, 4, a - 2, b + 2, MeshKind::external);
    } else {
      sketch.mesh(3, 4, teeth(), teeth(), form == 1 ? MeshKind::external : MeshKind::bevel);
    }
    return sketch.build();
  }

  /// A sun, planets of one wheel or two, and a ring or a second sun; perhaps a gear of the carrier or the
  /// other central wheel that drives a shaft beside.
  Mechanism epicyclic(int form) {
    const int planets = 1 + below(2), driven = below(3);
    test::TrainSketch sketch(3 + planets + (driven != 0 ? 1 : 0));
    sketch.joint(0, 1, "a").joint(0, 2, "a").joint(0, 3, "a");
    const int sun = teeth(), first = 17 + below(20), second = 17 + below(20);
    for (int p = 4; p < 4 + planets; ++p) {
      sketch.joint(3, p, "p" + std::to_string(p)).mesh(1, p, sun, first, MeshKind::external);
      if (form == 0) sketch.mesh(p, 2, first, sun + 2 * first, MeshKind::internal);
      if (form == 1) sketch.mesh(p, 2, second, sun + first + second, MeshKind::internal);
      if (form == 2) sketch.mesh(p, 2, second, std::max(17, sun + first - second), MeshKind::external);
    }
    if (driven != 0) {
      const MeshKind kind = below(2) == 0 ? MeshKind::bevel : MeshKind::external;
      sketch.joint(0, 4 + planets, "z").mesh(driven == 1 ? 3 : 2, 4 + planets, teeth(), teeth(), kind);
    }
    return sketch.build();
  }

 private:
  int below(unsigned n) { return static_cast<int>(m_random() % n); }
  int teeth() { return 17 + below(44); }

  std::mt19937 m_random;
};

/// The mechanism as a graph with tooth counts and kinds alone.
Mechanism bare(Mechanism mechanism) {
  for (Axis& axis : mechanism.axes) axis.point = axis.direction = std::nullopt;
  for (TurningJoint& joint : mechanism.turningJoints) joint.offset = Number(0);
  for (GearMesh& mesh : mechanism.gearMeshes) {
    mesh.pitchPoint.reset();
    mesh.faceWidth.reset();
    mesh.tailWheel.reset();  // who draws links and meshes only has named no wheel
    mesh.headWheel.reset();
  }
  return mechanism;
}

bool saysSo(const Mechanism& mechanism) {
  const Diagnostics found = trainDiagnostics(mechanism, placementOf(mechanism));
  return std::any_of(found.begin(), found.end(), [](const Diagnostic& d) {
    return d.detail == Detail::bodiesOverlap || d.detail == Detail::wheelsOverlap;
  });
}

/// A row for each example that has solids.
void exampleRows() {
  QTest::addColumn<QString>("name");
  for (const char* name : {"robot", "spur-pair", "three-planets", "planetary-ring-held",
                           "redundant-planetary", "bevel-differential", "bevel-wrist", "humpage-reduction",
                           "locked-train", "three-roll-wrist", "eight-speed-gearbox", "cannot-be-assembled",
                           "ravigneaux", "simpson", "ferguson-paradox", "reverted-train"}) {
    QTest::newRow(name) << QString(name);
  }
}

}  // namespace

class ClearanceTest : public QObject {
  Q_OBJECT
 private slots:
  /// Nothing of one link cuts into another, carriers moving.
  void linksPassEachOther_data() { exampleRows(); }
  void linksPassEachOther() {
    QFETCH(QString, name);
    const QStringList found = cutsOf(example(name), 4);
    QVERIFY2(found.empty(), qPrintable(found.join("; ")));
  }

  /// Linked sets placed by the program: all pass, and of none it says that it found no way.
  void linkedSetsPass() {
    QStringList cut, reported;
    for (unsigned seed = 1; seed <= 48; ++seed) {
      const Mechanism mechanism = linkedSets(seed);
      const QStringList found = cutsOf(mechanism, 2);
      const bool said = saysSo(mechanism);
      if (said) reported << QString::number(seed);
      if (!found.empty()) cut << QString("%1: %2").arg(seed).arg(found.join("; "));
    }
    QVERIFY2(cut.empty(), qPrintable(cut.join("\n")));
    QVERIFY2(reported.empty(), qPrintable(reported.join(", ")));
  }

  /// The examples drawn as bare graphs: the program places them so that wheels and bodies pass each other.
  void bareGraphsPass_data() { exampleRows(); }
  void bareGraphsPass() {
    QFETCH(QString, name);
    const Mechanism mechanism = bare(example(name));
    QVERIFY(!trainOf(mechanism, placementOf(mechanism)).gears.empty());
    QVERIFY(!saysSo(mechanism));
    const QStringList found = cutsOf(mechanism, 3);
    QVERIFY2(found.empty(), qPrintable(found.join("; ")));
  }

  /// Chains of wheels, stages between shafts and epicyclic trains as students draw them, without places:
  /// their bodies pass each other. Of the few that do not it is said.
  void drawnTrainsPass() {
    DrawnTrains drawn(5);
    QStringList silent, reported;
    const auto examine = [&](const QString& name, const Mechanism& train) {
      const Mechanism mechanism = bare(train);
      const QStringList found = cutsOf(mechanism, 2);
      if (found.empty()) return;
      (saysSo(mechanism) ? reported : silent) << name + ": " + found.join("; ");
    };
    for (int i = 0; i < 60; ++i) examine(QString("chain %1").arg(i), drawn.chain());
    for (int i = 0; i < 30; ++i) examine(QString("reverted %1").arg(i), drawn.reverted(i % 3));
    for (int i = 0; i < 90; ++i) examine(QString("epicyclic %1").arg(i), drawn.epicyclic(i % 3));
    QVERIFY2(silent.empty(), qPrintable(silent.join("\n")));
    QVERIFY2(reported.size() <= 4, qPrintable(reported.join("\n")));
  }

  /// Trains drawn at random, with meshes between any two links of neighbouring axes, several between the same
  /// two, and groups that nothing ties together: there is room for every wheel of each.
  void bareRandomTrainsHaveSpaceForEveryWheel() {
    std::size_t gears = 0;
    for (const auto& [links, meshes] : {std::pair{4, 3}, {6, 6}, {8, 6}, {12, 8}}) {
      for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        const Mechanism mechanism = bare(test::randomTrain(seed, links, meshes));
        const Placement placement = placementOf(mechanism);
        gears += trainOf(mechanism, placement).gears.size();
        for (const Diagnostic& d : trainDiagnostics(mechanism, placement))
          QVERIFY2(d.detail != Detail::wheelsOverlap,
                   qPrintable(QString("%1 links, %2: ").arg(links).arg(seed) + d.message.c_str()));
      }
    }
    QVERIFY2(gears > 1'000, qPrintable(QString::number(gears)));
  }

  /// Wrists of bevels as the set maker makes them, of many tooth counts, whose pairs lie one within the
  /// other: the tool's about the apex, the bend's round it, the roll's outside. The fork of some housings
  /// runs into what turns in it, and is reported.
  void wristsPassOrAreReported() {
    int alarms = 0;  // for nothing
    std::mt19937 random(7);
    const auto teeth = [&] { return 17 + static_cast<int>(random() % 20); };
    QStringList silent;
    for (int made = 0; made < 12;) {
      const WristTeeth wrist{teeth(), teeth() + 12, teeth(), teeth() + 12, teeth(), teeth()};
      const double bend = std::hypot(wrist.bendShaft, wrist.bend);
      if (std::hypot(wrist.rollShaft, wrist.idler) < bend + 6 ||
          std::hypot(wrist.idlerPinion, wrist.tool) > bend - 6)
        continue;
      ++made;
      const Mechanism mechanism = bevelWrist(wrist);
      const QStringList found = cutsOf(mechanism, 3);
      const bool said = saysSo(mechanism);
      alarms += said && found.empty() ? 1 : 0;
      if (found.empty() || said) continue;
      silent << QString("%1/%2 %3/%4 %5/%6: %7")
                    .arg(wrist.bendShaft)
                    .arg(wrist.bend)
                    .arg(wrist.rollShaft)
                    .arg(wrist.idler)
                    .arg(wrist.idlerPinion)
                    .arg(wrist.tool)
                    .arg(found.join("; "));
    }
    QVERIFY2(silent.empty(), qPrintable(silent.join("\n")));
    QVERIFY2(alarms == 0, qPrintable(QString::number(alarms)));
  }

  /// Planetaries placed by the program, of many tooth counts and numbers of planets.
  void planetariesPass() {
    int checked = 0;
    for (const auto& [sun, planet] : {std::pair{12, 18}, {24, 18}, {40, 16}, {18, 45}}) {
      for (int n = 1; n <= 4; ++n) {
        if ((sun + planet) * std::sin(std::numbers::pi / n) < planet + 2 && n > 1)
          continue;  // no room for so many
        ++checked;
        const QStringList found = cutsOf(test::planetary(sun, planet, n), 2);
        QVERIFY2(found.empty(),
                 qPrintable(QString("%1/%2 x %3: %4").arg(sun).arg(planet).arg(n).arg(found.join("; "))));
      }
    }
    QCOMPARE(checked, 15);
  }
};

QTEST_APPLESS_MAIN(ClearanceTest)
#include "test_clearance.moc"
