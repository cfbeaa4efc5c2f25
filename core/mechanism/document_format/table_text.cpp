#include "core/mechanism/document_format/table_text.h"

#include <algorithm>

namespace geargraph {
namespace {

/// Any number of apostrophes, then what begins a formula?
bool isFormulaBehindApostrophes(std::string_view text) {
  const std::size_t first = text.find_first_not_of('\'');
  return first != std::string_view::npos &&
         std::string_view("=+-@\t\r").find(text[first]) != std::string_view::npos;
}

}  // namespace

std::string guardedText(std::string_view text) {
  return (isFormulaBehindApostrophes(text) ? "'" : "") + std::string(text);
}

std::string unguardedText(std::string_view cell) {
  if (cell.starts_with('\'') && isFormulaBehindApostrophes(cell)) cell.remove_prefix(1);
  return std::string(cell);
}

std::string joinedTexts(const std::vector<std::string>& texts) {
  std::string cell;
  for (const std::string& text : texts) {
    if (!cell.empty()) cell += '|';
    for (const char c : text) {
      if (c == '|' || c == '\\') cell += '\\';
      cell += c;
    }
  }
  return cell;
}

std::vector<std::string> splitTexts(std::string_view cell) {
  std::vector<std::string> texts;
  if (cell.empty()) return texts;
  texts.emplace_back();
  for (std::size_t i = 0; i < cell.size(); ++i) {
    if (cell[i] == '|') {
      texts.emplace_back();
    } else {
      if (cell[i] == '\\' && i + 1 < cell.size()) ++i;
      texts.back() += cell[i];
    }
  }
  return texts;
}

}  // namespace geargraph
