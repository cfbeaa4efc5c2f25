#include "core/design/synthesis/reverted_train.h"

#include <algorithm>
#include <cmath>

#include "core/design/synthesis/set_sketch.h"
#include "core/foundations/base/words.h"

namespace geargraph::inline synthesis {
namespace {

double ratioOf(const RevertedTeeth& t) {
  return (static_cast<double>(t.second) / t.first) * (static_cast<double>(t.fourth) / t.third);
}

/// The nearest to the requirements for one sum and one first wheel: the third wheels on either side of the
/// exact one.
void addNearest(int sum, int first, const RevertedRequirements& requirements,
                std::vector<RevertedChoice>& choices) {
  const double wanted = requirements.ratio.toDouble();
  const double second = wanted * first / (sum - first);  // what the second pair should make
  const int near = static_cast<int>(std::floor(sum / (1 + second)));
  for (const int third : {near, near + 1}) {
    const RevertedTeeth teeth{first, sum - first, third, sum - third};
    if (std::min({teeth.second, third, teeth.fourth}) < requirements.fewestTeeth) continue;
    if (std::max({teeth.second, third, teeth.fourth}) > requirements.mostTeeth) continue;
    if (teeth.third > teeth.first) continue;  // the pairs exchanged
    choices.push_back({teeth, Rational(), std::abs(ratioOf(teeth) - wanted) / wanted});
  }
}

}  // namespace

std::vector<RevertedChoice> revertedChoices(const RevertedRequirements& requirements, std::size_t most) {
  std::vector<RevertedChoice> choices;
  if (requirements.ratio.sign() <= 0) return choices;
  for (int sum = 2 * requirements.fewestTeeth; sum <= 2 * requirements.mostTeeth; ++sum) {
    const int last = std::min(requirements.mostTeeth, sum - requirements.fewestTeeth);
    for (int first = std::max(requirements.fewestTeeth, sum - requirements.mostTeeth); first <= last; ++first)
      addNearest(sum, first, requirements, choices);
  }
  for (RevertedChoice& choice : choices) choice.ratio = choice.teeth.ratio();
  std::sort(choices.begin(), choices.end(), [](const RevertedChoice& a, const RevertedChoice& b) {
    if (a.error != b.error) return a.error < b.error;
    const int sumA = a.teeth.first + a.teeth.second, sumB = b.teeth.first + b.teeth.second;
    return sumA != sumB ? sumA < sumB : a.teeth.first < b.teeth.first;
  });
  const auto same = [](const RevertedChoice& a, const RevertedChoice& b) { return a.ratio == b.ratio; };
  choices.erase(std::unique(choices.begin(), choices.end(), same), choices.end());
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

}  // namespace geargraph::inline synthesis
