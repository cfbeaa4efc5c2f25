#pragma once

#include <optional>
#include <utility>

#include "core/theory/ttgraph/reference_lines.h"

namespace geargraph {

/// The geometry of one mesh in the drawn pose: the axes of its two gears in their carrier, pointing as their
/// levels do, and where the pitch surfaces touch. Each may be missing. Does not own what it points to.
struct MeshPose {
  const AxisLine* tailAxis = nullptr;
  const AxisLine* headAxis = nullptr;
  const Vector3* pitchPoint = nullptr;
  std::optional<MeshKind> kind;
  /// Of gears on skew axes: the helix angles of the tail's and the head's, rad, positive right-hand.
  std::optional<std::pair<double, double>> helices = {};
  bool tailSlides = false;  ///< its axis is that of a slide
  bool headSlides = false;
};

/// The sign s of the terminal equation N_i w_ik = s N_j w_jk [AU, below Eq. (26)]: +1 if both gears turn the
/// same way, seen from the carrier and each along its own axis.
///
/// Parallel axes: external gears turn in opposite directions in space, internal ones in the same; an axis
/// that points the other way changes the sign. Without `kind`, the gears are external exactly if the pitch
/// point lies between the axes.
///
/// Axes that intersect in an apex: the direction of the pitch line from there is a linear combination of the
/// two axes' directions. If both coefficients have the same sign (the pitch line is between the axes), the
/// gears turn in opposite directions; else in the same.
///
/// Skew axes: with Sigma the angle from the tail's direction to the head's about the common perpendicular
/// from tail to head, the teeth run the same way where they touch if beta_i + beta_j + Sigma is a whole
/// number of half turns; an even one is -1, an odd one +1. Of cones (hypoid) the half axes decide, seen from
/// the feet of the common perpendicular, beside which the pitch point lies: -1 if both are along or both
/// against their axes' directions.
///
/// A side that slides: with u the axis of the pinion, rho the way from it to the pitch point and d the
/// direction of the slide, +1 where d goes with u x rho (and so with the motion of the pinion's teeth there);
/// a thread is -1 if it is right-hand and both directions agree. s is the sign of a speed against an angular
/// velocity then.
///
/// std::nullopt if the drawn pose does not determine it: a bevel pair without its pitch point, skew axes
/// without helices.
[[nodiscard]] std::optional<int> meshSign(const MeshPose& pose);

}  // namespace geargraph
