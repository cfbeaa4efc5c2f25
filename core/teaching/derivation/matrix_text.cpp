#include "core/teaching/derivation/matrix_text.h"

#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

/// The labels of the rows or columns, parted by blanks.
std::string labels(int count, const IntegerMatrix& matrix, bool rows) {
  std::string text;
  for (int i = 0; i < count; ++i) {
    if (i > 0) text += ' ';
    text += rows ? matrix.rowHeading(i).text : matrix.columnHeading(i).text;
  }
  return text;
}

std::string comment(const std::string& mark, const IntegerMatrix& matrix) {
  return mark + ' ' + std::string(matrixTitle(matrix.kind())) + "; rows " +
         labels(matrix.rows(), matrix, true) + "; columns " + labels(matrix.columns(), matrix, false) + '\n';
}

/// "C15" with a digit behind a letter becomes "C_{15}".
std::string latexLabel(const std::string& text) {
  if (text.size() < 2 || text.front() < 'A' || text.front() > 'Z') return text;
  return text.substr(0, 1) + "_{" + text.substr(1) + '}';
}

std::string row(const IntegerMatrix& matrix, int i, const std::string& separator) {
  std::string text;
  for (int j = 0; j < matrix.columns(); ++j) {
    if (j > 0) text += separator;
    text += std::to_string(matrix.entry(i, j));
  }
  return text;
}

std::string separated(const IntegerMatrix& matrix, const std::string& separator) {
  std::string text{matrixSymbol(matrix.kind())};
  for (int j = 0; j < matrix.columns(); ++j) text += separator + matrix.columnHeading(j).text;
  text += "\n";
  for (int i = 0; i < matrix.rows(); ++i) {
    text += matrix.rowHeading(i).text;
    if (matrix.columns() > 0) text += separator + row(matrix, i, separator);
    text += "\n";
  }
  return text;
}

}  // namespace

std::string matrixTsv(const IntegerMatrix& matrix) {
  return separated(matrix, "\t");
}

std::string matrixCsv(const IntegerMatrix& matrix) {
  return separated(matrix, ",");
}

std::string matrixLatex(const IntegerMatrix& matrix) {
  std::string columns = "c|";
  for (int j = 0; j < matrix.columns(); ++j) {
    if (j > 0 && matrix.partition() == j) columns += '|';
    columns += 'r';
  }
  std::string text = "\\begin{array}{" + columns + "}\n";
  for (int j = 0; j < matrix.columns(); ++j) text += " & " + latexLabel(matrix.columnHeading(j).text);
  text += " \\\\ \\hline\n";
  for (int i = 0; i < matrix.rows(); ++i) {
    text += latexLabel(matrix.rowHeading(i).text);
    if (matrix.columns() > 0) text += " & " + row(matrix, i, " & ");
    text += i + 1 < matrix.rows() ? " \\\\\n" : "\n";
  }
  return text + "\\end{array}\n";
}

std::string matrixMatlab(const IntegerMatrix& matrix) {
  std::string text = comment("%", matrix) + matrixAsciiName(matrix.kind()) + " = [\n";
  for (int i = 0; i < matrix.rows(); ++i) text += "  " + row(matrix, i, " ") + '\n';
  return text + "];\n";
}

std::string matrixNumpy(const IntegerMatrix& matrix) {
  std::string text = comment("#", matrix) + matrixAsciiName(matrix.kind()) + " = np.array([\n";
  for (int i = 0; i < matrix.rows(); ++i) text += "    [" + row(matrix, i, ", ") + "],\n";
  return text + "])\n";
}

std::string matrixAsciiName(MatrixKind kind) {
  switch (kind) {
    case MatrixKind::incidence:
      return "Gamma0";
    case MatrixKind::reducedIncidence:
      return "Gamma";
    case MatrixKind::path:
      return "Z";
    case MatrixKind::spanningTree:
      return "T";
    case MatrixKind::cycleBasis:
      return "C";
    case MatrixKind::cutset:
      return "Q";
  }
  GEARGRAPH_REQUIRE(false);
}

}  // namespace geargraph
