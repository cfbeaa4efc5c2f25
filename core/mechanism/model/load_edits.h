#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "core/foundations/base/expected.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph {

// Edits of loads, balances and losses: pure functions, as in edits.h. withoutElements() also removes loads,
// by themselves or with their joint or link.

/// Appends a load; one without an id gets "L1", "L2", ... Rejects unknown-id, duplicate-id, and schema for a
/// load on the ground or beyond the limits of the format.
[[nodiscard]] Expected<Mechanism> withLoad(Mechanism mechanism, Load load);
/// Replaces the action of the load at this position; its id and unknown members stay. Rejects as withLoad().
/// @pre there is such a load
[[nodiscard]] Expected<Mechanism> withLoadAction(Mechanism mechanism, int load,
                                                 decltype(Load::action) action);
/// @pre there is such a load
[[nodiscard]] Expected<Mechanism> withoutLoad(Mechanism mechanism, int load);

/// Sets where torques hold the loads; none leaves the choice to the program. Rejects unknown-id,
/// duplicate-id, and schema for one on the ground.
[[nodiscard]] Expected<Mechanism> withBalances(Mechanism mechanism,
                                               std::optional<std::vector<HoldingTorque>> balances);

/// Sets how loads are shared that statics does not share out; none leaves it open, but for losses.
[[nodiscard]] Mechanism withSharing(Mechanism mechanism, std::optional<LoadSharing> sharing);
/// Sets the torque at the drive of every state; none: that of the loads, else 1 N m. Rejects schema beyond
/// the limits of the format.
[[nodiscard]] Expected<Mechanism> withDriveTorque(Mechanism mechanism, std::optional<Number> torque);

/// Sets the losses of a mesh: an efficiency, a coefficient of friction, or neither. Rejects unknown-id, and
/// schema for both or for numbers out of their range.
[[nodiscard]] Expected<Mechanism> withMeshLosses(Mechanism mechanism, MeshId mesh,
                                                 std::optional<Number> efficiency,
                                                 std::optional<Number> friction);
/// Sets the default losses, for all meshes that state neither.
[[nodiscard]] Expected<Mechanism> withDefaultLosses(Mechanism mechanism, std::optional<Number> efficiency,
                                                    std::optional<Number> friction);

/// The link that a load acts on; std::nullopt for a torque in a joint, which has jointOf().
[[nodiscard]] std::optional<LinkId> linkOf(const Load& load);
[[nodiscard]] std::optional<JointId> jointOf(const Load& load);

/// Calls use(axis) for the axis of every torque on a link and of every balance on one, named or not.
template <class Use>
void forEachLoadAxis(Mechanism& mechanism, const Use& use) {
  for (Load& load : mechanism.loads) {
    if (auto* torque = std::get_if<LinkTorque>(&load.action)) use(torque->axis);
  }
  if (!mechanism.balances) return;
  for (HoldingTorque& balance : *mechanism.balances) {
    if (auto* onLink = std::get_if<HoldingTorque::OnLink>(&balance.at)) use(onLink->axis);
  }
}

}  // namespace geargraph
