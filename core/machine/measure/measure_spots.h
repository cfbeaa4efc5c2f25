#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/machine/body_layout/derived_geometry.h"

namespace geargraph {

/// A wheel as far as it can be measured. Lengths.
struct MeasuredWheel {
  LinkOrdinal link = 0;
  MeshOrdinal mesh = 0;                   ///< its first
  std::optional<double> pitchDiameter{};  ///< operating, in the first mesh; empty: its wheels do not touch
  std::optional<Rational> pitchSquare{};  ///< the square of that in fractions, if it is rational
  double tipDiameter = 0;
  double rootDiameter = 0;
  double faceWidth = 0;
};

/// A place that is measured from or to: an axis, or a point. In the reference pose, base frame.
struct Spot {
  enum class Kind {
    axis,
    pitchPoint,
    wheelCentre,  ///< on its axis, in the middle of the face width; bevel: in the plane of its pitch circle
    faceCentre,   ///< on its axis, in one of its end faces
  };
  Kind kind = Kind::axis;
  ElementId element;                         ///< the axis, the mesh, or the link of the wheel
  Vector3 point{};                           ///< itself, or a point of the axis
  std::optional<ExactVector3> exactPoint{};  ///< if it is known in fractions
  /// The axis, or the one that a wheel's point lies on; empty for a pitch point.
  std::optional<ExactLine> line{};
  Vector3 direction{};  ///< of that line, of length 1
  std::optional<MeasuredWheel> wheel{};
  /// For a pitch point: the axes of its wheels, and the wheels.
  std::vector<ExactLine> meshLines{};
  std::vector<MeasuredWheel> meshWheels{};

  [[nodiscard]] bool isPoint() const { return kind != Kind::axis; }
};

/// The square of the distance of a point from a line.
[[nodiscard]] Rational squareFromLine(const ExactVector3& point, const ExactLine& line);

/// The spots of a train: each axis once, though several turning joints may lie on it; the pitch point of each
/// mesh that has one; centre and end faces of each wheel.
///
/// Cost: DerivedGeometry::wheels(), which the analysis has made already for documents that it knows.
class MeasureSpots {
 public:
  explicit MeasureSpots(DerivedGeometryPtr geometry);

  [[nodiscard]] const std::vector<Spot>& all() const { return m_spots; }

  /// What an element stands for: an axis or a turning joint for its axis; a mesh for its pitch point; a link
  /// for the centre or the face of its wheel that is nearest to `near`, without `near` for the centre of its
  /// first wheel, and without wheels for the axis it turns about. Null if it has no place.
  [[nodiscard]] const Spot* of(const ElementId& element, const std::optional<Vector3>& near = {}) const;

  /// "axis a", "pitch point of mesh 15", "centre of gear 15 on link 2", "face of gear 15 on link 2", in the
  /// language in use.
  [[nodiscard]] std::string nameOf(const Spot& spot) const;

 private:
  void addAxes();
  void addMeshes();
  void addWheels();

  DerivedGeometryPtr m_geometry;
  std::vector<Spot> m_spots;
  ByClass<std::size_t> m_ofClass;  ///< the position of its spot
};

}  // namespace geargraph
