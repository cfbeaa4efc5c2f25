#include "core/teaching/work_check/derived_table.h"

#include <algorithm>
#include <array>

#include "core/teaching/derivation/named_results.h"
#include "core/theory/matroid/coefficient_matrix.h"

namespace geargraph {
namespace {

struct MatrixFacts {
  std::string_view name;  ///< of the result
  RowFreedom freedom;
};

constexpr std::array<MatrixFacts, 8> kFacts = {{
    {"incidence", RowFreedom::none},
    {"reduced-incidence", RowFreedom::none},
    {"path", RowFreedom::none},
    {"spanning-tree", RowFreedom::sign},
    {"cycle-basis", RowFreedom::sign},
    {"cutset", RowFreedom::sign},
    {"p", RowFreedom::multiple},
    {"solution", RowFreedom::none},
}};

const MatrixFacts& factsOf(PaperMatrix kind) {
  return kFacts[static_cast<std::size_t>(kind)];
}

const NamedResult& resultOfPaper(PaperMatrix kind) {
  return *resultNamed(factsOf(kind).name);
}

Heading headingOfJoint(const Digraph& graph, JointOrdinal joint) {
  const int label = graph.edgeLabel(joint);
  return {label, std::to_string(label), graph.edgeId(joint)};
}

DerivedTable wholeNumbers(const Vocabulary& vocabulary, PaperMatrix kind, const IntegerMatrix& matrix) {
  DerivedTable table{kind, {}, {}, {}};
  for (int row = 0; row < matrix.rows(); ++row) table.rows.push_back(matrix.rowHeading(row));
  for (int column = 0; column < matrix.columns(); ++column)
    table.columns.push_back(matrix.columnHeading(column));
  for (int row = 0; row < matrix.rows(); ++row) {
    auto& entries = table.entries.emplace_back();
    for (int column = 0; column < matrix.columns(); ++column) {
      const int value = matrix.entry(row, column);
      entries.push_back({RationalFunction::fromInteger(vocabulary.ring(), value), value});
    }
  }
  return table;
}

DerivedTable coefficients(const Vocabulary& vocabulary) {
  const ExerciseSource& source = vocabulary.source();
  const Digraph& graph = source.graph();
  const LiveKinematics& live = *source.snapshot()->kinematics;
  const CoefficientMatrix matrix(source.mechanism(), *live.model, live.placement());
  DerivedTable table{PaperMatrix::coefficients, {}, {}, {}};
  for (JointOrdinal joint = 0; joint < graph.t(); ++joint)
    table.columns.push_back(headingOfJoint(graph, joint));
  for (MeshOrdinal mesh = 0; mesh < graph.c(); ++mesh) {
    const int label = graph.edgeLabel(graph.t() + mesh);
    table.rows.push_back({label, "C" + std::to_string(label), source.meshId(mesh)});
    ByJoint<DerivedEntry> row(static_cast<std::size_t>(graph.t()),
                              {RationalFunction::fromInteger(vocabulary.ring(), 0), 0});
    for (const CoefficientMatrix::Entry& entry : matrix.row(mesh)) {
      DerivedEntry& cell = row[entry.joint];
      cell.function = RationalFunction::power(vocabulary.ring(), entry.sign, mesh, entry.tail ? 1 : 0);
      cell.value = vocabulary.atTeeth(cell.function);
    }
    table.entries.push_back(std::move(row));
  }
  return table;
}

std::optional<DerivedTable> solution(const Vocabulary& vocabulary) {
  const ExerciseSource& source = vocabulary.source();
  const auto solved = solvedKinematics(source.mechanism(), *source.snapshot()->kinematics);
  if (!solved || !solved->exact || solved->exact->matrix.empty()) return std::nullopt;
  const ExactSolution& exact = *solved->exact;
  DerivedTable table{PaperMatrix::solution, {}, {}, {}};
  for (const JointOrdinal joint : exact.outputs) table.rows.push_back(headingOfJoint(source.graph(), joint));
  for (const JointOrdinal joint : exact.inputs)
    table.columns.push_back(headingOfJoint(source.graph(), joint));
  for (std::size_t row = 0; row < exact.outputs.size(); ++row) {
    auto& entries = table.entries.emplace_back();
    for (std::size_t column = 0; column < exact.inputs.size(); ++column) {
      const std::size_t at = row * exact.inputs.size() + column;
      DerivedEntry entry{{}, exact.matrix[at], false};
      const bool hasSymbol = solved->symbolic && solved->symbolic->matrix[at];
      if (hasSymbol) {
        // The same function in the ring of the vocabulary, whose variables are the same meshes.
        entry.function = *solved->symbolic->matrix[at];
        entry.hasFunction = true;
      }
      entries.push_back(std::move(entry));
    }
  }
  return table;
}

}  // namespace

const std::vector<PaperMatrix>& allPaperMatrices() {
  static const std::vector<PaperMatrix> kAll = {PaperMatrix::incidence,    PaperMatrix::reducedIncidence,
                                                PaperMatrix::path,         PaperMatrix::spanningTree,
                                                PaperMatrix::cycleBasis,   PaperMatrix::cutset,
                                                PaperMatrix::coefficients, PaperMatrix::solution};
  return kAll;
}

std::string_view paperMatrixName(PaperMatrix kind) {
  return factsOf(kind).name;
}

std::string_view paperMatrixSymbol(PaperMatrix kind) {
  const NamedResult& result = resultOfPaper(kind);
  if (result.of != ResultOf::graph) return result.asciiName;
  return result.symbol.substr(0, result.symbol.find(" = "));
}

std::string_view paperMatrixTitle(PaperMatrix kind) {
  return resultOfPaper(kind).title;
}

PaperEquation paperMatrixEquation(PaperMatrix kind) {
  return resultOfPaper(kind).equation(EntryForm::symbols);
}

RowFreedom rowFreedom(PaperMatrix kind) {
  return factsOf(kind).freedom;
}

std::optional<PaperMatrix> paperMatrixFromName(std::string_view name) {
  for (const PaperMatrix kind : allPaperMatrices()) {
    if (paperMatrixName(kind) == name) return kind;
  }
  return std::nullopt;
}

DerivedTable DerivedTable::transposed() const {
  DerivedTable table{kind, columns, rows, {}};
  for (std::size_t column = 0; column < columns.size(); ++column) {
    auto& row = table.entries.emplace_back();
    for (const auto& entriesOfRow : entries) row.push_back(entriesOfRow[column]);
  }
  return table;
}

std::optional<DerivedTable> derivedTable(const Vocabulary& vocabulary, PaperMatrix kind) {
  const ExerciseSource& source = vocabulary.source();
  if (kind == PaperMatrix::coefficients || kind == PaperMatrix::solution) {
    if (source.matroid() == nullptr || source.graph().c() == 0) return std::nullopt;
    if (kind == PaperMatrix::coefficients) return coefficients(vocabulary);
    return solution(vocabulary);
  }
  const IntegerMatrixPtr& matrix = source.matrix(static_cast<MatrixKind>(kind));
  if (matrix == nullptr || matrix->rows() == 0 || matrix->columns() == 0) return std::nullopt;
  return wholeNumbers(vocabulary, kind, *matrix);
}

std::string entryText(const DerivedEntry& entry) {
  return entry.hasFunction ? entry.function.toText() : entry.value.toString();
}

TableAgreement agreementOf(const Vocabulary& vocabulary, const WrittenAmount& written,
                           const DerivedEntry& derived) {
  if (derived.hasFunction && written.value == derived.function) return TableAgreement::full;
  const Rational difference = (vocabulary.atTeeth(written.value) - derived.value).abs();
  if (!difference.isZero() && !(difference < written.slack)) return TableAgreement::none;
  const bool isNumber =
      !written.hasRatios || written.hasNumbers || !derived.hasFunction || !vocabulary.ratiosAreFree();
  return isNumber ? TableAgreement::full : TableAgreement::forTheseTeeth;
}

}  // namespace geargraph
