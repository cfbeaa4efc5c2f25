#pragma once

#include <optional>
#include <vector>

#include "core/teaching/exercises/exercise_source.h"
#include "core/teaching/grading/number_text.h"

namespace geargraph {

/// A gear of a link in one mesh.
struct LinkGear {
  int teeth = 0;
  std::optional<Rational> diameter = {};  ///< pitch diameter in the document's unit, if it is a fraction
};

/// The gears of the link with this label, in the order of its meshes.
[[nodiscard]] std::vector<LinkGear> gearsOfLink(const ExerciseSource& source, int label);

/// Names in which numbers of this mechanism may be written, with their values: ratios i15, n41 and n14, teeth
/// N4 and pitch diameters d4 (N7' and N7'' for the meshes of a link in their order).
[[nodiscard]] NumberSymbols numberSymbols(const ExerciseSource& source);

}  // namespace geargraph
