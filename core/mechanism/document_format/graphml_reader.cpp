// GraphML, by expat. Document types are rejected, so that there are no entities and no other files.

#include <expat.h>

#include <algorithm>
#include <cstring>
#include <initializer_list>
#include <map>
#include <memory>

#include "core/foundations/base/translation.h"
#include "core/mechanism/document_format/graph_parts.h"

namespace geargraph {
namespace {

/// Takes the events of the parser.
class GraphMlReader {
 public:
  explicit GraphMlReader(std::string_view text)
      : m_text(text), m_parser(XML_ParserCreate(nullptr), &XML_ParserFree) {}

  Expected<GraphParts> run() {
    if (!m_parser) throw std::bad_alloc();
    XML_SetUserData(m_parser.get(), this);
    XML_SetElementHandler(m_parser.get(), guarded<&GraphMlReader::begin, const char*, const char**>,
                          guarded<&GraphMlReader::end, const char*>);
    XML_SetCharacterDataHandler(m_parser.get(), guarded<&GraphMlReader::characters, const char*, int>);
    XML_SetStartDoctypeDeclHandler(
        m_parser.get(), guarded<&GraphMlReader::documentType, const char*, const char*, const char*, int>);
    const XML_Status status =
        XML_Parse(m_parser.get(), m_text.data(), static_cast<int>(m_text.size()), XML_TRUE);
    if (m_exception) std::rethrow_exception(m_exception);
    if (m_failure.empty() && status != XML_STATUS_OK)
      fail(Code::syntax,
           translated("This is no XML: %1.", {XML_ErrorString(XML_GetErrorCode(m_parser.get()))}));
    if (m_failure.empty() && !m_hasGraph) fail(Code::format, translated("There is no <graph> in the file."));
    if (!m_failure.empty()) return std::move(m_failure);
    addDefaults();
    return std::move(m_parts);
  }

 private:
  struct Key {
    std::string name{};
    std::string owner{};  ///< "node", "edge", "graph", "all"
  };
  enum class Inside { nothing, graphMl, key, keyDefault, graph, node, edge, data, label, other };

  /// No exception leaves through the parser, which is C.
  template <auto handle, class... Arguments>
  static void guarded(void* self, Arguments... arguments) {
    auto& reader = *static_cast<GraphMlReader*>(self);
    if (reader.m_exception || !reader.m_failure.empty()) return;
    try {
      (reader.*handle)(arguments...);
    } catch (...) {
      reader.m_exception = std::current_exception();
      XML_StopParser(reader.m_parser.get(), XML_FALSE);
    }
  }

  [[nodiscard]] std::size_t offset() const {
    const XML_Index at = XML_GetCurrentByteIndex(m_parser.get());
    return at < 0 ? 0 : static_cast<std::size_t>(at);
  }
  void fail(Code code, std::string message) {
    GraphDiagnostics diagnostics(m_text);
    diagnostics.add(code, std::move(message), offset());
    m_failure = diagnostics.inOrder();
    XML_StopParser(m_parser.get(), XML_FALSE);
  }

  void documentType(const char*, const char*, const char*, int) {
    fail(Code::format, translated("A file with a document type (<!DOCTYPE>) is not read; leave it out."));
  }

  static const char* attribute(const char** attributes, const char* name) {
    for (; *attributes != nullptr; attributes += 2) {
      if (std::strcmp(attributes[0], name) == 0) return attributes[1];
    }
    return nullptr;
  }
  std::optional<std::string> needed(const char** attributes, const char* name, const std::string& element) {
    if (const char* const value = attribute(attributes, name)) return value;
    fail(Code::schema, translated("The element <%1> lacks the attribute \"%2\".", {element, name}));
    return std::nullopt;
  }

  void begin(const char* name, const char** attributes) {
    const char* const colon = std::strrchr(name, ':');  // of a name space
    const std::string element = colon != nullptr ? colon + 1 : name;
    const Inside around = m_inside.empty() ? Inside::nothing : m_inside.back();
    if (m_inside.size() >= static_cast<std::size_t>(kDeepestNesting))
      return fail(Code::schema, translated("Elements are nested deeper than 64."));
    m_inside.push_back(Inside::other);
    if (around == Inside::nothing) {
      if (element != "graphml")
        return fail(Code::format, translated("This is no GraphML: it begins with <%1>.", {element}));
      m_inside.back() = Inside::graphMl;
    } else if (around == Inside::graphMl && element == "key") {
      readKey(attributes);
    } else if (around == Inside::key && element == "default") {
      m_inside.back() = Inside::keyDefault;
      m_value.clear();
    } else if (element == "graph") {
      readGraph(around, attributes);
    } else if (around == Inside::graph && (element == "node" || element == "edge")) {
      element == "node" ? readNode(attributes) : readEdge(attributes);
    } else if (element == "hyperedge") {
      fail(Code::schema,
           translated("A hyperedge is not read; a joint and a mesh are edges between two nodes."));
    } else if (element == "data" &&
               (around == Inside::graph || around == Inside::node || around == Inside::edge)) {
      auto key = needed(attributes, "key", element);
      if (!key) return;
      m_inside.back() = Inside::data;
      m_key = std::move(*key);
      m_value.clear();
    } else if (around == Inside::other && (element == "NodeLabel" || element == "EdgeLabel")) {
      m_inside.back() = Inside::label;  // of yEd, inside the data that draw a node or an edge
      m_label.clear();
    }
  }

  void readKey(const char** attributes) {
    auto id = needed(attributes, "id", "key");
    if (!id) return;
    m_inside.back() = Inside::key;
    const char* const of = attribute(attributes, "for");
    const char* const name = attribute(attributes, "attr.name");
    m_key = std::move(*id);
    m_keys[m_key] = {name != nullptr ? name : m_key, of != nullptr ? of : "all"};
  }

