#pragma once

#include <span>

namespace geargraph {

/// A text that the page's script shows, in English, with its placeholders %1 to %9.
struct ScriptText {
  const char* name;  ///< by which the script asks for it: say('print')
  const char* text;  ///< marked by toTranslate()
};

/// All texts of the script for people. A page holds their translations with its data, so that the script,
/// whose hash the page's policy names, is the same in every language.
[[nodiscard]] std::span<const ScriptText> scriptTexts();

}  // namespace geargraph
