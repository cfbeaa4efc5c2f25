#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "core/mechanism/model/mechanism.h"
#include "core/mechanism/placement/placement.h"

namespace geargraph {

/// The contact of the teeth of a mesh along the line of action.
struct MeshContact {
  double pressureAngle = 0;  ///< alpha_w at which the pair works, rad
  /// Addendum contact ratios eps_1, eps_2: from the pitch point to the end of contact at the tip of the
  /// tail's and of the head's gear, in base pitches.
  double tailAddendum = 0;
  double headAddendum = 0;
  /// 1 / z_1 + 1 / z_2; for a ring and its pinion the difference; for a bevel pair with virtual tooth numbers
  /// z / cos(d).
  double slidingTeeth = 0;
  /// Of helical teeth: the helix angle of the tail's gear at the cylinder on which it works, rad, positive
  /// right-hand, 0 of herringbone teeth; and the size of the helix angle at the base cylinder.
  double helix = 0;
  double baseHelix = 0;
  /// Gears on skew axes slide along their teeth, which decides their losses: their helix angles at the pitch
  /// cylinders, rad, positive right-hand. `pressureAngle` is that of the normal section then.
  struct Crossing {
    double tailHelix = 0;
    double headHelix = 0;
  };
  std::optional<Crossing> crossing = {};
};

/// The tooth loss factor H_v: the lost fraction of the power through the teeth per coefficient of friction,
///
///     H_v = 2 pi (1/z_1 +- 1/z_2) * average of |x|,
///
/// x the distance of a contact from the pitch point in base pitches, averaged over one pitch, with the load
/// shared equally by the pairs in contact. Where eps_1, eps_2 <= 1 <= eps_1 + eps_2 <= 2 it is the formula of
/// H. Ohlendorf (dissertation, TH München, 1958; ISO/TR 14179-2),
///     pi (1/z_1 +- 1/z_2) (1 - eps_a + eps_1^2 + eps_2^2),   eps_a = eps_1 + eps_2;
/// elsewhere the pieces are integrated. Of helical teeth it is that of the transverse section over cos
/// beta_b, because the force stands across the teeth.
[[nodiscard]] double toothLossFactor(const MeshContact& contact);

/// By mesh, for the wheels as the program shapes them (module, profile shifts and tips as given in the
/// document, else as they follow from its centre distances); none for a mesh without a geometry. The result
/// is meaningless if `stop` was requested meanwhile. Cost: that of shapeWheels().
[[nodiscard]] std::vector<std::optional<MeshContact>> meshContacts(const Mechanism& mechanism,
                                                                   const Placement& placement,
                                                                   const std::stop_token& stop = {});

}  // namespace geargraph
