#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace geargraph {

/// The length of the well-formed UTF-8 character that starts at `at`, 1 to 4 bytes; 0 if there is none
/// (overlong forms, surrogates and truncated characters are invalid). @pre at < text.size()
[[nodiscard]] std::size_t utf8Length(std::string_view text, std::size_t at);

/// The number of characters (code points) of a text; every invalid byte counts as one.
[[nodiscard]] std::size_t utf8Count(std::string_view text);

/// Appends a code point. @pre at most 0x10FFFF and no surrogate
void appendUtf8(std::string& text, std::uint32_t codePoint);

}  // namespace geargraph
