#pragma once

#include <map>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/base/rational.h"
#include "core/exact/prime_field.h"

namespace geargraph {

/// Elements as vectors of length `rank`, in an order in which neighbours are close, each with a weight.
struct Representation {
  int rank = 0;
  std::vector<std::vector<PrimeField::Residue>> vectors;
  std::vector<Rational> weights;
};

/// The sum over all bases of the product of their elements' weights.
///
/// Elements are decided one by one: in the basis (contracted) or not (deleted). What is left is a space of
/// rows over the remaining elements, kept in reduced echelon form; equal spaces are one state, so a train
/// whose parts hang together loosely has few states at a time. Rank 2 has a closed form.
class BaseSweep {
 public:
  BaseSweep(const PrimeField& field, const Representation& elements);

  /// Counts `steps` down; nothing once there are none left, or `stop` was requested.
  [[nodiscard]] std::optional<Rational> count(long& steps, const std::stop_token& stop);

 private:
  using Residue = PrimeField::Residue;
  /// Rows of the space, one behind the other, each over all remaining elements.
  using State = std::vector<Residue>;
  using States = std::map<State, Rational>;  ///< with the sum of products of weights that lead there

  void decide(const State& state, int rows, int element, const Rational& weight, std::vector<States>& next);
  [[nodiscard]] State contracted(const State& state, int rows, int width) const;
  [[nodiscard]] State deleted(const State& state, int rows, int width) const;
  [[nodiscard]] Rational closedForm(const State& state, int rows, int element) const;

  const PrimeField& m_field;
  int m_elements;
  std::vector<Rational> m_weights;
  std::vector<States> m_states;  ///< by rank that is left to choose
  Rational m_total;
};

}  // namespace geargraph
