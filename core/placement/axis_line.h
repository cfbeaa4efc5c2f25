#pragma once

#include <memory>
#include <vector>

#include "core/base/triple.h"
#include "core/mechanism/mechanism.h"

namespace geargraph {

/// A line in fractions; the direction is of any length.
struct ExactLine {
  ExactVector3 point;
  ExactVector3 direction;
};

/// Where an axis lies in the reference pose, base frame.
struct AxisLine {
  Vector3 point{};
  Vector3 direction{0, 0, 1};               ///< of length 1
  bool automatic = false;                   ///< point or direction chosen by the program
  std::shared_ptr<const ExactLine> chosen;  ///< where it was; null for a given line, which the document has
};

/// The lines that the document gives, by axis; one that it leaves open stands at the origin and is automatic.
[[nodiscard]] std::vector<AxisLine> givenLines(const Mechanism& mechanism);

/// The line in fractions: as chosen, or as written in the document.
[[nodiscard]] ExactLine exactLine(const Mechanism& mechanism, const AxisLine& line, int axis);

}  // namespace geargraph
