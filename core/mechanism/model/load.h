#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/foundations/base/id.h"
#include "core/mechanism/model/number.h"

namespace geargraph {

/// Members of a file that this program does not know, as (name, JSON text), in the order of the file. They
/// are kept and written back, so that a newer or foreign program's data survives an edit here.
using UnknownMembers = std::vector<std::pair<std::string, std::string>>;

/// A torque in a turning joint, N m, about +direction of its axis: by the joint's tail on its head, and the
/// opposite on the tail.
struct JointTorque {
  JointId joint;
  Number torque;
  friend bool operator==(const JointTorque&, const JointTorque&) = default;
};

/// An external torque on a link, N m, with the reaction on the ground. Only the direction of `axis` matters;
/// the default is the link's first axis on the path to the ground.
struct LinkTorque {
  LinkId link;
  std::optional<AxisId> axis;
  Number torque;
  friend bool operator==(const LinkTorque&, const LinkTorque&) = default;
};

/// An external force on a link, N, at a point of the link in the reference pose (base frame, the document's
/// unit), with the reaction on the ground.
struct LinkForce {
  LinkId link;
  NumberTriple force;
  NumberTriple point;
  friend bool operator==(const LinkForce&, const LinkForce&) = default;
};

/// An external load on a mechanism, in the reference pose. Several loads on one element add up.
struct Load {
  LoadId id = {};  ///< may be empty
  std::variant<JointTorque, LinkTorque, LinkForce> action;
  UnknownMembers unknown = {};
  friend bool operator==(const Load&, const Load&) = default;
};

/// An unknown torque that holds the loads: in a joint, tail on head, or on a link about the direction of an
/// axis (without it: the link's first axis on the way to the ground).
struct HoldingTorque {
  struct OnLink {
    LinkId link;
    std::optional<AxisId> axis;
    friend bool operator==(const OnLink&, const OnLink&) = default;
  };
  std::variant<JointId, OnLink> at;
  UnknownMembers unknown = {};
  friend bool operator==(const HoldingTorque&, const HoldingTorque&) = default;
};

/// How the load of members that statics alone does not share out is distributed.
enum class LoadSharing {
  none,      ///< it stays open: what depends on it has no value
  stiffness  ///< all teeth are equally stiff, without clearance, on rigid bodies
};
[[nodiscard]] std::string_view loadSharingName(LoadSharing sharing);
/// std::nullopt for another name.
[[nodiscard]] std::optional<LoadSharing> loadSharingFrom(std::string_view name);

}  // namespace geargraph
