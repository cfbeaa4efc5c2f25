#pragma once

#include <cmath>

#include "core/mechanism/geometry_edits/fitted_edits.h"
#include "core/mechanism/model/pins.h"
#include "core/mechanism/placement/placement.h"
#include "tests/core/support/train_sketch.h"
#include "tests/core/support/trains.h"

// What the tests of fitted edits share: trains whose places are stated, and how well one fits.
namespace geargraph::test {

/// Sun 24 (1), ring 60 (2), carrier (3), planets 18 (4..), module 2, every place and pitch point stated.
inline Mechanism statedPlanetary(int planets) {
  const std::vector<ExactTriple> directions{
      {1, 0, 0}, {Rational(-3, 5), Rational(4, 5), 0}, {Rational(-3, 5), Rational(-4, 5), 0}};
  TrainBuilder train("planetary");
  const int a = train.axis({0, 0, 0}, {0, 0, 1});
  const int sun = train.link(0, a);
  const int ring = train.link(0, a);
  const int carrier = train.link(0, a);
  for (int i = 0; i < planets; ++i) {
    const int b = train.axis(scaled(directions[static_cast<std::size_t>(i)], 42), {0, 0, 1});
    const int planet = train.link(carrier, b);
    train.external(sun, a, 24, planet, b, 18);
    train.internal(planet, b, 18, ring, a, 60);
  }
  return train.mechanism();
}

inline const GearMesh& mesh(const Mechanism& mechanism, int position) {
  return mechanism.gearMeshes[static_cast<std::size_t>(position)];
}

/// How far pitch radii, tooth ratios and axes contradict each other, in modules.
inline double misfit(const Mechanism& mechanism) {
  const Placement placement = placementOf(mechanism);
  double worst = 0;
  for (std::size_t m = 0; m < placement.meshes.size(); ++m) {
    if (!placement.meshes[m]) return 1e9;
    const MeshGeometry& geometry = *placement.meshes[m];
    const GearMesh& element = mechanism.gearMeshes[m];
    const Vector3& point = geometry.pitchPoint;
    const auto radius = [&](int axisGroup) {
      const AxisLine& line = placement.lineOfClass(axisGroup);
      return length(cross(line.direction, point - line.point));
    };
    const double tail = radius(geometry.tailClass), head = radius(geometry.headClass);
    const double module = 2 * tail / element.tailTeeth;
    worst = std::max(
        worst, std::abs(tail * element.headTeeth - head * element.tailTeeth) / (module * element.tailTeeth));
    // The point lies in the plane of both axes: both radii point the same way or opposite ways.
    const Vector3 a = cross(placement.lineOfClass(geometry.tailClass).direction,
                            point - placement.lineOfClass(geometry.tailClass).point);
    const Vector3 b = cross(placement.lineOfClass(geometry.headClass).direction,
                            point - placement.lineOfClass(geometry.headClass).point);
    worst = std::max(worst, length(cross(a, b)) / (tail * head) * tail / module);
  }
  return worst;
}

inline double moduleOf(const Mechanism& mechanism, int position) {
  const Placement placement = placementOf(mechanism);
  return 2 * std::abs(placement.meshes[static_cast<std::size_t>(position)]->tailRadius) /
         mesh(mechanism, position).tailTeeth;
}

inline double distanceOfAxis(const Mechanism& mechanism, int axis) {
  const NumberTriple& point = *mechanism.axes[static_cast<std::size_t>(axis)].point;
  return std::hypot(point[0].value(), point[1].value());
}

inline NumberTriple at(double x, double y, double z) {
  return {Number::fromDouble(x), Number::fromDouble(y), Number::fromDouble(z)};
}

inline Mechanism pin(const Mechanism& mechanism, const ElementId& element) {
  return withPinned(mechanism, element, true).value();
}

inline bool blames(const Diagnostic& diagnostic, const ElementId& element) {
  return std::find(diagnostic.elements.begin(), diagnostic.elements.end(), element) !=
         diagnostic.elements.end();
}

}  // namespace geargraph::test
