#include "core/teaching/derivation/result_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

#include "core/foundations/files/json_writer.h"
#include "core/foundations/files/matrix_csv.h"
#include "core/teaching/derivation/named_results.h"
#include "core/teaching/force_tables/force_table.h"

namespace geargraph {
namespace {

using Layout = JsonWriter::Layout;

enum class Spelling { plain, latex, readableLatex };

/// As many digits as read back as the same number, where digits are wanted; else the text of the screen.
std::string spelled(const ResultTable& table, const ResultEntry& entry, Spelling spelling) {
  if (spelling == Spelling::latex) return entry.latex;
  if (spelling == Spelling::readableLatex) return readableLatex(entry);
  const bool approximate = entry.text.find("≈") != std::string::npos;
  const bool isNumber = !entry.isFormula && (table.form() == EntryForm::decimals || approximate);
  if (!isNumber) return entry.text;
  std::array<char, 40> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), entry.value + 0.0);
  return {digits.data(), end.ptr};
}

/// Calls `put` with the text of each entry of a row, zeros as "0", and the entry or null.
template <class Put>
void forEachEntry(const ResultTable& table, int row, Spelling spelling, const Put& put) {
  int column = 0;
  for (const ResultEntry& entry : table.row(row)) {
    for (; column < entry.column; ++column) put("0", nullptr);
    put(spelled(table, entry, spelling), &entry);
    ++column;
  }
  for (; column < table.columns(); ++column) put("0", nullptr);
}

std::string rowText(const ResultTable& table, int row, const std::string& separator, Spelling spelling) {
  std::string text;
  bool isFirst = true;
  forEachEntry(table, row, spelling, [&](const std::string& entry, const ResultEntry* /*of*/) {
    if (!isFirst) text += separator;
    isFirst = false;
    text += entry;
  });
  return text;
}

/// Two blanks part the cycle and the joint of a screw's row on the screen; one does in a text.
std::string plainLabel(std::string label) {
  if (const std::size_t gap = label.find("  "); gap != std::string::npos) label.erase(gap, 1);
  return label;
}

std::string rowLabel(const ResultTable& table, int row) {
  return plainLabel(table.rowHeading(row).text);
}
std::string columnLabel(const ResultTable& table, int column) {
  return plainLabel(table.columnHeading(column).text);
}

std::string separated(const ResultTable& table, const std::string& separator) {
  const NamedResult& result = table.result();
  std::string text(table.integers() != nullptr ? result.symbol : result.asciiName);
  for (int j = 0; j < table.columns(); ++j) text += separator + table.columnHeading(j).text;
  text += '\n';
  for (int i = 0; i < table.rows(); ++i) {
    text += rowLabel(table, i);
    if (table.columns() > 0) text += separator + rowText(table, i, separator, Spelling::plain);
    text += '\n';
  }
  return text;
}

/// "C15" becomes "C_{15}", the "C16 12" of a screw "C_{16,12}".
std::string latexHeading(const ResultTable& table, const Heading& heading) {
  if (table.headsAreRates()) return "\\dot{\\theta}_{" + heading.text + "}";
  const std::string text = plainLabel(heading.text);
  if (text.size() < 2 || text.front() != 'C') return text;
  const std::size_t blank = text.find(' ');
  const std::string rest = blank == std::string::npos ? "" : "," + text.substr(blank + 1);
  return "C_{" + text.substr(1, blank == std::string::npos ? blank : blank - 1) + rest + "}";
}

std::string latexArray(const ResultTable& table, Spelling spelling) {
  std::string columns = "c|";
  for (int j = 0; j < table.columns(); ++j) {
    if (j > 0 && table.partition() == j) columns += '|';
    columns += 'r';
  }
  std::string text = "\\begin{array}{" + columns + "}\n";
  for (int j = 0; j < table.columns(); ++j) text += " & " + latexHeading(table, table.columnHeading(j));
  text += " \\\\ \\hline\n";
  for (int i = 0; i < table.rows(); ++i) {
    text += latexHeading(table, table.rowHeading(i));
    if (table.columns() > 0) text += " & " + rowText(table, i, " & ", spelling);
    text += i + 1 < table.rows() ? " \\\\\n" : "\n";
  }
  return text + "\\end{array}\n";
}

