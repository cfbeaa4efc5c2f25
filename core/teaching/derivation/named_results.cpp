#include "core/teaching/derivation/named_results.h"

#include <algorithm>

#include "core/foundations/base/contract.h"
#include "core/foundations/base/translation.h"
#include "core/teaching/derivation/result_tables.h"
#include "core/teaching/derivation/solved_statics.h"

namespace geargraph {
namespace {

using Forms = std::vector<EntryForm>;

// --- the digraph

template <MatrixKind kind>
Forms matrixForms(const ResultSource& source) {
  return source.snapshot->matrix(kind) ? Forms{EntryForm::fractions} : Forms();
}
template <MatrixKind kind>
ResultTablePtr tableOfMatrix(const NamedResult& self, const ResultSource& source, EntryForm /*form*/) {
  return matrixTable(self, source.snapshot, kind);
}

struct MatrixPlaces {
  Term term;
  std::string_view asciiName;
  std::string_view reportFormula = {};
  std::string_view reportText = {};
  bool rowsAreCycles = false;
};

/// Names and equation are those of the graph's matrices.
template <MatrixKind kind>
NamedResult matrixResult(const MatrixPlaces& places) {
  return {.name = matrixCommandName(kind),
          .title = matrixTitle(kind),
          .asciiName = places.asciiName,
          .of = ResultOf::graph,
          .needs = toTranslate("a spanning tree"),
          .term = places.term,
          .isWhole = true,
          .rowsAreCycles = places.rowsAreCycles,
          .symbol = matrixSymbol(kind),
          .jsonName = matrixJsonName(kind),
          .isPrinted = true,
          .reportFormula = places.reportFormula,
          .reportText = places.reportText,
          .equation = [](EntryForm) { return matrixEquation(kind); },
          .forms = matrixForms<kind>,
          .table = tableOfMatrix<kind>};
}

// --- motion

bool hasModel(const ResultSource& source) {
  return source.snapshot->kinematics && source.snapshot->kinematics->model;
}

Forms solutionForms(const ResultSource& source) {
  const AnalysisSnapshot& snapshot = *source.snapshot;
  const MatroidAnalysis* matroid = hasModel(source) ? snapshot.matroid() : nullptr;
  if (matroid == nullptr || !matroid->solution) return {};
  Forms forms;
  const std::size_t entries = matroid->solution->inputs.size() * matroid->solution->outputs.size();
  if (matroid->solution->matrix.size() == entries) forms.push_back(EntryForm::decimals);
  if (!snapshot.solved || !snapshot.solved->exact) return forms;
  if (snapshot.solved->exact->matrix.size() == entries) forms.push_back(EntryForm::fractions);
  if (snapshot.solved->symbolic && snapshot.solved->symbolic->matrix.size() == entries)
    forms.push_back(EntryForm::symbols);
  return forms;
}

Forms ttForms(const ResultSource& source) {
  const bool isThere = hasModel(source) && source.snapshot->kinematics->ttGraph &&
                       source.snapshot->kinematics->ttGraph->isComplete();
  return isThere ? Forms{EntryForm::fractions} : Forms();
}

constexpr std::string_view kNeedsGeometry = toTranslate("a geometry of every mesh");
constexpr std::string_view kNeedsCarriers = toTranslate("a carrier and a sign of every mesh");

NamedResult screws() {
  return {.name = "screw",
          .title = toTranslate("Screws"),
          .asciiName = "U",
          .needs = kNeedsGeometry,
          .term = Term::screw,
          .symbol = "û",
          .equation = [](EntryForm) { return PaperEquation::screw; },
          .forms =
              [](const ResultSource& source) {
                return hasModel(source) ? Forms{EntryForm::decimals, EntryForm::fractions} : Forms();
              },
          .table = [](const NamedResult& self, const ResultSource& source,
                      EntryForm form) { return screwTable(self, source.snapshot, form); }};
}

NamedResult coefficients() {
  return {.name = "p",
          .title = toTranslate("Coefficient matrix"),
          .asciiName = "P",
          .needs = kNeedsGeometry,
          .term = Term::coefficientMatrix,
          .rowsAreCycles = true,
          .symbol = "P",
          .jsonName = "p",
          .equation =
              [](EntryForm form) {
                return form == EntryForm::symbols ? PaperEquation::equationsInRatios
                                                  : PaperEquation::coefficientsInNumbers;
              },
          .forms =
              [](const ResultSource& source) {
                return hasModel(source) ? Forms{EntryForm::decimals, EntryForm::fractions, EntryForm::symbols}
                                        : Forms();
              },
          .table = [](const NamedResult& self, const ResultSource& source,
                      EntryForm form) { return coefficientTable(self, source.snapshot, form); }};
}

NamedResult solution() {
  return {.name = "solution",
          .title = toTranslate("Solution"),
          .asciiName = "S",
          .of = ResultOf::solution,
          .needs = toTranslate("a mechanism without errors, and at most 250,000 entries"),
          .term = Term::solution,
          .symbol = "θ̇",
          .equation =
              [](EntryForm form) {
                return form == EntryForm::symbols ? PaperEquation::matroidSolution
                                                  : PaperEquation::solutionByInverse;
              },
          .forms = solutionForms,
          .table = [](const NamedResult& self, const ResultSource& source,
                      EntryForm form) { return solutionTable(self, source.snapshot, form); }};
}

NamedResult ttCircuits() {
  return {.name = "tt-circuits",
          .title = toTranslate("T-T circuit matrix"),
          .asciiName = "B",
          .needs = kNeedsCarriers,
          .term = Term::ttCircuitMatrix,
          .isWhole = true,
          .symbol = "B",
          .forms = ttForms,
          .table = [](const NamedResult& self, const ResultSource& source, EntryForm /*form*/) {
            return ttCircuitTable(self, source.snapshot);
          }};
}

NamedResult ttCutsets() {
  return {.name = "tt-cutsets",
          .title = toTranslate("T-T cutset matrix"),
          .asciiName = "Qtt",
          .needs = kNeedsCarriers,
          .term = Term::ttCutsetMatrix,
          .isWhole = true,
          .symbol = "Q′",
          .forms = ttForms,
          .table = [](const NamedResult& self, const ResultSource& source, EntryForm /*form*/) {
            return ttCutsetTable(self, source.snapshot);
          }};
}

// --- statics

Forms torqueForms(const ResultSource& source) {
  if (!source.statics || !source.statics->report || !source.statics->report->matrix) return {};
  Forms forms{EntryForm::decimals, EntryForm::fractions};
  const auto& symbolic = source.statics->report->symbolic;
  if (symbolic && symbolic->skipped == 0) forms.push_back(EntryForm::symbols);
  return forms;
}

NamedResult torques() {
  return {.name = "statics",
          .title = toTranslate("The transposed solution"),
          .asciiName = "K",
          .of = ResultOf::loads,
          .needs = toTranslate("balances in joints that hold all loads, and at most 250,000 entries"),
          .definition = toTranslate(
              "The torque in every balanced joint for one unit of torque in each loaded one: the solution of "
              "the speeds, transposed, with the opposite sign."),
          .forms = torqueForms,
          .table = [](const NamedResult& self, const ResultSource& source, EntryForm form) {
            return torqueTable(self, source.statics, form);
          }};
}

NamedResult cutsetEquations() {
  return {.name = "cutset-equations",
          .title = toTranslate("Cutset equations"),
          .asciiName = "Pt",
          .needs = kNeedsGeometry,
          .definition = toTranslate(
              "A row for each joint and a column for each mesh: the lever of the mesh's force about the "
              "joint's axis. It is P transposed; a row times the forces is the torque in the joint and that "
              "of the loads beyond it."),
          .forms =
              [](const ResultSource& source) {
                return source.snapshot->matroid() != nullptr ? Forms{EntryForm::decimals} : Forms();
              },
          .table = [](const NamedResult& self, const ResultSource& source,
                      EntryForm /*form*/) { return cutsetEquationTable(self, source.snapshot); }};
}

Forms forceForms(const ResultSource& source) {
  const bool isHeld = source.statics && source.statics->report && source.statics->report->isAnswered() &&
                      source.statics->report->problem.hasLoads();
  return isHeld ? Forms{EntryForm::decimals} : Forms();
}

template <ForceTableKind kind>
NamedResult forceResult() {
  return {.name = forceTableCommandName(kind),
          .title = forceTableTitle(kind),
          .asciiName = {},
          .of = ResultOf::loads,
          .needs = toTranslate("loads, and balances that hold them"),
          .forms = forceForms,
          .table = [](const NamedResult& self, const ResultSource& source, EntryForm /*form*/) {
            const AnalysisSnapshot& solved = *source.statics->snapshot;
            return recordTable(
                self, forceTable(*solved.mechanism, *solved.kinematics->model, solved.kinematics->placement(),
                                 *source.statics->report, kind));
          }};
}

NamedResult shiftTorques() {
  return {.name = forceTableCommandName(ForceTableKind::states),
          .title = forceTableTitle(ForceTableKind::states),
          .asciiName = {},
          .of = ResultOf::states,
          .needs = toTranslate("states of a gearbox"),
          .forms =
              [](const ResultSource& source) {
                return source.statics && !source.statics->states.empty() ? Forms{EntryForm::decimals}
                                                                         : Forms();
              },
          .table =
              [](const NamedResult& self, const ResultSource& source, EntryForm /*form*/) {
                const SolvedStatics& statics = *source.statics;
                return recordTable(self, shiftTable(*statics.snapshot->mechanism, statics.states));
              }};
}

std::vector<const NamedResult*>& catalogue() {
  static const NamedResult results[] = {
      matrixResult<MatrixKind::incidence>(
          {Term::incidenceMatrix, "Gamma0", "\\Gamma^0",
           toTranslate("In the incidence matrix an edge's column holds $-1$ in the row of the link that it "
                       "leaves and $1$ in the row of the link that it reaches.")}),
      matrixResult<MatrixKind::reducedIncidence>(
          {Term::reducedIncidenceMatrix, "Gamma", "\\Gamma = \\left[ G \\mid G^* \\right]",
           toTranslate("Without the row of the ground its rows are independent: $G$ for the turning joints, "
                       "$G^*$ for the meshes.")}),
      matrixResult<MatrixKind::path>(
          {Term::pathMatrix, "Z", "Z",
           toTranslate(
               "The turning joints are a spanning tree. The path matrix holds, for each link, the "
               "joints on its path to the ground: $1$ where the path follows the arrow, $-1$ where it "
               "runs against it.")}),
      matrixResult<MatrixKind::spanningTree>(
          {Term::spanningTreeMatrix, "T", "T = G^{*T} Z^T",
           toTranslate("Each mesh closes a fundamental cycle with the joints between its two links. They "
                       "follow from both matrices."),
           true}),
      matrixResult<MatrixKind::cycleBasis>(
          {Term::cycleBasisMatrix, "C", "C = \\left[ T \\mid U \\right]",
           toTranslate("With the meshes themselves, each once, this is the cycle-basis matrix."), true}),
      matrixResult<MatrixKind::cutset>({Term::cutsetMatrix, "Q"}),
      screws(),
      coefficients(),
      solution(),
      ttCircuits(),
      ttCutsets(),
      torques(),
      cutsetEquations(),
      forceResult<ForceTableKind::joints>(),
      forceResult<ForceTableKind::couplings>(),
      forceResult<ForceTableKind::meshes>(),
      forceResult<ForceTableKind::bearings>(),
      forceResult<ForceTableKind::powers>(),
      forceResult<ForceTableKind::circulations>(),
      shiftTorques(),
  };
  static std::vector<const NamedResult*> all = [] {
    std::vector<const NamedResult*> list;
    for (const NamedResult& result : results) list.push_back(&result);
    return list;
  }();
  return all;
}

}  // namespace

std::span<const NamedResult* const> namedResults() {
  return catalogue();
}

const NamedResult* resultNamed(std::string_view name) {
  for (const NamedResult* result : namedResults())
    if (result->name == name) return result;
  return nullptr;
}

const NamedResult& resultOf(MatrixKind kind) {
  const NamedResult* result = resultNamed(matrixCommandName(kind));
  GEARGRAPH_REQUIRE(result != nullptr);
  return *result;
}

std::vector<std::string> resultNames() {
  std::vector<std::string> names;
  for (const NamedResult* result : namedResults()) names.emplace_back(result->name);
  return names;
}

ResultTablePtr resultTable(const NamedResult& result, const ResultSource& source, EntryForm form) {
  const Forms forms = result.forms(source);
  const bool isThere = std::find(forms.begin(), forms.end(), form) != forms.end();
  return isThere ? result.table(result, source, form) : nullptr;
}

ResultTablePtr exactTable(const NamedResult& result, const ResultSource& source) {
  ResultTablePtr table = resultTable(result, source, EntryForm::fractions);
  return table ? table : resultTable(result, source, EntryForm::decimals);
}

std::string definitionOf(const NamedResult& result) {
  return translated(result.term ? definitionOf(*result.term).text : result.definition);
}

AddedResult::AddedResult(const NamedResult& result) {
  GEARGRAPH_REQUIRE(resultNamed(result.name) == nullptr && result.forms != nullptr &&
                    result.table != nullptr);
  catalogue().push_back(&result);
}

AddedResult::~AddedResult() {
  catalogue().pop_back();
}

}  // namespace geargraph
