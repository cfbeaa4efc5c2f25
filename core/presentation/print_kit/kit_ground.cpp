// The ground: a base with its bearings, bridges on posts over what moves, and rings of the ground.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/foundations/base/translation.h"
#include "core/machine/solids/gear_body.h"
#include "core/machine/solids/part_solids.h"
#include "core/machine/teeth/wheel_kind.h"
#include "core/presentation/print_kit/kit_builder.h"

namespace geargraph {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using std::numbers::pi;

constexpr double kFloor = 2;       // mm below the end of a shaft in the base
constexpr double kShaftEnd = 0.3;  // mm between them
constexpr double kPostGap = 1.5;   // mm between a post and what goes round beside it
constexpr double kPostSeat = kPostRadius + 1.8;

/// The frame of the base: z is `up`.
struct GroundFrame {
  Isometry3d toBase;

  [[nodiscard]] double height(const Vector3d& p) const { return (toBase * p).z(); }
  [[nodiscard]] Vector2d place(const Vector3d& p) const { return (toBase * p).head<2>(); }
};

struct GroundBearing {
  AxisGroupOrdinal axisGroup = 0;
  double low = 0;  ///< heights
  double high = 0;
};

/// A range of heights that something occupies.
struct HeightRange {
  double low = 0;
  double high = 0;
};

/// How far what turns about an axis of the ground comes from it, in any pose, and where.
struct Sweep {
  Vector2d centre;
  double radius = 0;
  double low = 0;
  double high = 0;
};

class GroundMaker {
 public:
  GroundMaker(KitBuilder& kit, const Placement& placement) : m_kit(kit), m_placement(placement) {
    m_frame.toBase = frameAlong(Vector3d::Zero(), kit.up).inverse();
  }

  std::optional<KitFailure> make() {
    for (const AxisGroupOrdinal c : m_kit.plan.axes.ordinals()) {
      const AxisLayout& axis = m_kit.plan.axes[c];
      for (const Bearing& bearing : axis.bearings) {
        if (bearing.parent != 0) continue;
        if (axis.direction.cross(m_kit.up).norm() > 1e-6)
          return layoutFailure(translated("Axes of the ground have several directions; a base holds one."));
        const double at = m_frame.height(axis.at(bearing.at));
        m_bearings.push_back({c, at - axis.width() / 2, at + axis.width() / 2});
      }
    }
    std::sort(m_bearings.begin(), m_bearings.end(),
              [](const GroundBearing& a, const GroundBearing& b) { return a.low < b.low; });
    for (const KitPart& part : m_kit.parts) m_occupied.push_back(rangeOf(part));
    findSweeps();
    std::size_t next = 0;
    m_base = cluster(next);
    m_baseTop = m_base.back().high;
    m_baseBottom = m_base.front().low;
    for (const GroundBearing& bearing : m_base) m_baseTop = std::max(m_baseTop, bearing.high);
    std::vector<std::vector<GroundBearing>> upper;
    while (next < m_bearings.size()) upper.push_back(cluster(next));
    if (auto failure = addRings()) return failure;
    for (const std::vector<GroundBearing>& bearings : upper) {
      if (auto failure = addBridge(bearings)) return failure;
    }
    return addBase();
  }

 private:
  [[nodiscard]] HeightRange rangeOf(const KitPart& part) const {
    HeightRange range{1e300, -1e300};
    for (const Float3& p : part.solid->positions) {
      const double h = m_frame.height(part.pose * Vector3d(p[0], p[1], p[2]));
      range.low = std::min(range.low, h);
      range.high = std::max(range.high, h);
    }
    return range;
  }

  /// The next bearings with nothing but shafts between them.
  std::vector<GroundBearing> cluster(std::size_t& next) const {
    std::vector<GroundBearing> found{m_bearings[next++]};
    double low = found.front().low, high = found.front().high;
    while (next < m_bearings.size()) {
      const double end = std::max(high, m_bearings[next].high);
      const bool isFree = std::none_of(m_occupied.begin(), m_occupied.end(), [&](const HeightRange& range) {
        return range.high > low + 0.01 && range.low < end - 0.01;
      });
      if (!isFree) break;
      high = end;
      found.push_back(m_bearings[next++]);
    }
    return found;
  }

