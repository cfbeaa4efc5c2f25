#pragma once

#include <QString>

#include "core/mechanism/model/element_index.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph {

/// The joints, the gears with their teeth, and the brakes and clutches of a link, as rich text with an
/// addressOf() hyperlink for each; empty if there are none. Beyond kMaxListed only the number of the others
/// is given.
struct LinkParts {
  static constexpr int kMaxListed = 12;

  QString joints;
  QString gears;
  QString couplings;
};

/// Cost: O(joints + meshes + couplings).
[[nodiscard]] LinkParts partsOf(const Mechanism& mechanism, const ElementIndex& index, const LinkId& link);

/// The turning joints about an axis, as rich text with hyperlinks: "11: 1 → 6". Cost: O(joints).
[[nodiscard]] QString jointsOn(const Mechanism& mechanism, const ElementIndex& index, const AxisId& axis);
/// The links of a coupling, in the same way.
[[nodiscard]] QString linksOf(const ShiftElement& coupling, const ElementIndex& index);

/// The hyperlink target for an element in rich text, and back.
[[nodiscard]] QString addressOf(const ElementId& element);
[[nodiscard]] ElementId elementAt(const QString& address);

}  // namespace geargraph
