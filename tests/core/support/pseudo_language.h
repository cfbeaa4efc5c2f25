#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/foundations/base/translation.h"

namespace geargraph::test {

/// A language in which every letter of a looked-up text wears an accent, so that English that was never
/// looked up shows: also where it stands in the place of a translated sentence.
class PseudoLanguage {
 public:
  PseudoLanguage() {
    setCatalogue([](const char* text, int /*n*/) { return accented(text); });
  }
  ~PseudoLanguage() { setCatalogue(nullptr); }
  PseudoLanguage(const PseudoLanguage&) = delete;
  PseudoLanguage& operator=(const PseudoLanguage&) = delete;

  static std::string accented(std::string_view text) {
    std::string result;
    bool isFormula = false;
    for (const char c : text) {
      if (c == '$') isFormula = !isFormula;
      result += c;
      if (!isFormula && isLetter(c)) result += kAccent;
    }
    return result;
  }

  /// The words of three letters or more that were not looked up, apart from formulas ($...$) and `names`.
  static std::vector<std::string> english(std::string_view text, const std::vector<std::string>& names = {}) {
    std::vector<std::string> words;
    std::string word;
    bool isFormula = false;
    const auto end = [&] {
      bool isName = word.size() < 3;
      for (const std::string& name : names) isName = isName || name.find(word) != std::string::npos;
      if (!isName) words.push_back(word);
      word.clear();
    };
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (text[i] == '$') isFormula = !isFormula;
      if (isFormula) continue;
      const bool isAccented = text.substr(i + 1).starts_with(kAccent);
      if (isLetter(text[i]) && !isAccented) {
        word += text[i];
      } else {
        end();
        if (isAccented) i += kAccent.size();
      }
    }
    end();
    return words;
  }

 private:
  static constexpr std::string_view kAccent = "\u0301";
  static bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
};

}  // namespace geargraph::test
