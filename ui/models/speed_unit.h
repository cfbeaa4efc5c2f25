#pragma once

#include <QString>
#include <optional>

#include "core/foundations/base/id.h"
#include "core/foundations/base/rational.h"

namespace geargraph {

/// The unit of displayed speeds: rad/s, revolutions per minute, or the ratio to the speed of a chosen joint
/// (relative speeds) or of its head link (absolute speeds).
struct SpeedUnit {
  enum class Kind { radPerSecond, rpm, ratio };
  Kind kind = Kind::radPerSecond;
  JointId reference;  ///< of a ratio
};

/// A speed given in rad/s as text in the unit: fractions stay fractions, rpm are decimals. `reference`: the
/// speed of the reference in rad/s; the ratio to a speed of 0 is "–".
[[nodiscard]] QString speedText(const Rational& speed, const SpeedUnit& unit,
                                const std::optional<Rational>& reference);
/// The same for a speed that is not known exactly.
[[nodiscard]] QString speedText(double speed, const SpeedUnit& unit, std::optional<double> reference);

}  // namespace geargraph
