#include "core/teaching/derivation/hand_calculation.h"

#include <algorithm>
#include <map>

#include "core/foundations/base/contract.h"
#include "core/foundations/base/triple.h"

namespace geargraph {
namespace {

bool isZeroValue(const Rational& value) {
  return value.isZero();
}
bool isZeroValue(const RationalFunction& value) {
  return value.isZero();
}
bool isTrivial(const Rational& value) {
  return value.isZero() || value == Rational(1) || value == Rational(-1);
}
bool isTrivial(const RationalFunction& value) {
  return value.isZero() || value.isOne() || (-value).isOne();
}

/// Fractions, counted.
class CountedRationals {
 public:
  using Value = Rational;
  [[nodiscard]] static Value integer(int value) { return Rational(value); }
  [[nodiscard]] static Value ratio(const TerminalPair& pair) {
    return Rational(pair.headTeeth, pair.tailTeeth);
  }
  [[nodiscard]] static Value inverseRatio(const TerminalPair& pair) {
    return Rational(pair.tailTeeth, pair.headTeeth);
  }
  [[nodiscard]] static bool isTooLong(const Value& /*value*/) { return false; }
};

/// Functions of the ratios, counted. The ratio of a pair is N_head / N_tail; either way it is a quotient of
/// teeth.
class CountedFunctions {
 public:
  using Value = RationalFunction;
  explicit CountedFunctions(RatioRingPtr ring) : m_ring(std::move(ring)) {}
  [[nodiscard]] Value integer(int value) const { return RationalFunction::fromInteger(m_ring, value); }
  [[nodiscard]] Value ratio(const TerminalPair& pair) const {
    return RationalFunction::power(m_ring, 1, pair.mesh, -1);
  }
  [[nodiscard]] Value inverseRatio(const TerminalPair& pair) const {
    return RationalFunction::power(m_ring, 1, pair.mesh, 1);
  }
  [[nodiscard]] static bool isTooLong(const Value& value) { return value.termCount() > kMaxHandTerms; }

 private:
  RatioRingPtr m_ring;
};

/// Arithmetic that counts what it does.
template <class Numbers>
class Counted {
 public:
  using Value = typename Numbers::Value;
  explicit Counted(Numbers numbers) : m_numbers(std::move(numbers)) {}

  [[nodiscard]] const Numbers& numbers() const { return m_numbers; }
  [[nodiscard]] const Operations& operations() const { return m_operations; }
  [[nodiscard]] bool isTooLong() const { return m_isTooLong; }

  [[nodiscard]] Value product(const Value& a, const Value& b) {
    if (isZeroValue(a) || isZeroValue(b)) return m_numbers.integer(0);
    if (!isTrivial(a) && !isTrivial(b)) ++m_operations.products;
    return checked(a * b);
  }
  [[nodiscard]] Value quotient(const Value& a, const Value& b) {
    if (isZeroValue(a)) return m_numbers.integer(0);
    if (!isTrivial(b)) ++m_operations.products;
    return checked(a / b);
  }
  [[nodiscard]] Value sum(const Value& a, const Value& b) {
    if (isZeroValue(a)) return b;
    if (isZeroValue(b)) return a;
    ++m_operations.sums;
    return checked(a + b);
  }

 private:
  Value checked(Value value) {
    m_isTooLong = m_isTooLong || Numbers::isTooLong(value);
    return value;
  }

