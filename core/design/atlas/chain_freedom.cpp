#include "core/design/atlas/chain_freedom.h"

#include <algorithm>
#include <bit>
#include <numeric>

#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

/// splitmix64, which is the same everywhere.
class RatioSource {
 public:
  explicit RatioSource(std::uint64_t seed) : m_state(seed) {}
  std::uint64_t next() {
    std::uint64_t z = (m_state += 0x9e3779b97f4a7c15U);
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
  }

 private:
  std::uint64_t m_state;
};

}  // namespace

std::optional<std::vector<int>> degenerateMeshes(const Chain& chain) {
  const int count = static_cast<int>(chain.meshes.size());
  GEARGRAPH_REQUIRE(count <= kMaxCountedMeshes);
  std::uint32_t smallest = 0;
  for (std::uint32_t set = 1; set < (std::uint32_t{1} << static_cast<unsigned>(count)); ++set) {
    if (smallest != 0 && std::popcount(set) >= std::popcount(smallest)) continue;
    std::vector<bool> isIn(static_cast<std::size_t>(chain.links));
    int links = 0;
    for (std::uint32_t rest = set; rest != 0; rest &= rest - 1) {
      const ChainMesh& mesh = chain.meshes[static_cast<std::size_t>(std::countr_zero(rest))];
      for (const int link : {mesh.tail, mesh.head, mesh.carrier}) {
        if (!isIn[static_cast<std::size_t>(link)]) ++links;
        isIn[static_cast<std::size_t>(link)] = true;
      }
    }
    if (links < std::popcount(set) + 2) smallest = set;
  }
  if (smallest == 0) return std::nullopt;
  std::vector<int> meshes;
  for (std::uint32_t rest = smallest; rest != 0; rest &= rest - 1) meshes.push_back(std::countr_zero(rest));
  return meshes;
}

ResidueRow speedRow(const PrimeField& field, const ChainMesh& mesh, const SignedTeeth& teeth,
                    std::size_t links) {
  ResidueRow row(links, 0);
  row[static_cast<std::size_t>(mesh.tail)] = field.fromInteger(teeth.tail);
  row[static_cast<std::size_t>(mesh.head)] = field.fromInteger(-teeth.head);
  row[static_cast<std::size_t>(mesh.carrier)] =
      field.subtract(field.fromInteger(teeth.head), field.fromInteger(teeth.tail));
  return row;
}

ChainMotion chainMotion(const Chain& chain, std::span<const SignedTeeth> teeth, const std::stop_token& stop) {
  GEARGRAPH_REQUIRE(teeth.size() == chain.meshes.size());
  const PrimeField field;
  const auto links = static_cast<std::size_t>(chain.links);
  std::vector<ResidueRow> rows;
  for (std::size_t m = 0; m < teeth.size(); ++m)
    rows.push_back(speedRow(field, chain.meshes[m], teeth[m], links));
  const std::vector<std::size_t> pivots = reduceRows(field, rows, stop);
  ChainMotion motion;
  motion.rank = static_cast<int>(pivots.size());
  motion.dof = chain.links - 1 - motion.rank;
  motion.isDependent = pivots.size() < chain.meshes.size();
  // The speeds of all links in terms of those without a pivot, which are free.
  std::vector<ResidueRow> speeds(links, ResidueRow(links, 0));
  for (std::size_t c = 0; c < links; ++c) speeds[c][c] = field.one();
  for (std::size_t p = 0; p < pivots.size(); ++p) {
    for (std::size_t c = 0; c < links; ++c)
      speeds[pivots[p]][c] = c == pivots[p] ? 0 : field.negate(rows[p][c]);
  }
  std::vector<int> order(links);
  std::iota(order.begin(), order.end(), 0);
  const auto speedOf = [&](int link) -> const ResidueRow& { return speeds[static_cast<std::size_t>(link)]; };
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return speedOf(a) < speedOf(b); });
  for (std::size_t i = 1; i < links; ++i) {
    const std::pair<int, int> pair{order[i - 1], order[i]};
    if (speedOf(pair.first) == speedOf(pair.second) && (!motion.locked || pair < *motion.locked))
      motion.locked = pair;
  }
  return motion;
}

ChainMotion genericMotion(const Chain& chain, std::uint64_t seed, const std::stop_token& stop) {
  RatioSource source(seed);
  std::vector<SignedTeeth> teeth;
  for (std::size_t m = 0; m < chain.meshes.size(); ++m)
    teeth.push_back({1, static_cast<std::int64_t>(source.next() >> 3U)});
  return chainMotion(chain, teeth, stop);
}

}  // namespace geargraph
