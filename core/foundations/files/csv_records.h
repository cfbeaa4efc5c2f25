#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/foundations/base/diagnostic.h"

namespace geargraph::inline files {

/// One field of a table, quotes resolved, and where it begins: 1-based line and column, in characters.
struct CsvField {
  std::string text;
  int line = 0;
  int column = 0;
};

/// Reads a table [RFC 4180] record by record: fields between separators, quoted ones with doubled quotes and
/// with line ends inside. Lines end with LF, CR LF or CR. Blanks around a field count only inside quotes.
/// Lines without any character are passed over, and so is a byte order mark.
///
/// Memory: one record. Cost: O(bytes).
class CsvRecords {
 public:
  /// Fields of a record that are stored; what follows is counted only.
  static constexpr std::size_t kMostFields = 256;

  /// @pre the text outlives the reader
  CsvRecords(std::string_view text, char separator);

  /// The next record; false at the end, or after an error. The record's storage is reused.
  [[nodiscard]] bool next(std::vector<CsvField>& fields);
  /// Fields of the last record, also those beyond kMostFields.
  [[nodiscard]] std::size_t count() const { return m_count; }
  /// Offset of the last record; a reader can be set to it. Cost of moving: O(1).
  struct Place {
    std::size_t offset = 0;
    int line = 1;
  };
  [[nodiscard]] Place place() const { return m_record; }
  void moveTo(const Place& place);

  /// One `syntax` where the text is no table: a quote inside a field, a text after a closing quote, a quoted
  /// field without end, bytes that are not UTF-8.
  [[nodiscard]] const std::optional<Diagnostic>& error() const { return m_error; }

 private:
  [[nodiscard]] bool atLineEnd() const;
  void passLineEnd();
  void passBlanks();
  bool readField(CsvField& field);
  bool readQuoted(CsvField& field);
  bool readPlain(CsvField& field);
  /// Appends one character; false where there is none.
  bool take(std::string& text);
  bool failAt(int line, int column, std::string message);

  std::string_view m_text;
  char m_separator;
  std::size_t m_at = 0;
  int m_line = 1;
  int m_column = 1;
  Place m_record;
  std::size_t m_count = 0;
  std::optional<Diagnostic> m_error;
};

/// The separator of a table: comma, semicolon or tab, whichever the first line has most of outside quotes.
[[nodiscard]] char csvSeparatorOf(std::string_view text);

/// A text as one field: in quotes where it holds the separator, a quote or a line end, or begins or ends with
/// a blank. Identity: CsvRecords reads it back.
[[nodiscard]] std::string csvField(std::string_view text, char separator);

}  // namespace geargraph::inline files
