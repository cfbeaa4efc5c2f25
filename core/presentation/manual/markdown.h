#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace geargraph {

/// GitHub Flavored Markdown with formulas between dollar signs, converted to the body of an HTML page.
/// Formulas become <x-equation>TeX</x-equation>, with type="display" if they are on a line of their own.
/// Cost: linear in its length.
[[nodiscard]] std::string htmlOfMarkdown(std::string_view markdown);

/// The text with all characters escaped that have a meaning in Markdown.
[[nodiscard]] std::string escapedMarkdown(std::string_view text);

/// Replaces every HTML element of this name by replacement(attributes, inside), both as written.
/// @pre elements of this name are not nested; htmlOfMarkdown() never nests them
[[nodiscard]] std::string withElements(
    std::string_view html, std::string_view name,
    const std::function<std::string(std::string_view attributes, std::string_view inside)>& replacement);

/// The value of an attribute, unescaped; empty where it is missing.
[[nodiscard]] std::string attributeOf(std::string_view attributes, std::string_view name);

/// The text of HTML: without tags and formulas, with entities decoded.
[[nodiscard]] std::string plainTextOf(std::string_view html);

}  // namespace geargraph
