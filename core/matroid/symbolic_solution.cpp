#include "core/matroid/symbolic_solution.h"

#include "core/matroid/live_solution.h"

namespace geargraph {
namespace {

/// The normalised rows (24) with one unknown per output and one given column per input.
class RatioSystem {
 public:
  RatioSystem(const KinematicModel& model, const CoefficientMatrix& matrix, std::span<const int> meshes,
              std::span<const int> inputs)
      : m_outputs(outputsOf(model, inputs)),
        m_meshes(meshes.begin(), meshes.end()),
        m_columnOf(static_cast<std::size_t>(model.t())) {
    m_joints = m_outputs;
    m_joints.insert(m_joints.end(), inputs.begin(), inputs.end());
    for (std::size_t i = 0; i < m_joints.size(); ++i) m_columnOf[m_joints[i]] = static_cast<int>(i);
    for (const int mesh : meshes) m_rows.push_back(matrix.row(mesh));
  }

  [[nodiscard]] int unknowns() const { return static_cast<int>(m_outputs.size()); }
  [[nodiscard]] int columns() const { return static_cast<int>(m_joints.size()); }
  [[nodiscard]] const std::vector<int>& outputs() const { return m_outputs; }
  [[nodiscard]] int joint(int column) const { return m_joints[static_cast<std::size_t>(column)]; }
  [[nodiscard]] int mesh(int row) const { return m_meshes[static_cast<std::size_t>(row)]; }

  /// Its rows without the columns in `left`; ratio(mesh, sign) and whole(sign) are the field's numbers.
  template <class Value, class Ratio, class Whole>
  [[nodiscard]] SparseRows<Value> rows(const std::vector<char>& left, const Ratio& ratio,
                                       const Whole& whole) const {
    SparseRows<Value> result;
    for (std::size_t row = 0; row < m_rows.size(); ++row) {
      for (const CoefficientMatrix::Entry& entry : m_rows[row]) {
        const int column = m_columnOf[entry.joint];
        if (left[column] != 0) continue;
        result.add(column, entry.tail ? ratio(m_meshes[row], entry.sign) : whole(entry.sign));
      }
      result.endRow();
    }
    return result;
  }

