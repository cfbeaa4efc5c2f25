#include "core/theory/matroid/symbolic_solution.h"

#include <algorithm>
#include <memory_resource>
#include <utility>

#include "core/foundations/base/scratch.h"
#include "core/theory/matroid/live_solution.h"

namespace geargraph {
namespace {

constexpr std::size_t kScratch = 32 * 1024;

/// The normalised rows (24), and those of engaged couplings, with one unknown per output and one given column
/// per input.
class RatioSystem {
 public:
  RatioSystem(const KinematicModel& model, const CoefficientMatrix& matrix, std::span<const int> equations,
              std::span<const int> inputs)
      : m_outputs(outputsOf(model, inputs)),
        m_equations(equations.begin(), equations.end()),
        m_columnOf(static_cast<std::size_t>(model.t())) {
    m_joints = m_outputs;
    m_joints.insert(m_joints.end(), inputs.begin(), inputs.end());
    for (std::size_t i = 0; i < m_joints.size(); ++i) m_columnOf[m_joints[i]] = static_cast<int>(i);
    m_starts.reserve(m_equations.size() + 1);
    m_entries.reserve(4 * m_equations.size());
    for (const int equation : equations) {
      if (equation < model.c()) {
        matrix.appendRow(equation, m_entries);
      } else {
        for (const auto& term : model.heldRow(equation).joints)
          m_entries.push_back({term.of, false, term.factor, static_cast<double>(term.factor)});
      }
      m_starts.push_back(m_entries.size());
    }
  }

  [[nodiscard]] int unknowns() const { return static_cast<int>(m_outputs.size()); }
  [[nodiscard]] int columns() const { return static_cast<int>(m_joints.size()); }
  [[nodiscard]] const std::vector<int>& outputs() const { return m_outputs; }
  [[nodiscard]] JointOrdinal joint(int column) const { return m_joints[static_cast<std::size_t>(column)]; }
  [[nodiscard]] int equation(int row) const { return m_equations[static_cast<std::size_t>(row)]; }

  /// Its rows at some ratios, by mesh; of a coupling there is none in it.
  [[nodiscard]] SparseRows<ModularDouble> rows(const ModularDoubleField& field,
                                               std::span<const ModularDouble> drawn,
                                               std::pmr::memory_resource& memory) const {
    SparseRows<ModularDouble> result(&memory);
    result.reserve(m_equations.size(), m_entries.size());
    for (std::size_t row = 0; row < m_equations.size(); ++row) {
      for (std::size_t i = m_starts[row]; i < m_starts[row + 1]; ++i) {
        const CoefficientMatrix::Entry& entry = m_entries[i];
        const ModularDouble value = entry.tail ? drawn[m_equations[row]] : field.one();
        result.add(m_columnOf[entry.joint], entry.sign > 0 ? value : field.negated(value));
      }
      result.endRow();
    }
    return result;
  }

  /// The same over the ratios, without the columns in `left`. Rows that peeling gives a pivot are divided by
  /// it, which is a ratio or 1: their other entries are the coefficients of the solution's lines, negated.
  [[nodiscard]] SparseRows<RationalFunction> rows(const std::vector<char>& left,
                                                  const SingletonElimination& peeling,
                                                  const RatioRingPtr& ring,
                                                  std::pmr::memory_resource& memory) const {
    std::pmr::vector<int> pivots(m_equations.size(), -1, &memory);
    for (const Pivot& pivot : peeling.first) pivots[pivot.row] = pivot.column;
    for (const Pivot& pivot : peeling.last) pivots[pivot.row] = pivot.column;
    SparseRows<RationalFunction> result(&memory);
    result.reserve(m_equations.size(), m_entries.size());
    for (std::size_t row = 0; row < m_equations.size(); ++row) {
      int sign = 1;
      int power = 0;
      for (std::size_t i = m_starts[row]; i < m_starts[row + 1]; ++i) {
        if (m_columnOf[m_entries[i].joint] != pivots[row]) continue;
        sign = m_entries[i].sign;
        power = m_entries[i].tail ? 1 : 0;
      }
      for (std::size_t i = m_starts[row]; i < m_starts[row + 1]; ++i) {
        const CoefficientMatrix::Entry& entry = m_entries[i];
        const int column = m_columnOf[entry.joint];
        if (left[static_cast<std::size_t>(column)] != 0) continue;
        const int exponent = (entry.tail ? 1 : 0) - power;
        // A row of a coupling has no ratio, its entries are +-1: any variable to the power 0 does.
        result.add(column, RationalFunction::power(ring, sign * entry.sign,
                                                   exponent == 0 ? 0 : m_equations[row], exponent));
      }
      result.endRow();
    }
    return result;
  }

