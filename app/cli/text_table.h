#pragma once

#include <string>
#include <vector>

namespace geargraph::cli {

/// The rows of a table, the headings first.
using TextRows = std::vector<std::vector<std::string>>;

/// The table with aligned columns under a title, indented by two spaces; empty if it has only headings. @pre
/// all rows have the same number of cells
[[nodiscard]] std::string aligned(const std::string& title, const TextRows& rows);

}  // namespace geargraph::cli
