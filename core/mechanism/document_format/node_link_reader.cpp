// The node-link JSON of NetworkX: {"directed": true, "graph": {}, "nodes": [{"id": 0}], "links": [{"source":
// 0, "target": 1}]}; its newer versions say "edges" for "links".

#include "core/foundations/base/translation.h"
#include "core/foundations/files/json.h"
#include "core/mechanism/document_format/graph_parts.h"
#include "core/mechanism/document_format/json_checks.h"

namespace geargraph {
namespace {

class NodeLinkReader {
 public:
  NodeLinkReader(std::string_view text, const JsonDocument& document)
      : m_text(text), m_root(document.root()) {}

  Expected<GraphParts> run() {
    if (!m_root.is(JsonKind::object)) return noGraph(m_root);
    const auto directed = m_root.member("directed");
    if (directed && directed->is(JsonKind::boolean) && !directed->boolean())
      return undirectedGraph(m_text, directed->offset());
    const auto nodes = m_root.member("nodes");
    auto edges = m_root.member("links");
    if (!edges) edges = m_root.member("edges");
    if (!nodes || !nodes->is(JsonKind::array)) return noGraph(nodes.value_or(m_root));
    if (edges && !edges->is(JsonKind::array)) return noGraph(*edges);
    m_parts.offset = m_root.offset();
    if (const auto graph = m_root.member("graph"); graph && graph->is(JsonKind::object)) {
      m_parts.offset = graph->offset();
      readMembers(AttributeOwner::graph, *graph, m_parts.attributes, {});
    }
    if (nodes->size() > kMaxNodes || (edges && edges->size() > kMaxEdges)) {
      return makeDiagnostics(translated("A graph of at most 100,000 nodes and 200,000 edges is read."),
                             nodes->size() > kMaxNodes ? *nodes : *edges);
    }
    nodes->forEachElement([&](JsonValue node, std::size_t) { readNode(node); });
    if (edges) edges->forEachElement([&](JsonValue edge, std::size_t) { readEdge(edge); });
    if (!m_failure.empty()) return std::move(m_failure);
    return std::move(m_parts);
  }

 private:
  Diagnostics makeDiagnostics(std::string message, JsonValue at, Code code = Code::schema) const {
    GraphDiagnostics diagnostics(m_text);
    diagnostics.add(code, std::move(message), at.offset());
    return diagnostics.inOrder();
  }
  Diagnostics noGraph(JsonValue at) const {
    return makeDiagnostics(
        translated("This is no node-link graph: it is an object with the lists \"nodes\" and \"links\"."), at,
        Code::format);
  }

  /// The name of a node, a text or a number.
  std::optional<std::string> keyOf(JsonValue element, std::string_view member) {
    const auto value = element.is(JsonKind::object) ? element.member(member) : std::nullopt;
    if (value && value->is(JsonKind::string)) return value->string();
    if (value && value->is(JsonKind::number)) return std::string(value->slice());
    if (m_failure.empty()) {
      m_failure = makeDiagnostics(
          translated("Expected an object with \"%1\", a text or a number that names a node.", {member}),
          value.value_or(element));
    }
    return std::nullopt;
  }

  void readNode(JsonValue node) {
    auto key = keyOf(node, "id");
    if (!key) return;
    ReadNode& read = m_parts.nodes.emplace_back(ReadNode{std::move(*key), node.offset()});
    readMembers(AttributeOwner::node, node, read.attributes, {"id"});
  }

  void readEdge(JsonValue edge) {
    auto source = keyOf(edge, "source");
    auto target = keyOf(edge, "target");
    if (!source || !target) return;
    ReadEdge& read =
        m_parts.edges.emplace_back(ReadEdge{std::move(*source), std::move(*target), edge.offset()});
    readMembers(AttributeOwner::edge, edge, read.attributes, {"source", "target", "key"});
  }

  void readMembers(AttributeOwner owner, JsonValue object, GraphAttributes& into,
                   std::initializer_list<std::string_view> others) {
    object.forEachMember([&](JsonValue key, JsonValue value) {
      const std::string name = key.string();
      for (const std::string_view other : others) {
        if (name == other) return;
      }
      if (value.is(JsonKind::null)) return;
      if (!knownAttribute(owner, name)) return m_parts.addUnread(name);
      const bool isText = value.is(JsonKind::string);
      m_parts.set(owner, into, name,
                  std::make_shared<const AttributeText>(
                      AttributeText{isText ? value.string() : std::string(value.slice()), !isText}));
    });
  }

  std::string_view m_text;
  JsonValue m_root;
  GraphParts m_parts;
  Diagnostics m_failure;
};

}  // namespace

Expected<GraphParts> readNodeLink(std::string_view text) {
  const auto document = JsonDocument::parse(text);
  if (!document) return document.error();
  JsonDiagnostics diagnostics(*document);
  checkJson(*document, diagnostics);
  // A list of edges may be longer than lists of documents.
  Diagnostics found = diagnostics.inOrder();
  std::erase_if(found,
                [](const Diagnostic& each) { return each.pointer == "/links" || each.pointer == "/edges"; });
  if (!found.empty()) return found;
  return NodeLinkReader(text, *document).run();
}

}  // namespace geargraph
