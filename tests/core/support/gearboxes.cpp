#include "tests/core/support/gearboxes.h"

#include "tests/core/support/train_sketch.h"

namespace geargraph::test {
namespace {

LinkId link(int number) {
  return LinkId(std::to_string(number));
}

}  // namespace

void addBrake(Mechanism& mechanism, const char* id, int of) {
  mechanism.couplings.push_back({ShiftElementId(id), ShiftElementKind::brake, {link(of)}, {}});
}

void addClutch(Mechanism& mechanism, const char* id, int one, int other) {
  mechanism.couplings.push_back({ShiftElementId(id), ShiftElementKind::clutch, {link(one), link(other)}, {}});
}

void addState(Mechanism& mechanism, const char* name, const std::vector<const char*>& engaged, int drive,
              int driven) {
  ShiftState state{name, {}, link(drive), link(driven), {}};
  for (const char* id : engaged) state.engaged.emplace_back(id);
  mechanism.states.push_back(std::move(state));
}

Mechanism eightSpeed() {
  TrainSketch train(12);
  for (int shaft = 1; shaft <= 8; ++shaft) train.joint(0, shaft, "a");
  train.joint(6, 9, "b").joint(1, 10, "c").joint(7, 11, "d").joint(2, 12, "e");
  train.mesh(3, 9, 48, 24, MeshKind::external).mesh(9, 4, 24, 96, MeshKind::internal);
  train.mesh(3, 10, 48, 24, MeshKind::external).mesh(10, 8, 24, 96, MeshKind::internal);
  train.mesh(8, 11, 69, 21, MeshKind::external).mesh(11, 5, 21, 111, MeshKind::internal);
  train.mesh(5, 12, 23, 31, MeshKind::external).mesh(12, 6, 31, 85, MeshKind::internal);
  Mechanism gearbox = train.build();
  gearbox.name = "Eight-speed gearbox";
  addBrake(gearbox, "A", 3);
  addBrake(gearbox, "B", 4);
  addClutch(gearbox, "C", 1, 5);
  addClutch(gearbox, "D", 7, 2);
  addClutch(gearbox, "E", 5, 7);
  addState(gearbox, "1", {"A", "B", "C"}, 1, 2);
  addState(gearbox, "2", {"A", "B", "E"}, 1, 2);
  addState(gearbox, "3", {"B", "C", "E"}, 1, 2);
  addState(gearbox, "4", {"B", "D", "E"}, 1, 2);
  addState(gearbox, "5", {"B", "C", "D"}, 1, 2);
  addState(gearbox, "6", {"C", "D", "E"}, 1, 2);
  addState(gearbox, "7", {"A", "C", "D"}, 1, 2);
  addState(gearbox, "8", {"A", "D", "E"}, 1, 2);
  addState(gearbox, "R", {"A", "B", "D"}, 1, 2);
  return gearbox;
}

Mechanism bevelDifferential() {
  Mechanism mechanism = TrainSketch(4)
                            .axis("a", {"0", "0", "0"}, {"1", "0", "0"})
                            .axis("b", {"0", "0", "0"}, {"0", "1", "0"})
                            .joint(0, 1, "a")
                            .joint(0, 2, "a")
                            .joint(0, 3, "a")
                            .joint(3, 4, "b")
                            .mesh(1, 4, 16, 10, MeshKind::bevel, {"-10", "16", "0"})
                            .mesh(2, 4, 16, 10, MeshKind::bevel, {"10", "16", "0"})
                            .build();
  addClutch(mechanism, "L", 1, 3);
  addClutch(mechanism, "S", 1, 2);
  addBrake(mechanism, "P", 4);
  addBrake(mechanism, "C", 3);
  return mechanism;
}

}  // namespace geargraph::test
