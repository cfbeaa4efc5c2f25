#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "core/teaching/work_check/submitted_text.h"

namespace geargraph {

/// A range of the user's text, in bytes.
struct TextRange {
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// The user's text, with line and column of its pieces.
class SubmittedText {
 public:
  explicit SubmittedText(std::string_view text) : m_text(text), m_lineStarts{0} {
    for (std::size_t at = 0; at < text.size(); ++at) {
      if (text[at] == '\n') m_lineStarts.push_back(at + 1);
    }
  }

  [[nodiscard]] std::string_view all() const { return m_text; }
  [[nodiscard]] std::string_view text(TextRange range) const {
    return m_text.substr(range.begin, range.end - range.begin);
  }
  [[nodiscard]] TextRange trimmed(TextRange range) const {
    while (range.begin < range.end && isBlank(m_text[range.begin])) ++range.begin;
    while (range.end > range.begin && isBlank(m_text[range.end - 1])) --range.end;
    return range;
  }
  /// The text of the range without blanks at its ends, with its place. Cost: logarithmic in the lines, linear
  /// in the line.
  [[nodiscard]] WrittenCell piece(TextRange range) const {
    const TextRange inner = trimmed(range);
    WrittenCell cell = placeOf(inner.begin);
    cell.text = text(inner);
    return cell;
  }
  [[nodiscard]] Diagnostic fault(std::size_t at, std::string message) const {
    const WrittenCell place = placeOf(at);
    Diagnostic fault{Code::syntax, std::move(message), {}, {}};
    fault.line = place.line;
    fault.column = place.column;
    return fault;
  }
  [[nodiscard]] static bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

 private:
  [[nodiscard]] WrittenCell placeOf(std::size_t at) const {
    const auto next = std::upper_bound(m_lineStarts.begin(), m_lineStarts.end(), at);
    const std::size_t start = *std::prev(next);
    const auto characters =
        std::count_if(m_text.begin() + static_cast<std::ptrdiff_t>(start),
                      m_text.begin() + static_cast<std::ptrdiff_t>(std::min(at, m_text.size())),
                      [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; });
    return {{}, static_cast<int>(next - m_lineStarts.begin()), static_cast<int>(characters) + 1};
  }

  std::string_view m_text;
  std::vector<std::size_t> m_lineStarts;
};

/// The cells of a table by row, as ranges of the text.
using RangeRows = std::vector<std::vector<TextRange>>;

/// Rows separated by double backslashes, cells by ampersands, neither inside braces.
[[nodiscard]] RangeRows latexRows(const SubmittedText& text, TextRange body);
/// Rows separated by semicolons or line ends, cells by commas or by blanks that are not part of a sum.
[[nodiscard]] RangeRows bracketRows(const SubmittedText& text, TextRange body);
/// Rows separated by line ends, cells by the separator that the text uses; quotes as in CSV.
[[nodiscard]] RangeRows separatedRows(const SubmittedText& text);

}  // namespace geargraph
