#include "tests/core/support/deep_train.h"

#include <algorithm>
#include <array>
#include <random>
#include <vector>

#include "core/foundations/base/contract.h"
#include "tests/core/support/trains.h"

namespace geargraph::test {
namespace {

/// What a link turns on, and about which axis: along a coordinate axis, through a whole point.
struct Held {
  int parent = 0;
  int axis = 0;
  std::array<std::int64_t, 3> point{};
  std::size_t along = 2;
};

}  // namespace

Mechanism deepTrain(std::uint64_t seed, int links) {
  constexpr int kInputs = 3;
  GEARGRAPH_REQUIRE(links > kInputs);
  std::mt19937_64 random(seed);
  const auto below = [&random](int limit) {
    return static_cast<int>(random() % static_cast<std::uint64_t>(limit));
  };
  TrainBuilder train("deep train");
  const auto newAxis = [&train](Held held) {
    ExactTriple direction{0, 0, 0};
    direction[held.along] = 1;
    held.axis = train.axis({held.point[0], held.point[1], held.point[2]}, direction);
    return held;
  };
  std::vector<Held> all{{}, newAxis({})};  // the ground, which nothing holds, and link 1
  train.link(0, all[1].axis);
  std::vector<GearMesh> meshes;
  std::vector<int> children(static_cast<std::size_t>(links) + 1,
                            0);  // by carrier: wheels that differ share nothing
  for (int link = 2; link <= links; ++link) {
    const int carrier = std::max(1, link - 1 - below(4));
    const Held& home = all[static_cast<std::size_t>(carrier)];
    Held held = home;
    held.parent = carrier;
    const int distance = 20 + below(20);
    const bool isParallel = below(2) > 0;
    if (isParallel) {
      held.point[(home.along + 1 + static_cast<std::size_t>(below(2))) % 3] +=
          below(2) == 0 ? distance : -distance;
    } else {
      held.along = (home.along + 1 + static_cast<std::size_t>(below(2))) % 3;
      held.point[home.along] += below(2) == 0 ? distance : -distance;
    }
    held = newAxis(held);
    train.link(carrier, held.axis);
    if (link > kInputs) {
      GearMesh mesh;
      mesh.id = MeshId("m" + std::to_string(meshes.size()));
      mesh.tail = LinkId(std::to_string(home.parent));
      mesh.head = LinkId(std::to_string(link));
      mesh.tailTeeth = 17 + (5 * children[static_cast<std::size_t>(carrier)]++ + below(5)) % 40;
      mesh.headTeeth = 17 + below(40);
      mesh.kind = isParallel ? MeshKind::external : MeshKind::bevel;
      meshes.push_back(mesh);
    } else {
      train.input(link - 1);
    }
    all.push_back(held);
  }
  train.input(0);
  Mechanism mechanism = train.mechanism();
  mechanism.gearMeshes = std::move(meshes);
  return mechanism;
}

}  // namespace geargraph::test