/// An assignment to a variable, below a comment with the labels.
std::string assignment(const ResultTable& table, const std::string& mark, const std::string& begin,
                       const std::string& beginRow, const std::string& separator, const std::string& endRow,
                       const std::string& end) {
  std::string text = mark + ' ' + std::string(table.result().title) + "; rows";
  for (int i = 0; i < table.rows(); ++i) text += ' ' + rowLabel(table, i);
  text += "; columns";
  for (int j = 0; j < table.columns(); ++j) text += ' ' + table.columnHeading(j).text;
  text += '\n' + std::string(table.result().asciiName) + begin;
  for (int i = 0; i < table.rows(); ++i)
    text += beginRow + rowText(table, i, separator, Spelling::plain) + endRow;
  return text + end;
}

std::vector<std::string> columnLabels(const ResultTable& table) {
  std::vector<std::string> labels;
  for (int column = 0; column < table.columns(); ++column) labels.push_back(columnLabel(table, column));
  return labels;
}

void writeDecimals(ByteSink& sink, const ResultTable& table, const CsvOptions& options) {
  CsvWriter csv(sink, columnLabels(table), options);
  for (int row = 0; row < table.rows() && !csv.failed(); ++row) {
    const std::vector<ResultValue> values = table.values(row);
    csv.sparseRow(rowLabel(table, row), std::span<const ResultValue>(values));
  }
}

void writeAsShown(ByteSink& sink, const ResultTable& table, const CsvOptions& options) {
  const std::string separator(1, options.separator);
  BufferedSink text(sink);
  if (options.byteOrderMark) text.write("\xEF\xBB\xBF");
  if (options.labels) {
    text.write(table.result().asciiName);
    for (const std::string& label : columnLabels(table))
      text.write(separator + csvLabel(label, options.separator));
    text.put('\n');
  }
  for (int row = 0; row < table.rows() && !text.failed(); ++row) {
    if (options.labels) text.write(csvLabel(rowLabel(table, row), options.separator) + separator);
    bool isFirst = true;
    forEachEntry(table, row, Spelling::plain, [&](std::string entry, const ResultEntry* of) {
      if (!isFirst) text.write(separator);
      isFirst = false;
      const bool isDecimal = of != nullptr && !of->isFormula && options.decimalPoint != '.';
      if (isDecimal) std::replace(entry.begin(), entry.end(), '.', options.decimalPoint);
      text.write(entry.find(options.separator) == std::string::npos ? entry : '"' + entry + '"');
    });
    text.put('\n');
  }
}

/// The rows of a table for JSON: of matrices of the digraph without a text for each entry.
class JsonRows {
 public:
  explicit JsonRows(const ResultTable& table) : m_table(table), m_integers(table.integers()) {}

  /// Calls `put` with the column of each non-zero of a row and a function that writes it.
  template <class Put>
  void forEachNonZero(JsonWriter& json, int row, const Put& put) {
    if (m_integers) {
      m_integers->rowEntries(row, m_entries);
      for (const MatrixEntry& entry : m_entries)
        put(entry.column, [&] { json.number(static_cast<std::int64_t>(entry.value)); });
      return;
    }
    for (const ResultValue& entry : m_table.values(row)) put(entry.column, [&] { json.number(entry.value); });
  }

 private:
  const ResultTable& m_table;
  IntegerMatrixPtr m_integers;
  std::vector<MatrixEntry> m_entries;  ///< of the row at hand
};

void writeLabel(JsonWriter& json, const Heading& heading) {
  json.number(static_cast<std::int64_t>(heading.label));
}

/// As many columns as the text takes in a font of fixed width.
std::size_t widthOf(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::string rightAligned(std::string_view text, std::size_t width) {
  const std::size_t own = widthOf(text);
  return std::string(width > own ? width - own : 0, ' ') + std::string(text);
}

}  // namespace

