#pragma once

#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>

namespace geargraph {

/// Marks a text for extraction that is translated later, where it is shown, by translated(): for instance a
/// text in a table.
constexpr const char* toTranslate(const char* text) {
  return text;
}

/// The text in the current language from the catalogue, else the text itself. A literal is also marked for
/// extraction (the target "translations"). Never for names that files or scripts read. Thread-safe.
[[nodiscard]] std::string translated(const char* text);
/// For a text that toTranslate() has marked elsewhere.
[[nodiscard]] std::string translated(std::string_view text);
/// The plural form for `n`, which also replaces "%n". In English the literal with its "(s)" is for
/// translators only: provide both forms by the catalogue, or choose between two texts.
[[nodiscard]] std::string translated(const char* text, int n);

/// The translation with its placeholders %1 to %9 filled: for whole sentences, never for concatenated parts.
[[nodiscard]] std::string translated(const char* text, std::initializer_list<std::string_view> places);

/// Replaces the placeholders %1 to %9 of a text, which may be in any order.
[[nodiscard]] std::string filled(std::string_view text, std::initializer_list<std::string_view> places);

/// Returns the translation of a text, in the plural form for n, or with n = -1 without one; empty if there is
/// none. Called from any thread.
using Catalogue = std::function<std::string(const char* text, int n)>;

/// Sets the catalogue for translated(); empty: texts stay English. Set it at the start of a program, and when
/// the user chooses another language. Thread-safe.
void setCatalogue(Catalogue catalogue);

}  // namespace geargraph
