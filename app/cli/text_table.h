#pragma once

#include <string>
#include <vector>

namespace geargraph::cli {

/// The cells of a table, its heading first.
using TextRows = std::vector<std::vector<std::string>>;

/// The table in columns under a title, indented by two; empty where there is nothing but the heading.
/// @pre all rows have as many cells
[[nodiscard]] std::string aligned(const std::string& title, const TextRows& rows);

/// With six digits and no -0.
[[nodiscard]] std::string decimal(double value);

}  // namespace geargraph::cli
