#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "core/mechanism/model/mechanism.h"
#include "core/mechanism/placement/placement.h"

namespace geargraph::inline train {

/// How the teeth of a mesh touch along the line of action.
struct MeshContact {
  double pressureAngle = 0;  ///< alpha_w at which the pair works, rad
  /// eps_1, eps_2: from the pitch point to the end of contact at the tip of the tail's gear, of the head's,
  /// in base pitches.
  double tailAddendum = 0;
  double headAddendum = 0;
  /// 1 / z_1 + 1 / z_2; of a ring and its pinion the difference; of a bevel pair with virtual teeth z /
  /// cos(d).
  double slidingTeeth = 0;
};

/// H_v: the part of the power across the teeth that a coefficient of friction of 1 would lose,
///
///     H_v = 2 pi (1/z_1 +- 1/z_2) * average of |x|,
///
/// x the distance of a contact from the pitch point in base pitches, over one pitch, pairs in contact sharing
/// the load equally. Where eps_1, eps_2 <= 1 <= eps_1 + eps_2 <= 2 it is the formula of H. Ohlendorf
/// (dissertation, TH München, 1958; ISO/TR 14179-2),
///     pi (1/z_1 +- 1/z_2) (1 - eps_a + eps_1^2 + eps_2^2),   eps_a = eps_1 + eps_2;
/// elsewhere the pieces are integrated.
[[nodiscard]] double toothLossFactor(const MeshContact& contact);

/// By mesh, of the wheels as the program shapes them (module, profile shifts and tips that the document
/// gives, else those that follow from its centre distances); none where a mesh has no geometry. Of no use
/// when `stop` was requested meanwhile. Cost: that of shapeWheels().
[[nodiscard]] std::vector<std::optional<MeshContact>> meshContacts(const Mechanism& mechanism,
                                                                   const Placement& placement,
                                                                   const std::stop_token& stop = {});

}  // namespace geargraph::inline train
