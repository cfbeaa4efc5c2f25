#include "core/foundations/base/readable.h"

#include <cstdio>

#include "core/foundations/base/locale.h"

namespace geargraph {

bool isLongFraction(std::string_view number) {
  return number.size() > kMaxReadableFraction && number.find('/') != std::string_view::npos;
}

std::string readableNumber(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.6g", value == 0 ? 0.0 : value);
  return localizedNumber(buffer);
}

std::string readableNumber(const Rational& value) {
  std::string text = value.toString();
  return isLongFraction(text) ? readableNumber(value.toDouble()) : text;
}

}  // namespace geargraph
