#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/design/gearboxes/element_classes.h"

namespace geargraph {

/// The rules by which the section of a gearbox can be drawn in the half plane above its axis.
enum class SectionRule : std::uint8_t {
  shaftsNest,     ///< the links of all sets, without elements, cross nowhere
  brakesReach,    ///< with the brakes, whose links reach the housing
  clutchesReach,  ///< with the clutches too
  endsReach       ///< input and output come out of the housing at its two ends, along the axis
};
constexpr std::size_t kSectionRuleCount = 4;

/// "shafts-nest", "brakes-reach", ...: the name in files.
[[nodiscard]] std::string_view sectionRuleName(SectionRule rule);
/// Why a section that breaks the rule cannot be drawn, as a sentence.
[[nodiscard]] std::string sectionRuleReason(SectionRule rule);

/// The first rule that the gearbox breaks; std::nullopt if its section can be drawn. A link is a region of
/// the half plane, a set the place where its carrier has ring and sun on two sides, so that the carrier's
/// shaft passes between them to the left and to the right; an element touches its two links. Whether
/// regions can lie beside each other without crossing is decided by the planarity of a graph, tried for
/// each way to distribute what is joined to a link among its several carriers.
/// Cost: O(3^e) planarity tests for e joints of a link that has several carriers, at most kMaxDistributions.
[[nodiscard]] std::optional<SectionRule> brokenSectionRule(const BasicSets& sets, const GearLayout& layout,
                                                           int shafts,
                                                           std::span<const ElementLinks> elements);

}  // namespace geargraph
