#pragma once

#include <vector>

#include "core/foundations/base/triple.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph::inline placement {

[[nodiscard]] inline ExactVector3 toFractions(const NumberTriple& triple) {
  return {triple[0].exact(), triple[1].exact(), triple[2].exact()};
}
[[nodiscard]] inline Vector3 toDoubles(const NumberTriple& triple) {
  return {triple[0].value(), triple[1].value(), triple[2].value()};
}

/// The same direction with 1 as its largest component, so that its doubles neither overflow nor vanish.
/// @pre not 0
[[nodiscard]] ExactVector3 scaledToOne(const ExactVector3& direction);
/// The direction with length 1, of any length that a document can give. @pre not 0
[[nodiscard]] Vector3 unitDirection(const NumberTriple& direction);
[[nodiscard]] Vector3 unitDirection(const ExactVector3& direction);

/// A line in fractions; the direction is of any length.
struct ExactLine {
  ExactVector3 point;
  ExactVector3 direction;
};

/// Where an axis lies in the reference pose, base frame.
struct AxisLine {
  Vector3 point{};
  Vector3 direction{0, 0, 1};  ///< of length 1
  bool automatic = false;      ///< point or direction chosen by the program
  int chosen = -1;  ///< where it was: its place in Placement::chosen; else the document has the line
};

/// The lines that the document gives, by axis; one that it leaves open stands at the origin and is automatic.
[[nodiscard]] std::vector<AxisLine> givenLines(const Mechanism& mechanism);

}  // namespace geargraph::inline placement
