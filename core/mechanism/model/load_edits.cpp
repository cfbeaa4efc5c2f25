#include "core/mechanism/model/load_edits.h"

#include <algorithm>

#include "core/foundations/base/contract.h"
#include "core/foundations/base/translation.h"
#include "core/mechanism/model/checked_edit.h"
#include "core/mechanism/model/load_checks.h"
#include "core/mechanism/model/rejections.h"

namespace geargraph {
namespace {

LoadId freshLoadId(const Mechanism& mechanism) {
  for (int number = 1;; ++number) {
    const LoadId id("L" + std::to_string(number));
    const bool taken = std::any_of(mechanism.loads.begin(), mechanism.loads.end(),
                                   [&](const Load& load) { return load.id == id; });
    if (!taken) return id;
  }
}

Load& loadAt(Mechanism& mechanism, int load) {
  GEARGRAPH_REQUIRE(load >= 0 && load < static_cast<int>(mechanism.loads.size()));
  return mechanism.loads[static_cast<std::size_t>(load)];
}

}  // namespace

Expected<Mechanism> withLoad(Mechanism mechanism, Load load) {
  if (load.id.empty()) load.id = freshLoadId(mechanism);
  mechanism.loads.push_back(std::move(load));
  return checkedEdit(std::move(mechanism), "/loads", &loadDiagnostics);
}

Expected<Mechanism> withLoadAction(Mechanism mechanism, int load, decltype(Load::action) action) {
  loadAt(mechanism, load).action = std::move(action);
  return checkedEdit(std::move(mechanism), "/loads", &loadDiagnostics);
}

Expected<Mechanism> withoutLoad(Mechanism mechanism, int load) {
  (void)loadAt(mechanism, load);
  mechanism.loads.erase(mechanism.loads.begin() + load);
  return mechanism;
}

Expected<Mechanism> withBalances(Mechanism mechanism, std::optional<std::vector<HoldingTorque>> balances) {
  mechanism.balances = std::move(balances);
  return checkedEdit(std::move(mechanism), "/balances", &loadDiagnostics);
}

Mechanism withSharing(Mechanism mechanism, std::optional<LoadSharing> sharing) {
  mechanism.sharing = sharing;
  return mechanism;
}

Expected<Mechanism> withDriveTorque(Mechanism mechanism, std::optional<Number> torque) {
  mechanism.driveTorque = std::move(torque);
  return checkedEdit(std::move(mechanism), "/driveTorque", &loadDiagnostics);
}

Expected<Mechanism> withMeshLosses(Mechanism mechanism, MeshId mesh, std::optional<Number> efficiency,
                                   std::optional<Number> friction) {
  const auto found = std::find_if(mechanism.gearMeshes.begin(), mechanism.gearMeshes.end(),
                                  [&](const GearMesh& each) { return each.id == mesh; });
  if (found == mechanism.gearMeshes.end()) return unknownElement(mesh);
  if (const auto problem = lossProblem(efficiency, friction))
    return Diagnostic{Code::schema, problem->message, {mesh}, {}, 0, 0};
  found->efficiency = std::move(efficiency);
  found->friction = std::move(friction);
  return mechanism;
}

Expected<Mechanism> withDefaultLosses(Mechanism mechanism, std::optional<Number> efficiency,
                                      std::optional<Number> friction) {
  if (const auto problem = lossProblem(efficiency, friction))
    return Diagnostic{Code::schema, problem->message, {}, {}, 0, 0};
  if (!mechanism.gearDefaults) {
    if (!efficiency && !friction) return mechanism;
    mechanism.gearDefaults.emplace();
  }
  mechanism.gearDefaults->efficiency = std::move(efficiency);
  mechanism.gearDefaults->friction = std::move(friction);
  return mechanism;
}

std::optional<LinkId> linkOf(const Load& load) {
  if (const auto* torque = std::get_if<LinkTorque>(&load.action)) return torque->link;
  if (const auto* force = std::get_if<LinkForce>(&load.action)) return force->link;
  return std::nullopt;
}

std::optional<JointId> jointOf(const Load& load) {
  if (const auto* torque = std::get_if<JointTorque>(&load.action)) return torque->joint;
  return std::nullopt;
}

}  // namespace geargraph
