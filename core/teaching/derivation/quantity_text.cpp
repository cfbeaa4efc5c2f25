#include <algorithm>
#include <array>
#include <charconv>

#include "core/foundations/files/csv.h"
#include "core/teaching/derivation/quantity_table.h"

namespace geargraph {
namespace {

enum class Spelling { plain, latex, readableLatex };

/// As many digits as read back as the same number, where digits are wanted; else the text of the screen.
std::string spelled(const QuantityTable& table, const QuantityEntry& entry, Spelling spelling) {
  if (spelling == Spelling::latex) return entry.latex;
  if (spelling == Spelling::readableLatex) return readableLatex(entry);
  const bool approximate = entry.text.find("≈") != std::string::npos;
  if (table.form() != EntryForm::decimals && !approximate) return entry.text;
  std::array<char, 40> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), entry.value + 0.0);
  return {digits.data(), end.ptr};
}

std::string rowText(const QuantityTable& table, int row, const std::string& separator, Spelling spelling) {
  std::string text;
  int column = 0;
  const auto put = [&](const std::string& entry) {
    if (column++ > 0) text += separator;
    text += entry;
  };
  for (const QuantityEntry& entry : table.row(row)) {
    while (column < entry.column) put("0");
    put(spelled(table, entry, spelling));
  }
  while (column < table.columns()) put("0");
  return text;
}

/// Two blanks part the cycle and the joint of a screw's row on the screen; one does in a text.
std::string plainLabel(std::string label) {
  if (const std::size_t gap = label.find("  "); gap != std::string::npos) label.erase(gap, 1);
  return label;
}

void writeSeparated(ByteSink& sink, const QuantityTable& table, const std::string& separator) {
  BufferedSink text(sink);
  text.write(quantityAsciiName(table.kind()));
  for (int j = 0; j < table.columns(); ++j) text.write(separator + table.columnHeading(j).text);
  text.put('\n');
  for (int i = 0; i < table.rows() && !text.failed(); ++i) {
    text.write(plainLabel(table.rowHeading(i).text) + separator);
    text.write(rowText(table, i, separator, Spelling::plain));
    text.put('\n');
  }
}

std::string separated(const QuantityTable& table, const std::string& separator) {
  TextSink text;
  writeSeparated(text, table, separator);
  return text.take();
}

std::string comment(const QuantityTable& table, const std::string& mark) {
  std::string text = mark + ' ' + std::string(quantityTitle(table.kind())) + "; rows";
  for (int i = 0; i < table.rows(); ++i) text += ' ' + plainLabel(table.rowHeading(i).text);
  text += "; columns";
  for (int j = 0; j < table.columns(); ++j) text += ' ' + table.columnHeading(j).text;
  return text + '\n';
}

std::string latexHeading(const QuantityTable& table, const Heading& heading) {
  if (table.headsAreRates()) return "\\dot{\\theta}_{" + heading.text + "}";
  const std::string text = plainLabel(heading.text);
  if (text.size() < 2 || text.front() != 'C') return text;
  const std::size_t blank = text.find(' ');
  const std::string rest = blank == std::string::npos ? "" : "," + text.substr(blank + 1);
  return "C_{" + text.substr(1, blank == std::string::npos ? blank : blank - 1) + rest + "}";
}

std::string latexArray(const QuantityTable& table, Spelling spelling) {
  std::string columns = "c|";
  for (int j = 0; j < table.columns(); ++j) {
    if (j > 0 && table.partition() == j) columns += '|';
    columns += 'r';
  }
  std::string text = "\\begin{array}{" + columns + "}\n";
  for (int j = 0; j < table.columns(); ++j) text += " & " + latexHeading(table, table.columnHeading(j));
  text += " \\\\ \\hline\n";
  for (int i = 0; i < table.rows(); ++i) {
    text += latexHeading(table, table.rowHeading(i)) + " & " + rowText(table, i, " & ", spelling);
    text += i + 1 < table.rows() ? " \\\\\n" : "\n";
  }
  return text + "\\end{array}\n";
}

}  // namespace

std::string quantityTsv(const QuantityTable& table) {
  return separated(table, "\t");
}

std::string quantityCsv(const QuantityTable& table) {
  return separated(table, ",");
}

void writeQuantityCsv(ByteSink& sink, const QuantityTable& table, const CsvOptions& options) {
  const std::string separator(1, options.separator);
  BufferedSink text(sink);
  if (options.byteOrderMark) text.write("\xEF\xBB\xBF");
  const auto label = [&](const std::string& heading) {
    return csvLabel(plainLabel(heading), options.separator);
  };
  if (options.labels) {
    text.write(quantityAsciiName(table.kind()));
    for (int j = 0; j < table.columns(); ++j) text.write(separator + label(table.columnHeading(j).text));
    text.put('\n');
  }
  const auto field = [&](std::string entry, const QuantityEntry& of) {
    const bool isDecimal = !of.isFormula && options.decimalPoint != '.';
    if (isDecimal) std::replace(entry.begin(), entry.end(), '.', options.decimalPoint);
    return entry.find(options.separator) == std::string::npos ? entry : '"' + entry + '"';
  };
  for (int i = 0; i < table.rows() && !text.failed(); ++i) {
    if (options.labels) text.write(label(table.rowHeading(i).text) + separator);
    int column = 0;
    const auto put = [&](const std::string& entry) {
      if (column++ > 0) text.write(separator);
      text.write(entry);
    };
    for (const QuantityEntry& entry : table.row(i)) {
      while (column < entry.column) put("0");
      put(field(spelled(table, entry, Spelling::plain), entry));
    }
    while (column < table.columns()) put("0");
    text.put('\n');
  }
}

std::string quantityLatex(const QuantityTable& table) {
  return latexArray(table, Spelling::latex);
}

std::string readableLatex(const QuantityTable& table) {
  return latexArray(table, Spelling::readableLatex);
}

std::string quantityMatlab(const QuantityTable& table) {
  std::string text = comment(table, "%") + std::string(quantityAsciiName(table.kind())) + " = [\n";
  for (int i = 0; i < table.rows(); ++i) text += "  " + rowText(table, i, " ", Spelling::plain) + '\n';
  return text + "];\n";
}

std::string quantityNumpy(const QuantityTable& table) {
  std::string text = comment(table, "#") + std::string(quantityAsciiName(table.kind())) + " = np.array([\n";
  for (int i = 0; i < table.rows(); ++i) {
    text += "    [" + rowText(table, i, ", ", Spelling::plain) + "],\n";
  }
  return text + "])\n";
}

}  // namespace geargraph
