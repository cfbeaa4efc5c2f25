// A matrix with one wrong entry, which is to be found and corrected.

#include <algorithm>

#include "core/teaching/exercises/exercise_entry.h"
#include "core/teaching/exercises/question_builder.h"
#include "core/teaching/exercises/question_facts.h"

namespace geargraph {
namespace {

constexpr int kMaxErrorEntries = 180;
constexpr int kMaxWide = 20;

/// "C15", a letter with digits, becomes "C_{15}".
std::string texLabel(const std::string& text) {
  if (text.size() < 2 || text.front() < 'A' || text.front() > 'Z') return text;
  return text.substr(0, 1) + "_{" + text.substr(1) + '}';
}

struct WrongEntry {
  int row = 0;
  int column = 0;
  int shown = 0;
};

std::string texWith(const IntegerMatrix& matrix, const WrongEntry& wrong) {
  std::string tex = "\\begin{array}{c|";
  std::string head;
  for (int column = 0; column < matrix.columns(); ++column) {
    tex += column > 0 && matrix.partition() == column ? "|r" : "r";
    head += " & " + texLabel(matrix.columnHeading(column).text);
  }
  tex += "}\n" + head + " \\\\ \\hline\n";
  for (int row = 0; row < matrix.rows(); ++row) {
    tex += texLabel(matrix.rowHeading(row).text);
    for (int column = 0; column < matrix.columns(); ++column) {
      const bool isWrong = row == wrong.row && column == wrong.column;
      tex += " & " + asText(isWrong ? wrong.shown : matrix.entry(row, column));
    }
    tex += row + 1 < matrix.rows() ? " \\\\\n" : "\n";
  }
  return tex + "\\end{array}";
}

const char* symbolOf(MatrixKind kind) {
  switch (kind) {
    case MatrixKind::incidence:
      return "\\Gamma^0";
    case MatrixKind::path:
      return "Z";
    case MatrixKind::cutset:
      return "Q";
    default:
      return "C";
  }
}

}  // namespace

std::vector<MatrixKind> searchableMatrices(const ExerciseSource& source) {
  std::vector<MatrixKind> kinds;
  for (const MatrixKind kind : {MatrixKind::incidence, MatrixKind::path, MatrixKind::cycleBasis}) {
    const IntegerMatrixPtr& matrix = source.matrix(kind);
    if (matrix && matrix->rows() > 1 && matrix->columns() > 1 && matrix->columns() <= kMaxWide &&
        matrix->rows() * matrix->columns() <= kMaxErrorEntries)
      kinds.push_back(kind);
  }
  return kinds;
}

namespace {

Question wrongEntryQuestion(const ExerciseSource& source, ExerciseRandom& random) {
  const MatrixKind kind = random.oneOf(searchableMatrices(source));
  const IntegerMatrix& matrix = *source.matrix(kind);
  std::vector<WrongEntry> candidates;
  for (int row = 0; row < matrix.rows(); ++row) {
    for (int column = 0; column < matrix.columns(); ++column) {
      const int value = matrix.entry(row, column);
      if (value != 0) {
        candidates.push_back({row, column, -value});
        candidates.push_back({row, column, 0});
      } else if (random.below(4) == 0) {  // zeros are many
        candidates.push_back({row, column, random.below(2) == 0 ? 1 : -1});
      }
    }
  }
  const WrongEntry wrong = random.oneOf(candidates);
  const std::string row = matrix.rowHeading(wrong.row).text;
  const std::string column = matrix.columnHeading(wrong.column).text;
  const int value = matrix.entry(wrong.row, wrong.column);

  QuestionBuilder build(ExerciseKind::wrongEntry, 3);
  build.question.prompt =
      translated("One entry of this matrix $%1$ is wrong. Find it and correct it.", {symbolOf(kind)});
  build.question.formula = texWith(matrix, wrong);
  build.question.rule = translated("The entry in row %1, column %2 is %3, not %4.",
                                   {row, column, inWords(value), inWords(wrong.shown)});
  std::vector<std::string> rows;
  std::vector<std::string> columns;
  for (int i = 0; i < matrix.rows(); ++i) rows.push_back(matrix.rowHeading(i).text);
  for (int i = 0; i < matrix.columns(); ++i) columns.push_back(matrix.columnHeading(i).text);
  build.field(toTranslate("row"), FieldKind::choice, rows);
  build.field(toTranslate("column"), FieldKind::choice, columns);
  build.field(toTranslate("right value"), FieldKind::integer);
  build.accept({row, column, asText(value)});
  const ElementId rowElement = matrix.rowHeading(wrong.row).element;
  const ElementId columnElement = matrix.columnHeading(wrong.column).element;
  build.wrongIf("wrong-correction",
                {{Test::values, {0, 1}, {{row, column}}}, {Test::differs, {2}, {{asText(value)}}}},
                translated("You find the wrong entry, but its right value is another one."),
                {rowElement, columnElement}, {2});
  build.wrongIf("right-row-only", {{Test::values, {0}, {{row}}}, {Test::differs, {1}, {{column}}}},
                translated("The wrong entry is in this row, but the entry that you name is right."),
                {rowElement}, {1});
  build.wrongIf("right-column-only", {{Test::values, {1}, {{column}}}, {Test::differs, {0}, {{row}}}},
                translated("The wrong entry is in this column, but the entry that you name is right."),
                {columnElement}, {0});
  build.wrongIf(
      "right-entry-blamed", {{Test::differs, {0}, {{row}}}, {Test::differs, {1}, {{column}}}},
      translated("The entry that you name is right: follow the arrows of its row and column once more."), {},
      {0, 1});
  return std::move(build.question);
}

Lack withoutSearchable(const ExerciseSource& source) {
  if (const Lack reason = withoutEdges(source)) return reason;
  return searchableMatrices(source).empty() ? Lack(translated("the matrices are too large or too small"))
                                            : std::nullopt;
}

}  // namespace

ExerciseEntry wrongEntryEntry() {
  return {.kind = ExerciseKind::wrongEntry,
          .name = "wrong-entry",
          .title = toTranslate("Find the wrong entry"),
          .hint = toTranslate(
              "Derive the matrix from the drawing, row by row, and stop at the first entry that differs. "
              "Compare signs with the directions of the arrows."),
          .lack = withoutSearchable,
          .make = wrongEntryQuestion};
}

}  // namespace geargraph