  /// How far a point of a link comes from a line of the ground in any pose: what turns about an axis stays on
  /// a circle about it, whose middle turns with the link that carries the axis.
  [[nodiscard]] double reachOf(LinkOrdinal link, Vector3d point, const AxisLayout& ground) const {
    double around = 0;
    const JointTree& tree = *m_placement.tree;
    for (LinkOrdinal at = link; at != 0;) {
      const LinkOrdinal parent = tree.parent[at];
      if (parent == 0) break;
      const AxisGroupOrdinal c = m_placement.classes->classOf[tree.joint[at]];
      const AxisLayout& axis = m_kit.plan.axes[c];
      const Vector3d middle = axis.at(axis.coordinate(point));
      around += (point - middle).norm();
      point = middle;
      at = parent;
    }
    return (point - ground.at(ground.coordinate(point))).norm() + around;
  }

  /// The axis of the ground that the link's chain ends at.
  [[nodiscard]] AxisGroupOrdinal rootOf(LinkOrdinal link) const {
    const JointTree& tree = *m_placement.tree;
    while (tree.parent[link] != 0) link = tree.parent[link];
    return m_placement.classes->classOf[tree.joint[link]];
  }

  void findSweeps() {
    for (const KitPart& part : m_kit.parts) {
      if (part.link == 0) continue;
      const AxisLayout& axis = m_kit.plan.axes[rootOf(part.link)];
      const HeightRange range = rangeOf(part);
      Sweep sweep{m_frame.place(axis.point), 0, range.low, range.high};
      for (const Float3& p : part.solid->positions) {
        sweep.radius =
            std::max(sweep.radius, reachOf(part.link, part.pose * Vector3d(p[0], p[1], p[2]), axis));
      }
      const AxisGroupOrdinal own = m_placement.classes->classOf[m_placement.tree->joint[part.link]];
      if (m_kit.plan.axes[own].direction.cross(m_kit.up).norm() > 1e-6) {  // it turns up and down
        sweep.low = std::min(sweep.low, range.low - (range.high - range.low));
        sweep.high = std::max(sweep.high, range.high + (range.high - range.low));
      }
      m_sweeps.push_back(sweep);
    }
  }

  /// Is a disc free of all that turns between two heights, and of the ground's rings?
  [[nodiscard]] bool isFree(const Vector2d& at, double radius, double low, double high, bool isOnRing) const {
    const bool clear = std::all_of(m_sweeps.begin(), m_sweeps.end(), [&](const Sweep& sweep) {
      return sweep.high < low + 0.1 || sweep.low > high - 0.1 ||
             (at - sweep.centre).norm() > sweep.radius + radius + kPostGap;
    });
    if (!clear) return false;
    return isOnRing || std::all_of(m_rings.begin(), m_rings.end(), [&](const GroundRing& ring) {
             return ring.low > high || (at - ring.centre).norm() > ring.outer + radius + 0.5;
           });
  }

  struct GroundRing {
    Vector2d centre;
    double low = 0, high = 0;
    double outer = 0, screws = 0;  ///< radii
    double turn = 0;               ///< direction of its first hole, in the base frame
    double sense = 1;              ///< of its holes about `up`
  };

  std::optional<KitFailure> addRings() {
    for (const TrainGear& gear : m_kit.train.gears) {
      if (gear.link != 0) continue;
      if (!isRing(gear.spec)) {
        return layoutFailure(
            translated("The wheel %1 is fixed to the ground, for which the kit has no part.", {gear.name}));
      }
      const Vector3d k = gear.pose.linear().col(2);
      if (k.cross(m_kit.up).norm() > 1e-6)
        return layoutFailure(translated("Axes of the ground have several directions; a base holds one."));
      const double middle = m_frame.height(gear.pose.translation());
      GroundRing ring;
      ring.centre = m_frame.place(gear.pose.translation());
      ring.low = middle - gear.spec.faceWidth / 2;
      ring.high = middle + gear.spec.faceWidth / 2;
      ring.outer = rimDiameter(gear.spec) / 2;
      ring.screws = nominalRootRadius(gear.spec) + kScrewRim / 2;
      const double length = ring.low - m_baseTop - 2 * kFlush;
      if (length < 3) return layoutFailure(translated("The ring %1 is too near to the base.", {gear.name}));
      // Its holes are in the print frame, whose z is up.
      const Vector3d x = m_frame.toBase.linear() * gear.pose.linear().col(0);
      ring.turn = std::atan2(x.y(), x.x()) + pi / 8;
      for (int i = 0; i < 8; i += 2) {
        const double angle = ring.turn + pi / 4 * i;
        const Vector2d at = ring.centre + ring.screws * Vector2d(std::cos(angle), std::sin(angle));
        addPost(at, m_baseTop + kFlush, length);
        m_kit.addScrew(gear.spec.faceWidth);
        m_basePosts.push_back(at);
      }
      m_rings.push_back(ring);
    }
    return std::nullopt;
  }

