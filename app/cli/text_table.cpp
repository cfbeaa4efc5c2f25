#include "app/cli/text_table.h"

#include <algorithm>

#include "core/foundations/files/utf8.h"

namespace geargraph::cli {

std::string aligned(const std::string& title, const TextRows& rows) {
  if (rows.size() <= 1) return {};
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const auto& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], utf8Count(row[i]));
  std::string result = title + "\n";
  for (const auto& row : rows) {
    std::string line = "  ";
    for (std::size_t i = 0; i < row.size(); ++i)
      line += row[i] + std::string(widths[i] - utf8Count(row[i]) + 2, ' ');
    line.erase(line.find_last_not_of(' ') + 1);
    result += line + '\n';
  }
  return result;
}

}  // namespace geargraph::cli
