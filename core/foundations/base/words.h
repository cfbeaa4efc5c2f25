#pragma once

#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>

namespace geargraph::inline base {

/// Marks a text as one to be translated where it is shown, by translated(). A text in a table, for instance.
constexpr const char* toTranslate(const char* text) {
  return text;
}

/// A text for people in the language in use: that of the catalogue, else the text itself. With a literal it
/// marks it for extraction, too (the target "translations"). Never for names that files or scripts read. Safe
/// on all threads.
[[nodiscard]] std::string translated(const char* text);
/// A text that toTranslate() has marked elsewhere.
[[nodiscard]] std::string translated(std::string_view text);
/// In the plural form of `n`, which also takes the place of "%n". English: the literal with its "(s)" is for
/// translators; give both forms by the catalogue or choose between two texts.
[[nodiscard]] std::string translated(const char* text, int n);

/// A text with others in its places %1 to %9, as filled(): whole sentences, never halves that are put
/// together.
[[nodiscard]] std::string translated(const char* text, std::initializer_list<std::string_view> places);

/// Puts texts in the places %1 to %9 of a translated one, in whatever order its language has them.
[[nodiscard]] std::string filled(std::string_view text, std::initializer_list<std::string_view> places);

/// The translation of a text, of -1 or a count of things; empty where there is none. Called from all threads.
using Catalogue = std::function<std::string(const char* text, int n)>;

/// Where texts are looked up from now on; empty: nowhere, they are English. A program sets it at its start,
/// and when its user chooses another language. Safe while other threads look up.
void setCatalogue(Catalogue catalogue);

}  // namespace geargraph::inline base
