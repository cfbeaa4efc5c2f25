#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/foundations/files/byte_sink.h"

namespace geargraph {

/// The format of a table. Lines end with a line feed, which both spreadsheet programs and scripts accept.
struct CsvOptions {
  char separator = ',';        ///< ',' ';' or a tab
  char decimalPoint = '.';     ///< '.' or ','
  bool labels = true;          ///< a header row and a first column of labels
  bool byteOrderMark = false;  ///< EF BB BF, by which spreadsheet programs recognise UTF-8
};

/// One text as a field [RFC 4180]: quoted if it contains the separator, a quote or a line end. A text that a
/// spreadsheet program would take for a formula (it begins with = + - @, a tab or a return) gets an
/// apostrophe in front.
[[nodiscard]] std::string csvLabel(std::string_view text, char separator);

/// Writes a table row by row, in chunks, at about the speed of a disk: zeros are copied in long pieces from a
/// template "0,0,0,", runs of -1 from another, and only other values are formatted. The owner of the sink
/// checks it for failure at the end.
/// Cost: about that of write() on the same bytes.
class CsvWriter {
 public:
  /// Writes the header row, if there is one.
  CsvWriter(ByteSink& sink, std::span<const std::string> columnLabels, const CsvOptions& options);
  ~CsvWriter() { flush(); }
  CsvWriter(const CsvWriter&) = delete;
  CsvWriter& operator=(const CsvWriter&) = delete;

  /// Writes a row of integers from its non-zeros: anything with `column` and `value`, in column order.
  template <class Entry>
  void row(std::string_view label, std::span<const Entry> entries);
  /// Writes a row whose non-zeros all equal `sign`: where bit j % 64 of word j / 64 is set. The fastest way:
  /// fields are copied eight columns at a time. @pre sign is 1 or -1, a word for each 64 columns
  void signRow(std::string_view label, std::span<const std::uint64_t> columns, int sign);
  /// Writes a row of real numbers: each as the shortest decimal that reads back as the same double, quoted if
  /// its decimal point is the separator. @pre one per column, all finite
  void row(std::string_view label, std::span<const double> values);
  /// Writes a row of real numbers from its non-zeros: anything with `column` and `value`, in column order.
  /// @pre all finite
  /// Cost: that of copying its zeros, and some 50 ns for each non-zero.
  template <class Entry>
  void sparseRow(std::string_view label, std::span<const Entry> entries);

  /// True if nothing more can be written; a long loop may stop.
  [[nodiscard]] bool failed() const { return m_sink.failed(); }

 private:
  static constexpr std::size_t kChunk = std::size_t{1} << 18U;
  static constexpr std::size_t kMaxFieldLength = 12;  // "-2147483648,"
  static constexpr std::size_t kMaxRealLength = 32;   // 24 characters, quotes and separator
  static constexpr std::size_t kSlack = 32;           // short runs are copied with more than they have

  /// The text of eight columns, by the bits of the non-zeros.
  struct SignFields {
    int sign = 0;
    std::array<std::array<char, kSlack>, 256> text{};
    std::array<std::uint8_t, 256> length{};
  };
  const SignFields& signFields(int sign);

  /// Writes the label and its separator, if there are labels.
  void beginRow(std::string_view label);
  /// Writes a number and a separator. @pre there is room for kMaxRealLength more bytes
  char* putReal(char* out, double value) const;
  /// Ensures space for `bytes` more bytes and returns a pointer to it.
  char* reserve(std::size_t bytes);
  void append(std::string_view bytes);
  void flush();
  /// Copies `count` fields of a template, whose fields have `width` bytes.
  static char* copyFields(char* out, const std::string& fields, std::size_t count, std::size_t width) {
    const std::size_t bytes = count * width;
    if (bytes <= kSlack) {
      std::memcpy(out, fields.data(), kSlack);  // of a known length, so no call
    } else {
      std::memcpy(out, fields.data(), bytes);
    }
    return out + bytes;
  }

  ByteSink& m_sink;
  CsvOptions m_options;
  std::size_t m_columns;
  std::size_t m_templateFields;
  std::string m_zeros;      ///< "0,0,0," and so on, for all columns
  std::string m_ones;       ///< "1,1,1,"
  std::string m_minusOnes;  ///< "-1,-1,-1,"
  SignFields m_signFields;
  std::vector<char> m_buffer;
  std::size_t m_used = 0;
};

template <class Entry>
void CsvWriter::row(std::string_view label, std::span<const Entry> entries) {
  beginRow(label);
  if (m_columns == 0) return;
  char* const begin = reserve(m_zeros.size() + entries.size() * kMaxFieldLength + kSlack);
  char* out = begin;
  std::size_t column = 0;
  for (std::size_t i = 0; i < entries.size();) {
    const auto at = static_cast<std::size_t>(entries[i].column);
    out = copyFields(out, m_zeros, at - column, 2);
    if (entries[i].value == -1) {
      std::size_t run = 1;
      while (i + run < entries.size() && entries[i + run].value == -1 &&
             static_cast<std::size_t>(entries[i + run].column) == at + run) {
        ++run;
      }
      out = copyFields(out, m_minusOnes, run, 3);
      i += run;
      column = at + run;
    } else {
      out = std::to_chars(out, out + kMaxFieldLength, entries[i].value).ptr;
      *out++ = m_options.separator;
      ++i;
      column = at + 1;
    }
  }
  out = copyFields(out, m_zeros, m_columns - column, 2);
  out[-1] = '\n';  // in place of the last separator
  m_used += static_cast<std::size_t>(out - begin);
}

template <class Entry>
void CsvWriter::sparseRow(std::string_view label, std::span<const Entry> entries) {
  beginRow(label);
  if (m_columns == 0) return;
  char* const begin = reserve(m_zeros.size() + entries.size() * kMaxRealLength + kSlack);
  char* out = begin;
  std::size_t column = 0;
  for (const Entry& entry : entries) {
    const auto at = static_cast<std::size_t>(entry.column);
    out = copyFields(out, m_zeros, at - column, 2);
    out = putReal(out, entry.value);
    column = at + 1;
  }
  out = copyFields(out, m_zeros, m_columns - column, 2);
  out[-1] = '\n';  // in place of the last separator
  m_used += static_cast<std::size_t>(out - begin);
}

}  // namespace geargraph
