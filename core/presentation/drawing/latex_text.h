#pragma once

#include <string>
#include <string_view>

namespace geargraph {

/// Plain text in a LaTeX document: what LaTeX reads as a command is escaped, and signs that not every LaTeX
/// engine has in its text faces become commands.
[[nodiscard]] std::string escapedLatex(std::string_view text);

}  // namespace geargraph
