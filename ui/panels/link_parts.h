#pragma once

#include <QString>

#include "core/mechanism/model/element_index.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph::inline panels {

/// What is on a link, each as rich text whose links are addressOf() an element: its joints, its gears with
/// their teeth, its brakes and clutches. Empty where there are none. Of more than kMostListed the first are
/// listed, and how many more there are.
struct LinkParts {
  static constexpr int kMostListed = 12;

  QString joints;
  QString gears;
  QString couplings;
};

/// Cost: O(joints + meshes + couplings).
[[nodiscard]] LinkParts partsOf(const Mechanism& mechanism, const ElementIndex& index, const LinkId& link);

/// The target of a link in rich text that stands for an element, and back.
[[nodiscard]] QString addressOf(const ElementId& element);
[[nodiscard]] ElementId elementAt(const QString& address);

}  // namespace geargraph::inline panels