  void addPost(const Vector2d& at, double low, double length) {
    Isometry3d pose = m_frame.toBase.inverse();
    pose.translate(Vector3d(at.x(), at.y(), low));
    KitPart& part =
        m_kit.add(KitPartKind::post, 0, "post", postSolid(kPostRadius, length, m_kit.options.chamfer), pose);
    part.diameter = 2 * kPostRadius;
    part.length = length;
  }

  /// The nearest free place for a post from a point in a direction.
  [[nodiscard]] std::optional<Vector2d> postPlace(const Vector2d& from, double angle, double low,
                                                  double high) const {
    const Vector2d way(std::cos(angle), std::sin(angle));
    for (double radius = 2 * kPostRadius + 6; radius < 400; radius += 1) {
      const Vector2d at = from + radius * way;
      if (isFree(at, kPostRadius, low, high, false)) return at;
    }
    return std::nullopt;
  }

  /// Two posts across from each other, as near as they may be. On a ring of the ground: in its holes.
  std::optional<KitFailure> addBridge(const std::vector<GroundBearing>& bearings) {
    double low = 1e300, high = -1e300;
    Vector2d middle(0, 0);
    for (const GroundBearing& bearing : bearings) {
      low = std::min(low, bearing.low);
      high = std::max(high, bearing.high);
      middle +=
          m_frame.place(m_kit.plan.axes[bearing.axisGroup].point) / static_cast<double>(bearings.size());
    }
    std::vector<Vector2d> posts;
    double foot = m_baseTop;
    for (const GroundRing& ring : m_rings) {
      if (ring.high > low - 3 || (ring.centre - middle).norm() > ring.screws) continue;
      std::vector<Vector2d> places;
      for (int i = 1; i < 8; i += 2) {
        const double angle = ring.turn + pi / 4 * i;
        const Vector2d at = ring.centre + ring.screws * Vector2d(std::cos(angle), std::sin(angle));
        if (isFree(at, kPostRadius, ring.high, high, true) && !isTaken(at)) places.push_back(at);
      }
      if (places.size() < 2) continue;
      const Vector2d first = places.front();
      const auto last = std::max_element(
          places.begin(), places.end(),
          [&](const Vector2d& a, const Vector2d& b) { return (a - first).norm() < (b - first).norm(); });
      posts = {first, *last};
      foot = ring.high;
      break;
    }
    if (posts.empty()) {
      double best = 1e300;
      for (int i = 0; i < 24; ++i) {
        const double angle = pi * i / 24;
        const auto a = postPlace(middle, angle, m_baseTop, high),
                   b = postPlace(middle, angle + pi, m_baseTop, high);
        if (!a || !b || isTaken(*a) || isTaken(*b)) continue;
        const double span = (*a - *b).norm();
        if (span >= best - 0.5) continue;
        best = span;
        posts = {*a, *b};
      }
      for (const Vector2d& at : posts) m_basePosts.push_back(at);
    }
    if (posts.empty()) return layoutFailure(translated("There is no room for posts beside what turns."));
    for (const Vector2d& at : posts) {
      addPost(at, foot + kFlush, low - foot - 2 * kFlush);
      m_taken.push_back(at);
      m_kit.addScrew(high - low);  // from above
      if (foot > m_baseTop) m_kit.addScrew(m_rings.front().high - m_rings.front().low);
    }
    addPlate(bearings, posts, low, high);
    return std::nullopt;
  }

  [[nodiscard]] bool isTaken(const Vector2d& at) const {
    return std::any_of(m_taken.begin(), m_taken.end(),
                       [&](const Vector2d& other) { return (other - at).norm() < 2 * kPostSeat; });
  }