  Numbers m_numbers;
  Operations m_operations;
  bool m_isTooLong = false;
};

/// Makes the left square of `rows` the unit matrix; columns from `size` on go along. Gives the order of the
/// rows by pivot.
template <class Numbers>
void reduce(Counted<Numbers>& counted, std::vector<std::vector<typename Numbers::Value>>& rows,
            std::size_t size) {
  using Value = typename Numbers::Value;
  // The unknowns' part decides; a pivot of 1 or -1 needs no quotient.
  const auto effort = [size](const std::vector<Value>& row, std::size_t column) {
    const auto entries = std::count_if(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(size),
                                       [](const Value& value) { return !isZeroValue(value); });
    return std::pair(entries, isTrivial(row[column]) ? 0 : 1);
  };
  for (std::size_t column = 0; column < size && !counted.isTooLong(); ++column) {
    std::size_t pivot = size;
    for (std::size_t row = column; row < size; ++row) {
      if (isZeroValue(rows[row][column])) continue;
      if (pivot == size || effort(rows[row], column) < effort(rows[pivot], column)) pivot = row;
    }
    GEARGRAPH_REQUIRE(pivot < size);
    std::swap(rows[pivot], rows[column]);
    const Value divisor = rows[column][column];
    for (Value& value : rows[column]) value = counted.quotient(value, divisor);
    for (std::size_t row = 0; row < size; ++row) {
      if (row == column || isZeroValue(rows[row][column])) continue;
      const Value factor = -rows[row][column];
      rows[row][column] = counted.numbers().integer(0);  // that it comes to 0 needs no arithmetic
      for (std::size_t i = 0; i < rows[row].size(); ++i) {
        if (i != column) rows[row][i] = counted.sum(rows[row][i], counted.product(factor, rows[column][i]));
      }
    }
  }
}

template <class Numbers>
std::optional<HandSolution<typename Numbers::Value>> byInverse(Numbers numbers,
                                                               const HandRows<typename Numbers::Value>& rows,
                                                               std::span<const int> inputs,
                                                               std::span<const int> outputs) {
  using Value = typename Numbers::Value;
  GEARGRAPH_REQUIRE(rows.size() == outputs.size());
  Counted<Numbers> counted(std::move(numbers));
  const std::size_t size = outputs.size();
  const auto at = [](JointOrdinal joint) { return static_cast<std::size_t>(joint); };
  std::vector<std::vector<Value>> work;
  for (std::size_t row = 0; row < size; ++row) {
    std::vector<Value>& line = work.emplace_back();
    for (const int output : outputs) line.push_back(rows[row][at(output)]);
    for (std::size_t i = 0; i < size; ++i) line.push_back(counted.numbers().integer(i == row ? 1 : 0));
  }
  reduce(counted, work, size);
  HandSolution<Value> solution;
  for (std::size_t row = 0; row < size && !counted.isTooLong(); ++row) {
    std::vector<Value>& line = solution.matrix.emplace_back();
    for (const int input : inputs) {
      Value sum = counted.numbers().integer(0);
      for (std::size_t i = 0; i < size; ++i)
        sum = counted.sum(sum, counted.product(work[row][size + i], rows[i][at(input)]));
      line.push_back(-sum);
    }
  }
  if (counted.isTooLong()) return std::nullopt;
  solution.operations = counted.operations();
  return solution;
}

/// The chain of the T-T graph: joint rates as sums over the inputs.
template <class Numbers>
class CalculationChain {
 public:
  using Value = typename Numbers::Value;

  /// `together`: independent ones of the plan's coupled equations.
  CalculationChain(Numbers numbers, const TtGraph& graph, const SubstitutionPlan& plan,
                   std::vector<int> together)
      : m_counted(std::move(numbers)),
        m_graph(graph),
        m_plan(plan),
        m_together(std::move(together)),
        m_known(static_cast<std::size_t>(graph.graph().t())) {
    for (std::size_t i = 0; i < plan.inputs.size(); ++i) {
      Sum unit = nothing();
      unit[i] = m_counted.numbers().integer(1);
      known(plan.inputs[i]) = std::move(unit);
    }
  }

  std::optional<HandSolution<Value>> run() {
    for (const SubstitutionPlan::Step& step : m_plan.steps) {
      if (m_counted.isTooLong()) return std::nullopt;
      if (step.equation < m_graph.graph().c()) {
        solveMesh(step.equation, step.joint);
      } else {
        solveHeld(step.equation, step.joint);
      }
    }
    solveCoupled();
    if (m_counted.isTooLong()) return std::nullopt;
    HandSolution<Value> solution;
    for (const int output : m_plan.outputs) solution.matrix.push_back(*known(output));
    solution.operations = m_counted.operations();
    solution.together = std::move(m_together);
    return solution;
  }

 private:
  using Sum = std::vector<Value>;  ///< by input

  std::optional<Sum>& known(JointOrdinal joint) { return m_known[joint]; }
  [[nodiscard]] Sum nothing() const { return Sum(m_plan.inputs.size(), m_counted.numbers().integer(0)); }
  void add(Sum& sum, const Sum& term, int sign) {
    for (std::size_t i = 0; i < sum.size(); ++i)
      sum[i] = m_counted.sum(sum[i], sign > 0 ? term[i] : -term[i]);
  }
  void scale(Sum& sum, const Value& factor) {
    for (Value& value : sum) value = m_counted.product(factor, value);
  }
  void divide(Sum& sum, const Value& divisor) {
    for (Value& value : sum) value = m_counted.quotient(value, divisor);
  }

  /// The known terms of a circuit, and the coefficient of the unknown in it.
  std::pair<Sum, int> circuit(std::span<const CircuitTerm> terms, int unknown) {
    std::pair<Sum, int> result{nothing(), 0};
    for (const CircuitTerm& term : terms) {
      if (term.joint == unknown) {
        result.second += term.coefficient;
      } else {
        add(result.first, *known(term.joint), term.coefficient);
      }
    }
    return result;
  }

