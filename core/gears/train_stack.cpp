#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/gears/gear_body.h"
#include "core/gears/train_wheels.h"

namespace geargraph {
namespace {

using Eigen::Vector3d;

/// Room between stacked planes, for a carrier's arm, in modules.
constexpr double kPlaneGap = 5;

struct Annulus {
  double inner;
  double outer;
};

Annulus annulusOf(const GearSpec& spec) {
  if (spec.kind == GearKind::internal) return {nominalTipRadius(spec), rimDiameter(spec) / 2};
  return {0, nominalTipRadius(spec)};
}

/// Do two wheels on parallel axes take up the same room?
bool collide(const TrainWheel& a, const TrainWheel& b) {
  if (a.axis.cross(b.axis).norm() > 1e-6) return false;
  const double along = (b.origin - a.origin).dot(a.axis);
  const AxialSpan sa = axialSpan(a.spec);
  AxialSpan sb = axialSpan(b.spec);
  if (a.axis.dot(b.axis) < 0) sb = {-sb.high, -sb.low};
  if (sa.high <= sb.low + along || sb.high + along <= sa.low) return false;
  const Vector3d apart = b.origin - a.origin - along * a.axis;
  const double distance = apart.norm();
  const Annulus ra = annulusOf(a.spec);
  const Annulus rb = annulusOf(b.spec);
  const bool inside = distance + rb.outer <= ra.inner || distance + ra.outer <= rb.inner;
  return !inside && distance < ra.outer + rb.outer;
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
  std::vector<int> standing;
  const auto blocked = [&](const Plane& plane) {
    return std::any_of(plane.wheels.begin(), plane.wheels.end(), [&](int w) {
      return std::any_of(standing.begin(), standing.end(), [&](int other) {
        return collide(train.wheels[static_cast<std::size_t>(w)],
                       train.wheels[static_cast<std::size_t>(other)]);
      });
    });
  };
  for (const Plane& plane : planes) {
    const TrainWheel& first = train.wheels[static_cast<std::size_t>(plane.wheels.front())];
    const Vector3d direction = first.axis;
    double step = 0;
    for (const int w : plane.wheels) {
      const GearSpec& spec = train.wheels[static_cast<std::size_t>(w)].spec;
      step = std::max(step, spec.faceWidth + kPlaneGap * spec.module);
    }
    double at = 0;
    for (int attempt = 1; plane.movable && blocked(plane) && attempt < 60; ++attempt) {
      const double goal = (attempt % 2 == 1 ? 1 : -1) * ((attempt + 1) / 2) * step;  // +1, -1, +2, -2, ...
      for (const int w : plane.wheels)
        train.wheels[static_cast<std::size_t>(w)].origin += (goal - at) * direction;
      at = goal;
    }
    for (TrainPair& pair : train.pairs) {
      if (at != 0 && std::count(plane.wheels.begin(), plane.wheels.end(), pair.tail) > 0) {
        pair.pitchPoint += at * direction;
      }
    }
    standing.insert(standing.end(), plane.wheels.begin(), plane.wheels.end());
  }
}

}  // namespace geargraph
