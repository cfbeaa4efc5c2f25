#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "core/machine/solids/solid.h"

namespace geargraph::test {

/// The section of a gear's mesh, as a set of straight segments in a plane: what an inspector would measure,
/// made from triangles alone. Shares nothing with what made the triangles.
///
/// Spur gears and rings are cut by the plane in the middle of their face; the section's plane is that plane.
/// Bevels are cut by a sphere about their apex; the section's plane is the sphere's stereographic picture
/// about the gear's axis, which keeps angles, so lengths only need a factor.
class Section {
 public:
  /// Cut by z = `height`.
  [[nodiscard]] static Section flat(const Solid& solid, double height = 0.0137);
  /// Cut by the sphere of this radius about the origin.
  [[nodiscard]] static Section spherical(const Solid& solid, double radius);

  [[nodiscard]] Eigen::Vector2d toSection(const Eigen::Vector3d& point) const;
  [[nodiscard]] Eigen::Vector3d toSpace(const Eigen::Vector2d& point) const;
  /// Is the point in the material (even-odd along the ray from the axis outward)?
  [[nodiscard]] bool contains(const Eigen::Vector2d& point) const;
  /// Length from the point to the nearest segment. @pre it is within a few teeth of the outline
  [[nodiscard]] double distance(const Eigen::Vector2d& point) const;
  /// Ends, and points in between, of the segments that lie within `reach` of the point.
  [[nodiscard]] std::vector<Eigen::Vector2d> samplesNear(const Eigen::Vector2d& point, double reach) const;
  [[nodiscard]] double area() const;
  [[nodiscard]] std::size_t size() const { return m_segments.size(); }

 private:
  struct Segment {
    Eigen::Vector2d a, b;
  };
  Section(std::vector<Segment> segments, double sphere);
  [[nodiscard]] std::size_t binOf(double angle) const;
  [[nodiscard]] double scaleAt(const Eigen::Vector2d& point) const;

  std::vector<Segment> m_segments;
  std::vector<std::vector<std::size_t>> m_bins;  ///< segments by azimuth
  double m_sphere = 0;                           ///< radius, 0: flat
};

/// One gear of a pair: its section and where it stands.
struct Placed {
  const Section* section = nullptr;
  Eigen::Isometry3d pose;
};

/// Depth of the deepest point of either gear inside the other, near the pitch point; 0 where they are apart.
[[nodiscard]] double interpenetration(const Placed& a, const Placed& b, const Eigen::Vector3d& pitchPoint,
                                      double reach);

/// What turning the gears through a pitch shows. Lengths in the unit of the solids, at b's pitch circle.
struct MeshReport {
  double interpenetration = 0;
  double transmissionError = 0;  ///< peak to peak, the worse of both flanks
  double phaseError = 0;         ///< pitches by which the middle of the play is off, at worst
  double leastBacklash = 1e300;
  double mostBacklash = 0;
};

/// Turns gear a by `frames` steps through one pitch (of `teethA`) and gear b so that the surfaces roll at the
/// pitch point, then turns b on in either direction until the flanks touch. `ratioSign` -1 turns b the wrong
/// way, for the test of this test.
[[nodiscard]] MeshReport checkMesh(Placed a, Placed b, int teethA, int teethB,
                                   const Eigen::Vector3d& pitchPoint, double module, int frames,
                                   double ratioSign = 1);

}  // namespace geargraph::test
