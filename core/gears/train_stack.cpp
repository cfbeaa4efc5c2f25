#include <algorithm>
#include <set>

#include "core/gears/wheel_rooms.h"

namespace geargraph {
namespace {

using Eigen::Vector3d;

/// Room between stacked planes, in modules: for a carrier's arm, and where several sets are linked for the
/// discs that join them.
constexpr double kPlaneGap = 5;
constexpr double kLinkedGap = 12;
constexpr int kNearTries = 60;  // plane by plane, then in strides
constexpr int kMostTries = 120;
constexpr double kStride = 1.0 / 12;  // of the way

/// Wheels that lie in one plane because they mesh.
struct Plane {
  std::vector<int> wheels;
  bool movable = true;
};

std::vector<Plane> planesOf(const TrainWheels& train) {
  std::vector<int> planeOf(train.wheels.size(), -1);
  std::vector<Plane> planes;
  const auto join = [&](int from, int to) {
    for (const int w : planes[static_cast<std::size_t>(from)].wheels) {
      planeOf[static_cast<std::size_t>(w)] = to;
      planes[static_cast<std::size_t>(to)].wheels.push_back(w);
    }
    planes[static_cast<std::size_t>(from)].wheels.clear();
  };
  for (std::size_t w = 0; w < train.wheels.size(); ++w) {
    planeOf[w] = static_cast<int>(w);
    planes.push_back({{static_cast<int>(w)}, true});
  }
  for (const TrainPair& pair : train.pairs) {
    const int a = planeOf[static_cast<std::size_t>(pair.tail)];
    const int b = planeOf[static_cast<std::size_t>(pair.head)];
    if (pair.kind != MeshKind::bevel && a != b) join(std::max(a, b), std::min(a, b));
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

}  // namespace

void stackWheels(TrainWheels& train, const Placement& placement) {
  std::vector<Plane> planes = planesOf(train);
  std::stable_partition(planes.begin(), planes.end(), [](const Plane& plane) { return !plane.movable; });
  WheelRooms rooms(train, placement);
  std::vector<int> standing;
  const auto blocked = [&](const Plane& plane) {
    return std::any_of(plane.wheels.begin(), plane.wheels.end(), [&](int w) {
      return std::any_of(standing.begin(), standing.end(),
                         [&](int other) { return rooms.collide(w, other); });
    });
  };
  const auto isRing = [](const TrainWheel& wheel) { return wheel.spec.kind == GearKind::internal; };
  const auto rings = std::count_if(train.wheels.begin(), train.wheels.end(), isRing);
  const double gap = rings > 1 ? kLinkedGap : kPlaneGap;
  std::vector<Vector3d> moved(train.wheels.size(), Vector3d::Zero());
  for (const Plane& plane : planes) {
    const Vector3d axis = train.wheels[static_cast<std::size_t>(plane.wheels.front())].axis;
    double side = 0;
    for (const int w : plane.wheels) side += rooms.freeSide(w).dot(axis);
    const Vector3d direction = side < 0 ? Vector3d(-axis) : axis;
    double step = 0;
    for (const int w : plane.wheels) {
      const GearSpec& spec = train.wheels[static_cast<std::size_t>(w)].spec;
      step = std::max(step, spec.faceWidth + gap * spec.module);
    }
    double at = 0, far = 0;
    for (int attempt = 1; plane.movable && blocked(plane) && attempt < kMostTries; ++attempt) {
      if (attempt % 2 == 1) far += attempt < kNearTries ? step : std::max(step, kStride * far);
      const double goal = attempt % 2 == 1 ? far : -far;
      for (const int w : plane.wheels) rooms.move(w, (goal - at) * direction);
      at = goal;
    }
    for (const int w : plane.wheels) {
      moved[static_cast<std::size_t>(w)] = at * direction;
      train.wheels[static_cast<std::size_t>(w)].origin += at * direction;
    }
    standing.insert(standing.end(), plane.wheels.begin(), plane.wheels.end());
  }
  for (TrainPair& pair : train.pairs) pair.pitchPoint += moved[static_cast<std::size_t>(pair.tail)];
}

std::vector<std::pair<int, int>> wheelsInOnePlace(const TrainWheels& train, const Placement& placement) {
  const WheelRooms rooms(train, placement);
  std::vector<std::set<int>> near;  // the wheel itself and those it meshes with
  for (std::size_t w = 0; w < train.wheels.size(); ++w) near.push_back({static_cast<int>(w)});
  for (const TrainPair& pair : train.pairs) {
    near[static_cast<std::size_t>(pair.tail)].insert(pair.head);
    near[static_cast<std::size_t>(pair.head)].insert(pair.tail);
  }
  std::vector<std::pair<int, int>> found;
  for (std::size_t a = 0; a < train.wheels.size(); ++a) {
    for (std::size_t b = a + 1; b < train.wheels.size(); ++b) {
      if (train.wheels[a].link == train.wheels[b].link) continue;
      if (!rooms.collide(static_cast<int>(a), static_cast<int>(b))) continue;
      const bool neighbours =
          std::any_of(near[a].begin(), near[a].end(), [&](int w) { return near[b].contains(w); });
      const bool coaxial = train.wheels[a].axisClass == train.wheels[b].axisClass;
      if (!neighbours || (coaxial && !near[a].contains(static_cast<int>(b))))
        found.emplace_back(static_cast<int>(a), static_cast<int>(b));
    }
  }
  return found;
}

}  // namespace geargraph
