#include "core/design/atlas/identify.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <numeric>
#include <set>

#include "core/foundations/base/contract.h"
#include "core/mechanism/model/validate.h"
#include "core/mechanism/placement/planet_groups.h"

namespace geargraph {
namespace {

/// What the meshes of a group of planets say about the links outside of it: the reduced equations of these
/// links after the group's own speeds are eliminated, without the meshes with copies. Columns: the group's
/// links, then all links.
std::vector<ResidueRow> equationsOutside(const DrawnChain& drawn, const PlanetGroup& group,
                                         const std::set<int>& copies) {
  const PrimeField field;
  const auto links = static_cast<std::size_t>(drawn.chain.links);
  std::vector<ResidueRow> rows;
  for (const int mesh : group.meshes) {
    const auto position = static_cast<std::size_t>(mesh);
    const ChainMesh& own = drawn.chain.meshes[position];
    if (copies.contains(own.tail) || copies.contains(own.head)) continue;
    const ResidueRow all = speedRow(field, own, drawn.teeth[position], links);
    ResidueRow& row = rows.emplace_back();
    for (const int link : group.links) row.push_back(all[static_cast<std::size_t>(link)]);
    row.insert(row.end(), all.begin(), all.end());
    for (const int link : group.links) row[group.links.size() + static_cast<std::size_t>(link)] = 0;
  }
  const std::vector<std::size_t> pivots = reduceRows(field, rows);
  std::vector<ResidueRow> outside;
  for (std::size_t r = 0; r < pivots.size(); ++r)
    if (pivots[r] >= group.links.size()) outside.push_back(std::move(rows[r]));
  return outside;
}

/// Planets that carry nothing, in sets of those on one carrier with the same partners and teeth: also two on
/// one axis, as the pinions of a bevel differential.
std::vector<std::vector<PlanetGroup>> equalLinks(const Placement& placement, const DrawnChain& drawn) {
  std::vector<bool> carries(static_cast<std::size_t>(drawn.chain.links));
  for (const auto& axisGroup : placement.classes->classes)
    carries[static_cast<std::size_t>(static_cast<int>(axisGroup.rootLink))] = true;
  std::vector<std::vector<int>> meshesOf(carries.size());
  for (std::size_t m = 0; m < drawn.chain.meshes.size(); ++m) {
    meshesOf[static_cast<std::size_t>(drawn.chain.meshes[m].tail)].push_back(static_cast<int>(m));
    meshesOf[static_cast<std::size_t>(drawn.chain.meshes[m].head)].push_back(static_cast<int>(m));
  }
  using Partner = std::array<std::int64_t, 4>;  // link, carrier, own teeth, its teeth
  std::map<std::vector<Partner>, std::vector<PlanetGroup>> sets;
  for (int link = 1; link < drawn.chain.links; ++link) {
    const std::vector<int>& meshes = meshesOf[static_cast<std::size_t>(link)];
    if (carries[static_cast<std::size_t>(link)] || meshes.size() < 2) continue;
    const int root = placement.classes->classes[placement.classes->classOfLink(link)].rootLink;
    if (root == 0) continue;  // equalPlanets() knows them
    std::vector<Partner> partners;
    PlanetGroup group{{link}, {}, {}};
    for (const int m : meshes) {
      const ChainMesh& mesh = drawn.chain.meshes[static_cast<std::size_t>(m)];
      const SignedTeeth& teeth = drawn.teeth[static_cast<std::size_t>(m)];
      if (mesh.carrier != root) break;
      const bool isTail = mesh.tail == link;
      const std::int64_t head = std::abs(teeth.head);
      partners.push_back({isTail ? mesh.head : mesh.tail, mesh.carrier, isTail ? teeth.tail : head,
                          isTail ? head : teeth.tail});
      group.meshes.emplace_back(m);
    }
    if (partners.size() != meshes.size()) continue;
    std::sort(partners.begin(), partners.end());
    sets[partners].push_back(std::move(group));
  }
  std::vector<std::vector<PlanetGroup>> equal;
  for (auto& [partners, set] : sets)
    if (set.size() > 1) equal.push_back(std::move(set));
  return equal;
}

/// Planets that repeat what an equal one says about the others. One set after the other: what a copy meshes
/// with may be no copy without it.
std::set<int> copiedPlanets(const Mechanism& mechanism, const Placement& placement, const DrawnChain& drawn) {
  std::vector<std::vector<PlanetGroup>> sets = equalPlanets(mechanism, placement, PlanetScope::all);
  for (std::vector<PlanetGroup>& set : equalLinks(placement, drawn)) sets.push_back(std::move(set));
  std::set<int> copies;
  for (const std::vector<PlanetGroup>& set : sets) {
    if (copies.contains(set.front().links.front())) continue;
    const std::vector<ResidueRow> first = equationsOutside(drawn, set.front(), copies);
    if (first.empty()) continue;  // it only follows: a gear of its own
    for (std::size_t g = 1; g < set.size(); ++g)
      if (equationsOutside(drawn, set[g], copies) == first)
        copies.insert(set[g].links.begin(), set[g].links.end());
  }
  return copies;
}

/// The parts of lists at these positions.
template <class List>
List chosen(const List& all, const std::vector<int>& positions) {
  List some;
  for (const int position : positions) some.push_back(all[static_cast<std::size_t>(position)]);
  return some;
}

/// The chain of these links and meshes of a drawn train.
Chain chainOf(const Chain& whole, const std::vector<int>& links, const std::vector<int>& meshes) {
  Chain some = whole;
  some.meshes = chosen(whole.meshes, meshes);
  return subchain(some, links);
}

IdentifiedChain identifiedPart(const DrawnChain& drawn, std::vector<int> meshes, const Atlas& atlas,
                               const std::stop_token& stop) {
  IdentifiedChain part;
  part.links = linksOf(drawn.chain, meshes);
  part.meshes = std::move(meshes);
  part.chain = chainOf(drawn.chain, part.links, part.meshes);
  const ChainMotion motion = chainMotion(part.chain, chosen(drawn.teeth, part.meshes), stop);
  const ChainMotion generic = genericMotion(part.chain, 1, stop);
  part.dof = motion.dof;
  part.turnsByTeeth = motion.rank < generic.rank;
  part.isLocked = generic.isDegenerate() && !part.turnsByTeeth;
  const int most = std::max({atlas.mostLinks(0), atlas.mostLinks(1), atlas.mostLinks(2)});
  if (part.chain.links <= most) {
    part.rotation = atlas.rotationNumberOf(part.chain);
    part.displacement = atlas.numberOf(part.chain);
  }
  return part;
}

/// Chains with one more link, which is in one mesh.
std::vector<Chain> extended(const Chain& chain) {
  std::vector<Chain> all;
  const std::size_t axes = chain.axes.size();
  for (std::size_t place = 0; place < axes + static_cast<std::size_t>(chain.links); ++place) {
    Chain larger = chain;
    const int added = larger.links++;
    if (place < axes) {
      larger.axes[place].push_back(added);
    } else {
      larger.axes.push_back({static_cast<int>(place - axes), added});
    }
    for (const ChainMesh& mesh : possibleMeshes(larger)) {
      if (mesh.tail != added && mesh.head != added) continue;
      all.push_back(larger);
      all.back().meshes.push_back(mesh);
    }
  }
  return all;
}

/// Chains without one of the links that are in one mesh only.
std::vector<Chain> shortened(const Chain& chain) {
  std::vector<Chain> all;
  for (int link = 0; link < chain.links; ++link) {
    const auto has = [&](const ChainMesh& mesh) {
      return mesh.tail == link || mesh.head == link || mesh.carrier == link;
    };
    if (std::count_if(chain.meshes.begin(), chain.meshes.end(), has) != 1) continue;
    std::vector<int> kept(static_cast<std::size_t>(chain.links));
    std::iota(kept.begin(), kept.end(), 0);
    kept.erase(kept.begin() + link);
    all.push_back(subchain(chain, kept));
  }
  return all;
}

std::vector<ChainNumber> numbersOf(const std::vector<Chain>& chains, const Atlas& atlas) {
  std::set<ChainNumber> numbers;
  for (const Chain& chain : chains)
    if (const auto number = atlas.numberOf(chain)) numbers.insert(*number);
  return {numbers.begin(), numbers.end()};
}

}  // namespace

std::string_view removalName(RemovalReason reason) {
  return reason == RemovalReason::copy ? "copy" : "no-mesh";
}

Expected<DrawnChain> drawnChain(const Mechanism& mechanism, const Placement& placement) {
  if (!placement.tree) return treeDiagnostics(mechanism);
  DrawnChain drawn;
  drawn.chain.links = static_cast<int>(mechanism.links.size());
  const AxisGroups& classes = *placement.classes;
  drawn.chain.axes.resize(classes.classes.size());
  for (std::size_t c = 0; c < classes.classes.size(); ++c)
    drawn.chain.axes[c].push_back(classes.classes[static_cast<int>(c)].rootLink);
  for (int link = 1; link < drawn.chain.links; ++link)
    drawn.chain.axes[static_cast<std::size_t>(static_cast<int>(classes.classOfLink(link)))].push_back(link);
  for (std::vector<int>& axis : drawn.chain.axes) std::sort(axis.begin(), axis.end());
  for (const std::optional<MeshGeometry>& mesh : placement.meshes) {
    if (!mesh) return placement.diagnostics;
    drawn.chain.meshes.push_back({mesh->tail, mesh->head, mesh->carrier});
    drawn.teeth.push_back({mesh->tailTeeth, mesh->sign * mesh->headTeeth});
  }
  return drawn;
}

std::optional<TrainIdentity> identifyTrain(const Mechanism& mechanism, const Placement& placement,
                                           const DrawnChain& drawn, const Atlas& atlas,
                                           const std::stop_token& stop) {
  GEARGRAPH_REQUIRE(drawn.chain.links <= kMaxIdentifiedLinks);
  const std::set<int> copies = copiedPlanets(mechanism, placement, drawn);
  TrainIdentity identity;
  for (int m = 0; m < static_cast<int>(drawn.chain.meshes.size()); ++m) {
    const ChainMesh& mesh = drawn.chain.meshes[static_cast<std::size_t>(m)];
    if (!copies.contains(mesh.tail) && !copies.contains(mesh.head)) identity.meshes.push_back(m);
  }
  identity.links = linksOf(drawn.chain, identity.meshes);
  for (int link = 0; link < drawn.chain.links; ++link) {
    if (copies.contains(link)) {
      identity.removed.push_back({link, RemovalReason::copy});
    } else if (!std::binary_search(identity.links.begin(), identity.links.end(), link)) {
      identity.removed.push_back({link, RemovalReason::noMesh});
    }
  }
  Chain staying = drawn.chain;
  staying.meshes = chosen(drawn.chain.meshes, identity.meshes);
  for (const std::vector<int>& part : partsOf(staying)) {
    if (stop.stop_requested()) return std::nullopt;
    identity.parts.push_back(identifiedPart(drawn, chosen(identity.meshes, part), atlas, stop));
  }
  identity.chain = subchain(staying, identity.links);
  return stop.stop_requested() ? std::nullopt : std::optional(std::move(identity));
}

ChainRelatives relativesOf(const Chain& chain, const Atlas& atlas) {
  ChainRelatives relatives;
  const auto own = atlas.numberOf(chain);
  if (const auto rotation = atlas.rotationNumberOf(chain)) {
    for (const AtlasChain& other : atlas.group(*rotation))
      if (other.number != own) relatives.sameEquations.push_back(other.number);
  }
  relatives.oneMeshLess = numbersOf(shortened(chain), atlas);
  relatives.oneMeshMore = numbersOf(extended(chain), atlas);
  const std::vector<int> orbits = linkOrbits(chain);
  relatives.frames = static_cast<int>(std::set<int>(orbits.begin(), orbits.end()).size());
  return relatives;
}

std::optional<TrainMatch> matchOf(const TrainIdentity& a, const TrainIdentity& b) {
  GEARGRAPH_REQUIRE(std::max(a.chain.links, b.chain.links) <= kMaxMatchedLinks);
  for (const ChainLikeness likeness : {ChainLikeness::displacement, ChainLikeness::rotation}) {
    const auto image = isomorphism(a.chain, b.chain, likeness);
    if (!image) continue;
    TrainMatch match{likeness, {}, {}};
    for (std::size_t i = 0; i < image->size(); ++i)
      match.links.emplace_back(a.links[i], b.links[static_cast<std::size_t>((*image)[i])]);
    // A second mesh between the same links goes to the second.
    std::multimap<ChainMesh, int> left;
    const auto sorted = [](int tail, int head, int carrier) {
      return ChainMesh{std::min(tail, head), std::max(tail, head), carrier};
    };
    for (std::size_t m = 0; m < b.meshes.size(); ++m) {
      const ChainMesh& mesh = b.chain.meshes[m];
      left.emplace(sorted(mesh.tail, mesh.head, mesh.carrier), b.meshes[m]);
    }
    const auto imageOf = [&](int link) { return (*image)[static_cast<std::size_t>(link)]; };
    for (std::size_t m = 0; m < a.meshes.size(); ++m) {
      const ChainMesh& mesh = a.chain.meshes[m];
      const auto found = left.find(sorted(imageOf(mesh.tail), imageOf(mesh.head), imageOf(mesh.carrier)));
      GEARGRAPH_REQUIRE(found != left.end());
      match.meshes.emplace_back(a.meshes[m], found->second);
      left.erase(found);
    }
    return match;
  }
  return std::nullopt;
}

}  // namespace geargraph
