#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "app/cli/arguments.h"

namespace geargraph::cli {

/// Removes `--language` from the words and returns its value, "de"; std::nullopt if it is not among them.
[[nodiscard]] std::variant<std::optional<std::string>, UsageError> takeLanguage(
    std::vector<std::string>& words);

/// The language code of a locale, "de" for "de_DE.UTF-8", if the program has that language; else "en".
[[nodiscard]] std::string languageOfLocale(std::string_view locale);

/// Sets the language of texts for people: the named one, else that of the environment (LC_ALL, LC_MESSAGES,
/// LANG). JSON and the answers to `serve` are always English. The language of the environment does not apply
/// to exercises, because they are graded in the language in which they were made.
void speakLanguage(const std::optional<std::string>& named, const std::vector<std::string>& words);

}  // namespace geargraph::cli
