#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/teaching/derivation/glossary.h"
#include "core/teaching/derivation/result_table.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph {

struct SolvedStatics;
using SolvedStaticsPtr = std::shared_ptr<const SolvedStatics>;

/// What results are made of.
struct ResultSource {
  SnapshotPtr snapshot;
  SolvedStaticsPtr statics = nullptr;  ///< null: not solved, so that there are no results of loads
};

/// What a result is of, which is what has to be computed before it is there.
enum class ResultOf : std::uint8_t {
  graph,     ///< the digraph and its tree
  motion,    ///< analyzeLive()
  solution,  ///< analyzeFully(), for its exact values
  loads,     ///< solvedStatics() of the train or of a state; not expected of a mechanism without loads
  states,    ///< solvedStatics() of all states
};

/// A result of the analysis, which all that shows or writes results reads here (docs/adding/result.md). It is
/// a file of `export --to csv --matrix` and of --all, and in Python, by its name; the other documents that
/// have it are said below.
struct NamedResult {
  std::string_view name;       ///< "reduced-incidence": on the command line, in file names, for ever
  std::string_view title;      ///< "Reduced incidence matrix"
  std::string_view asciiName;  ///< "Gamma0", "P": as a variable of other programs
  ResultOf of = ResultOf::motion;
  std::string_view needs;            ///< what a mechanism needs for it, as part of a sentence
  std::optional<Term> term = {};     ///< its definition in the glossary
  std::string_view definition = {};  ///< where it has none there
  bool isWhole = false;              ///< of whole numbers, which have one form
  bool rowsAreCycles = false;        ///< a row belongs to the cycle of its mesh

  std::string_view symbol = {};    ///< "Γ = [G | G*]"; in the window's Matrices by this; empty: not there
  std::string_view jsonName = {};  ///< its member of "matrices" in `analyze --json`; empty: not there
  bool isPrinted = false;          ///< by `analyze`, as text
  std::string_view reportFormula = {};  ///< "T = G^{*T} Z^T": as the report's part of matrices says it
  std::string_view reportText = {};     ///< the sentence above it; empty: not in that part

  /// The paper's equation that prints it in this form: P in numbers (19), in gear ratios (24).
  PaperEquation (*equation)(EntryForm form) = [](EntryForm) { return PaperEquation::none; };
  /// The forms that there are of it: symbols only if they were solved within their budget, fractions of a
  /// solution only with the exact part. Empty if it is undefined.
  std::vector<EntryForm> (*forms)(const ResultSource& source) = nullptr;
  /// @pre forms() names the form
  ResultTablePtr (*table)(const NamedResult& self, const ResultSource& source, EntryForm form) = nullptr;
};

/// The catalogue, in the order in which results are derived. The entries live as long as the program.
[[nodiscard]] std::span<const NamedResult* const> namedResults();
/// Null where there is none of this name.
[[nodiscard]] const NamedResult* resultNamed(std::string_view name);
[[nodiscard]] const NamedResult& resultOf(MatrixKind kind);
[[nodiscard]] std::vector<std::string> resultNames();

/// The table; null if it does not have this form.
[[nodiscard]] ResultTablePtr resultTable(const NamedResult& result, const ResultSource& source,
                                         EntryForm form);
/// From the exact values where there are any, whose decimals are the nearest ones; null if it is undefined.
[[nodiscard]] ResultTablePtr exactTable(const NamedResult& result, const ResultSource& source);

/// What the result is, in full sentences and in the current language.
[[nodiscard]] std::string definitionOf(const NamedResult& result);

/// A result of the catalogue as long as this lives, for instance one of a test. Not thread-safe: add and drop
/// results while no other thread reads them.
class AddedResult {
 public:
  /// `result` lives longer than this. @pre no other has its name
  explicit AddedResult(const NamedResult& result);
  ~AddedResult();
  AddedResult(const AddedResult&) = delete;
  AddedResult& operator=(const AddedResult&) = delete;
};

}  // namespace geargraph