  /// w_ik = s n w_jk, each chord the sum of its circuit, one of which has the unknown.
  void solveMesh(MeshOrdinal mesh, int unknown) {
    const TerminalPair& pair = *m_graph.terminal(mesh);
    auto [tail, inTail] = circuit(m_graph.tailCircuit(mesh), unknown);
    auto [head, inHead] = circuit(m_graph.headCircuit(mesh), unknown);
    const Value ratio = m_counted.numbers().ratio(pair);
    Sum value;
    if (inHead == 0) {  // tail: a x + A = s n B
      scale(head, ratio);
      value = nothing();
      add(value, head, pair.sign * inTail);
      add(value, tail, -inTail);
    } else if (inTail == 0) {  // b x + B = s A / n
      scale(tail, m_counted.numbers().inverseRatio(pair));
      value = nothing();
      add(value, tail, pair.sign * inHead);
      add(value, head, -inHead);
    } else {  // (a - s n b) x = s n B - A
      scale(head, ratio);
      value = nothing();
      add(value, head, pair.sign);
      add(value, tail, -1);
      const Value signedRatio = pair.sign * inHead > 0 ? -ratio : ratio;
      divide(value, m_counted.sum(m_counted.numbers().integer(inTail), signedRatio));
    }
    known(unknown) = std::move(value);
  }

  void solveHeld(int equation, int unknown) {
    auto [rest, coefficient] = circuit(m_graph.heldCircuit(equation).terms, unknown);
    Sum value = nothing();
    add(value, rest, -coefficient);
    known(unknown) = std::move(value);
  }

  /// What no single equation gives: elimination over the unknowns that are left.
  void solveCoupled() {
    std::vector<int> unknowns;
    for (const int output : m_plan.outputs) {
      if (!known(output)) unknowns.push_back(output);
    }
    if (unknowns.empty() || m_counted.isTooLong()) return;
    std::vector<Sum> rows;
    for (const int equation : m_together) rows.push_back(coupledRow(equation, unknowns));
    const std::size_t size = unknowns.size();
    GEARGRAPH_REQUIRE(rows.size() == size);
    reduce(m_counted, rows, size);
    for (std::size_t i = 0; i < size && !m_counted.isTooLong(); ++i)
      known(unknowns[i]) = Sum(rows[i].begin() + static_cast<std::ptrdiff_t>(size), rows[i].end());
  }

  /// The unknowns' coefficients, then minus the known part by input.
  Sum coupledRow(int equation, const std::vector<int>& unknowns) {
    Sum row(unknowns.size(), m_counted.numbers().integer(0));
    Sum rest = nothing();
    const auto place = [&](std::span<const CircuitTerm> terms, const Value& factor) {
      Sum part = nothing();
      for (const CircuitTerm& term : terms) {
        const auto found = std::find(unknowns.begin(), unknowns.end(), term.joint);
        if (found == unknowns.end()) {
          add(part, *known(term.joint), term.coefficient);
          continue;
        }
        Value& entry = row[static_cast<std::size_t>(found - unknowns.begin())];
        entry = m_counted.sum(entry, term.coefficient > 0 ? factor : -factor);
      }
      scale(part, factor);
      add(rest, part, -1);
    };
    if (equation < m_graph.graph().c()) {
      const TerminalPair& pair = *m_graph.terminal(equation);
      const Value ratio = m_counted.numbers().ratio(pair);
      place(m_graph.tailCircuit(equation), m_counted.numbers().integer(1));
      place(m_graph.headCircuit(equation), pair.sign > 0 ? -ratio : ratio);
    } else {
      place(m_graph.heldCircuit(equation).terms, m_counted.numbers().integer(1));
    }
    row.insert(row.end(), rest.begin(), rest.end());
    return row;
  }

