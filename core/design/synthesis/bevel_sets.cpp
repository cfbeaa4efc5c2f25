#include "core/design/synthesis/bevel_sets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "core/design/synthesis/set_sketch.h"
#include "core/foundations/base/translation.h"

namespace geargraph {
namespace {

/// A third of the cone distance, less where a smaller one of the distances is near; whole units, 2 at least.
std::int64_t faceOf(double distance, std::span<const double> distances) {
  double room = distance / 3;
  for (const double other : distances) {
    if (other < distance) room = std::min(room, distance - other - 1);
  }
  return std::max<std::int64_t>(2, static_cast<std::int64_t>(room));
}

}  // namespace

Expected<Mechanism> bevelDifferentialSet(int sideTeeth, int pinionTeeth, int pinions) {
  if (2 * sideTeeth % pinions != 0) {
    return Diagnostic{
        Code::assembly,
        translated("The pinions do not go in evenly: twice the side wheels' teeth, %1, has to be a "
                   "multiple of %2.",
                   {std::to_string(2 * sideTeeth), std::to_string(pinions)}),
        {},
        {},
        0,
        0};
  }
  SetSketch set(translated("Bevel differential"));
  const int casing = set.link(0, "a", translated("case"));
  const int left = set.link(0, "a", translated("left wheel"));
  const int right = set.link(0, "a", translated("right wheel"));
  for (int i = 0; i < pinions; ++i) {
    const std::string number = std::to_string(i + 1);
    const int pinion = set.link(casing, "b" + number,
                                pinions == 1 ? translated("pinion") : translated("pinion %1", {number}));
    set.mesh(left, pinion, sideTeeth, pinionTeeth, MeshKind::bevel);
    set.mesh(right, pinion, sideTeeth, pinionTeeth, MeshKind::bevel);
  }
  set.input(casing, Number(1));
  set.input(left, Number(0));
  return std::move(set).build();
}

Mechanism bevelWrist(const WristTeeth& teeth) {
  SetSketch set(translated("Bevel wrist"));
  const NumberTriple apex{Number(0), Number(0), Number(0)};
  const NumberTriple y{Number(0), Number(1), Number(0)};
  const NumberTriple z{Number(0), Number(0), Number(1)};
  set.axis("a", apex, z);
  set.axis("b", apex, y);
  set.axis("c", apex, z);
  const int housing = set.link(0, "a", translated("housing"));
  const int bendShaft = set.link(0, "a", translated("bend shaft"));
  const int bend = set.link(housing, "b", translated("bend"));
  const int rollShaft = set.link(0, "a", translated("roll shaft"));
  const int idler = set.link(housing, "b", translated("idler"));
  const int tool = set.link(bend, "c", translated("tool"));
  // Module 2: a pitch radius is the number of teeth. The shafts come from below, the tool is above.
  const auto at = [](int across, int along) {
    return NumberTriple{Number(0), Number(across), Number(along)};
  };
  // Bearings beyond the wheels. The fork's is the nearest on the ground, with both shafts through it: its
  // standoffs pass no other.
  set.bearing(housing, -teeth.idler - 30);
  set.bearing(bendShaft, -teeth.idler - 70);
  set.bearing(bend, -teeth.bendShaft - 25);
  set.bearing(rollShaft, -teeth.idler - 50);
  set.bearing(idler, teeth.rollShaft + 25);
  set.bearing(tool, teeth.idlerPinion + 36);
  // All cones share one apex: a pair ends where the next smaller one begins.
  const std::array distances = {std::hypot(teeth.bendShaft, teeth.bend),
                                std::hypot(teeth.rollShaft, teeth.idler),
                                std::hypot(teeth.idlerPinion, teeth.tool)};
  const auto pair = [&](int tail, int head, int tailTeeth, int headTeeth, const NumberTriple& pitchPoint) {
    GearMesh& mesh = set.mesh(tail, head, tailTeeth, headTeeth, MeshKind::bevel);
    mesh.pitchPoint = pitchPoint;
    mesh.faceWidth = Number(faceOf(std::hypot(tailTeeth, headTeeth), distances));
  };
  pair(bendShaft, bend, teeth.bendShaft, teeth.bend, at(-teeth.bendShaft, -teeth.bend));
  pair(rollShaft, idler, teeth.rollShaft, teeth.idler, at(teeth.rollShaft, -teeth.idler));
  pair(idler, tool, teeth.idlerPinion, teeth.tool, at(teeth.tool, teeth.idlerPinion));
  set.input(housing, Number(0));
  set.input(bendShaft, Number(1));
  set.input(rollShaft, Number(0));
  return std::move(set).build();
}

}  // namespace geargraph