std::string resultText(const ResultTable& table, TableFormat format) {
  switch (format) {
    case TableFormat::tsv:
      return separated(table, "\t");
    case TableFormat::csv:
      return separated(table, ",");
    case TableFormat::latex:
      return latexArray(table, Spelling::latex);
    case TableFormat::matlab:
      return assignment(table, "%", " = [\n", "  ", " ", "\n", "];\n");
    case TableFormat::numpy:
      return assignment(table, "#", " = np.array([\n", "    [", ", ", "],\n", "])\n");
  }
  return {};
}

std::string readableLatex(const ResultTable& table) {
  return latexArray(table, Spelling::readableLatex);
}

void writeResultCsv(ByteSink& sink, const ResultTable& table, const CsvOptions& options, CsvEntries entries) {
  if (const ValueTable* records = table.records()) return writeForceCsv(sink, *records, options);
  if (const IntegerMatrixPtr matrix = table.integers())
    return writeMatrixCsv<MatrixEntry, UniformRow>(sink, *matrix, options);
  entries == CsvEntries::decimals ? writeDecimals(sink, table, options) : writeAsShown(sink, table, options);
}

void writeResultJson(JsonWriter& json, const ResultTable& table, bool asTriplets) {
  json.beginObject();
  json.key("rows");
  json.beginArray(Layout::row);
  for (int row = 0; row < table.rows(); ++row) writeLabel(json, table.rowHeading(row));
  json.endArray();
  std::vector<Heading> columns;
  for (int column = 0; column < table.columns(); ++column) columns.push_back(table.columnHeading(column));
  json.key("columns");
  json.beginArray(Layout::row);
  for (const Heading& column : columns) writeLabel(json, column);
  json.endArray();
  json.key(asTriplets ? "triplets" : "entries");
  json.beginArray();
  JsonRows rows(table);
  for (int row = 0; row < table.rows(); ++row) {
    if (asTriplets) {
      const Heading heading = table.rowHeading(row);
      rows.forEachNonZero(json, row, [&](int column, const auto& writeValue) {
        json.beginArray(Layout::row);
        writeLabel(json, heading);
        writeLabel(json, columns[static_cast<std::size_t>(column)]);
        writeValue();
        json.endArray();
      });
      continue;
    }
    json.beginArray(Layout::row);
    int next = 0;
    const auto fillTo = [&](int column) {
      for (; next < column; ++next) json.number(std::int64_t{0});
    };
    rows.forEachNonZero(json, row, [&](int column, const auto& writeValue) {
      fillTo(column);
      writeValue();
      ++next;
    });
    fillTo(table.columns());
    json.endArray();
  }
  json.endArray();
  json.endObject();
}

std::string resultGrid(const ResultTable& table) {
  std::size_t labelWidth = 0;
  std::size_t width = 2;
  std::vector<std::vector<std::string>> cells;
  for (int row = 0; row < table.rows(); ++row) {
    labelWidth = std::max(labelWidth, widthOf(rowLabel(table, row)));
    std::vector<std::string>& texts = cells.emplace_back();
    forEachEntry(table, row, Spelling::plain, [&](const std::string& text, const ResultEntry* of) {
      texts.push_back(of == nullptr ? "." : text);
      width = std::max(width, widthOf(texts.back()));
    });
  }
  for (int column = 0; column < table.columns(); ++column)
    width = std::max(width, widthOf(columnLabel(table, column)));
  std::string text = std::string(labelWidth + 2, ' ');
  for (int column = 0; column < table.columns(); ++column) {
    text += (table.partition() == column ? "  " : "") + rightAligned(columnLabel(table, column), width + 1);
  }
  text += '\n';
  for (int row = 0; row < table.rows(); ++row) {
    text += "  " + rightAligned(rowLabel(table, row), labelWidth);
    for (int column = 0; column < table.columns(); ++column) {
      text += (table.partition() == column ? " |" : "") +
              rightAligned(cells[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)], width + 1);
    }
    text += '\n';
  }
  return text;
}

}  // namespace geargraph