  /// The hole around the shafts of moving links on an axis between two heights: as wide everywhere as the
  /// widest shaft there. `floor`: below the lowest end, if that is above `low`.
  [[nodiscard]] std::vector<Rim> shaftHole(AxisGroupOrdinal axisGroup, double low, double high,
                                           std::optional<double>& floor) const {
    const AxisLayout& axis = m_kit.plan.axes[axisGroup];
    struct Piece {
      double low, high, radius;
    };
    std::vector<Piece> pieces;
    std::vector<double> heights{low, high};
    double lowest = high;
    for (const std::size_t s : m_kit.plan.shaftsOn[axisGroup]) {
      const ShaftSegment& shaft = m_kit.plan.shafts[s];
      if (shaft.link == 0) continue;
      const auto [from, to] =
          std::minmax({m_frame.height(axis.at(shaft.low)), m_frame.height(axis.at(shaft.high))});
      if (to < low || from > high) continue;
      pieces.push_back({from - kShaftEnd, to + kShaftEnd, shaft.outer + m_kit.options.bore / 2});
      lowest = std::min(lowest, from - kShaftEnd);
      for (const double h : {from - kShaftEnd, to + kShaftEnd}) {
        if (h > low + 1e-6 && h < high - 1e-6) heights.push_back(h);
      }
    }
    if (pieces.empty()) return {};
    if (lowest > low + 0.5) floor = lowest;
    std::sort(heights.begin(), heights.end());
    const Vector2d centre = m_frame.place(axis.point);
    double widest = 0;
    for (const Piece& piece : pieces) widest = std::max(widest, piece.radius);
    const int points = static_cast<int>(circleOutline({0, 0}, widest).size());
    std::vector<Rim> rims;
    for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
      const double middle = (heights[i] + heights[i + 1]) / 2;
      if (heights[i + 1] - heights[i] < 1e-6 || (floor && middle < *floor)) continue;
      double radius = 0;
      for (const Piece& piece : pieces) {
        if (piece.low < middle && middle < piece.high) radius = std::max(radius, piece.radius);
      }
      if (radius == 0) radius = rims.empty() ? widest : (rims.back().outline.front() - centre).norm();
      const KitOutline round = reversed(circleOutline(centre, radius, points));
      if (!rims.empty() && std::abs((rims.back().outline.front() - centre).norm() - radius) < 1e-9) {
        rims.back().height = heights[i + 1];
        continue;
      }
      rims.push_back({heights[i], round});
      rims.push_back({heights[i + 1], round});
    }
    return rims;
  }

  void note(const GroundBearing& bearing, double low, double high, bool isClosed) {
    const AxisLayout& axis = m_kit.plan.axes[bearing.axisGroup];
    const double middle = (bearing.low + bearing.high) / 2;
    const Vector3d onAxis = axis.point + (middle - m_frame.height(axis.point)) * m_kit.up;
    const ShaftSegment* const shaft = m_kit.passing(bearing.axisGroup, 0, axis.coordinate(onAxis));
    if (shaft == nullptr) return;
    const Vector3d ends[] = {onAxis + (low - middle) * m_kit.up, onAxis + (high - middle) * m_kit.up};
    const auto [from, to] = std::minmax({axis.coordinate(ends[0]), axis.coordinate(ends[1])});
    for (const std::size_t s : m_kit.plan.shaftsOn[bearing.axisGroup]) {
      const ShaftSegment& each = m_kit.plan.shafts[s];
      if (each.link != 0 && each.low < to && each.high > from)
        m_kit.items.push_back({bearing.axisGroup, each.link, from, to, true, isClosed});
    }
  }

  [[nodiscard]] double bossAt(const GroundBearing& bearing) const {
    double radius = 0;
    const AxisLayout& axis = m_kit.plan.axes[bearing.axisGroup];
    for (const std::size_t s : m_kit.plan.shaftsOn[bearing.axisGroup]) {
      if (m_kit.plan.shafts[s].link != 0) radius = std::max(radius, m_kit.plan.shafts[s].outer);
    }
    return radius + m_kit.options.bore / 2 + std::max(kLeastWall, axis.module) + 1;
  }

  /// A bridge: printed as it lies, screwed down onto its posts.
  void addPlate(const std::vector<GroundBearing>& bearings, const std::vector<Vector2d>& posts, double low,
                double high) {
    std::vector<KitDisc> discs;
    PlateShape shape;
    for (const GroundBearing& bearing : bearings) {
      discs.push_back({m_frame.place(m_kit.plan.axes[bearing.axisGroup].point), bossAt(bearing)});
      note(bearing, low, high, false);
    }
    for (const Vector2d& at : posts) {
      discs.push_back({at, kPostSeat});
      shape.holes.push_back(screwHole(at, 0, high - low, true));
    }
    addBores(shape, bearings, low, high);
    shape.outer = chamferedWall(hullOutline(discs), 0, high - low, m_kit.options.chamfer);
    Isometry3d pose = m_frame.toBase.inverse();
    pose.translate(Vector3d(0, 0, low));
    const std::string number = m_kit.engrave(shape, 0);
    m_kit.add(KitPartKind::bridge, 0, "bridge", plateSolid(shape), pose).number = number;
  }

