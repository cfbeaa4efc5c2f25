#pragma once

#include <string>

namespace geargraph {

/// During its lifetime, texts composed on its thread are English, with decimal points, whatever the current
/// language: for texts that files and scripts read.
class EnglishScope {
 public:
  EnglishScope();
  ~EnglishScope();
  EnglishScope(const EnglishScope&) = delete;
  EnglishScope& operator=(const EnglishScope&) = delete;
};

/// Is no catalogue in use for texts composed on this thread now?
[[nodiscard]] bool isEnglish();

/// A number in a text for people: "12.5" with the current decimal sign instead of the point.
/// @pre `number` is a number with a decimal point, if any
[[nodiscard]] std::string localizedNumber(std::string number);

/// The same for TeX: "12{,}5".
[[nodiscard]] std::string spokenTexNumber(std::string number);

/// Sets the decimal sign, initially a point. Set it together with the catalogue. Thread-safe.
void setDecimalSign(char sign);
/// The decimal sign of texts composed on this thread now.
[[nodiscard]] char decimalSign();

}  // namespace geargraph
