#pragma once

#include <optional>

#include "core/foundations/base/diagnostic.h"
#include "core/mechanism/model/mechanism.h"
#include "core/mechanism/placement/mesh_word.h"
#include "core/mechanism/placement/pitch_point.h"
#include "core/mechanism/placement/tolerance.h"

namespace geargraph {

/// The geometry of a gear mesh in the reference pose. The axes A (tail's gear) and B (head's) are the lines
/// of the two axis classes; both are fixed in the carrier, so nothing here changes with the pose.
struct MeshGeometry {
  LinkOrdinal tail = 0;  ///< link positions
  LinkOrdinal head = 0;
  LinkOrdinal carrier = 0;  ///< the transfer vertex
  AxisGroupOrdinal tailClass = 0;
  AxisGroupOrdinal headClass = 0;
  int tailTeeth = 1;
  int headTeeth = 1;
  MeshWeights weights;  ///< of its row: the teeth, except where a side slides
  /// s: N_tail w_tail = s N_head w_head, the speeds relative to the carrier about the classes' lines. From
  /// the geometry: the sign of r_A . r_B.
  int sign = -1;
  BevelSides sides;      ///< of a derived bevel pair
  int bevelSize = 2;     ///< of a derived bevel pair: its module in halves of the placement's
  bool derived = false;  ///< the pitch point follows from axes and teeth; the file has none
  MeshKind kind = kUsualKind;
  Vector3 pitchPoint{};
  /// From the point of the tail's line to that of the head's and to the pitch point: as differences, so that
  /// a train far from the origin loses no precision.
  Vector3 tailToHead{};
  Vector3 tailToPitch{};
  /// e_c: the normal of the plane of both axes, its first component that is not 0 positive (the paper's x
  /// direction). Where the wheels do not touch: the direction of the strand, or of the push of a pin, through
  /// the pitch point (strand.h).
  Vector3 normal{};
  double tailRadius = 0;  ///< e_c . r_A, r_A = u_A x (P - p_A): the paper's P_c,k of a joint on axis A;
                          ///< e_c . u_A where that side slides
  double headRadius = 0;  ///< e_c . r_B; the sign is that of tailRadius * headRadius
  /// Helix angles at the reference cylinders, rad, positive for right-hand helices; 0: straight teeth. No
  /// radius, sign or coefficient of parallel or meeting axes depends on them. On skew axes they make e_c, the
  /// tooth normal in the plane that touches both cylinders or cones (crossing.h, hypoid.h), so that
  /// tailRadius is r cos(beta) there. Of bevels spiral angles: positive where the teeth turn about the half
  /// axis in the positive sense as they lead away from the apex.
  double tailHelix = 0;
  double headHelix = 0;

  /// How far the pitch point is from the axes of the gears.
  [[nodiscard]] double tailPitchRadius() const;
  [[nodiscard]] double headPitchRadius() const;
};

/// Is the half axis of the tail's gear, from the apex of an intersecting pair towards the gear, along (+1) or
/// against (-1) its line's direction? The two half axes point the way of the pitch point; where it does not
/// lie between them, the larger gear is a ring and its half axis points the other way.
/// @pre directions of length 1
[[nodiscard]] int tailHalfAxis(const MeshGeometry& geometry, const Vector3& tailDirection,
                               const Vector3& headDirection);

/// The unit vector or its opposite: the one whose first component that is not 0 is positive.
[[nodiscard]] Vector3 orientedNormal(const Vector3& direction);

[[nodiscard]] LinePosition positionOf(const GearPair<double>& pair, const LineComparison& train);

/// Checks a pitch point against axes, teeth and kind (the moment equation has rank 1 exactly if both radii
/// are non-zero and parallel), and sets normal, radii, sign and kind. Returns false with pitch-point-on-axis,
/// pitch-geometry or teeth-geometry, which names what was found and what would fit, if it does not fit.
/// @pre the lines are not skew, `position` is theirs; the points of `pair` are relative to the point of the
/// tail's line; `geometry` has pitchPoint and tailToPitch
[[nodiscard]] bool checkGeometry(const Mechanism& mechanism, MeshOrdinal mesh, const GearPair<double>& pair,
                                 LinePosition position, MeshGeometry& geometry, Diagnostics& diagnostics);

/// pitch-geometry, for axes that are neither parallel nor intersecting.
[[nodiscard]] Diagnostic skewAxes(const Mechanism& mechanism, MeshOrdinal mesh, const GearPair<double>& pair);
/// teeth-geometry, for a pair with a ring and equal tooth counts.
[[nodiscard]] Diagnostic equalInternalTeeth(const Mechanism& mechanism, MeshOrdinal mesh);

}  // namespace geargraph
