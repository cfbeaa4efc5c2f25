#pragma once

#include <optional>
#include <string_view>

namespace geargraph {

/// The part of a graph that an attribute belongs to.
enum class GraphPart { graph, node, turningEdge, meshEdge };

/// How a member of the document is written in formats whose values are texts only.
enum class MemberType {
  text,
  id,
  number,  ///< also a fraction, "22/7"
  flag,
  json,  ///< a list or an object
};

/// A member of the document, or of an element of one of its lists, that is written as a graph attribute.
struct GraphMember {
  GraphPart part = GraphPart::graph;
  std::string_view attribute;
  std::string_view member;
  MemberType type = MemberType::text;
};

/// Null if the member is not written as an attribute.
[[nodiscard]] const GraphMember* graphMemberOf(GraphPart part, std::string_view member);
/// The same, by the name of the attribute.
[[nodiscard]] const GraphMember* graphAttributeOf(GraphPart part, std::string_view attribute);

/// Attributes that identify a node or an edge: the id of its element, the label, ...
constexpr std::string_view kVersionAttribute = "geargraph";
constexpr std::string_view kNameAttribute = "name";
constexpr std::string_view kLinkId = "linkId";
constexpr std::string_view kEdgeId = "edgeId";
constexpr std::string_view kLabel = "label";
constexpr std::string_view kEdgeKind = "kind";
constexpr std::string_view kTurning = "turning";
constexpr std::string_view kMesh = "mesh";
constexpr int kGraphVersion = 1;

/// The name of an attribute as a constant that outlives the text being read; std::nullopt for an attribute
/// without a meaning here.
enum class AttributeOwner { graph, node, edge };
[[nodiscard]] std::optional<std::string_view> knownAttribute(AttributeOwner owner, std::string_view name);

}  // namespace geargraph
