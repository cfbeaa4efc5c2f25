#include "core/design/synthesis/reverted_train.h"

#include <algorithm>

#include "core/design/synthesis/set_search.h"
#include "core/design/synthesis/set_sketch.h"
#include "core/foundations/base/translation.h"

namespace geargraph {
namespace {

/// One for each ratio; of two that differ by exchanging the pairs the one with the larger first pair's
/// driver.
std::vector<RevertedChoice> differentChoices(const std::vector<FoundTeeth>& all) {
  std::vector<RevertedChoice> choices;
  for (const FoundTeeth& found : all) {
    // Wheels in the order of their first ends.
    const RevertedTeeth teeth{found.teeth[0], found.teeth[1], found.teeth[2], found.teeth[3]};
    if (teeth.third > teeth.first) continue;
    const bool isNew = std::none_of(choices.begin(), choices.end(), [&](const RevertedChoice& each) {
      return each.ratio == found.ratios.front();
    });
    if (isNew) choices.push_back({teeth, found.ratios.front(), found.error.toDouble()});
  }
  return choices;
}

}  // namespace

std::vector<RevertedChoice> revertedChoices(const RevertedRequirements& requirements, std::size_t most) {
  if (requirements.ratio.sign() <= 0) return {};
  TeethWish wish;
  RatioWish& ratio = wish.ratios.emplace_back();
  ratio.drive = 1;
  ratio.driven = 3;
  ratio.isEngaged = true;
  wish.fewest = requirements.fewestTeeth;
  wish.most = requirements.mostTeeth;
  const auto isEnough = [&](const std::vector<FoundTeeth>& found) {
    return differentChoices(found).size() >= most;
  };
  std::vector<RevertedChoice> choices =
      differentChoices(nearestTeeth(revertedTrain({}), std::move(wish), requirements.ratio, isEnough));
  if (choices.size() > most)
    choices.erase(choices.begin() + static_cast<std::ptrdiff_t>(most), choices.end());
  return choices;
}

Mechanism revertedTrain(const RevertedTeeth& teeth) {
  SetSketch set(translated("Reverted train"));
  const int input = set.link(0, "a", translated("input"));
  const int counter = set.link(0, "b", translated("countershaft"));
  const int output = set.link(0, "a", translated("output"));
  set.mesh(input, counter, teeth.first, teeth.second, MeshKind::external);
  set.mesh(counter, output, teeth.third, teeth.fourth, MeshKind::external);
  set.input(input, Number(1));
  return std::move(set).build();
}

}  // namespace geargraph
