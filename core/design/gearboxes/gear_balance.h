#pragma once

#include "core/design/gearboxes/gearbox.h"

namespace geargraph {

/// Speeds and torques of one gear, for the input at speed 1 under a torque of 1, without losses.
template <class Value>
struct GearBalance {
  std::vector<Value> speeds;    ///< by number of link, the housing first
  std::vector<Value> elements;  ///< by engaged element: its torque on its first link
  std::vector<Value> suns;      ///< by basic set: the torque of the set on its sun; k times that on its ring
  Value ratio{};
};

/// std::nullopt where these elements leave no gear at these teeth.
/// The balances of all links, unknowns the torques of sets, engaged elements and output.
template <class Numbers>
[[nodiscard]] std::optional<GearBalance<typename Numbers::Value>> gearBalance(
    const BasicSets& sets, const GearLayout& layout, int shafts, std::span<const typename Numbers::Value> k,
    std::span<const ElementLinks> engaged, const Numbers& numbers) {
  using Value = typename Numbers::Value;
  const auto space = speedSpace<Numbers>(sets, layout, shafts, k, numbers);
  if (!space || engaged.size() + 1 != static_cast<std::size_t>(space->freedom)) return std::nullopt;
  std::array<std::array<Value, kMaxFreedom>, 3> directions{};
  for (std::size_t i = 0; i < engaged.size(); ++i) directions[i] = directionOf(*space, engaged[i], numbers);
  GearBalance<Value> balance;
  for (int link = 0; link <= shafts; ++link) {
    balance.speeds.push_back(
        speedWith(directions, space->rows[static_cast<std::size_t>(link)], space->freedom, numbers));
  }
  const Value out = balance.speeds[layout.output];
  const Value in = balance.speeds[layout.input];
  if (numbers.isZero(in) || numbers.isZero(out)) return std::nullopt;
  for (Value& each : balance.speeds) each = numbers.multiply(each, numbers.inverse(in));
  balance.ratio = numbers.multiply(in, numbers.inverse(out));

  const std::size_t unknowns = sets.size() + engaged.size() + 1;
  const auto rows = static_cast<std::size_t>(shafts);
  std::vector<std::vector<Value>> matrix(rows + 1, std::vector<Value>(unknowns + 1, numbers.whole(0)));
  const auto put = [&](int link, std::size_t column, const Value& value) {
    Value& entry = matrix[static_cast<std::size_t>(link)][column];
    entry = numbers.add(entry, value);
  };
  for (std::size_t set = 0; set < sets.size(); ++set) {
    const Value ring = sets[set].isDouble ? numbers.subtract(numbers.whole(0), k[set]) : k[set];
    const int at = static_cast<int>(set);
    put(layout.link(at, SetMember::sun), set, numbers.whole(1));
    put(layout.link(at, SetMember::ring), set, ring);
    put(layout.link(at, SetMember::carrier), set, numbers.subtract(numbers.whole(-1), ring));
  }
  for (std::size_t i = 0; i < engaged.size(); ++i) {
    put(engaged[i].a, sets.size() + i, numbers.whole(1));
    put(engaged[i].b, sets.size() + i, numbers.whole(-1));
  }
  put(layout.output, unknowns - 1, numbers.whole(1));
  put(layout.input, unknowns, numbers.whole(-1));
  for (std::size_t column = 0; column < unknowns; ++column) {
    std::size_t best = 0;
    for (std::size_t row = column + 1; row <= rows; ++row) {
      if (numbers.isZero(matrix[row][column])) continue;
      if (best == 0 || numbers.isBetterPivot(matrix[row][column], matrix[best][column])) best = row;
    }
    if (best == 0) return std::nullopt;
    std::swap(matrix[column + 1], matrix[best]);
    auto& own = matrix[column + 1];
    const Value scale = numbers.inverse(own[column]);
    for (std::size_t i = column; i <= unknowns; ++i) own[i] = numbers.multiply(own[i], scale);
    for (std::size_t row = 1; row <= rows; ++row) {
      if (row == column + 1 || numbers.isZero(matrix[row][column])) continue;
      const Value factor = matrix[row][column];
      for (std::size_t i = column; i <= unknowns; ++i)
        matrix[row][i] = numbers.subtract(matrix[row][i], numbers.multiply(factor, own[i]));
    }
  }
  for (std::size_t set = 0; set < sets.size(); ++set) balance.suns.push_back(matrix[set + 1][unknowns]);
  for (std::size_t i = 0; i < engaged.size(); ++i)
    balance.elements.push_back(matrix[sets.size() + i + 1][unknowns]);
  return balance;
}

}  // namespace geargraph
