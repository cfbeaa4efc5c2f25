#pragma once

#include "core/design/gearboxes/layout_search.h"

namespace geargraph {

/// Ratios of input to output in states of one layout, at any k.
class StateRatios {
 public:
  StateRatios(const BasicSets& sets, const GearLayout& layout, int shafts)
      : m_sets(&sets), m_layout(&layout), m_shafts(shafts) {}

  /// By state, signed; 0 where the state has none. `states` by elements' links; each freedom - 1 of them.
  /// False if the sets depend on each other at this k.
  [[nodiscard]] bool at(std::span<const double> k, std::span<const std::array<ElementLinks, 3>> states,
                        std::span<double> ratios) const;

 private:
  const BasicSets* m_sets;
  const GearLayout* m_layout;
  int m_shafts;
};

/// Moves `k` within the bounds until the logarithms of the ratios of `states` come nearest to the targets, in
/// the sense of least squares. Returns the largest difference, over `logs`; infinite if a sign is wrong.
/// `negative`: the last state's ratio is wanted below 0.
/// Cost: a few elimination of the speeds for each step, at most 16 steps.
[[nodiscard]] double refineK(const StateRatios& ratios, std::span<const std::array<ElementLinks, 3>> states,
                             std::span<const double> logs, bool negative, double least, double most,
                             std::span<double> k);

}  // namespace geargraph
