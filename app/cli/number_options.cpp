#include "app/cli/number_options.h"

#include <algorithm>
#include <cmath>

#include "core/foundations/base/arithmetic.h"
#include "core/foundations/base/translation.h"

namespace geargraph::cli {

std::variant<TypedAngle, UsageError> angleOption(std::string_view option, std::string_view word) {
  const std::string_view value = word.substr(std::min(word.find('='), word.size() - 1) + 1);
  const auto angle = angleFromText(value);
  if (!angle && arithmeticFromText(value))
    return UsageError{translated("%1 needs the unit of its angle: %2deg or %2rad.", {option, word})};
  if (!angle) {
    return UsageError{
        translated("%1 is like 8=30deg, 8=1/2rad or 8=2turns: an input's label and its angle.", {option})};
  }
  if (!std::isfinite(angle->degrees.toDouble()) || !std::isfinite(angle->radians.toDouble())) {
    return UsageError{
        translated("The angle %1 is too large: no program could represent it, the largest number is "
                   "1.79e308. Leave out whole turns.",
                   {word})};
  }
  return *angle;
}

}  // namespace geargraph::cli
