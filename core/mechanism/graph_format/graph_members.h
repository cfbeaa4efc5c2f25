#pragma once

#include <optional>
#include <string_view>

namespace geargraph::inline graph_format {

/// What an attribute of a graph belongs to.
enum class GraphPart { graph, node, turningEdge, meshEdge };

/// How a member of the document is written in forms that know texts only.
enum class MemberType {
  text,
  id,
  number,  ///< "22/7", too
  flag,
  json,  ///< a list or an object
};

/// A member of the document, or of an element of its lists, that is an attribute of a graph.
struct GraphMember {
  GraphPart part = GraphPart::graph;
  std::string_view attribute;
  std::string_view member;
  MemberType type = MemberType::text;
};

/// None where it is no such member.
[[nodiscard]] const GraphMember* graphMemberOf(GraphPart part, std::string_view member);
/// By the name of the attribute.
[[nodiscard]] const GraphMember* graphAttributeOf(GraphPart part, std::string_view attribute);

/// Attributes that say what a node or edge is: the id of its element, the label, ...
constexpr std::string_view kVersionAttribute = "geargraph";
constexpr std::string_view kNameAttribute = "name";
constexpr std::string_view kLinkId = "linkId";
constexpr std::string_view kEdgeId = "edgeId";
constexpr std::string_view kLabel = "label";
constexpr std::string_view kEdgeKind = "kind";
constexpr std::string_view kTurning = "turning";
constexpr std::string_view kMesh = "mesh";
constexpr int kGraphVersion = 1;

/// The lasting spelling of an attribute that a reader asks for; none of others.
enum class AttributeOwner { graph, node, edge };
[[nodiscard]] std::optional<std::string_view> knownAttribute(AttributeOwner owner, std::string_view name);

}  // namespace geargraph::inline graph_format
