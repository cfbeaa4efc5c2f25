#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/foundations/base/diagnostic.h"

namespace geargraph {

/// One field of a table without its quotes, and its position: 1-based line and column, in characters.
struct CsvField {
  std::string text;
  int line = 0;
  int column = 0;
};

/// Reads a table [RFC 4180] record by record: fields between separators, quoted ones with doubled quotes and
/// with line ends inside. Lines end with LF, CR LF or CR. Blanks around a field are significant only inside
/// quotes. Empty lines and a byte order mark are skipped.
///
/// Memory: one record. Cost: O(bytes).
class CsvRecords {
 public:
  /// The most fields of a record that are stored; further ones are only counted.
  static constexpr std::size_t kMaxFields = 256;

  /// @pre the text outlives the reader
  CsvRecords(std::string_view text, char separator);

  /// Reads the next record into `fields`, reusing their storage; false at the end, or after an error.
  [[nodiscard]] bool next(std::vector<CsvField>& fields);
  /// The number of fields of the last record, including those beyond kMaxFields.
  [[nodiscard]] std::size_t count() const { return m_count; }
  /// The position of a record, to which a reader can return. Cost: O(1).
  struct Place {
    std::size_t offset = 0;
    int line = 1;
  };
  [[nodiscard]] Place place() const { return m_record; }
  void moveTo(const Place& place);

  /// A `syntax` diagnostic if the text is no valid table: a quote inside a field, a text after a closing
  /// quote, a quoted field without end, bytes that are not UTF-8.
  [[nodiscard]] const std::optional<Diagnostic>& error() const { return m_error; }

 private:
  [[nodiscard]] bool atLineEnd() const;
  void passLineEnd();
  void passBlanks();
  bool readField(CsvField& field);
  bool readQuoted(CsvField& field);
  bool readPlain(CsvField& field);
  /// Appends one character; false if it is invalid.
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

/// The separator of a table: comma, semicolon or tab, whichever is most frequent in the first line outside
/// quotes.
[[nodiscard]] char csvSeparatorOf(std::string_view text);

/// A text as one field: quoted if it contains the separator, a quote or a line end, or begins or ends with a
/// blank. Identity: CsvRecords reads it back.
[[nodiscard]] std::string csvField(std::string_view text, char separator);

}  // namespace geargraph
