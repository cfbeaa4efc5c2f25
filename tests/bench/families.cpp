#include "tests/bench/families.h"

#include <algorithm>
#include <random>

#include "core/foundations/base/contract.h"
#include "core/theory/analysis/analysis.h"
#include "core/theory/matroid/input_sets.h"
#include "tests/core/support/trains.h"

namespace geargraph::bench {
namespace {

using test::ExactTriple;
using test::TrainBuilder;

const ExactTriple kUp{0, 0, 1};
constexpr int kInputs = 3;

ExactTriple at(std::int64_t x, std::int64_t y = 0) {
  return {x, y, 0};
}

}  // namespace

Mechanism nestedCarriers(int links) {
  TrainBuilder train("nested carriers");
  std::vector<int> axes;
  std::vector<int> chain{0};
  for (int k = 1; k <= links; ++k) {
    axes.push_back(train.axis(at(k), kUp));
    chain.push_back(train.link(chain.back(), axes.back()));
  }
  // Link k-1 is on axis k too, being the carrier that holds it.
  for (int k = 1; k + 1 <= links && links - k >= kInputs; ++k) {
    train.external(chain[k - 1], axes[k - 1], 20 + k % 7, chain[k + 1], axes[k], 30 + k % 11);
  }
  return train.mechanism();
}

Mechanism coaxialStacks(int links) {
  TrainBuilder train("coaxial stacks");
  const int left = train.axis(at(0), kUp);
  const int right = train.axis(at(100), kUp);
  std::vector<int> leftLinks;
  std::vector<int> rightLinks;
  for (int k = 0; k < links / 2; ++k) {
    leftLinks.push_back(train.link(leftLinks.empty() ? 0 : leftLinks.back(), left));
    rightLinks.push_back(train.link(rightLinks.empty() ? 0 : rightLinks.back(), right));
  }
  // Each pair meshes, and every link meshes with the next of the other stack: all turn with the first.
  const int pairs = links / 2;
  for (int k = 0; k < pairs; ++k) {
    train.external(leftLinks[k], left, 20 + k % 7, rightLinks[k], right, 31 + k % 5);
    if (k + 1 < pairs && 2 * k + 2 + kInputs <= links) {
      train.external(rightLinks[k], right, 18 + k % 3, leftLinks[k + 1], left, 40 + k % 9);
    }
  }
  return train.mechanism();
}

Mechanism planetaryChain(int links) {
  TrainBuilder train("planetary chain");
  const int main = train.axis(at(0), kUp);
  int sun = train.link(0, main);
  for (int link = 2; link < links; link += 2) {
    const int carrier = train.link(0, main);
    const int planetAxis = train.axis(at(3 + link), kUp);
    const int planet = train.link(carrier, planetAxis);
    const int sunTeeth = 20 + link % 7;
    const int planetTeeth = 16 + link % 5;
    train.external(sun, main, sunTeeth, planet, planetAxis, planetTeeth);
    train.internal(planet, planetAxis, planetTeeth, 0, main, sunTeeth + 2 * planetTeeth);
    sun = carrier;
  }
  return train.mechanism();
}

Mechanism epicyclicTree(int links) {
  TrainBuilder train("epicyclic tree");
  std::mt19937_64 random(1);
  const auto below = [&random](int limit) {
    return static_cast<int>(random() % static_cast<std::uint64_t>(limit));
  };
  // On a carrier, each gear is driven by the one before it, the first by a wheel that the carrier's own
  // carrier holds on the carrier's axis. Now and then a gear becomes a carrier itself.
  struct Gear {
    int link = 0;
    int axis = 0;
    int parent = 0;
  };
  std::int64_t place = 1;
  int made = 0;
  const auto newGear = [&](int parent) {
    const int axis = train.axis(at(place, place % 13), kUp);
    ++place;
    ++made;
    return Gear{train.link(parent, axis), axis, parent};
  };
  std::vector<Gear> carriers{newGear(0)};
  int free = 1;
  while (made < links) {
    const std::size_t recent = std::min<std::size_t>(8, carriers.size());
    const Gear carrier =
        carriers[carriers.size() - 1 - static_cast<std::size_t>(below(static_cast<int>(recent)))];
    Gear last = newGear(carrier.link);
    if (free < kInputs) {
      ++free;
    } else {
      train.external(carrier.parent, carrier.axis, 60 + below(20), last.link, last.axis, 17 + below(30));
    }
    for (int more = below(4); more > 0 && made < links; --more) {
      const Gear next = newGear(carrier.link);
      train.external(last.link, last.axis, 17 + below(40), next.link, next.axis, 17 + below(40));
      last = next;
    }
    if (below(2) == 0) carriers.push_back(last);
  }
  return train.mechanism();
}

Mechanism driven(Mechanism train) {
  const SnapshotPtr snapshot = analyzeLive(std::make_shared<const Mechanism>(train));
  GEARGRAPH_REQUIRE(snapshot->matroid() != nullptr);
  train.inputs.emplace();
  for (const int joint : snapshot->matroid()->choice.joints) {
    train.inputs->push_back({train.turningJoints[static_cast<std::size_t>(joint)].id, Number(1), {}});
  }
  return train;
}

Mechanism drivenAtRandom(Mechanism train) {
  train = driven(std::move(train));
  std::mt19937_64 random(7);
  // Valid sets are rare among all: from one to the next, an input is exchanged for a joint that may replace
  // it.
  const ModularDoubleField field;
  for (int exchange = 0; exchange < 12; ++exchange) {
    const SnapshotPtr snapshot = analyzeLive(std::make_shared<const Mechanism>(train));
    const std::vector<int>& inputs = snapshot->matroid()->choice.joints;
    const auto sets = InputSets::of(*snapshot->kinematics->model, field, inputs);
    const std::size_t place = random() % inputs.size();
    const std::vector<int> others = sets->replacementsFor(inputs[place]);
    if (others.empty()) continue;
    const int joint = others[random() % others.size()];
    (*train.inputs)[place].joint = train.turningJoints[static_cast<std::size_t>(joint)].id;
  }
  return train;
}

Mechanism drivenTree(int links) {
  return driven(epicyclicTree(links));
}

Mechanism coupledTree(int links) {
  return drivenAtRandom(epicyclicTree(links));
}

}  // namespace geargraph::bench
