#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "app/cli/arguments.h"

namespace geargraph::cli {

/// The language that `--language` names, "de", which is taken out of the words; none where it is not there.
[[nodiscard]] std::variant<std::optional<std::string>, UsageError> takeLanguage(
    std::vector<std::string>& words);

/// The two letters of a locale, "de" of "de_DE.UTF-8", where the program speaks that language; else "en".
[[nodiscard]] std::string languageOfLocale(std::string_view locale);

/// From now on texts for people are in the language that was named, else in that of the environment (LC_ALL,
/// LC_MESSAGES, LANG). JSON is English in any case, and so are answers to `serve`; exercises are in the
/// language of the environment only where it is named, as they are graded in the language that they were made
/// in.
void speakLanguage(const std::optional<std::string>& named, const std::vector<std::string>& words);

}  // namespace geargraph::cli
