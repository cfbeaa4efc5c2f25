#include <cmath>
#include <cstdio>

#include "core/gears/half_tooth.h"
#include "core/gears/tooth_pair.h"
#include "core/gears/train_findings.h"

namespace geargraph {
namespace {

/// How far a ring's tip may be lowered before it is worth a word, in modules.
constexpr double kNoticedShortening = 0.3;

std::string number(double value, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

std::vector<ElementId> blamed(const Mechanism& mechanism, const TrainGear& gear) {
  std::vector<ElementId> elements;
  for (const int mesh : gear.meshes)
    elements.emplace_back(mechanism.gearMeshes[static_cast<std::size_t>(mesh)].id);
  elements.emplace_back(mechanism.links[static_cast<std::size_t>(gear.link)].id);
  if (gear.wheel) elements.emplace_back(*gear.wheel);
  return elements;
}

Diagnostic finding(Code code, std::string message, std::vector<ElementId> elements) {
  Diagnostic d;
  d.code = code;
  d.message = std::move(message);
  d.elements = std::move(elements);
  return d;
}

void addToothForm(const Mechanism& mechanism, const TrainGear& gear, Diagnostics& found) {
  const GearSpec& spec = gear.spec;
  const std::string who = "Gear " + gear.name + " (" + std::to_string(spec.teeth) + " teeth)";
  const Diagnostics impossible = specDiagnostics(spec);
  if (!impossible.empty()) {
    found.push_back(finding(Code::interference,
                            who + " is drawn as a plain wheel: " + impossible.front().message,
                            blamed(mechanism, gear)));
    return;
  }
  if (spec.kind == GearKind::internal) return;
  const HalfTooth tooth = spec.kind == GearKind::bevel ? bevelTooth(spec, 0.05) : externalTooth(spec, 0.05);
  if (tooth.undercut) {
    found.push_back(finding(Code::undercut,
                            who + " is undercut: at a profile shift of " + number(spec.profileShift, 2) +
                                " a rack needs " + number(fewestTeethWithoutUndercut(spec), 1) +
                                " teeth or more. Use more teeth, or a shift of at least " +
                                number(leastShiftWithoutUndercut(spec), 2) + ".",
                            blamed(mechanism, gear)));
  }
  if (tooth.shortened) {
    found.push_back(finding(Code::interference,
                            who + " would have pointed teeth: its tips were lowered to keep a land of " +
                                number(kNarrowestLand, 1) + " modules. Use a smaller profile shift than " +
                                number(spec.profileShift, 2) + ".",
                            blamed(mechanism, gear)));
  }
}

void addRingPair(const Mechanism& mechanism, const GearTrain& train, const TrainMesh& mesh,
                 Diagnostics& found) {
  const TrainGear* ring = &train.gears[static_cast<std::size_t>(mesh.tailGear)];
  const TrainGear* pinion = &train.gears[static_cast<std::size_t>(mesh.headGear)];
  if (pinion->spec.kind == GearKind::internal) std::swap(ring, pinion);
  if (ring->spec.kind != GearKind::internal || pinion->spec.kind != GearKind::external) return;
  if (!specDiagnostics(ring->spec).empty() || !specDiagnostics(pinion->spec).empty()) return;
  const Eigen::Vector3d axis = ring->pose.linear().col(2);
  const double distance =
      (ring->pose.translation() - pinion->pose.translation()).cross(axis).norm() / ring->spec.module;
  const std::string pair =
      std::to_string(pinion->spec.teeth) + " teeth in a ring of " + std::to_string(ring->spec.teeth);
  const std::vector<ElementId> elements{mechanism.gearMeshes[static_cast<std::size_t>(mesh.mesh)].id};
  const double margin = trochoidMargin(pinion->spec, ring->spec, distance);
  if (margin < 0) {
    found.push_back(finding(
        Code::interference,
        pair + ": their tips collide outside of the mesh, by " + number(-margin * ring->spec.teeth / 2, 3) +
            " modules. Use a difference of more teeth, or a larger profile shift of the ring.",
        elements));
  }
  const double standard = ring->spec.teeth / 2.0 - ring->spec.addendum + ring->spec.profileShift;
  if (ring->spec.tipRadius > standard + kNoticedShortening) {
    found.push_back(finding(Code::interference,
                            pair +
                                ": the ring's tips would run into the pinion's fillets and were lowered by " +
                                number(ring->spec.tipRadius - standard, 2) +
                                " modules. Use a pinion of more teeth, or with a larger profile shift.",
                            elements));
  }
}

}  // namespace

Diagnostics toothDiagnostics(const Mechanism& mechanism, const GearTrain& train) {
  Diagnostics found;
  for (const TrainGear& gear : train.gears) addToothForm(mechanism, gear, found);
  for (const TrainMesh& mesh : train.meshes) addRingPair(mechanism, train, mesh, found);
  return found;
}

}  // namespace geargraph
