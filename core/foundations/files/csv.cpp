#include "core/foundations/files/csv.h"

#include <algorithm>
#include <cmath>

#include "core/foundations/base/contract.h"

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

CsvWriter::CsvWriter(ByteSink& sink, std::span<const std::string> columnLabels, const CsvOptions& options)
    : m_sink(sink),
      m_options(options),
      m_columns(columnLabels.size()),
      m_templateFields(std::max(m_columns, kSlack)),
      m_zeros(repeated(std::string("0") + options.separator, m_templateFields)),
      m_ones(repeated(std::string("1") + options.separator, m_templateFields)),
      m_minusOnes(repeated(std::string("-1") + options.separator, m_templateFields)),
      m_buffer(kChunk) {
  if (options.byteOrderMark) append("\xEF\xBB\xBF");
  if (!options.labels) return;
  for (const std::string& label : columnLabels) {
    append(options.separator + csvLabel(label, options.separator));
  }
  append("\n");
}

char* CsvWriter::putReal(char* out, double value) const {
  GEARGRAPH_REQUIRE(std::isfinite(value));
  const bool isQuoted = m_options.decimalPoint == m_options.separator;
  char* const begin = isQuoted ? out + 1 : out;
  char* end = std::to_chars(begin, begin + kMaxRealLength - 3, value).ptr;
  char* const point = m_options.decimalPoint == '.' ? end : std::find(begin, end, '.');
  if (point != end) {
    *point = m_options.decimalPoint;
    if (isQuoted) {
      *out = '"';
      *end++ = '"';
    }
  } else if (isQuoted) {  // no decimal point after all
    std::memmove(out, begin, static_cast<std::size_t>(end - begin));
    --end;
  }
  *end++ = m_options.separator;
  return end;
}

void CsvWriter::row(std::string_view label, std::span<const double> values) {
  GEARGRAPH_REQUIRE(values.size() == m_columns);
  beginRow(label);
  if (m_columns == 0) return;
  char* const begin = reserve(values.size() * kMaxRealLength);
  char* out = begin;
  for (const double value : values) out = putReal(out, value);
  out[-1] = '\n';  // in place of the last separator
  m_used += static_cast<std::size_t>(out - begin);
}

void CsvWriter::signRow(std::string_view label, std::span<const std::uint64_t> columns, int sign) {
  GEARGRAPH_REQUIRE(columns.size() == (m_columns + 63) / 64);
  beginRow(label);
  if (m_columns == 0) return;
  const SignFields& fields = signFields(sign);
  char* const begin = reserve(3 * m_columns + kSlack);
  char* out = begin;
  const std::size_t whole = m_columns / 64;
  for (std::size_t i = 0; i < whole;) {
    const std::uint64_t word = columns[i];
    if (word == 0 || word == ~std::uint64_t{0}) {
      std::size_t end = i + 1;
      while (end < whole && columns[end] == word) ++end;
      const std::string& run = word == 0 ? m_zeros : (sign < 0 ? m_minusOnes : m_ones);
      out = copyFields(out, run, 64 * (end - i), run.size() / m_templateFields);
      i = end;
      continue;
    }
    ++i;
    for (unsigned shift = 0; shift < 64; shift += 8) {
      const std::size_t byte = (word >> shift) & 0xFFU;
      std::memcpy(out, fields.text[byte].data(), kSlack);
      out += fields.length[byte];
    }
  }
  for (std::size_t column = 64 * whole; column < m_columns; ++column) {
    if ((columns[whole] >> (column % 64) & 1U) != 0) {
      if (sign < 0) *out++ = '-';
      *out++ = '1';
    } else {
      *out++ = '0';
    }
    *out++ = m_options.separator;
  }
  out[-1] = '\n';  // in place of the last separator
  m_used += static_cast<std::size_t>(out - begin);
}

const CsvWriter::SignFields& CsvWriter::signFields(int sign) {
  if (m_signFields.sign == sign) return m_signFields;
  m_signFields.sign = sign;
  for (std::size_t byte = 0; byte < 256; ++byte) {
    std::string text;
    for (unsigned bit = 0; bit < 8; ++bit) {
      text += (byte >> bit & 1U) == 0 ? "0" : (sign < 0 ? "-1" : "1");
      text += m_options.separator;
    }
    std::copy(text.begin(), text.end(), m_signFields.text[byte].begin());
    m_signFields.length[byte] = static_cast<std::uint8_t>(text.size());
  }
  return m_signFields;
}

void CsvWriter::beginRow(std::string_view label) {
  if (m_options.labels) append(csvLabel(label, m_options.separator));
  if (m_columns == 0) {
    append("\n");
  } else if (m_options.labels) {
    append({&m_options.separator, 1});
  }
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
