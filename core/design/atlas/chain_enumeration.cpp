#include "core/design/atlas/chain_enumeration.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include "core/design/atlas/chain_form.h"
#include "core/design/atlas/chain_freedom.h"
#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

/// Chains by their form: one of each class.
using ChainClasses = std::map<ChainForm, Chain>;

/// Every way to add the gear pairs of the last level and one more; nondegenerate ones only.
ChainClasses withOneMeshMore(const ChainClasses& chains, const std::stop_token& stop) {
  ChainClasses more;
  for (const auto& [form, chain] : chains) {
    if (stop.stop_requested()) return {};
    for (const ChainMesh& mesh : possibleMeshes(chain)) {
      if (std::find(chain.meshes.begin(), chain.meshes.end(), mesh) != chain.meshes.end()) continue;
      Chain larger = chain;
      larger.meshes.push_back(mesh);
      ChainForm key = displacementForm(larger);
      if (more.contains(key) || degenerateMeshes(larger)) continue;
      more.emplace(std::move(key), std::move(larger));
    }
  }
  return more;
}

ChainClasses chainsWithMeshes(int links, int meshes, const std::stop_token& stop) {
  ChainClasses chains;
  for (const Chain& tree : axisTrees(links, stop)) chains.emplace(displacementForm(tree), tree);
  for (int m = 0; m < meshes; ++m) chains = withOneMeshMore(chains, stop);
  return stop.stop_requested() ? ChainClasses() : chains;
}

/// Links that carry many gear pairs come first, then those on many axes and in many meshes.
Chain wellNamed(const Chain& chain) {
  using Rank = std::tuple<int, int, int, int>;
  std::vector<Rank> ranks;
  for (int link = 0; link < chain.links; ++link) {
    int carries = 0;
    int gears = 0;
    for (const ChainMesh& mesh : chain.meshes) {
      carries += mesh.carrier == link ? 1 : 0;
      gears += mesh.tail == link || mesh.head == link ? 1 : 0;
    }
    const auto axes = std::count_if(chain.axes.begin(), chain.axes.end(), [&](const std::vector<int>& axis) {
      return std::find(axis.begin(), axis.end(), link) != axis.end();
    });
    ranks.emplace_back(-carries, -static_cast<int>(axes), -gears, link);
  }
  std::sort(ranks.begin(), ranks.end());
  std::vector<int> newName(ranks.size());
  for (std::size_t i = 0; i < ranks.size(); ++i)
    newName[static_cast<std::size_t>(std::get<3>(ranks[i]))] = static_cast<int>(i);
  return renamed(chain, newName);
}

bool hasFewerAxes(const Chain& a, const Chain& b) {
  return std::tuple(a.axes.size(), a.axes, a.meshes) < std::tuple(b.axes.size(), b.axes, b.meshes);
}

/// Well named, in groups of one rotation graph, both ordered.
std::vector<std::vector<Chain>> groupedByEquations(const ChainClasses& chains) {
  std::map<ChainForm, std::vector<Chain>> byEquations;
  for (const auto& [form, chain] : chains) byEquations[rotationForm(chain)].push_back(wellNamed(chain));
  std::vector<std::vector<Chain>> groups;
  for (auto& [form, group] : byEquations) {
    std::sort(group.begin(), group.end(), hasFewerAxes);
    groups.push_back(std::move(group));
  }
  std::sort(groups.begin(), groups.end(),
            [](const auto& a, const auto& b) { return hasFewerAxes(a.front(), b.front()); });
  return groups;
}

}  // namespace

std::vector<Chain> axisTrees(int links, const std::stop_token& stop) {
  ChainClasses trees;
  trees.emplace(ChainForm(), Chain{1, {}, {}});
  for (int leaf = 1; leaf < links; ++leaf) {
    ChainClasses larger;
    for (const auto& [form, tree] : trees) {
      if (stop.stop_requested()) return {};
      for (std::size_t axis = 0; axis < tree.axes.size() + static_cast<std::size_t>(leaf); ++axis) {
        Chain grown = tree;
        ++grown.links;
        if (axis < tree.axes.size()) {
          grown.axes[axis].push_back(leaf);
        } else {
          grown.axes.push_back({static_cast<int>(axis - tree.axes.size()), leaf});
        }
        larger.emplace(displacementForm(grown), std::move(grown));
      }
    }
    trees = std::move(larger);
  }
  std::vector<Chain> all;
  for (auto& [form, tree] : trees) all.push_back(std::move(tree));
  return all;
}

std::vector<std::vector<Chain>> enumerateChains(int links, int dof, const std::stop_token& stop) {
  GEARGRAPH_REQUIRE(links >= 3 && links <= 9 && dof >= 1 && dof <= links - 2);
  return groupedByEquations(chainsWithMeshes(links, links - 1 - dof, stop));
}

std::vector<std::vector<Chain>> enumerateLockedChains(int links, const std::stop_token& stop) {
  GEARGRAPH_REQUIRE(links >= 4 && links <= 9);
  ChainClasses locked;
  for (const auto& [form, chain] : chainsWithMeshes(links, links - 2, stop)) {
    if (stop.stop_requested()) return {};
    for (const ChainMesh& mesh : possibleMeshes(chain)) {
      if (std::find(chain.meshes.begin(), chain.meshes.end(), mesh) != chain.meshes.end()) continue;
      Chain larger = chain;
      larger.meshes.push_back(mesh);
      const auto culprits = degenerateMeshes(larger);
      if (!culprits || culprits->size() != larger.meshes.size()) continue;
      locked.emplace(displacementForm(larger), std::move(larger));
    }
  }
  return groupedByEquations(locked);
}

}  // namespace geargraph
