#include "core/theory/matroid/structure.h"

#include <algorithm>
#include <memory_resource>

#include "core/foundations/base/scratch.h"

namespace geargraph {
namespace {

/// A hash of an equation that sums of others do not reach by chance.
std::uint64_t keyOf(std::uint64_t equation) {
  std::uint64_t z = (equation + 1) * 0x9e3779b97f4a7c15U;
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31U);
}

/// Rates of one motion drawn at random: what stands still here stands still always.
std::vector<char> deadIn(const KinematicModel& model, const ModularDoubleField& field,
                         const Elimination<ModularDouble>& system) {
  std::vector<ModularDouble> phi(static_cast<std::size_t>(system.columns));
  ResidueStream random(field.prime(), 0x64656164U);
  for (const int column : system.freeColumns) phi[column].residue = random.next();
  substitute(field, system, phi);
  std::vector<char> dead(static_cast<std::size_t>(model.t()));
  for (JointOrdinal joint = 0; joint < model.t(); ++joint)
    dead[joint] = model.rateOf(field, joint, phi).residue == 0 ? 1 : 0;
  return dead;
}

}  // namespace

std::optional<Structure> structureOf(const KinematicModel& model, const ModularDoubleField& field,
                                     const std::stop_token& stop) {
  auto system = eliminate(field, equationRows(model, field, model.equations()), model.n(), model.n(), stop);
  if (!system) return std::nullopt;
  if (system->rank() < std::min(model.equations(), model.n())) {
    const ModularDoubleField second(PrimeField::kSecondSeed);
    auto confirmed =
        eliminate(second, equationRows(model, second, model.equations()), model.n(), model.n(), stop);
    if (!confirmed) return std::nullopt;
    // The larger rank is a proof. That the first prime divides a determinant has a chance near 2^-60.
    GEARGRAPH_REQUIRE(confirmed->rank() == system->rank());
  }
  Structure result;
  result.rank = system->rank();
  result.dof = model.t() - result.rank;
  result.kutzbachDof = model.n() - model.equations();
  result.dead = deadIn(model, field, *system);
  result.idle = idleJoints(model);
  result.system = std::move(*system);
  return result;
}

std::vector<char> idleJoints(const KinematicModel& model) {
  // A cycle crosses a joint exactly if one end of the mesh or the coupling is beyond it: then its key stays
  // in the exclusive-or of all keys there.
  Scratch<> scratch;
  std::pmr::vector<std::uint64_t> keys(static_cast<std::size_t>(model.n()) + 1, 0, &scratch);
  for (MeshOrdinal mesh = 0; mesh < model.c(); ++mesh) {
    const DigraphEdge& edge = model.graph().meshEdge(mesh);
    const std::uint64_t key = keyOf(static_cast<std::uint64_t>(mesh));
    keys[edge.tail] ^= key;
    keys[edge.head] ^= key;
  }
  for (int equation = model.c(); equation < model.equations(); ++equation) {
    const std::uint64_t key = keyOf(static_cast<std::uint64_t>(equation));
    keys[model.heldRow(equation).from] ^= key;
    keys[model.heldRow(equation).to] ^= key;
  }
  std::vector<char> idle(static_cast<std::size_t>(model.t()), 0);
  const auto order = model.tree().preorder();
  for (auto node = order.rbegin(); node != order.rend(); ++node) {
    if (*node == 0) continue;
    idle[model.tree().jointToParent(*node)] = keys[*node] == 0 ? 1 : 0;
    keys[model.tree().parent(*node)] ^= keys[*node];
  }
  return idle;
}

std::vector<std::vector<int>> rigidBlocks(const KinematicModel& model, const std::vector<char>& dead) {
  std::vector<int> blockOf(static_cast<std::size_t>(model.n()) + 1, 0);
  std::vector<std::vector<int>> blocks;
  for (const LinkOrdinal node : model.tree().preorder()) {
    if (node != 0 && dead[model.tree().jointToParent(node)] != 0) {
      blockOf[node] = blockOf[model.tree().parent(node)];
    } else {
      blockOf[node] = static_cast<int>(blocks.size());
      blocks.emplace_back();
    }
    blocks[blockOf[node]].push_back(node);
  }
  std::erase_if(blocks, [](const std::vector<int>& block) { return block.size() < 2; });
  for (std::vector<int>& block : blocks) std::sort(block.begin(), block.end());
  std::sort(blocks.begin(), blocks.end());
  return blocks;
}

}  // namespace geargraph
