// Graphs as texts: DOT, GraphML, node-link JSON.

#include "core/mechanism/document_format/graph_text.h"

#include <array>
#include <map>

#include "core/foundations/files/json.h"
#include "core/foundations/files/json_writer.h"

namespace geargraph {
namespace {

std::string valueText(const AttributeValue& value) {
  if (const int* number = std::get_if<int>(&value)) return std::to_string(*number);
  if (const auto* json = std::get_if<JsonText>(&value)) return json->json;
  return std::get<std::string>(value);
}

/// DOT knows no escapes but of the quote; a backslash begins an escape of labels, so it is doubled.
std::string dotText(std::string_view text) {
  std::string dot = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') dot += '\\';
    dot += c;
  }
  return dot + '"';
}

std::string dotAttributes(const Attributes& attributes) {
  std::string text;
  for (const auto& [name, value] : attributes) {
    text += (text.empty() ? "" : ", ") + std::string(name) + '=' + dotText(valueText(value));
  }
  return " [" + text + "];\n";
}

std::string asDot(const GraphDescription& graph) {
  std::string text = "digraph " + dotText(graph.name) + " {\n";
  if (!graph.attributes.empty()) text += "  graph" + dotAttributes(graph.attributes);
  for (const DescribedNode& node : graph.nodes)
    text += "  " + std::to_string(node.label) + dotAttributes(node.attributes);
  for (const DescribedEdge& edge : graph.edges) {
    text += "  " + std::to_string(edge.source) + " -> " + std::to_string(edge.target) +
            dotAttributes(edge.attributes);
  }
  return text + "}\n";
}

/// XML 1.0 has no control characters but tab and line ends, and reads a return as a line end.
std::string xmlText(std::string_view text) {
  std::string xml;
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (code < 0x20 && c != '\t' && c != '\n' && c != '\r') continue;
    switch (c) {
      case '\r':
        xml += "&#13;";
        break;
      case '&':
        xml += "&amp;";
        break;
      case '<':
        xml += "&lt;";
        break;
      case '>':
        xml += "&gt;";
        break;
      case '"':
        xml += "&quot;";
        break;
      default:
        xml += c;
    }
  }
  return xml;
}

std::string_view xmlType(const AttributeValue& value) {
  if (std::holds_alternative<int>(value)) return "int";
  const auto* json = std::get_if<JsonText>(&value);
  if (json == nullptr) return "string";
  if (json->json == "true" || json->json == "false") return "boolean";
  return isJsonNumber(json->json) ? "double" : "string";
}

/// The type that holds all values of each attribute, in the order of the names' first use.
class XmlKeys {
 public:
  void add(const Attributes& attributes) {
    for (const auto& [name, value] : attributes) {
      const std::string_view type = xmlType(value);
      const auto [known, isNew] = m_types.try_emplace(name, type);
      if (isNew) m_names.push_back(name);
      if (known->second == type) continue;
      const auto isNumber = [](std::string_view each) { return each == "int" || each == "double"; };
      known->second = isNumber(known->second) && isNumber(type) ? "double" : "string";
    }
  }

  void declare(std::string& text, const std::string& part) const {
    for (const std::string_view name : m_names) {
      text += "  <key id=\"" + part + '.' + std::string(name) + "\" for=\"" + part + "\" attr.name=\"" +
              std::string(name) + "\" attr.type=\"" + std::string(m_types.at(name)) + "\"/>\n";
    }
  }

 private:
  std::vector<std::string_view> m_names;
  std::map<std::string_view, std::string_view> m_types;
};

void writeData(std::string& text, const std::string& part, const Attributes& attributes) {
  const std::string indent = part == "graph" ? "    " : "      ";
  for (const auto& [name, value] : attributes) {
    text += indent + "<data key=\"" + part + '.' + std::string(name) + "\">" + xmlText(valueText(value)) +
            "</data>\n";
  }
}

std::string asGraphMl(const GraphDescription& graph) {
  XmlKeys ofGraph, ofNodes, ofEdges;
  ofGraph.add(graph.attributes);
  for (const DescribedNode& node : graph.nodes) ofNodes.add(node.attributes);
  for (const DescribedEdge& edge : graph.edges) ofEdges.add(edge.attributes);
  std::string text =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<graphml "
      "xmlns=\"http://graphml.graphdrawing.org/xmlns\">\n";
  ofGraph.declare(text, "graph");
  ofNodes.declare(text, "node");
  ofEdges.declare(text, "edge");
  text += "  <graph id=\"" + xmlText(graph.name) + "\" edgedefault=\"directed\">\n";
  writeData(text, "graph", graph.attributes);
  for (const DescribedNode& node : graph.nodes) {
    text += "    <node id=\"" + std::to_string(node.label) + "\">\n";
    writeData(text, "node", node.attributes);
    text += "    </node>\n";
  }
  for (const DescribedEdge& edge : graph.edges) {
    text += "    <edge id=\"" + xmlText(edge.key) + "\" source=\"" + std::to_string(edge.source) +
            "\" target=\"" + std::to_string(edge.target) + "\">\n";
    writeData(text, "edge", edge.attributes);
    text += "    </edge>\n";
  }
  return text + "  </graph>\n</graphml>\n";
}

void writeMembers(JsonWriter& json, const Attributes& attributes) {
  for (const auto& [name, value] : attributes) {
    if (const auto* text = std::get_if<JsonText>(&value)) {
      json.key(name);
      json.json(text->json);
    } else if (const int* number = std::get_if<int>(&value)) {
      json.member(name, *number);
    } else {
      json.member(name, std::get<std::string>(value));
    }
  }
}

std::string asNodeLink(const GraphDescription& graph) {
  TextSink sink;
  {
    JsonWriter json(sink);
    json.beginObject();
    json.member("directed", true);
    json.member("multigraph", true);
    json.key("graph");
    json.beginObject(graph.attributes.empty() ? JsonWriter::Layout::row : JsonWriter::Layout::lines);
    json.member("name", graph.name);
    writeMembers(json, graph.attributes);
    json.endObject();
    json.key("nodes");
    json.beginArray();
    for (const DescribedNode& node : graph.nodes) {
      json.beginObject(JsonWriter::Layout::row);
      json.member("id", node.label);
      writeMembers(json, node.attributes);
      json.endObject();
    }
    json.endArray();
    json.key("links");
    json.beginArray();
    for (const DescribedEdge& edge : graph.edges) {
      json.beginObject(JsonWriter::Layout::row);
      json.member("source", edge.source);
      json.member("target", edge.target);
      json.member("key", edge.key);
      writeMembers(json, edge.attributes);
      json.endObject();
    }
    json.endArray();
    json.endObject();
  }
  return sink.take();
}

}  // namespace

std::optional<GraphForm> graphFormFromName(std::string_view name) {
  constexpr std::array<std::string_view, 3> kNames = {"dot", "graphml", "node-link"};
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (kNames.at(i) == name) return static_cast<GraphForm>(i);
  }
  return std::nullopt;
}

std::string graphText(const GraphDescription& graph, GraphForm form) {
  switch (form) {
    case GraphForm::dot:
      return asDot(graph);
    case GraphForm::graphMl:
      return asGraphMl(graph);
    case GraphForm::nodeLink:
      return asNodeLink(graph);
  }
  return {};
}

}  // namespace geargraph