  /// Where the rows without the columns in `left` have entries.
  [[nodiscard]] SparsePattern pattern(const std::vector<char>& left,
                                      std::pmr::memory_resource& memory) const {
    SparsePattern result(&memory);
    result.starts.reserve(m_equations.size() + 1);
    result.columns.reserve(m_entries.size());
    for (std::size_t row = 0; row < m_equations.size(); ++row) {
      for (std::size_t i = m_starts[row]; i < m_starts[row + 1]; ++i) {
        const int column = m_columnOf[m_entries[i].joint];
        if (left[static_cast<std::size_t>(column)] == 0) result.columns.push_back(column);
      }
      result.starts.push_back(static_cast<int>(result.columns.size()));
    }
    return result;
  }

 private:
  std::vector<int> m_outputs;
  std::vector<int> m_equations;
  ByJoint<int> m_columnOf;
  std::vector<int> m_joints;                        ///< by column
  std::vector<std::size_t> m_starts{0};             ///< by row, and one behind the last
  std::vector<CoefficientMatrix::Entry> m_entries;  ///< of the rows, one behind the other
};

/// Which entries are identically zero, found at ratios drawn at random modulo a prime.
struct Zeros {
  std::vector<std::vector<char>> ofInput;  ///< by input, then by column: the entry vanishes
  std::vector<char> all;                   ///< by column: with every input
};

std::optional<Zeros> zerosOf(const RatioSystem& ratios, const KinematicModel& model,
                             const std::stop_token& stop) {
  const ModularDoubleField field;
  ResidueStream random(field.prime(), 0x726174696f73U);
  Scratch<kScratch> scratch;
  std::pmr::vector<ModularDouble> drawn(&scratch);
  drawn.reserve(static_cast<std::size_t>(model.c()));
  for (MeshOrdinal mesh = 0; mesh < model.c(); ++mesh) drawn.push_back({1, random.next()});
  const auto columns = static_cast<std::size_t>(ratios.columns());
  const auto system =
      eliminate(field, ratios.rows(field, drawn, scratch), ratios.unknowns(), ratios.columns(), stop);
  if (!system) return std::nullopt;
  GEARGRAPH_REQUIRE(system->freeColumns.empty());
  Zeros zeros;
  zeros.all.assign(columns, 1);
  constexpr std::size_t kAtOnce = 4;
  std::pmr::vector<ModularDouble> x(&scratch);
  for (std::size_t first = static_cast<std::size_t>(ratios.unknowns()); first < columns; first += kAtOnce) {
    if (stop.stop_requested()) return std::nullopt;
    const std::size_t width = std::min(kAtOnce, columns - first);
    x.assign(columns * width, ModularDouble());
    for (std::size_t k = 0; k < width; ++k) x[(first + k) * width + k] = field.one();
    substitute(field, *system, x, width);
    for (std::size_t k = 0; k < width; ++k) {
      std::vector<char>& vanishing = zeros.ofInput.emplace_back(columns);
      for (std::size_t i = 0; i < columns; ++i) {
        vanishing[i] = field.isZero(x[i * width + k]) ? 1 : 0;
        zeros.all[i] &= vanishing[i];
      }
    }
  }
  return zeros;
}

std::vector<SymbolicLine> linesOf(const RatioSystem& ratios, const Elimination<RationalFunction>& system) {
  std::vector<SymbolicLine> lines;
  lines.reserve(system.lines.size());
  for (const auto& line : system.lines) {
    const auto& rows = system.matrixOf(line.core);
    const RationalFunction& pivot = pivotOf(rows, line.row, line.column);
    SymbolicLine& result = lines.emplace_back();
    result.joint = ratios.joint(line.column);
    result.equation = line.core ? -1 : ratios.equation(line.row);
    result.terms.reserve(static_cast<std::size_t>(rows.end(line.row) - rows.begin(line.row)) - 1);
    for (int entry = rows.begin(line.row); entry < rows.end(line.row); ++entry) {
      if (rows.column(entry) == line.column) continue;
      SymbolicLine::Term& term = result.terms.emplace_back();
      term.joint = ratios.joint(rows.column(entry));
      term.coefficient = -rows.value(entry);
      if (!pivot.isOne()) term.coefficient /= pivot;
    }
  }
  return lines;
}

}  // namespace

RatioRingPtr ratioRingOf(const Mechanism& mechanism) {
  std::vector<std::string> names;
  std::vector<RatioRing::Teeth> teeth;
  names.reserve(mechanism.gearMeshes.size());
  teeth.reserve(mechanism.gearMeshes.size());
  for (MeshOrdinal mesh = 0; mesh < mechanism.c(); ++mesh) {
    names.emplace_back("i").append(std::to_string(mechanism.meshLabel(mesh)));
    const GearMesh& element = mechanism.gearMeshes[mesh];
    const bool ofTail = slides(saidKind(element)) && tailSlides(mechanism, element);
    const MeshWeights weights = weightsOf(element, ofTail).value_or(MeshWeights());
    teeth.push_back({weights.tail, weights.head});
  }
  return std::make_shared<RatioRing>(std::move(names), std::move(teeth));
}

std::optional<SymbolicSolution> solveSymbolic(const Mechanism& mechanism, const KinematicModel& model,
                                              const CoefficientMatrix& matrix, std::span<const int> equations,
                                              std::span<const int> inputs, const std::stop_token& stop,
                                              ExpansionBudget budget) {
  constexpr int kMaxTermsOfTheCore = 600;
  const RatioSystem ratios(model, matrix, equations, inputs);
  const auto zeros = zerosOf(ratios, model, stop);
  if (!zeros) return std::nullopt;

  SymbolicSolution solution;
  solution.ring = ratioRingOf(mechanism);
  solution.inputs.assign(inputs.begin(), inputs.end());
  solution.outputs = ratios.outputs();

  std::stop_source enough;  // the caller's request, or the core's size
  const std::stop_callback forward(stop, [&] { enough.request_stop(); });
  const RationalFunctionField bounded(solution.ring, kMaxTermsOfTheCore, enough);
  const RationalFunctionField field(solution.ring);
  std::vector<char> left = zeros->all;
  std::fill(left.begin() + ratios.unknowns(), left.end(), 0);
  Scratch<kScratch> scratch;
  SingletonElimination peeling(ratios.pattern(left, scratch), ratios.unknowns());
  auto rows = ratios.rows(left, peeling, solution.ring, scratch);
  const auto system = eliminate(bounded, std::move(rows), std::move(peeling), ratios.unknowns(),
                                ratios.columns(), enough.get_token());
  if (!system) return std::nullopt;

  solution.lines = linesOf(ratios, *system);
  const std::size_t columns = inputs.size();
  solution.matrix.resize(solution.outputs.size() * columns);
  std::vector<std::optional<RationalFunction>> x(static_cast<std::size_t>(ratios.columns()),
                                                 RationalFunction());
  for (std::size_t j = 0; j < columns; ++j) {
    auto& given = x[static_cast<std::size_t>(ratios.unknowns()) + j];
    given = field.one();
    if (!expand(field, *system, zeros->ofInput[j], x, budget, stop)) return std::nullopt;
    given = RationalFunction();
    for (std::size_t i = 0; i < solution.outputs.size(); ++i) {
      auto& entry = solution.matrix[i * columns + j];
      if (!x[i]) {
        ++solution.skipped;
        x[i].emplace();
      } else if (x[i]->isZero()) {
        entry.emplace();
      } else {
        entry.emplace(std::exchange(*x[i], RationalFunction()));
      }
    }
  }
  return solution;
}

}  // namespace geargraph
