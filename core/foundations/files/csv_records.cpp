#include "core/foundations/files/csv_records.h"

#include <algorithm>
#include <array>

#include "core/foundations/base/translation.h"
#include "core/foundations/files/utf8.h"

namespace geargraph {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

bool isBlank(char c) {
  return c == ' ' || c == '\t';
}

}  // namespace

CsvRecords::CsvRecords(std::string_view text, char separator) : m_text(text), m_separator(separator) {
  if (m_text.starts_with(kByteOrderMark)) m_at = kByteOrderMark.size();
}

void CsvRecords::moveTo(const Place& place) {
  m_at = place.offset;
  m_line = place.line;
  m_column = 1;
}

bool CsvRecords::next(std::vector<CsvField>& fields) {
  while (m_at < m_text.size() && atLineEnd()) passLineEnd();
  if (m_error || m_at == m_text.size()) return false;
  m_record = {m_at, m_line};
  m_count = 0;
  while (true) {
    CsvField beyond;
    if (m_count < kMaxFields && m_count == fields.size()) fields.emplace_back();
    if (!readField(m_count < kMaxFields ? fields[m_count] : beyond)) return false;
    ++m_count;
    if (m_at == m_text.size() || atLineEnd()) break;
    ++m_at;  // the separator
    ++m_column;
  }
  fields.resize(std::min(m_count, kMaxFields));
  if (m_at < m_text.size()) passLineEnd();
  return true;
}

bool CsvRecords::atLineEnd() const {
  return m_text[m_at] == '\n' || m_text[m_at] == '\r';
}

void CsvRecords::passLineEnd() {
  const bool isPair = m_text.substr(m_at).starts_with("\r\n");
  m_at += isPair ? 2 : 1;
  ++m_line;
  m_column = 1;
}

void CsvRecords::passBlanks() {
  while (m_at < m_text.size() && m_text[m_at] != m_separator && isBlank(m_text[m_at])) {
    ++m_at;
    ++m_column;
  }
}

bool CsvRecords::readField(CsvField& field) {
  field.text.clear();
  passBlanks();
  field.line = m_line;
  field.column = m_column;
  return m_at < m_text.size() && m_text[m_at] == '"' ? readQuoted(field) : readPlain(field);
}

bool CsvRecords::readQuoted(CsvField& field) {
  ++m_at;
  ++m_column;
  while (true) {
    if (m_at == m_text.size())
      return failAt(field.line, field.column, translated("The quote that begins here is never closed."));
    if (m_text[m_at] == '"') {
      const bool isDoubled = m_text.substr(m_at).starts_with("\"\"");
      m_at += isDoubled ? 2 : 1;
      m_column += isDoubled ? 2 : 1;
      if (!isDoubled) break;
      field.text += '"';
    } else if (atLineEnd()) {
      const std::size_t begin = m_at;
      passLineEnd();
      field.text += m_text.substr(begin, m_at - begin);
    } else if (!take(field.text)) {
      return false;
    }
  }
  passBlanks();
  if (m_at == m_text.size() || m_text[m_at] == m_separator || atLineEnd()) return true;
  return failAt(m_line, m_column,
                translated("A field ends with its closing quote; a quote inside a field is written twice."));
}

bool CsvRecords::readPlain(CsvField& field) {
  while (m_at < m_text.size() && m_text[m_at] != m_separator && !atLineEnd()) {
    if (m_text[m_at] == '"')
      return failAt(
          m_line, m_column,
          translated("A field with a quote in it is quoted as a whole, and the quote written twice."));
    if (!take(field.text)) return false;
  }
  while (!field.text.empty() && isBlank(field.text.back())) field.text.pop_back();
  return true;
}

bool CsvRecords::take(std::string& text) {
  const std::size_t length = utf8Length(m_text, m_at);
  if (length == 0) return failAt(m_line, m_column, translated("These bytes are not UTF-8."));
  text += m_text.substr(m_at, length);
  m_at += length;
  ++m_column;
  return true;
}

bool CsvRecords::failAt(int line, int column, std::string message) {
  m_error = Diagnostic{Code::syntax, std::move(message), {}, {}, line, column};
  return false;
}

char csvSeparatorOf(std::string_view text) {
  constexpr std::array kSeparators = {',', ';', '\t'};
  std::array<std::size_t, kSeparators.size()> counts{};
  bool isQuoted = false;
  const std::size_t first = std::min(text.find_first_not_of("\r\n"), text.size());
  for (const char c : text.substr(first)) {
    if (c == '"') isQuoted = !isQuoted;
    if (isQuoted) continue;
    if (c == '\n' || c == '\r') break;
    for (std::size_t i = 0; i < kSeparators.size(); ++i) counts.at(i) += c == kSeparators.at(i) ? 1 : 0;
  }
  const auto most = std::max_element(counts.begin(), counts.end());
  return kSeparators.at(static_cast<std::size_t>(most - counts.begin()));
}

std::string csvField(std::string_view text, char separator) {
  const bool hasBlankEnd = !text.empty() && (isBlank(text.front()) || isBlank(text.back()));
  const bool isSpecial = text.find_first_of("\"\r\n") != std::string_view::npos ||
                         text.find(separator) != std::string_view::npos;
  if (!hasBlankEnd && !isSpecial) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

}  // namespace geargraph