  Counted<Numbers> m_counted;
  const TtGraph& m_graph;
  const SubstitutionPlan& m_plan;
  std::vector<int> m_together;
  ByJoint<std::optional<Sum>> m_known;
};

/// The coupled equations that are independent in the unknowns that they have to give, the first
/// ones.
std::vector<int> independentOf(const TtGraph& graph, const SubstitutionPlan& plan) {
  ByJoint<char> isGiven(static_cast<std::size_t>(graph.graph().t()), 0);
  for (const int input : plan.inputs) isGiven[input] = 1;
  for (const SubstitutionPlan::Step& step : plan.steps) isGiven[step.joint] = 1;
  std::vector<int> chosen;
  std::vector<std::map<int, Rational>> reduced;
  for (const int equation : plan.coupledEquations) {
    std::map<int, Rational> row;
    const auto add = [&](std::span<const CircuitTerm> terms, const Rational& factor) {
      for (const CircuitTerm& term : terms) {
        if (!isGiven[term.joint]) row[term.joint] += factor * Rational(term.coefficient);
      }
    };
    if (equation < graph.graph().c()) {
      const TerminalPair& pair = *graph.terminal(equation);
      add(graph.tailCircuit(equation), Rational(pair.tailTeeth));
      add(graph.headCircuit(equation), Rational(-pair.sign * pair.headTeeth));
    } else {
      add(graph.heldCircuit(equation).terms, 1);
    }
    const auto withoutZeros = [&] {
      std::erase_if(row, [](const auto& entry) { return entry.second.isZero(); });
    };
    withoutZeros();
    for (const std::map<int, Rational>& earlier : reduced) {
      const auto found = row.find(earlier.begin()->first);
      if (found == row.end()) continue;
      const Rational factor = found->second / earlier.begin()->second;
      for (const auto& [joint, value] : earlier) row[joint] -= factor * value;
      withoutZeros();
    }
    if (row.empty()) continue;
    chosen.push_back(equation);
    reduced.push_back(std::move(row));
  }
  return chosen;
}

/// Counts sums and products of doubles that are exactly what the document says they are.
class CountedDoubles {
 public:
  double difference(double a, double b) {
    if (a != 0 && b != 0) ++m_operations.sums;
    return a - b;
  }
  double product(double a, double b) {
    const auto isPlain = [](double v) { return v == 0 || v == 1 || v == -1; };
    if (!isPlain(a) && !isPlain(b)) ++m_operations.products;
    return a * b;
  }
  double dot(const Vector3& a, const Vector3& b) {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double term = product(a[i], b[i]);
      if (sum != 0 && term != 0) ++m_operations.sums;
      sum += term;
    }
    return sum;
  }
  Vector3 cross(const Vector3& a, const Vector3& b) {
    const auto part = [&](std::size_t i, std::size_t j) {
      return difference(product(a[i], b[j]), product(a[j], b[i]));
    };
    return {part(1, 2), part(2, 0), part(0, 1)};
  }
  [[nodiscard]] const Operations& operations() const { return m_operations; }

 private:
  Operations m_operations;
};

}  // namespace

HandSolution<Rational> solvedByInverse(const HandRows<Rational>& rows, std::span<const int> inputs,
                                       std::span<const int> outputs) {
  return *byInverse(CountedRationals(), rows, inputs, outputs);
}

std::optional<HandSolution<RationalFunction>> solvedByInverse(const HandRows<RationalFunction>& rows,
                                                              std::span<const int> inputs,
                                                              std::span<const int> outputs,
                                                              const RatioRingPtr& ring) {
  return byInverse(CountedFunctions(ring), rows, inputs, outputs);
}

HandSolution<Rational> solvedBySubstitution(const TtGraph& graph, const SubstitutionPlan& plan) {
  return *CalculationChain(CountedRationals(), graph, plan, independentOf(graph, plan)).run();
}

std::optional<HandSolution<RationalFunction>> solvedBySubstitution(const TtGraph& graph,
                                                                   const SubstitutionPlan& plan,
                                                                   std::span<const int> together,
                                                                   const RatioRingPtr& ring) {
  return CalculationChain(CountedFunctions(ring), graph, plan, {together.begin(), together.end()}).run();
}

Operations geometryOperations(const Mechanism& mechanism, const KinematicModel& model,
                              const Placement& placement) {
  CountedDoubles counted;
  const CoefficientMatrix matrix(mechanism, model, placement);
  long long ratios = 0;
  for (MeshOrdinal mesh = 0; mesh < model.c(); ++mesh) {
    const MeshGeometry& geometry = *placement.meshes[mesh];
    for (const CoefficientMatrix::Entry& entry : matrix.row(mesh)) {
      const int axis = placement.tree->axisOf[entry.joint];
      const AxisLine& line = placement.axes[axis];
      Vector3 toAxis{};
      for (std::size_t i = 0; i < 3; ++i)
        toAxis[i] = counted.difference(line.point[i], geometry.pitchPoint[i]);
      (void)counted.dot(counted.cross(toAxis, line.direction), geometry.normal);
    }
    ++ratios;
  }
  Operations all = counted.operations();
  all.products += ratios;
  return all;
}

}  // namespace geargraph
