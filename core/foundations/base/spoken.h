#pragma once

#include <string>

namespace geargraph::inline base {

/// While one lives, the texts that its thread composes are English, with decimal points: those that files and
/// scripts read, in every language of the window.
class InEnglish {
 public:
  InEnglish();
  ~InEnglish();
  InEnglish(const InEnglish&) = delete;
  InEnglish& operator=(const InEnglish&) = delete;
};

/// No catalogue is in use for the texts that are composed on this thread now.
[[nodiscard]] bool isEnglish();

/// A number in a text for people: "12.5" with the decimal sign in use in place of its point.
/// @pre `number` is a number, as programs write it
[[nodiscard]] std::string spokenNumber(std::string number);

/// The same in TeX: "12{,}5".
[[nodiscard]] std::string spokenTexNumber(std::string number);

/// The decimal sign from now on; a point at first. Set with the catalogue. Safe while other threads read it.
void setDecimalSign(char sign);
/// That of texts which are composed on this thread now.
[[nodiscard]] char decimalSign();

}  // namespace geargraph::inline base
