#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "core/gears/bevel_room.h"
#include "core/gears/gear_body.h"
#include "core/gears/train_wheels.h"

namespace geargraph {
namespace {

using Eigen::Vector3d;

/// Room between stacked planes, in modules: for a carrier's arm, and where several sets are linked for the
/// discs that join them.
constexpr double kPlaneGap = 5;
constexpr double kLinkedGap = 12;

/// The room of a wheel: a disc or an annulus of some width.
struct Room {
  Vector3d origin, axis;
  AxialSpan span;
  double inner = 0;
  double outer = 0;

  explicit Room(const TrainWheel& wheel)
      : origin(wheel.origin), axis(wheel.axis), span(axialSpan(wheel.spec)) {
    const bool ring = wheel.spec.kind == GearKind::internal;
    if (ring) inner = nominalTipRadius(wheel.spec);
    outer = ring ? rimDiameter(wheel.spec) / 2 : nominalTipRadius(wheel.spec);
  }
};

/// Do two wheels on parallel axes take up the same room?
bool collide(const Room& a, const Room& b) {
  const Vector3d apart = b.origin - a.origin;
  const double along = apart.dot(a.axis);
  const double sense = a.axis.dot(b.axis);
  if (std::abs(std::abs(sense) - 1) > 1e-12) return false;
  const double low = sense < 0 ? -b.span.high : b.span.low;
  const double high = sense < 0 ? -b.span.low : b.span.high;
  if (a.span.high <= low + along || high + along <= a.span.low) return false;
  const double distance = (apart - along * a.axis).norm();
  const bool inside = distance + b.outer <= a.inner || distance + a.outer <= b.inner;
  return !inside && distance < a.outer + b.outer;
}

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

void stackWheels(TrainWheels& train) {
  std::vector<Plane> planes = planesOf(train);
  std::stable_partition(planes.begin(), planes.end(), [](const Plane& plane) { return !plane.movable; });
  std::vector<Room> rooms;
  for (const TrainWheel& wheel : train.wheels) rooms.emplace_back(wheel);
  std::vector<int> standing;
  const auto room = [&](int w) -> Room& { return rooms[static_cast<std::size_t>(w)]; };
  const auto blocked = [&](const Plane& plane) {
    return std::any_of(plane.wheels.begin(), plane.wheels.end(), [&](int w) {
      return std::any_of(standing.begin(), standing.end(),
                         [&](int other) { return collide(room(w), room(other)); });
    });
  };
  const auto isRing = [](const TrainWheel& wheel) { return wheel.spec.kind == GearKind::internal; };
  const auto rings = std::count_if(train.wheels.begin(), train.wheels.end(), isRing);
  const double gap = rings > 1 ? kLinkedGap : kPlaneGap;
  std::vector<Vector3d> moved(train.wheels.size(), Vector3d::Zero());
  for (const Plane& plane : planes) {
    const Vector3d direction = room(plane.wheels.front()).axis;
    double step = 0;
    for (const int w : plane.wheels) {
      const GearSpec& spec = train.wheels[static_cast<std::size_t>(w)].spec;
      step = std::max(step, spec.faceWidth + gap * spec.module);
    }
    double at = 0;
    for (int attempt = 1; plane.movable && blocked(plane) && attempt < 60; ++attempt) {
      const double goal = (attempt % 2 == 1 ? 1 : -1) * ((attempt + 1) / 2) * step;  // +1, -1, +2, -2, ...
      for (const int w : plane.wheels) room(w).origin += (goal - at) * direction;
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

std::vector<std::pair<int, int>> wheelsInOnePlace(const TrainWheels& train) {
  std::vector<Room> rooms;
  std::vector<std::set<int>> near;  // the wheel itself and those it meshes with
  for (std::size_t w = 0; w < train.wheels.size(); ++w) {
    rooms.emplace_back(train.wheels[w]);
    near.push_back({static_cast<int>(w)});
  }
  for (const TrainPair& pair : train.pairs) {
    near[static_cast<std::size_t>(pair.tail)].insert(pair.head);
    near[static_cast<std::size_t>(pair.head)].insert(pair.tail);
  }
  std::vector<std::pair<int, int>> found;
  for (std::size_t a = 0; a < rooms.size(); ++a) {
    for (std::size_t b = a + 1; b < rooms.size(); ++b) {
      if (train.wheels[a].link == train.wheels[b].link) continue;
      const auto isBevel = [&](std::size_t w) { return train.wheels[w].spec.kind == GearKind::bevel; };
      // The room of a bevel is a disc that its cone does not fill.
      const bool apart = isBevel(a) && isBevel(b) ? !bevelsCollide(train.wheels[a], train.wheels[b])
                                                  : !collide(rooms[a], rooms[b]);
      if (apart) continue;
      const bool neighbours =
          std::any_of(near[a].begin(), near[a].end(), [&](int w) { return near[b].contains(w); });
      if (!neighbours) found.emplace_back(static_cast<int>(a), static_cast<int>(b));
    }
  }
  return found;
}

}  // namespace geargraph
