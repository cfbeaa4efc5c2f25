#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <set>

#include "core/machine/solids/gear_body.h"
#include "core/machine/teeth/wheel_kind.h"
#include "core/machine/train/stack_order.h"
#include "core/machine/train/wheel_envelopes.h"

namespace geargraph {
namespace {

using Eigen::Vector3d;

/// Room between stacked planes, in modules: for a carrier's arm, and where several sets are linked for the
/// discs that join them.
constexpr double kPlaneGap = 5;
constexpr double kLinkedGap = 12;
constexpr int kNearTries = 60;  // plane by plane, then in strides
constexpr int kMaxTries = 120;
constexpr double kStride = 1.0 / 12;  // of the way

/// Wheels that lie in one plane because they mesh.
struct Plane {
  std::vector<GearOrdinal> wheels;
  bool movable = true;
};

std::vector<Plane> planesOf(const TrainWheels& train) {
  ByGear<int> planeOf(train.wheels.size(), -1);
  std::vector<Plane> planes;
  const auto join = [&](int from, int to) {
    for (const GearOrdinal w : planes[static_cast<std::size_t>(from)].wheels) {
      planeOf[static_cast<std::size_t>(w)] = to;
      planes[static_cast<std::size_t>(to)].wheels.push_back(w);
    }
    planes[static_cast<std::size_t>(from)].wheels.clear();
  };
  for (const GearOrdinal w : train.wheels.ordinals()) {
    planeOf[w] = static_cast<int>(w);
    planes.push_back({{static_cast<int>(w)}, true});
  }
  for (const TrainPair& pair : train.pairs) {
    const int a = planeOf[static_cast<std::size_t>(pair.tail)];
    const int b = planeOf[static_cast<std::size_t>(pair.head)];
    if (pairKind(pair.kind).axes == LinePosition::parallel && a != b) join(std::max(a, b), std::min(a, b));
  }
  for (const TrainPair& pair : train.pairs) {
    if (!pair.movable)
      planes[static_cast<std::size_t>(planeOf[static_cast<std::size_t>(pair.tail)])].movable = false;
    if (!pair.movable)
      planes[static_cast<std::size_t>(planeOf[static_cast<std::size_t>(pair.head)])].movable = false;
  }
  std::erase_if(planes, [](const Plane& plane) { return plane.wheels.empty(); });
  return planes;
}

/// The middle of a wheel's teeth.
Vector3d middleOf(const TrainWheel& wheel) {
  const AxialSpan span = axialSpan(wheel.spec);
  return wheel.origin + (span.low + span.high) / 2 * wheel.axis;
}

/// The planes as numbers, without what meets, their heights counted from where they are drawn; none where
/// they are not parallel.
std::optional<StackPlanes> stackOf(const TrainWheels& train, const std::vector<Plane>& planes,
                                   const Placement& placement, const WheelEnvelopes& envelopes) {
  constexpr std::size_t kMaxPlanes = 40;
  if (planes.size() < 2 || planes.size() > kMaxPlanes || !planes.back().movable) return std::nullopt;
  const Vector3d axis = train.wheels[static_cast<std::size_t>(planes.back().wheels.front())].axis;
  const AxisGroups& classes = *placement.classes;
  StackPlanes stack;
  std::map<int, StackPlanes::Carrier> carriers;
  for (std::size_t p = 0; p < planes.size(); ++p) {
    double thickness = 0;
    for (const GearOrdinal w : planes[p].wheels) {
      const TrainWheel& wheel = train.wheels[static_cast<std::size_t>(w)];
      const bool isAcross = wheel.axis.cross(axis).norm() > 1e-9;
      if (isAcross && planes[p].movable) return std::nullopt;
      if (isAcross) continue;
      thickness = std::max(thickness, wheel.spec.faceWidth);
      stack.gap = std::max(stack.gap, kPlaneGap * toothSize(wheel.spec));
      stack.wheels.push_back({static_cast<int>(p), wheel.link, wheel.axisGroup, middleOf(wheel).dot(axis)});
      for (std::size_t c = 0; c < classes.classes.size(); ++c) {
        if (envelopes.covers(w, static_cast<int>(c)))
          stack.covers.push_back({static_cast<int>(p), static_cast<int>(c), middleOf(wheel).dot(axis)});
      }
      const LinkOrdinal rootLink = classes.classes[wheel.axisGroup].rootLink;
      const int home = classes.classOfLink(rootLink);
      if (home < 0) continue;
      StackPlanes::Carrier& carrier = carriers[rootLink];
      carrier.link = rootLink;
      carrier.axisGroup = home;
      carrier.planes.push_back(static_cast<int>(p));
    }
    stack.thickness.push_back(thickness);
  }
  for (auto& [link, carrier] : carriers) stack.carriers.push_back(std::move(carrier));
  return stack;
}

enum class Sides { both, thisOne, other };

struct Moves {
  std::vector<Vector3d> by;  ///< by plane
  bool isClear = true;       ///< every plane that can be moved has found a place
};

/// Plane by plane, in this order, to the nearest place where it is clear of those before it.
Moves nearestMoves(const TrainWheels& train, const std::vector<Plane>& planes,
                   const std::vector<std::size_t>& order, Sides sides, WheelEnvelopes envelopes, double gap,
                   const std::stop_token& stop) {
  std::vector<int> standing;
  std::vector<std::pair<int, int>> near;  // wheels of the plane, and those that stand where they may come to
  const auto blocked = [&] {
    return std::any_of(near.begin(), near.end(),
                       [&](const auto& pair) { return envelopes.collide(pair.first, pair.second); });
  };
  Moves moves{std::vector<Vector3d>(planes.size())};
  for (const std::size_t p : order) {
    if (stop.stop_requested()) return moves;
    const Plane& plane = planes[p];
    const Vector3d axis = train.wheels[static_cast<std::size_t>(plane.wheels.front())].axis;
    double side = 0;
    for (const GearOrdinal w : plane.wheels) side += envelopes.freeSide(w).dot(axis);
    const Vector3d direction = side < 0 ? Vector3d(-axis) : axis;
    double step = 0;
    for (const GearOrdinal w : plane.wheels) {
      const GearSpec& spec = train.wheels[static_cast<std::size_t>(w)].spec;
      step = std::max(step, spec.faceWidth + gap * toothSize(spec));
    }
    near.clear();
    for (const GearOrdinal w : plane.wheels) {
      for (std::size_t s = 0; plane.movable && s < standing.size(); ++s)
        if (envelopes.mayIntersect(w, standing[s])) near.emplace_back(w, standing[s]);
    }
    double at = 0, far = 0;
    for (int attempt = 1; attempt < kMaxTries && blocked(); ++attempt) {
      if (stop.stop_requested()) return moves;
      const bool isFirst = attempt % 2 == 1 || sides != Sides::both;
      if (isFirst) far += attempt < kNearTries ? step : std::max(step, kStride * far);
      const double goal = isFirst == (sides != Sides::other) ? far : -far;
      for (const GearOrdinal w : plane.wheels) envelopes.move(w, (goal - at) * direction);
      at = goal;
    }
    moves.by[p] = at * direction;
    moves.isClear = moves.isClear && !blocked();
    standing.insert(standing.end(), plane.wheels.begin(), plane.wheels.end());
  }
  return moves;
}

/// Where wheels of a train stand in one level, which of them meet there.
void addMeetings(StackPlanes& stack, const std::vector<Plane>& planes, const WheelEnvelopes& envelopes,
                 const std::stop_token& stop) {
  const auto meet = [&](const Plane& a, const Plane& b) {
    return std::any_of(a.wheels.begin(), a.wheels.end(), [&](GearOrdinal w) {
      return std::any_of(b.wheels.begin(), b.wheels.end(), [&](GearOrdinal other) {
        return !stop.stop_requested() && envelopes.collide(w, other);
      });
    });
  };
  for (const Plane& plane : planes) {
    std::vector<bool>& meets = stack.meets.emplace_back();
    for (const Plane& other : planes) meets.push_back(&plane != &other && meet(plane, other));
  }
}

/// Finds the moves of planes that enclose the fewest wheels of a link between another's.
class PlaneStacker {
 public:
  PlaneStacker(const TrainWheels& train, const std::vector<Plane>& planes, const Placement& placement,
               double gap, const std::stop_token& stop)
      : m_train(train),
        m_planes(planes),
        m_placement(placement),
        m_gap(gap),
        m_envelopes(train, placement),
        m_stop(stop) {}

