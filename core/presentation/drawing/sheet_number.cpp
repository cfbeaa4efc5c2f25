#include "core/presentation/drawing/sheet_number.h"

#include <array>
#include <charconv>
#include <cmath>

#include "core/foundations/base/contract.h"

namespace geargraph {

std::string sheetNumber(double value) {
  GEARGRAPH_REQUIRE(std::isfinite(value));
  std::array<char, 320> text{};  // the largest double has 309 digits
  const auto [end, error] =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, 2);
  GEARGRAPH_REQUIRE(error == std::errc{});
  std::string out(text.data(), end);
  out.erase(out.find_last_not_of('0') + 1);
  if (out.back() == '.') out.pop_back();
  return out == "-0" ? "0" : out;
}

}  // namespace geargraph
