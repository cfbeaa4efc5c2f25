#include "core/machine/solids/mass_properties.h"

namespace geargraph {
namespace {

Eigen::Vector3d vertexOf(const Solid& solid, std::uint32_t vertex) {
  const Float3& p = solid.positions[vertex];
  return {p[0], p[1], p[2]};
}

/// Inertia from second moments: of both about the same point.
Eigen::Matrix3d inertiaOf(const Eigen::Matrix3d& moments) {
  return moments.trace() * Eigen::Matrix3d::Identity() - moments;
}

Eigen::Matrix3d pointInertia(double mass, const Eigen::Vector3d& at) {
  return mass * inertiaOf(at * at.transpose());
}

}  // namespace

MassProperties massProperties(const Solid& solid, double density) {
  if (solid.empty()) return {};
  // About a point of the solid, so that a far place costs no digits.
  const Eigen::Vector3d near = boundsOf(solid).center();
  double volume = 0;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (const Triangle& triangle : solid.triangles) {
    const Eigen::Vector3d a = vertexOf(solid, triangle[0]) - near;
    const Eigen::Vector3d b = vertexOf(solid, triangle[1]) - near;
    const Eigen::Vector3d c = vertexOf(solid, triangle[2]) - near;
    const Eigen::Vector3d sum = a + b + c;
    const double sixfold = a.dot(b.cross(c));
    volume += sixfold / 6;
    first += sixfold / 24 * sum;
    second +=
        sixfold / 120 * (sum * sum.transpose() + a * a.transpose() + b * b.transpose() + c * c.transpose());
  }
  if (volume == 0) return {};
  MassProperties body;
  body.mass = density * volume;
  const Eigen::Vector3d center = first / volume;
  body.center = near + center;
  body.inertia = density * inertiaOf(second - volume * center * center.transpose());
  return body;
}

MassProperties joined(const MassProperties& a, const MassProperties& b) {
  MassProperties both;
  both.mass = a.mass + b.mass;
  if (both.mass == 0) {
    both.inertia = a.inertia + b.inertia;
    return both;
  }
  both.center = (a.mass * a.center + b.mass * b.center) / both.mass;
  both.inertia = a.inertia + b.inertia + pointInertia(a.mass, a.center - both.center) +
                 pointInertia(b.mass, b.center - both.center);
  return both;
}

MassProperties moved(const MassProperties& body, const Eigen::Isometry3d& placed) {
  const Eigen::Matrix3d turn = placed.linear();
  return {body.mass, placed * body.center, turn * body.inertia * turn.transpose()};
}

MassProperties rescaled(const MassProperties& body, double factor) {
  return {body.mass, factor * body.center, factor * factor * body.inertia};
}

}  // namespace geargraph