 private:
  std::vector<int> m_outputs;
  std::vector<int> m_meshes;
  std::vector<int> m_columnOf;  ///< by joint
  std::vector<int> m_joints;    ///< by column
  std::vector<std::vector<CoefficientMatrix::Entry>> m_rows;
};

/// Which entries are identically zero, found at ratios drawn at random modulo a prime.
struct Zeros {
  std::vector<std::vector<char>> ofInput;  ///< by input, then by column: the entry vanishes
  std::vector<char> all;                   ///< by column: with every input
};

std::optional<Zeros> zerosOf(const RatioSystem& ratios, const KinematicModel& model,
                             const std::stop_token& stop) {
  const FusedField field;
  ResidueStream random(field.prime(), 0x726174696f73U);
  std::vector<Fused> drawn;
  for (int mesh = 0; mesh < model.c(); ++mesh) drawn.push_back({1, random.next()});
  const auto columns = static_cast<std::size_t>(ratios.columns());
  const auto ratio = [&](int mesh, int sign) { return sign > 0 ? drawn[mesh] : field.negated(drawn[mesh]); };
  const auto whole = [&](int sign) { return field.fromInteger(sign); };
  const auto system = eliminate(field, ratios.rows<Fused>(std::vector<char>(columns, 0), ratio, whole),
                                ratios.unknowns(), ratios.columns(), stop);
  if (!system) return std::nullopt;
  GEARGRAPH_REQUIRE(system->freeColumns.empty());
  Zeros zeros;
  zeros.all.assign(columns, 1);
  std::vector<Fused> x(columns);
  for (int input = ratios.unknowns(); input < ratios.columns(); ++input) {
    if (stop.stop_requested()) return std::nullopt;
    x[input] = field.one();
    substitute(field, *system, x);
    std::vector<char> vanishing(columns);
    for (std::size_t i = 0; i < columns; ++i) {
      vanishing[i] = field.isZero(x[i]) ? 1 : 0;
      if (vanishing[i] == 0) zeros.all[i] = 0;
    }
    zeros.ofInput.push_back(std::move(vanishing));
    x[input] = {};
  }
  return zeros;
}

std::vector<SymbolicLine> linesOf(const RatioSystem& ratios, const RationalFunctionField& field,
                                  const Elimination<RationalFunction>& system) {
  std::vector<SymbolicLine> lines;
  for (const auto& line : system.lines) {
    const auto& rows = system.matrixOf(line.core);
    const RationalFunction& pivot = pivotOf(rows, line.row, line.column);
    SymbolicLine result;
    result.joint = ratios.joint(line.column);
    result.mesh = line.core ? -1 : ratios.mesh(line.row);
    for (int entry = rows.begin(line.row); entry < rows.end(line.row); ++entry) {
      if (rows.column(entry) == line.column) continue;
      result.terms.push_back(
          {ratios.joint(rows.column(entry)), field.negated(field.quotient(rows.value(entry), pivot))});
    }
    lines.push_back(std::move(result));
  }
  return lines;
}

}  // namespace

RatioRingPtr ratioRingOf(const Mechanism& mechanism) {
  std::vector<std::string> names;
  std::vector<Rational> values;
  for (int mesh = 0; mesh < mechanism.c(); ++mesh) {
    names.push_back("i" + std::to_string(mechanism.meshLabel(mesh)));
    values.emplace_back(mechanism.gearMeshes[mesh].tailTeeth, mechanism.gearMeshes[mesh].headTeeth);
  }
  return std::make_shared<RatioRing>(std::move(names), std::move(values));
}

std::optional<SymbolicSolution> solveSymbolic(const Mechanism& mechanism, const KinematicModel& model,
                                              const CoefficientMatrix& matrix, std::span<const int> meshes,
                                              std::span<const int> inputs, const std::stop_token& stop,
                                              int budget) {
  constexpr int kMostTermsOfTheCore = 600;
  const RatioSystem ratios(model, matrix, meshes, inputs);
  const auto zeros = zerosOf(ratios, model, stop);
  if (!zeros) return std::nullopt;

  SymbolicSolution solution;
  solution.ring = ratioRingOf(mechanism);
  solution.inputs.assign(inputs.begin(), inputs.end());
  solution.outputs = ratios.outputs();

  std::stop_source enough;  // the caller's wish, or the core's size
  const std::stop_callback forward(stop, [&] { enough.request_stop(); });
  const RationalFunctionField bounded(solution.ring, kMostTermsOfTheCore, enough);
  const RationalFunctionField field(solution.ring);
  const auto ratio = [&](int mesh, int sign) {
    RationalFunction i = RationalFunction::variable(solution.ring, mesh);
    return sign > 0 ? i : -i;
  };
  const auto whole = [&](int sign) { return field.fromInteger(sign); };
  std::vector<char> left = zeros->all;
  std::fill(left.begin() + ratios.unknowns(), left.end(), 0);
  auto system = eliminate(bounded, ratios.rows<RationalFunction>(left, ratio, whole), ratios.unknowns(),
                          ratios.columns(), enough.get_token());
  if (!system) return std::nullopt;

  solution.lines = linesOf(ratios, field, *system);
  const std::size_t columns = inputs.size();
  solution.matrix.resize(solution.outputs.size() * columns);
  std::vector<std::optional<RationalFunction>> x(static_cast<std::size_t>(ratios.columns()),
                                                 field.fromInteger(0));
  for (std::size_t j = 0; j < columns; ++j) {
    auto& given = x[static_cast<std::size_t>(ratios.unknowns()) + j];
    given = field.one();
    if (!expand(field, *system, zeros->ofInput[j], x, stop, budget)) return std::nullopt;
    given = field.fromInteger(0);
    for (std::size_t i = 0; i < solution.outputs.size(); ++i) {
      if (!x[i]) ++solution.skipped;
      solution.matrix[i * columns + j] = x[i];
    }
  }
  return solution;
}

}  // namespace geargraph
