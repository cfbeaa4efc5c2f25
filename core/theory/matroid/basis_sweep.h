#pragma once

#include <map>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/foundations/base/rational.h"
#include "core/foundations/exact/prime_field.h"

namespace geargraph {

/// Elements as sparse vectors of length `rank`, in an order in which neighbours are close, each with a
/// weight.
struct Representation {
  int rank = 0;
  std::vector<std::vector<std::pair<int, PrimeField::Residue>>> vectors;  ///< (place, value), by place
  std::vector<Rational> weights;
};

/// The sum over all bases of the product of their elements' weights.
///
/// Elements are decided one by one: in the basis (contracted) or not (deleted). What remains is a row space
/// over the undecided elements, kept in reduced echelon form; equal spaces are one state, so a train with
/// loosely coupled parts has few states at a time. A state stores only the rows that decisions have changed.
/// Rank 2 has a closed form.
class FrontierBasisCounter {
 public:
  /// Both arguments outlive it.
  FrontierBasisCounter(const PrimeField& field, const Representation& elements)
      : m_field(field), m_given(elements) {}

  /// Counts `steps` down; std::nullopt once none are left, or if `stop` was requested.
  /// @pre the vectors have rank `rank`
  [[nodiscard]] std::optional<Rational> count(long& steps, const std::stop_token& stop);

 private:
  using Residue = PrimeField::Residue;
  using Row = std::vector<std::pair<int, Residue>>;  ///< (element, value), by element; the first value is 1

  /// Rows by number, in ascending order of their first elements: first the changed rows, then the initial
  /// rows from number `next` on. The last of the changed rows never has the number before `next`.
  struct State {
    std::vector<int> changed;
    int next = 0;
    auto operator<=>(const State&) const = default;
  };
  using States = std::map<State, Rational>;  ///< with the sum of products of weights that lead there

  [[nodiscard]] bool begin(long& steps);
  void decide(const State& state, int element, const Rational& weight, States& next, long& steps);
  [[nodiscard]] std::optional<State> deleted(State state, long& steps);
  [[nodiscard]] Rational closedForm(const State& state, int element) const;

  [[nodiscard]] int rowsOf(const State& state) const {
    return static_cast<int>(state.changed.size()) + m_given.rank - state.next;
  }
  /// The number of the state's row at this place. @pre there is one
  [[nodiscard]] static int numberAt(const State& state, std::size_t place) {
    const std::size_t changed = state.changed.size();
    return place < changed ? state.changed[place] : state.next + static_cast<int>(place - changed);
  }
  [[nodiscard]] const Row& row(int number) const { return *m_rows[static_cast<std::size_t>(number)]; }
  [[nodiscard]] int numberOf(Row row);
  static void dropFirst(State& state);
  static void fold(State& state);

  const PrimeField& m_field;
  const Representation& m_given;
  std::map<Row, int> m_numbers;
  std::vector<const Row*> m_rows;  ///< by number; those of the beginning come first, in order
  Rational m_total;
};

}  // namespace geargraph
