#pragma once

#include <optional>
#include <vector>

#include "core/machine/teeth/gear_spec.h"
#include "core/presentation/brep/brep.h"
#include "core/presentation/brep/cubic_spline.h"

namespace geargraph {

/// The outline of all teeth in one section, counter-clockwise: of a wheel on a cylinder in its plane, of a
/// cone on its back cone.
struct ToothRing {
  /// Between two stations: an arc about the axis where there is no spline.
  struct Piece {
    std::size_t from = 0;
    std::size_t to = 0;
    std::optional<SplineCurve> spline = {};
    bool isTip = false;
  };
  std::vector<Eigen::Vector3d> stations;
  std::vector<Piece> pieces;
  std::vector<std::size_t> splits;  ///< stations in the middle of the spaces that were to be split
  double deviation = 0;             ///< of the splines, a length
};

/// Splines are within `deviation`, a length. Root arcs before the teeth named by `splitSpaces`, ascending,
/// are two pieces. @pre the wheel has teeth, in one section
[[nodiscard]] ToothRing toothRing(const GearSpec& spec, double deviation,
                                  const std::vector<int>& splitSpaces = {});

}  // namespace geargraph
