#pragma once

#include <compare>
#include <utility>
#include <vector>

namespace geargraph {

/// A gear pair of a chain: links `tail` and `head` turn on different axes of the link `carrier`.
struct ChainMesh {
  int tail = 0;
  int head = 0;
  int carrier = 0;
  friend auto operator<=>(const ChainMesh&, const ChainMesh&) = default;
};

/// A geared kinematic chain without frame, teeth and lengths: links 0..links-1, axes, gear pairs.
///
/// An axis is the ascending list of the two or more links that turn about it; the incidence of links and axes
/// is a tree. By which tree of turning joints a coaxial bundle is drawn does not matter. Lists of axes and
/// meshes may be in any order; equality is that of the lists (isomorphism: chain_form.h).
struct Chain {
  int links = 0;
  std::vector<std::vector<int>> axes;
  std::vector<ChainMesh> meshes;

  friend bool operator==(const Chain&, const Chain&) = default;
  /// Freedom with one link held, where the gear pairs are independent (chain_freedom.h).
  [[nodiscard]] int dof() const { return links - 1 - static_cast<int>(meshes.size()); }
};

/// Every gear pair that the axes allow: the pairs of links that share no axis but have a link in common with
/// which each shares one. That link, the carrier, is unique, because the incidence is a tree. Ascending,
/// tail < head. Cost: O(links^3).
[[nodiscard]] std::vector<ChainMesh> possibleMeshes(const Chain& chain);

/// The chain with link i named newName[i], its lists sorted and each tail before its head.
[[nodiscard]] Chain renamed(const Chain& chain, const std::vector<int>& newName);

/// The chain of some of the links, renamed in their order: axes of which at least two links stay, and the
/// meshes of which all three do. @pre `kept` ascends
[[nodiscard]] Chain subchain(const Chain& chain, const std::vector<int>& kept);

/// No link parts it, and every link is in a mesh: what is left of the gear pairs without any one link is
/// connected. Chains of one freedom always are. Cost: O(links meshes).
[[nodiscard]] bool isNonfractionated(const Chain& chain);

/// The gear pairs in parts that have at most one link in common (a cut link), each the indices of its meshes,
/// ascending, in the order of their first meshes. Cost: O(links + meshes).
[[nodiscard]] std::vector<std::vector<int>> partsOf(const Chain& chain);

/// The links in these meshes, as gears or carriers, ascending.
[[nodiscard]] std::vector<int> linksOf(const Chain& chain, const std::vector<int>& meshes);

}  // namespace geargraph