  /// The bores of bearings, one for each axis; heights from `low`.
  bool addBores(PlateShape& shape, const std::vector<GroundBearing>& bearings, double low,
                double high) const {
    bool isClosed = false;
    std::vector<int> done;
    for (const GroundBearing& bearing : bearings) {
      if (std::find(done.begin(), done.end(), int{bearing.axisGroup}) != done.end()) continue;
      done.push_back(bearing.axisGroup);
      std::optional<double> floor;
      std::vector<Rim> hole = shaftHole(bearing.axisGroup, low, high, floor);
      if (hole.empty()) continue;
      for (Rim& rim : hole) rim.height -= low;
      isClosed = isClosed || floor.has_value();
      (floor ? shape.wells : shape.holes).push_back(std::move(hole));
    }
    return isClosed;
  }

  std::optional<KitFailure> addBase() {
    double bottom = m_baseBottom;
    for (const GroundBearing& bearing : m_base) {
      const AxisLayout& axis = m_kit.plan.axes[bearing.axisGroup];
      for (const std::size_t s : m_kit.plan.shaftsOn[bearing.axisGroup]) {
        const ShaftSegment& shaft = m_kit.plan.shafts[s];
        if (shaft.link == 0) continue;
        const double end = std::min(m_frame.height(axis.at(shaft.low)), m_frame.height(axis.at(shaft.high)));
        if (end < m_baseTop) bottom = std::min(bottom, end - kShaftEnd - kFloor);
      }
    }
    for (const HeightRange& range : m_occupied) {
      if (range.low < bottom)
        return layoutFailure(
            translated("Parts reach below the lowest bearing of the ground, so that no base fits "
                       "there; move that joint along its axis."));
    }
    std::vector<KitDisc> discs;
    PlateShape shape;
    for (const GroundBearing& bearing : m_base) {
      const Vector2d centre = m_frame.place(m_kit.plan.axes[bearing.axisGroup].point);
      double sweep = 0;
      for (const Sweep& each : m_sweeps) {
        if ((each.centre - centre).norm() < 1e-6) sweep = std::max(sweep, each.radius);
      }
      discs.push_back({centre, std::max(bossAt(bearing), 0.6 * std::min(sweep, 60.0))});
      note(bearing, bearing.low, bearing.high, true);
    }
    for (const Vector2d& at : m_basePosts) {
      discs.push_back({at, kPostSeat});
      shape.holes.push_back(screwHole(at, 0, m_baseTop - bottom, false));
      m_kit.addScrew(m_baseTop - bottom);
    }
    addBores(shape, m_base, bottom, m_baseTop);
    shape.outer = chamferedWall(hullOutline(discs), 0, m_baseTop - bottom, m_kit.options.chamfer);
    Isometry3d pose = m_frame.toBase.inverse();
    pose.translate(Vector3d(0, 0, bottom));
    const std::string number = m_kit.engrave(shape, 0);
    KitPart& part = m_kit.add(KitPartKind::base, 0, "base", plateSolid(shape), pose);
    part.number = number;
    std::rotate(m_kit.parts.begin(), m_kit.parts.end() - 1, m_kit.parts.end());  // the first of all
    return std::nullopt;
  }

  KitBuilder& m_kit;
  const Placement& m_placement;
  GroundFrame m_frame;
  std::vector<GroundBearing> m_bearings;
  std::vector<GroundBearing> m_base;
  std::vector<HeightRange> m_occupied;
  std::vector<Sweep> m_sweeps;
  std::vector<GroundRing> m_rings;
  std::vector<Vector2d> m_basePosts;
  std::vector<Vector2d> m_taken;
  double m_baseTop = 0;
  double m_baseBottom = 0;
};

}  // namespace

std::optional<KitFailure> addGround(KitBuilder& kit, const Placement& placement) {
  return GroundMaker(kit, placement).make();
}

}  // namespace geargraph
