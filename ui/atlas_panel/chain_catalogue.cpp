#include "ui/atlas_panel/chain_catalogue.h"

#include <set>
#include <utility>

namespace geargraph {
namespace {

int axesOf(const AtlasChain& chain) {
  return static_cast<int>(chain.chain.axes.size());
}

}  // namespace

ChainCatalogue::ChainCatalogue(const Atlas& atlas) : m_atlas(&atlas) {
  for (const AtlasChain& chain : atlas.chains()) m_facts.push_back({&chain, isNonfractionated(chain.chain)});
}

ChainCatalogue::Exclusion ChainCatalogue::exclusionOf(const Facts& facts, const ChainFilter& filter) {
  const ChainNumber& number = facts.chain->number;
  Exclusion out;
  out.links = filter.links && number.links != *filter.links;
  out.dof = filter.dof && number.dof != *filter.dof;
  out.axes = filter.axes && axesOf(*facts.chain) != *filter.axes;
  out.fractionated = filter.isNonfractionatedOnly && !facts.isNonfractionated;
  out.equations =
      filter.equations && (number.links != filter.equations->links || number.dof != filter.equations->dof ||
                           number.rotation != filter.equations->rotation);
  return out;
}

std::vector<const AtlasChain*> ChainCatalogue::chosen(const ChainFilter& filter) const {
  std::vector<const AtlasChain*> chains;
  for (const Facts& facts : m_facts)
    if (exclusionOf(facts, filter).count() == 0) chains.push_back(facts.chain);
  return chains;
}

FilterCounts ChainCatalogue::counts(const ChainFilter& filter) const {
  FilterCounts counts;
  std::set<std::pair<std::pair<int, int>, int>> rotations;
  for (const Facts& facts : m_facts) {
    const ChainNumber& number = facts.chain->number;
    const Exclusion out = exclusionOf(facts, filter);
    const int excluded = out.count();
    const auto isShownWithout = [excluded](bool byThis) { return excluded == (byThis ? 1 : 0); };
    counts.links[number.links] += isShownWithout(out.links);
    counts.dof[number.dof] += isShownWithout(out.dof);
    counts.axes[axesOf(*facts.chain)] += isShownWithout(out.axes);
    counts.nonfractionated += facts.isNonfractionated && excluded == 0;
    if (excluded > 0) continue;
    ++counts.all;
    rotations.insert({{number.links, number.dof}, number.rotation});
  }
  counts.rotations = static_cast<int>(rotations.size());
  return counts;
}

}  // namespace geargraph
