#pragma once

#include <QString>
#include <optional>

#include "core/foundations/base/id.h"
#include "core/foundations/exact/pi_number.h"
#include "core/mechanism/model/mechanism.h"

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
[[nodiscard]] QString speedText(const PiNumber& speed, const SpeedUnit& unit,
                                const std::optional<PiNumber>& reference);
/// The same for a speed that is not known exactly.
[[nodiscard]] QString speedText(double speed, const SpeedUnit& unit, std::optional<double> reference);

/// one / other, exact where `other` has a single power of pi. @pre other is not 0
[[nodiscard]] std::optional<PiNumber> quotient(const PiNumber& one, const PiNumber& other);

/// The unit of a rate that is shown in `unit`, where joints slide: "rad/s" or "rpm" of what turns; of what
/// slides "mm/s", with the document's unit of length, whatever `unit` is but a ratio. A ratio of two joints
/// of one kind has none, else it is "mm/rad" or "rad/mm".
[[nodiscard]] QString unitOfRate(const Mechanism& mechanism, bool slides, const SpeedUnit& unit = {});
/// The unit of a rate over another one: empty, "mm/rad" or "rad/mm".
[[nodiscard]] QString unitOfRatio(const Mechanism& mechanism, bool slides, bool otherSlides);

}  // namespace geargraph
