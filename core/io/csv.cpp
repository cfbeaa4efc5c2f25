#include "core/io/csv.h"

#include <array>
#include <cmath>

#include "core/base/contract.h"

namespace geargraph {
namespace {

std::string repeated(std::string_view field, std::size_t times) {
  std::string result;
  result.reserve(field.size() * times);
  for (std::size_t i = 0; i < times; ++i) result += field;
  return result;
}

std::string quotedIfNeeded(std::string field, char separator) {
  if (field.find_first_of(std::string("\"\r\n") + separator) == std::string::npos) return field;
  std::string quoted = "\"";
  for (const char c : field) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

}  // namespace

std::string csvLabel(std::string_view text, char separator) {
  const bool isFormula =
      !text.empty() && std::string_view("=+-@\t\r").find(text.front()) != std::string_view::npos;
  return quotedIfNeeded((isFormula ? "'" : "") + std::string(text), separator);
}

std::string csvNumber(double value, const CsvOptions& options) {
  GEARGRAPH_REQUIRE(std::isfinite(value));
  std::array<char, 32> digits{};
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  GEARGRAPH_REQUIRE(error == std::errc{});
  std::replace(digits.data(), end, '.', options.decimalPoint);
  return quotedIfNeeded(std::string(digits.data(), end), options.separator);
}

CsvWriter::CsvWriter(ByteSink& sink, std::span<const std::string> columnLabels, const CsvOptions& options)
    : m_sink(sink),
      m_options(options),
      m_columns(columnLabels.size()),
      m_zeros(repeated(std::string("0") + options.separator, std::max(m_columns, kSlack))),
      m_minusOnes(repeated(std::string("-1") + options.separator, std::max(m_columns, kSlack))),
      m_buffer(kChunk) {
  if (options.byteOrderMark) append("\xEF\xBB\xBF");
  if (!options.labels) return;
  for (const std::string& label : columnLabels) {
    append(options.separator + csvLabel(label, options.separator));
  }
  append("\n");
}

void CsvWriter::row(std::string_view label, std::span<const double> values) {
  GEARGRAPH_REQUIRE(values.size() == m_columns);
  std::string line = m_options.labels ? csvLabel(label, m_options.separator) : std::string();
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0 || m_options.labels) line += m_options.separator;
    line += csvNumber(values[i], m_options);
  }
  append(line + '\n');
}

char* CsvWriter::reserve(std::size_t bytes) {
  if (m_used + bytes > m_buffer.size()) {
    flush();
    if (bytes > m_buffer.size()) m_buffer.resize(bytes);
  }
  return m_buffer.data() + m_used;
}

void CsvWriter::append(std::string_view bytes) {
  std::memcpy(reserve(bytes.size()), bytes.data(), bytes.size());
  m_used += bytes.size();
}

void CsvWriter::flush() {
  if (m_used > 0) m_sink.write({m_buffer.data(), m_used});
  m_used = 0;
}

}  // namespace geargraph
