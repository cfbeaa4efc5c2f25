#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/theory/matroid/structure.h"

namespace geargraph {

/// All valid sets of inputs: the bases of the dual matroid of P, found from K, the rates of all joints in
/// terms of those of one valid set. K is stored modulo a 61-bit prime.
class InputSets {
 public:
  /// std::nullopt if `stop` was requested or K has more than 20 million entries.
  /// @pre `inputs` is a valid set (chooseInputs())
  [[nodiscard]] static std::optional<InputSets> of(const KinematicModel& model,
                                                   const ModularDoubleField& field,
                                                   std::span<const int> inputs,
                                                   const std::stop_token& stop = {});

  /// May joint y be driven instead of the input x, the others staying? Exactly if K(y, x) is not 0.
  [[nodiscard]] bool canReplace(int x, int y) const;
  /// All joints y for which canReplace(x, y), by label.
  [[nodiscard]] std::vector<int> replacementsFor(int x) const;

  /// How many valid sets there are, exactly. std::nullopt if `stop` was requested or the matroid is too
  /// strongly coupled to count within the budget (some seconds).
  ///
  /// Independent parts multiply; rigidly tied joints (parallel elements) and joints of which one at least is
  /// always driven (series elements) are merged like resistors; what is left is decided joint by joint.
  [[nodiscard]] std::optional<Rational> count(const std::stop_token& stop = {}) const;

  /// The first sets in the order of their sorted labels, `limit` at most, joints ascending. Where that takes
  /// too long (hundreds of coupled inputs): the set given to of() and those that differ from it by one joint.
  [[nodiscard]] std::vector<std::vector<int>> list(std::size_t limit, const std::stop_token& stop = {}) const;

 private:
  explicit InputSets(const PrimeField& field) : m_field(field) {}
  [[nodiscard]] std::vector<std::vector<int>> neighbours(std::size_t limit) const;

  PrimeField m_field;
  std::vector<int> m_inputs;
  /// By joint: the non-zeros of its row of K, by place of the input.
  std::vector<std::vector<std::pair<int, PrimeField::Residue>>> m_rates;
};

}  // namespace geargraph
