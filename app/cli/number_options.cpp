#include "app/cli/number_options.h"

#include <string>

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
  return UsageError{std::string(option) + " takes a number from " + shown(least) + " to " + shown(most) +
                    ", not \"" + *text + "\"."};
}

}  // namespace geargraph::cli
