#include "app/cli/number_options.h"

#include <string>

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

}  // namespace geargraph::cli
