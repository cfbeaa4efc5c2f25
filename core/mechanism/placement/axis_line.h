#pragma once

#include <vector>

#include "core/foundations/base/triple.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph {

[[nodiscard]] inline ExactVector3 toFractions(const NumberTriple& triple) {
  return {triple[0].exact(), triple[1].exact(), triple[2].exact()};
}
[[nodiscard]] inline Vector3 toDoubles(const NumberTriple& triple) {
  return {triple[0].value(), triple[1].value(), triple[2].value()};
}

/// The same direction with 1 as its largest component, so that its doubles neither overflow nor vanish.
/// @pre not 0
[[nodiscard]] ExactVector3 scaledToOne(const ExactVector3& direction);
/// The unit vector of a direction of any length that a document can have. @pre not 0
[[nodiscard]] Vector3 unitDirection(const NumberTriple& direction);
[[nodiscard]] Vector3 unitDirection(const ExactVector3& direction);

/// A line in fractions; the direction is of any length.
struct ExactLine {
  ExactVector3 point;
  ExactVector3 direction;
};

/// The line of an axis in the reference pose, base frame.
struct AxisLine {
  Vector3 point{};
  Vector3 direction{0, 0, 1};  ///< of length 1
  bool automatic = false;      ///< point or direction chosen by the program
  int chosen = -1;             ///< automatic: position in Placement::chosen; -1: the line is the document's
};

/// The lines given in the document, by axis; one that it leaves open is at the origin and marked automatic.
[[nodiscard]] ByAxis<AxisLine> givenLines(const Mechanism& mechanism);

}  // namespace geargraph
