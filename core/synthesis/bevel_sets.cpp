#include "core/synthesis/bevel_sets.h"

#include "core/synthesis/set_sketch.h"

namespace geargraph {

Expected<Mechanism> bevelDifferentialSet(int sideTeeth, int pinionTeeth, int pinions) {
  if (2 * sideTeeth % pinions != 0) {
    return Diagnostic{Code::assembly,
                      "The pinions do not go in evenly: twice the side wheels' teeth, " +
                          std::to_string(2 * sideTeeth) + ", has to be a multiple of " +
                          std::to_string(pinions) + ".",
                      {},
                      {},
                      0,
                      0};
  }
  SetSketch set("Bevel differential");
  const int casing = set.link(0, "a", "case");
  const int left = set.link(0, "a", "left wheel");
  const int right = set.link(0, "a", "right wheel");
  for (int i = 0; i < pinions; ++i) {
    const std::string number = pinions == 1 ? "" : " " + std::to_string(i + 1);
    const int pinion = set.link(casing, "b" + std::to_string(i + 1), "pinion" + number);
    set.mesh(left, pinion, sideTeeth, pinionTeeth, MeshKind::bevel);
    set.mesh(right, pinion, sideTeeth, pinionTeeth, MeshKind::bevel);
  }
  set.input(casing, Number(1));
  set.input(left, Number(0));
  return std::move(set).build();
}

Mechanism bevelWrist(const WristTeeth& teeth) {
  SetSketch set("Bevel wrist");
  const NumberTriple apex{Number(0), Number(0), Number(0)};
  const NumberTriple y{Number(0), Number(1), Number(0)};
  const NumberTriple z{Number(0), Number(0), Number(1)};
  set.axis("a", apex, z);
  set.axis("b", apex, y);
  set.axis("c", apex, z);
  const int housing = set.link(0, "a", "housing");
  const int bendShaft = set.link(0, "a", "bend shaft");
  const int bend = set.link(housing, "b", "bend");
  const int rollShaft = set.link(0, "a", "roll shaft");
  const int idler = set.link(housing, "b", "idler");
  const int tool = set.link(bend, "c", "tool");
  // Module 2: a pitch radius is the number of teeth. The shafts come from below, the tool is above.
  const auto at = [](int across, int along) {
    return NumberTriple{Number(0), Number(across), Number(along)};
  };
  set.mesh(bendShaft, bend, teeth.bendShaft, teeth.bend, MeshKind::bevel).pitchPoint =
      at(-teeth.bendShaft, -teeth.bend);
  set.mesh(rollShaft, idler, teeth.rollShaft, teeth.idler, MeshKind::bevel).pitchPoint =
      at(teeth.rollShaft, -teeth.idler);
  set.mesh(idler, tool, teeth.idlerPinion, teeth.tool, MeshKind::bevel).pitchPoint =
      at(teeth.tool, teeth.idlerPinion);
  set.input(housing, Number(0));
  set.input(bendShaft, Number(1));
  set.input(rollShaft, Number(0));
  return std::move(set).build();
}

}  // namespace geargraph
