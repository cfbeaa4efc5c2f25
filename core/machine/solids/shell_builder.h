#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "core/machine/solids/solid.h"

namespace geargraph {

/// A vertex of a profile; revolved about the z axis it gives a circle, or at radius 0 a point.
struct ProfileVertex {
  double radius = 0;
  double height = 0;
  friend bool operator==(const ProfileVertex&, const ProfileVertex&) = default;
};

/// A closed polygon of vertices around the z axis, counter-clockwise seen from +z: indices, and the angle of
/// each, ascending from the first within one turn.
struct Loop {
  std::vector<std::uint32_t> vertices;
  std::vector<double> angles;
};

/// Lets the loop begin with its first vertex from the angle on, as sew() needs where loops are turned.
void beginLoopAt(Loop& loop, double start);

/// Joins loops by triangle strips. All orientations are for a body inside its teeth; `inward` reverses all
/// triangles and normals of revolution, for rings, whose body is outside.
class ShellBuilder {
 public:
  explicit ShellBuilder(Solid& solid, bool inward = false) : m_solid(solid), m_inward(inward) {}

  std::uint32_t addVertex(const Eigen::Vector3d& position, const Eigen::Vector3d& normal);

  /// Adds a triangle, counter-clockwise seen from outside for a body inside its teeth.
  void addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (m_inward) std::swap(b, c);
    m_solid.triangles.push_back({a, b, c});
  }

  /// `count` vertices on the circle with the normal (radial, axial), or one for a point of the axis. The
  /// first is at angle `start`. Equal circles give bitwise equal positions.
  Loop addCircle(const ProfileVertex& circle, int count, double start, const Eigen::Vector2d& normal);

  /// The strip from loop a to loop b, in the order of the profile, with the material on the left. The loops
  /// may have different numbers of vertices (a loop of one is a pole); their angles decide which one
  /// advances.
  void sew(const Loop& a, const Loop& b);

  /// Adds strips of revolution along a profile, creased at every circle, from the first to the last.
  void addRevolved(std::span<const ProfileVertex> circles, int count, double start);

  /// Outward normal (radial, axial) of the strip between two circles, material on the left.
  [[nodiscard]] Eigen::Vector2d normalOf(const ProfileVertex& a, const ProfileVertex& b) const;

  [[nodiscard]] Solid& solid() { return m_solid; }
  [[nodiscard]] bool inward() const { return m_inward; }

 private:
  /// The angle of a vertex of a circle, with its cosine and sine.
  struct Turn {
    double angle = 0;
    double c = 1;
    double s = 0;
  };
  /// The angles of circles of `count` vertices from `start`, cached because most circles of a body have the
  /// same.
  const std::vector<Turn>& turnsOf(int count, double start);
  /// Adds the vertices of a circle, one for a point of the axis; returns the index of the first.
  std::uint32_t write(const ProfileVertex& circle, const std::vector<Turn>& turns,
                      const Eigen::Vector2d& normal);
  /// sew() for two circles of `count` vertices each, or for one and a pole.
  void sewAlike(std::uint32_t a, bool poleA, std::uint32_t b, bool poleB, std::uint32_t count);

  Solid& m_solid;
  bool m_inward;
  std::vector<Turn> m_turns;
  double m_start = 0;  ///< angle of the first of m_turns
};

/// Number of vertices that keeps a circle within the tolerance (a length), at least 12.
[[nodiscard]] int circleCount(double radius, double tolerance);

}  // namespace geargraph
