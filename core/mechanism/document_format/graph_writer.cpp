// The digraph of a mechanism: its document, spread over the nodes and edges of a graph.

#include <charconv>
#include <unordered_map>

#include "core/foundations/base/contract.h"
#include "core/foundations/files/json.h"
#include "core/mechanism/document_format/graph_members.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "core/mechanism/document_format/mechanism_graph.h"
#include "core/mechanism/document_format/mechanism_table.h"

namespace geargraph {
namespace {

AttributeValue attributeValue(JsonValue value) {
  if (value.is(JsonKind::string)) return value.string();
  int number = 0;
  const std::string_view slice = value.slice();
  const auto [end, error] = std::from_chars(slice.data(), slice.data() + slice.size(), number);
  if (error == std::errc() && end == slice.data() + slice.size() && slice != "-0") return number;
  return JsonText{value.compact()};
}

/// The members of an element as attributes, those that `attributes` has already aside.
void addMembers(GraphPart part, JsonValue element, Attributes& attributes) {
  const std::size_t own = attributes.size();
  element.forEachMember([&](JsonValue key, JsonValue value) {
    const GraphMember* const member = graphMemberOf(part, key.string());
    if (member == nullptr) return;
    for (std::size_t i = 0; i < own; ++i) {
      if (attributes[i].first == member->attribute) return;
    }
    attributes.emplace_back(member->attribute, attributeValue(value));
  });
}

class DigraphWriter {
 public:
  explicit DigraphWriter(const Mechanism& mechanism) : m_mechanism(mechanism) {
    for (int i = 0; i <= mechanism.n(); ++i) m_positions.emplace(mechanism.links[i].id, i);
  }

  GraphDescription describe(JsonValue document) {
    GraphDescription graph{m_mechanism.name};
    graph.attributes.emplace_back(kVersionAttribute, kGraphVersion);
    graph.attributes.emplace_back(kNameAttribute, m_mechanism.name);
    addMembers(GraphPart::graph, document, graph.attributes);
    document.member("links")->forEachElement([&](JsonValue link, std::size_t i) {
      DescribedNode& node = graph.nodes.emplace_back();
      node.label = m_mechanism.linkLabel(static_cast<int>(i));
      node.attributes = {{kLinkId, m_mechanism.links[i].id.text()},
                         {kNameAttribute, m_mechanism.links[i].name}};
      addMembers(GraphPart::node, link, node.attributes);
    });
    document.member("turningJoints")->forEachElement([&](JsonValue joint, std::size_t i) {
      graph.edges.push_back(
          edge(m_mechanism.turningJoints[i], m_mechanism.jointLabel(static_cast<int>(i)), kTurning));
      addMembers(GraphPart::turningEdge, joint, graph.edges.back().attributes);
    });
    document.member("gearMeshes")->forEachElement([&](JsonValue mesh, std::size_t i) {
      graph.edges.push_back(
          edge(m_mechanism.gearMeshes[i], m_mechanism.meshLabel(static_cast<int>(i)), kMesh));
      addMembers(GraphPart::meshEdge, mesh, graph.edges.back().attributes);
    });
    return graph;
  }

 private:
  template <class Element>
  DescribedEdge edge(const Element& element, int label, std::string_view kind) {
    return {m_mechanism.linkLabel(m_positions.at(element.tail)),
            m_mechanism.linkLabel(m_positions.at(element.head)),
            std::to_string(label),
            {{kLabel, label}, {kEdgeId, element.id.text()}, {kEdgeKind, std::string(kind)}}};
  }

  const Mechanism& m_mechanism;
  std::unordered_map<LinkId, int> m_positions;
};

}  // namespace

std::string digraphFile(const Mechanism& mechanism, GraphForm form) {
  const TablePart part = tablePart(mechanism);
  const std::string text = writeMechanism(part.mechanism);
  const auto document = JsonDocument::parse(text);
  GEARGRAPH_REQUIRE(document.has_value());
  GraphDescription graph = DigraphWriter(part.mechanism).describe(document->root());
  // The others have the name anyway; XML's is an attribute, in which line ends become blanks.
  if (form != GraphForm::graphMl)
    std::erase_if(graph.attributes, [](const auto& each) { return each.first == kNameAttribute; });
  return graphText(graph, form);
}

}  // namespace geargraph
