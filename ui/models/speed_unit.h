#pragma once

#include <QString>
#include <optional>

#include "core/foundations/base/id.h"
#include "core/foundations/base/rational.h"

namespace geargraph::inline models {

/// How speeds are told: in rad/s, in turns a minute, or as ratio to the speed of a chosen joint (relative
/// speeds) or of the link that it carries (absolute ones).
struct SpeedUnit {
  enum class Kind { radPerSecond, rpm, ratio };
  Kind kind = Kind::radPerSecond;
  JointId reference;  ///< of a ratio
};

/// A speed of rad/s in the unit: fractions stay fractions, turns a minute are decimals. `reference`: the
/// speed of the reference in rad/s; a ratio to what stands still is "–".
[[nodiscard]] QString speedText(const Rational& speed, const SpeedUnit& unit,
                                const std::optional<Rational>& reference);
/// The same without a fraction at hand.
[[nodiscard]] QString speedText(double speed, const SpeedUnit& unit, std::optional<double> reference);

}  // namespace geargraph::inline models
