#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/theory/statics/losses.h"

namespace geargraph {

/// What one element delivers to a link, W; below 0: what it takes from it.
struct PowerPort {
  LinkOrdinal link = 0;
  Real power;
};

/// The power of one element at all links that it acts on. The sum over its ports is what it feeds into the
/// train: minus the loss for a mesh, torque times rate for a joint (0 where it is free), 0 for an engaged
/// coupling, the power of a load or a balance on a link. That sum is the same for every observer.
struct ElementPower {
  enum class Kind { mesh, joint, coupling, load, balance };
  Kind kind = Kind::mesh;
  /// The mesh, the joint or the coupling; a load on a link: its position in StaticsProblem::torques, that of
  /// a force after those; a balance on a link: in StaticsProblem::balances. Loads and balances in joints are
  /// part of their joint.
  int position = 0;
  /// A mesh: tail's gear, head's gear, carrier. A joint: tail, head. A coupling: the link that it acts on,
  /// then the other one or the ground. A load, a balance: its link, then the ground, which has the reaction.
  std::vector<PowerPort> ports;
  bool isDetermined = true;
  /// Determined only by the assumption of equal stiffness: the element is part of a self-stress or, with
  /// losses, depends on its shares.
  bool isAssumed = false;

  [[nodiscard]] Real fed() const;
};

/// Where power goes in a steady motion, seen from one link, the observer: all speeds are relative to it.
/// Power is conserved at every link: its ports sum to 0 (Kirchhoff's law), also at the ground.
///
/// A mesh is an element with three terminals: its port torque times the speed of the gear about its own axis,
/// for either gear, and the reactions of both on the carrier (Chen and Angeles, Mech. Mach. Theory 42(1),
/// 2007). A joint passes the wrench of its cutset, the meshes taken as port torques, times the twist of its
/// links; between parallel axes, without forces, that is its own torque alone.
struct PowerFlow {
  LinkOrdinal observer = 0;            ///< a link; 0: the ground
  std::vector<ElementPower> elements;  ///< ascending by kind, then by position

  /// By link, the sum over all ports: 0 in fractions where all directions have rational cosines and all
  /// forces rational moments, else within rounding.
  [[nodiscard]] ByLink<Real> sums(int links) const;
  /// Cost: O(log elements). @pre the element is in the flow
  [[nodiscard]] const ElementPower& of(ElementPower::Kind kind, int position) const;
};

/// The flow of a solved problem. `losses` by mesh, or empty. A mesh whose load is indeterminate, and the
/// joints that transmit a part of it, are not determined. Cost: O(n + c) times the number of directions of
/// axes, and O(depth) per force.
/// @pre all of one mechanism; the solution has values
[[nodiscard]] PowerFlow powerFlow(const Mechanism& mechanism, const KinematicModel& model,
                                  const Placement& placement, const StaticsProblem& problem,
                                  const StaticsSolution& solution, std::span<const MeshLoss> losses,
                                  const Motion& motion, LinkOrdinal observer = 0);

/// The latent ratio: the sum of the powers through all meshes, seen from their carriers, over the power fed.
/// std::nullopt if nothing is fed or a mesh is not determined.
[[nodiscard]] std::optional<Real> latentRatio(const StaticsSolution& solution, const MeshPowers& powers,
                                              const Real& fed);

}  // namespace geargraph
