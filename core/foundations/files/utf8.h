#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace geargraph::inline files {

/// Bytes of the well-formed UTF-8 character that starts at `at`, 1 to 4; 0 where the bytes are none (overlong
/// forms, surrogates and cut-off characters are none). @pre at < text.size()
[[nodiscard]] std::size_t utf8Length(std::string_view text, std::size_t at);

/// Characters (code points) of a text; every byte that starts no character counts as one.
[[nodiscard]] std::size_t utf8Count(std::string_view text);

/// Appends a code point. @pre it is one: at most 0x10FFFF and no surrogate
void appendUtf8(std::string& text, std::uint32_t codePoint);

}  // namespace geargraph::inline files
