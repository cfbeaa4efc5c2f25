#include "app/cli/number_options.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/foundations/base/arithmetic.h"
#include "core/foundations/base/words.h"

namespace geargraph::cli {

std::variant<double, UsageError> numberWithin(const Arguments& arguments, std::string_view option,
                                              double otherwise, double least, double most) {
  const auto text = arguments.value(option);
  if (!text) return otherwise;
  const auto value = numberFrom<double>(*text);
  if (value && *value >= least && *value <= most) return *value;
  const auto shown = [](double bound) {
    std::string digits = std::to_string(bound);
    digits.erase(digits.find_last_not_of('0') + 1);
    return digits.back() == '.' ? digits.substr(0, digits.size() - 1) : digits;
  };
  return UsageError{
      translated("%1 takes a number from %2 to %3, not \"%4\".", {option, shown(least), shown(most), *text})};
}

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

std::optional<NumberTriple> tripleFrom(
    std::string_view text, const std::function<std::optional<Number>(std::string_view text)>& read) {
  NumberTriple triple;
  for (std::size_t i = 0; i < triple.size(); ++i) {
    const std::size_t comma = i + 1 < triple.size() ? text.find(',') : text.size();
    if (comma == std::string_view::npos) return std::nullopt;
    const std::optional<Number> number = read(text.substr(0, comma));
    if (!number) return std::nullopt;
    triple.at(i) = *number;
    text.remove_prefix(std::min(comma + 1, text.size()));
  }
  return triple;
}

}  // namespace geargraph::cli
