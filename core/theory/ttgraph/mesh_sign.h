#pragma once

#include <optional>

#include "core/theory/ttgraph/reference_lines.h"

namespace geargraph::inline ttgraph {

/// What the drawn pose says about one mesh: the axes of its two gears in their carrier, pointing as their
/// levels do, and where the pitch surfaces touch. Each may be missing. Refers to what it names.
struct MeshPose {
  const AxisLine* tailAxis = nullptr;
  const AxisLine* headAxis = nullptr;
  const Vector3* pitchPoint = nullptr;
  std::optional<MeshKind> kind;
};

/// The sign s of the terminal equation N_i w_ik = s N_j w_jk [AU, below Eq. (26)]: +1 if both gears turn the
/// same way, seen from the carrier and each along its own axis.
///
/// Parallel axes: external gears turn against each other in space, internal ones together; an axis that
/// points the other way turns the sign. Without `kind`, the gears are external exactly if the pitch point
/// lies between the axes.
///
/// Axes that meet in an apex: the pitch line from there is a sum of shares of the two axes. If it lies
/// between the two as they point (shares of one sign), the gears turn against each other; else together.
///
/// None where the drawn pose does not tell: a bevel pair without its pitch point, skew axes.
[[nodiscard]] std::optional<int> meshSign(const MeshPose& pose);

}  // namespace geargraph::inline ttgraph