  [[nodiscard]] std::vector<Vector3d> nearest() const {
    std::vector<std::size_t> order(m_planes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    return nearestMoves(m_train, m_planes, order, Sides::both, m_envelopes, m_gap, m_stop).by;
  }

  /// Other moves, where these enclose some and others fewer.
  [[nodiscard]] std::vector<Vector3d> improved(std::vector<Vector3d> moves) const {
    if (m_stop.stop_requested()) return moves;
    std::optional<StackPlanes> stack = stackOf(m_train, m_planes, m_placement, m_envelopes);
    if (!stack) return moves;
    const Vector3d axis = m_train.wheels[static_cast<std::size_t>(m_planes.back().wheels.front())].axis;
    const auto enclosed = [&](const std::vector<Vector3d>& some) {
      std::vector<double> heights;
      for (const Vector3d& move : some) heights.push_back(move.dot(axis));
      return enclosedCount(*stack, heights);
    };
    int fewest = enclosed(moves);
    const auto consider = [&](std::vector<Vector3d> others) {
      const int count = enclosed(others);
      if (count >= fewest) return;
      fewest = count;
      moves = std::move(others);
    };
    if (fewest == 0) return moves;
    if (isOneLevel(*stack)) {
      addMeetings(*stack, m_planes, m_envelopes, m_stop);
      const std::vector<double> heights = stackedHeights(*stack, m_stop);
      std::vector<Vector3d> stacked;
      for (const double height : heights) stacked.push_back((height - heights.front()) * axis);
      consider(std::move(stacked));
    } else {
      eachOrder(consider);
    }
    return moves;
  }

 private:
  /// All planes can be moved, and begin in one level.
  [[nodiscard]] bool isOneLevel(const StackPlanes& stack) const {
    return m_planes.front().movable &&
           std::all_of(stack.wheels.begin(), stack.wheels.end(), [&](const StackPlanes::Wheel& wheel) {
             return std::abs(wheel.offset - stack.wheels.front().offset) < 1e-6 * stack.gap;
           });
  }

  /// Every order of the few that can be moved, past the others, to both sides and to either.
  template <class Consider>
  void eachOrder(const Consider& consider) const {
    constexpr std::size_t kMax = 4;
    std::vector<std::size_t> order(m_planes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto first =
        std::find_if(order.begin(), order.end(), [&](std::size_t p) { return m_planes[p].movable; });
    if (static_cast<std::size_t>(order.end() - first) > kMax) return;
    do {
      for (const Sides sides : {Sides::both, Sides::thisOne, Sides::other}) {
        Moves moves = nearestMoves(m_train, m_planes, order, sides, m_envelopes, m_gap, m_stop);
        if (m_stop.stop_requested()) return;
        if (moves.isClear) consider(std::move(moves.by));
      }
    } while (std::next_permutation(first, order.end()));
  }

  const TrainWheels& m_train;
  const std::vector<Plane>& m_planes;
  const Placement& m_placement;
  double m_gap;
  WheelEnvelopes m_envelopes;
  const std::stop_token& m_stop;
};

}  // namespace

void stackWheels(TrainWheels& train, const Placement& placement, const std::stop_token& stop) {
  if (train.wheels.empty()) return;  // nor need there be a tree
  std::vector<Plane> planes = planesOf(train);
  std::stable_partition(planes.begin(), planes.end(), [](const Plane& plane) { return !plane.movable; });
  const auto rings = std::count_if(train.wheels.begin(), train.wheels.end(),
                                   [](const TrainWheel& wheel) { return isRing(wheel.spec); });
  const double gap = rings > 1 ? kLinkedGap : kPlaneGap;
  const PlaneStacker stacker(train, planes, placement, gap, stop);
  std::vector<Vector3d> moves = stacker.nearest();
  if (rings < 2)
    moves = stacker.improved(std::move(moves));  // linked sets find ways through (coaxial_plan.h)
  std::vector<Vector3d> moved(train.wheels.size(), Vector3d::Zero());
  for (std::size_t p = 0; p < planes.size(); ++p) {
    for (const GearOrdinal w : planes[p].wheels) {
      moved[static_cast<std::size_t>(w)] = moves[p];
      train.wheels[static_cast<std::size_t>(w)].origin += moves[p];
    }
  }
  for (TrainPair& pair : train.pairs) pair.pitchPoint += moved[static_cast<std::size_t>(pair.tail)];
}

std::vector<std::pair<int, int>> overlappingWheels(const TrainWheels& train, const Placement& placement,
                                                   const std::stop_token& stop) {
  const WheelEnvelopes envelopes(train, placement);
  std::vector<std::set<int>> near;  // the wheel itself and those it meshes with
  for (const GearOrdinal w : train.wheels.ordinals()) near.push_back({static_cast<int>(w)});
  for (const TrainPair& pair : train.pairs) {
    near[static_cast<std::size_t>(pair.tail)].insert(pair.head);
    near[static_cast<std::size_t>(pair.head)].insert(pair.tail);
  }
  std::vector<std::pair<int, int>> found;
  for (const auto& [one, other] : envelopes.nearPairs(stop)) {
    if (stop.stop_requested()) return found;
    const auto a = static_cast<std::size_t>(one), b = static_cast<std::size_t>(other);
    if (train.wheels[a].link == train.wheels[b].link || near[a].contains(other)) continue;
    const bool coaxial = train.wheels[a].axisGroup == train.wheels[b].axisGroup;
    const auto isNeighbour = [&](GearOrdinal w) { return near[b].contains(w); };
    if (envelopes.collide(one, other) &&
        (coaxial || std::none_of(near[a].begin(), near[a].end(), isNeighbour)))
      found.emplace_back(one, other);
  }
  return found;
}

}  // namespace geargraph
