#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/design/teeth_search/teeth_problem.h"

namespace geargraph {

/// An assignment of teeth with its exact ratios.
struct FoundTeeth {
  std::vector<int> teeth;        ///< by wheel
  std::vector<Rational> ratios;  ///< by wish
  std::vector<Rational> errors;  ///< relative, by wish
  Rational error;                ///< the largest of them without its sign
};

/// The ratios and errors of these teeth. @pre no polynomial of a ratio is 0
[[nodiscard]] FoundTeeth foundTeeth(const TeethProblem& problem, std::span<const int> teeth);

/// Keeps the best of the choices that it is offered: the smallest error, then the smallest largest wheel,
/// then the teeth in their order. Exact: errors are compared as fractions. Cost: O(log most) for a choice
/// that is kept, a few operations on doubles for others.
class BestChoices {
 public:
  BestChoices(const TeethProblem& problem, std::size_t most) : m_problem(problem), m_most(most) {}

  void offer(std::span<const int> teeth);
  /// The best first.
  [[nodiscard]] std::vector<FoundTeeth> take() &&;

 private:
  const TeethProblem& m_problem;
  std::size_t m_most;
  std::vector<FoundTeeth> m_heap;  ///< the worst first
  double m_worst = 0;              ///< its error, a little enlarged
};

/// The largest error of these teeth as a double, right to a few units of its last place; infinite where a
/// polynomial is 0.
[[nodiscard]] double nearError(const TeethProblem& problem, std::span<const int> teeth);

}  // namespace geargraph
