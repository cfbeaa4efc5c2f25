#include "core/mechanism/graph_format/graph_members.h"

#include <algorithm>
#include <array>

namespace geargraph::inline graph_format {
namespace {

using enum GraphPart;
using enum MemberType;

constexpr std::array kMembers = {
    GraphMember{graph, "name", "name", text},
    GraphMember{graph, "notes", "notes", text},
    GraphMember{graph, "unit", "unit", text},
    GraphMember{graph, "axes", "axes", json},
    GraphMember{graph, "wheels", "wheels", json},
    GraphMember{graph, "gearDefaults", "gearDefaults", json},
    GraphMember{graph, "inputs", "inputs", json},
    GraphMember{graph, "couplings", "couplings", json},
    GraphMember{graph, "states", "states", json},
    GraphMember{graph, "engaged", "engaged", json},
    GraphMember{graph, "loads", "loads", json},
    GraphMember{graph, "balances", "balances", json},
    GraphMember{graph, "sharing", "sharing", text},
    GraphMember{graph, "driveTorque", "driveTorque", number},
    GraphMember{graph, "density", "density", number},
    GraphMember{graph, "gravity", "gravity", json},
    GraphMember{node, "linkId", "id", id},
    GraphMember{node, "name", "name", text},
    GraphMember{node, "pinned", "pinned", flag},
    GraphMember{node, "mass", "mass", number},
    GraphMember{node, "centerOfMass", "centerOfMass", json},
    GraphMember{node, "inertia", "inertia", json},
    GraphMember{turningEdge, "edgeId", "id", id},
    GraphMember{turningEdge, "axis", "axis", id},
    GraphMember{turningEdge, "offset", "offset", number},
    GraphMember{turningEdge, "limits", "limits", json},
    GraphMember{meshEdge, "edgeId", "id", id},
    GraphMember{meshEdge, "tailTeeth", "tailTeeth", number},
    GraphMember{meshEdge, "headTeeth", "headTeeth", number},
    GraphMember{meshEdge, "pitchPoint", "pitchPoint", json},
    GraphMember{meshEdge, "meshKind", "kind", text},
    GraphMember{meshEdge, "faceWidth", "faceWidth", number},
    GraphMember{meshEdge, "tailWheel", "tailWheel", id},
    GraphMember{meshEdge, "headWheel", "headWheel", id},
    GraphMember{meshEdge, "pinned", "pinned", flag},
    GraphMember{meshEdge, "efficiency", "efficiency", number},
    GraphMember{meshEdge, "friction", "friction", number},
};

template <class Matches>
const GraphMember* found(Matches matches) {
  const auto* const at = std::find_if(kMembers.begin(), kMembers.end(), matches);
  return at == kMembers.end() ? nullptr : &*at;
}

}  // namespace

const GraphMember* graphMemberOf(GraphPart part, std::string_view member) {
  return found([&](const GraphMember& each) { return each.part == part && each.member == member; });
}

const GraphMember* graphAttributeOf(GraphPart part, std::string_view attribute) {
  return found([&](const GraphMember& each) { return each.part == part && each.attribute == attribute; });
}

std::optional<std::string_view> knownAttribute(AttributeOwner owner, std::string_view name) {
  const auto isOf = [&](GraphPart part) {
    switch (owner) {
      case AttributeOwner::graph:
        return part == GraphPart::graph;
      case AttributeOwner::node:
        return part == GraphPart::node;
      case AttributeOwner::edge:
        return part == GraphPart::turningEdge || part == GraphPart::meshEdge;
    }
    return false;
  };
  if (const auto* known =
          found([&](const GraphMember& each) { return isOf(each.part) && each.attribute == name; }))
    return known->attribute;
  if (owner == AttributeOwner::graph && name == kVersionAttribute) return kVersionAttribute;
  if (name == kLabel) return kLabel;
  if (owner == AttributeOwner::edge && name == kEdgeKind) return kEdgeKind;
  return std::nullopt;
}

}  // namespace geargraph::inline graph_format