  void readGraph(Inside around, const char** attributes) {
    if (around != Inside::graphMl || m_hasGraph)
      return fail(Code::schema,
                  translated("A file with one graph is read, without graphs inside its nodes."));
    m_hasGraph = true;
    m_inside.back() = Inside::graph;
    m_parts.offset = offset();
    if (const char* const id = attribute(attributes, "id")) m_parts.name = id;
    const char* const direction = attribute(attributes, "edgedefault");
    m_isDirected = direction == nullptr || std::strcmp(direction, "undirected") != 0;
  }

  void readNode(const char** attributes) {
    auto id = needed(attributes, "id", "node");
    if (!id) return;
    if (m_parts.nodes.size() == kMaxNodes)
      return fail(Code::schema, translated("A graph of at most 100,000 nodes is read."));
    m_inside.back() = Inside::node;
    m_parts.nodes.push_back({std::move(*id), offset()});
  }

  void readEdge(const char** attributes) {
    auto source = needed(attributes, "source", "edge");
    if (!source) return;
    auto target = needed(attributes, "target", "edge");
    if (!target) return;
    const char* const directed = attribute(attributes, "directed");
    if (directed != nullptr ? std::strcmp(directed, "false") == 0 : !m_isDirected) {
      m_failure = undirectedGraph(m_text, offset());
      XML_StopParser(m_parser.get(), XML_FALSE);
      return;
    }
    if (m_parts.edges.size() == kMaxEdges)
      return fail(Code::schema, translated("A graph of at most 200,000 edges is read."));
    m_inside.back() = Inside::edge;
    m_parts.edges.push_back({std::move(*source), std::move(*target), offset()});
  }

  void characters(const char* text, int length) {
    if (m_inside.empty()) return;
    if (m_inside.back() == Inside::data || m_inside.back() == Inside::keyDefault)
      m_value.append(text, static_cast<std::size_t>(length));
    if (m_inside.back() == Inside::label) m_label.append(text, static_cast<std::size_t>(length));
  }

  void end(const char*) {
    const Inside left = m_inside.back();
    m_inside.pop_back();
    if (left == Inside::keyDefault) {
      addDefault(m_keys[m_key]);
    } else if (left == Inside::data) {
      addData();
    } else if (left == Inside::label) {
      addLabel();
    }
  }

  /// The first label of the node or edge that is being read.
  void addLabel() {
    const auto value = std::make_shared<const AttributeText>(AttributeText{std::move(m_label)});
    m_label.clear();
    const auto isIn = [&](Inside part) {
      return std::find(m_inside.begin(), m_inside.end(), part) != m_inside.end();
    };
    GraphAttributes* const owner = isIn(Inside::node)   ? &m_parts.nodes.back().attributes
                                   : isIn(Inside::edge) ? &m_parts.edges.back().attributes
                                                        : nullptr;
    if (owner != nullptr && owner->find(kLabel) == nullptr) owner->set(kLabel, value);
  }

  /// A value counts for what it is in, whatever its key is declared for.
  void addData() {
    const auto key = m_keys.find(m_key);
    const std::string& name = key != m_keys.end() ? key->second.name : m_key;
    auto value = std::make_shared<const AttributeText>(AttributeText{std::move(m_value)});
    m_value.clear();
    switch (m_inside.back()) {
      case Inside::node:
        return m_parts.set(AttributeOwner::node, m_parts.nodes.back().attributes, name, std::move(value));
      case Inside::edge:
        return m_parts.set(AttributeOwner::edge, m_parts.edges.back().attributes, name, std::move(value));
      default:
        return m_parts.set(AttributeOwner::graph, m_parts.attributes, name, std::move(value));
    }
  }

  void addDefault(const Key& key) {
    const auto value = std::make_shared<const AttributeText>(AttributeText{std::move(m_value)});
    m_value.clear();
    const auto add = [&](AttributeOwner owner, std::string_view name, GraphAttributes& defaults) {
      if (key.owner == name || key.owner == "all") m_parts.set(owner, defaults, key.name, value);
    };
    add(AttributeOwner::graph, "graph", m_ofGraph);
    add(AttributeOwner::node, "node", m_ofNodes);
    add(AttributeOwner::edge, "edge", m_ofEdges);
  }

  /// What graph, nodes and edges have that do not state it.
  void addDefaults() {
    const auto complete = [](GraphAttributes& attributes, const GraphAttributes& defaults) {
      for (const auto& [name, value] : defaults.all()) {
        if (attributes.find(name) == nullptr) attributes.set(name, value);
      }
    };
    complete(m_parts.attributes, m_ofGraph);
    for (ReadNode& node : m_parts.nodes) complete(node.attributes, m_ofNodes);
    for (ReadEdge& edge : m_parts.edges) complete(edge.attributes, m_ofEdges);
  }

  std::string_view m_text;
  std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> m_parser;
  GraphParts m_parts;
  std::map<std::string, Key> m_keys;                ///< by id
  GraphAttributes m_ofGraph, m_ofNodes, m_ofEdges;  ///< by default
  std::vector<Inside> m_inside;
  std::string m_key;    ///< of the data or declaration at hand
  std::string m_value;  ///< gathered so far
  std::string m_label;
  bool m_hasGraph = false;
  bool m_isDirected = true;
  Diagnostics m_failure;
  std::exception_ptr m_exception;
};

}  // namespace

Expected<GraphParts> readGraphMl(std::string_view text) {
  return GraphMlReader(text).run();
}

}  // namespace geargraph
