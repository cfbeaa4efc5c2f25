#pragma once

#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/teaching/grading/grade.h"
#include "core/teaching/grading/mistake_names.h"
#include "core/teaching/work_check/derived_table.h"

namespace geargraph {

enum class WorkOutcome {
  right,
  wrong,
  /// Right in another order of rows and columns, and a known mistake in the order of the labels: only labels
  /// could decide.
  ambiguous,
};
[[nodiscard]] std::string_view outcomeName(WorkOutcome outcome);

/// An entry of the user's matrix, counted from 0.
struct EntryPlace {
  int row = 0;
  int column = 0;
  friend bool operator==(const EntryPlace&, const EntryPlace&) = default;
};

/// A mistake with its place and reason. Without entries: in the matrix as a whole.
struct WorkDifference {
  std::string name;  ///< of mistakeNames() or paperMistakeNames()
  std::vector<EntryPlace> entries;
  std::vector<ElementId> elements;
  std::string reason;  ///< one sentence: what was written, then what is right
};

/// A written entry with the derived one that belongs in its place.
struct ComparedEntry {
  WrittenCell written;
  std::string derived;  ///< in the user's order, orientation and multiple
  bool differs = false;
  std::vector<ElementId> elements;
};

/// The comparison of the user's matrix with the derived one.
struct MatrixVerdict {
  PaperMatrix kind = PaperMatrix::incidence;
  bool isRecognised = false;  ///< the user did not say which matrix it is
  WorkOutcome outcome = WorkOutcome::wrong;
  std::vector<Heading> rows;     ///< derived, in the user's order; empty if the sizes differ
  std::vector<Heading> columns;  ///< the same
  std::vector<std::vector<ComparedEntry>> entries;
  std::vector<std::string> notes;  ///< permitted deviations found in the matrix, as sentences
  std::vector<WorkDifference> differences;
};

/// The result for one equation of the user's.
struct EquationVerdict {
  std::string text;
  int line = 1;
  bool isRight = false;
  std::optional<WorkDifference> difference;  ///< if it is wrong
  std::vector<ElementId> elements;           ///< that it is about
};

using WorkVerdict = std::variant<MatrixVerdict, std::vector<EquationVerdict>>;

/// Compares a user's text with the results derived from the mechanism, with every coupling released. A matrix
/// is right in any order of rows and columns that its labels allow, with cycles in either direction,
/// equations of P multiplied by any number, C, T and Z of any spanning tree, the solution for any valid
/// inputs named by its labels. Without `kind` the matrix is recognised by its name, size and entries.
///
/// Fails with `syntax` with line and column if the text cannot be parsed, a label is unknown or no matrix of
/// the mechanism has this size; with the errors of the mechanism if it has no such matrix. Cost: that of the
/// derived matrices, and of the search for an order, which is bounded. Ends soon after `stop` is requested;
/// the verdict is then meaningless.
[[nodiscard]] Expected<WorkVerdict> checkPaper(const ExerciseSource& source, std::string_view text,
                                               std::optional<PaperMatrix> kind = {},
                                               const std::stop_token& stop = {});

/// The mistakes that only this check reports, in addition to those of the grader. Names are stable.
[[nodiscard]] std::span<const MistakeName> paperMistakeNames();
/// The title of a mistake of either list. @pre there is such a mistake
[[nodiscard]] std::string_view paperMistakeTitle(std::string_view name);

/// The verdict as JSON: `format` "geargraph-check", version 1.
[[nodiscard]] std::string verdictJson(const WorkVerdict& verdict);

}  // namespace geargraph
