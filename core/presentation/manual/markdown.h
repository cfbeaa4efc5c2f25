#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace geargraph::inline manual {

/// Markdown as GitHub writes it, with tables and with formulas between dollar signs, as the inside of an HTML
/// page. Formulas become <x-equation>TeX</x-equation>, with type="display" where they have a line of their
/// own. Cost: linear in its length.
[[nodiscard]] std::string htmlOfMarkdown(std::string_view markdown);

/// A text of which Markdown takes nothing as a sign of its own.
[[nodiscard]] std::string escapedMarkdown(std::string_view text);

/// HTML in which every element of this name is replaced by what `replacement` makes of its attributes, as
/// they are written, and of what is inside. @pre elements of this name are not nested, as htmlOfMarkdown()
/// writes them
[[nodiscard]] std::string withElements(
    std::string_view html, std::string_view name,
    const std::function<std::string(std::string_view attributes, std::string_view inside)>& replacement);

/// The value of an attribute, unescaped; empty where it is missing.
[[nodiscard]] std::string attributeOf(std::string_view attributes, std::string_view name);

/// The words of HTML: without tags, entities as the characters they stand for. Formulas are left out.
[[nodiscard]] std::string plainTextOf(std::string_view html);

}  // namespace geargraph::inline manual
