#include "core/presentation/exporters/number_options.h"

#include <algorithm>
#include <string>

#include "core/foundations/base/translation.h"

namespace geargraph {

std::variant<double, UsageError> numberWithin(const OptionValues& given, std::string_view option,
                                              double otherwise, double least, double most) {
  const auto text = given.value(option);
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

}  // namespace geargraph
