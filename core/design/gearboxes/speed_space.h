#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/design/gearboxes/gear_layout.h"
#include "core/foundations/base/rational.h"
#include "core/foundations/exact/prime_field.h"

namespace geargraph {

constexpr int kMaxFreedom = 4;  ///< of a layout with nothing engaged

/// Numbers of a speed space: doubles to search with, residues for what holds at general tooth counts,
/// fractions for what is shown.
struct DoubleNumbers {
  using Value = double;
  [[nodiscard]] double whole(int value) const { return value; }
  [[nodiscard]] double add(double a, double b) const { return a + b; }
  [[nodiscard]] double subtract(double a, double b) const { return a - b; }
  [[nodiscard]] double multiply(double a, double b) const { return a * b; }
  [[nodiscard]] double inverse(double a) const { return 1 / a; }
  [[nodiscard]] bool isZero(double a) const { return std::abs(a) < 1e-9; }
  [[nodiscard]] bool isBetterPivot(double a, double b) const { return std::abs(a) > std::abs(b); }
};

struct ResidueNumbers {
  PrimeField field;
  using Value = PrimeField::Residue;
  [[nodiscard]] Value whole(int value) const { return field.fromInteger(value); }
  [[nodiscard]] Value add(Value a, Value b) const { return field.add(a, b); }
  [[nodiscard]] Value subtract(Value a, Value b) const { return field.subtract(a, b); }
  [[nodiscard]] Value multiply(Value a, Value b) const { return field.multiply(a, b); }
  [[nodiscard]] Value inverse(Value a) const { return field.inverse(a); }
  [[nodiscard]] bool isZero(Value a) const { return a == 0; }
  [[nodiscard]] bool isBetterPivot(Value, Value) const { return false; }
};

struct FractionNumbers {
  using Value = Rational;
  [[nodiscard]] Rational whole(int value) const { return value; }
  [[nodiscard]] Rational add(const Rational& a, const Rational& b) const { return a + b; }
  [[nodiscard]] Rational subtract(const Rational& a, const Rational& b) const { return a - b; }
  [[nodiscard]] Rational multiply(const Rational& a, const Rational& b) const { return a * b; }
  [[nodiscard]] Rational inverse(const Rational& a) const { return a.inverse(); }
  [[nodiscard]] bool isZero(const Rational& a) const { return a.isZero(); }
  [[nodiscard]] bool isBetterPivot(const Rational&, const Rational&) const { return false; }
};

/// The speeds of all links as linear functions of as many free ones as the layout has freedoms: row i the
/// coefficients of link i, row 0 the housing's, all 0.
template <class Value>
struct SpeedSpace {
  int freedom = 0;
  std::array<std::array<Value, kMaxFreedom>, kMaxShafts + 1> rows{};
};

/// `k` by set: ring over sun, above 0. std::nullopt if the equations of the sets depend on each other.
template <class Numbers>
[[nodiscard]] std::optional<SpeedSpace<typename Numbers::Value>> speedSpace(
    const BasicSets& sets, const GearLayout& layout, int shafts, std::span<const typename Numbers::Value> k,
    const Numbers& numbers) {
  using Value = typename Numbers::Value;
  std::array<std::array<Value, kMaxShafts + 1>, kMaxSets> matrix{};
  const int equations = static_cast<int>(sets.size());
  for (auto& row : matrix) row.fill(numbers.whole(0));
  for (int set = 0; set < equations; ++set) {
    auto& row = matrix[static_cast<std::size_t>(set)];
    const auto at = static_cast<std::size_t>(set);
    const Value ring = sets[at].isDouble ? numbers.subtract(numbers.whole(0), k[at]) : k[at];
    const auto put = [&](SetMember member, const Value& value) {
      Value& entry = row[static_cast<std::size_t>(layout.link(set, member))];
      entry = numbers.add(entry, value);
    };
    put(SetMember::sun, numbers.whole(1));
    put(SetMember::ring, ring);
    put(SetMember::carrier, numbers.subtract(numbers.whole(-1), ring));
  }
  std::array<int, kMaxSets> pivots{};
  std::array<bool, kMaxShafts + 1> isPivot{};
  for (int row = 0; row < equations; ++row) {
    auto& own = matrix[static_cast<std::size_t>(row)];
    int best = 0;
    for (int column = 1; column <= shafts; ++column) {
      const Value& entry = own[static_cast<std::size_t>(column)];
      if (numbers.isZero(entry)) continue;
      if (best == 0 || numbers.isBetterPivot(entry, own[static_cast<std::size_t>(best)])) best = column;
    }
    if (best == 0) return std::nullopt;
    pivots[static_cast<std::size_t>(row)] = best;
    isPivot[static_cast<std::size_t>(best)] = true;
    const Value scale = numbers.inverse(own[static_cast<std::size_t>(best)]);
    for (int column = 1; column <= shafts; ++column)
      own[static_cast<std::size_t>(column)] = numbers.multiply(own[static_cast<std::size_t>(column)], scale);
    for (int other = 0; other < equations; ++other) {
      auto& line = matrix[static_cast<std::size_t>(other)];
      const Value factor = line[static_cast<std::size_t>(best)];
      if (other == row || numbers.isZero(factor)) continue;
      for (int column = 1; column <= shafts; ++column) {
        Value& entry = line[static_cast<std::size_t>(column)];
        entry = numbers.subtract(entry, numbers.multiply(factor, own[static_cast<std::size_t>(column)]));
      }
    }
  }
  SpeedSpace<Value> space;
  space.freedom = shafts - equations;
  for (auto& row : space.rows) row.fill(numbers.whole(0));
  int direction = 0;
  for (int column = 1; column <= shafts; ++column) {
    if (isPivot[static_cast<std::size_t>(column)]) continue;
    space.rows[static_cast<std::size_t>(column)][static_cast<std::size_t>(direction)] = numbers.whole(1);
    for (int row = 0; row < equations; ++row) {
      const auto pivot = static_cast<std::size_t>(pivots[static_cast<std::size_t>(row)]);
      space.rows[pivot][static_cast<std::size_t>(direction)] = numbers.subtract(
          numbers.whole(0), matrix[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)]);
    }
    ++direction;
  }
  return space;
}

}  // namespace geargraph
