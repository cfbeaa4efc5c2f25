// A mechanism from the parts of a graph: they are put together as a document, which the document's reader
// judges; its diagnostics get the places that they have in the graph.

#include <algorithm>
#include <charconv>
#include <map>
#include <unordered_set>

#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"
#include "core/foundations/files/json.h"
#include "core/foundations/files/utf8.h"
#include "core/mechanism/document_format/graph_members.h"
#include "core/mechanism/document_format/graph_parts.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "core/mechanism/document_format/mechanism_graph.h"
#include "core/mechanism/document_format/mechanism_table.h"
#include "core/mechanism/model/limits.h"

namespace geargraph {
namespace {

std::optional<int> wholeNumber(std::string_view text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

std::string jsonString(std::string_view text) {
  std::string json;
  appendJsonString(json, text);
  return json;
}

bool isTrueOrFalse(std::string_view text, std::string_view word) {
  return std::equal(text.begin(), text.end(), word.begin(), word.end(), [](char a, char b) {
    return (a >= 'A' && a <= 'Z' ? static_cast<char>(a - 'A' + 'a') : a) == b;
  });
}

/// The value as the document writes it; none where a list or an object is expected and the text is not JSON.
std::optional<std::string> documentValue(const AttributeText& value, MemberType type) {
  switch (type) {
    case MemberType::text:
      return jsonString(value.text);
    case MemberType::id:
      return value.isJson ? value.text : jsonString(value.text);
    case MemberType::number:
      return value.isJson || isJsonNumber(value.text) ? value.text : jsonString(value.text);
    case MemberType::flag:
      if (value.isJson) return value.text;
      for (const char* const word : {"true", "false"}) {
        if (isTrueOrFalse(value.text, word)) return word;
      }
      return jsonString(value.text);
    case MemberType::json:
      if (!value.isJson && !JsonDocument::parse(value.text)) return std::nullopt;
      return value.text;
  }
  return std::nullopt;
}

/// One link, joint or mesh of the document, and where it comes from.
struct Origin {
  std::string name;  ///< in sentences: The edge "15" ("4" -> "1")
  std::size_t offset = 0;
  GraphPart part = GraphPart::graph;
  std::vector<ElementId> elements{};
};

class MechanismGraphReader {
 public:
  MechanismGraphReader(std::string_view text, GraphParts parts)
      : m_text(text), m_parts(std::move(parts)), m_diagnostics(text) {}

  Expected<GraphReading> run() {
    if (!isOfThisVersion()) return m_diagnostics.inOrder();
    if (m_parts.edges.empty() && m_parts.nodes.empty())
      m_diagnostics.add(Code::schema, translated("The graph has no node; the first one is the ground."),
                        m_parts.offset);
    sortNodes();
    sortEdges();
    writeHead();
    writeLinks();
    writeAxes();
    writeEdges(GraphPart::turningEdge, "turningJoints", m_joints);
    writeEdges(GraphPart::meshEdge, "gearMeshes", m_meshes);
    m_json += '}';
    if (!m_diagnostics.empty()) return m_diagnostics.inOrder();
    auto mechanism = readMechanism(m_json);
    if (!mechanism) {
      for (const Diagnostic& found : mechanism.error()) addDiagnostic(found);
      return m_diagnostics.inOrder();
    }
    addUnread();
    return GraphReading{std::move(mechanism).value(), std::move(m_notes)};
  }

 private:
  bool isOfThisVersion() {
    const AttributeText* const version = m_parts.attributes.find(kVersionAttribute);
    if (version == nullptr) return true;
    m_isOurs = true;
    const auto number = wholeNumber(version->text);
    if (number && *number >= 1 && *number <= kGraphVersion) return true;
    m_diagnostics.add(
        Code::version,
        translated(
            "The graph has version %1, but this program reads version %2: read it with a newer GearGraph.",
            {inQuotes(version->text), std::to_string(kGraphVersion)}),
        m_parts.offset);
    return false;
  }

  /// Nodes 0..n by number; others as they come.
  void sortNodes() {
    std::vector<std::pair<int, std::size_t>> order;
    const auto count = static_cast<int>(m_parts.nodes.size());
    for (std::size_t i = 0; i < m_parts.nodes.size(); ++i) {
      const auto number = wholeNumber(m_parts.nodes[i].key);
      if (number && *number >= 0 && *number < count) order.emplace_back(*number, i);
    }
    std::sort(order.begin(), order.end());
    const auto isTwice = [](const auto& a, const auto& b) { return a.first == b.first; };
    const bool isComplete = order.size() == m_parts.nodes.size() &&
                            std::adjacent_find(order.begin(), order.end(), isTwice) == order.end();
    if (isComplete) {
      std::vector<ReadNode> sorted;
      sorted.reserve(order.size());
      for (const auto& [number, at] : order) sorted.push_back(std::move(m_parts.nodes[at]));
      m_parts.nodes = std::move(sorted);
    } else if (!m_parts.nodes.empty()) {
      m_notes.push_back(
          translated("The ground is the first node, %1.", {inQuotes(m_parts.nodes.front().key)}));
    }
  }

  /// Joints and meshes, each by their labels where all edges have different ones.
  void sortEdges() {
    std::map<int, std::size_t> byLabel;
    for (std::size_t i = 0; i < m_parts.edges.size(); ++i) {
      const AttributeText* const label = m_parts.edges[i].attributes.find(kLabel);
      if (const auto number = label != nullptr ? wholeNumber(label->text) : std::nullopt)
        byLabel.emplace(*number, i);
    }
    std::vector<std::size_t> order;
    if (byLabel.size() == m_parts.edges.size()) {
      for (const auto& [label, at] : byLabel) order.push_back(at);
    } else {
      for (std::size_t i = 0; i < m_parts.edges.size(); ++i) order.push_back(i);
    }
    for (const std::size_t at : order) {
      const auto part = partOf(m_parts.edges[at]);
      if (part == GraphPart::turningEdge) m_joints.push_back(&m_parts.edges[at]);
      if (part == GraphPart::meshEdge) m_meshes.push_back(&m_parts.edges[at]);
    }
  }

  static std::string nameOf(const ReadEdge& edge) {
    const std::string ends = inQuotes(edge.source) + " -> " + inQuotes(edge.target);
    for (const std::string_view attribute : {kLabel, kEdgeId}) {
      if (const AttributeText* const value = edge.attributes.find(attribute))
        return translated("The edge %1 (%2)", {inQuotes(value->text), ends});
    }
    return translated("The edge %1", {ends});
  }

  std::optional<GraphPart> partOf(const ReadEdge& edge) {
    const AttributeText* const kind = edge.attributes.find(kEdgeKind);
    if (kind == nullptr) {
      m_diagnostics.add(
          Code::schema,
          translated("%1 lacks the attribute \"kind\"; expected \"turning\" or \"mesh\".", {nameOf(edge)}),
          edge.offset);
      return std::nullopt;
    }
    if (kind->text == kTurning) return GraphPart::turningEdge;
    if (kind->text == kMesh) return GraphPart::meshEdge;
    const bool isTtGraph = kind->text == "branch" || kind->text == "chord";
    m_diagnostics.add(Code::schema,
                      isTtGraph ? translated("%1: its \"kind\" is %2, so this is a T-T graph; the digraph "
                                             "(--view digraph) is read back.",
                                             {nameOf(edge), inQuotes(kind->text)})
                                : translated("%1: its \"kind\" is %2; expected \"turning\" or \"mesh\".",
                                             {nameOf(edge), inQuotes(kind->text)}),
                      edge.offset);
    return std::nullopt;
  }

  /// False beyond what a document may have, with a diagnostic.
  bool append(std::string_view json) {
    if (m_json.size() + json.size() <= kLargestFile) {
      m_json += json;
      return true;
    }
    if (!m_isTooLarge)
      m_diagnostics.add(Code::schema, translated("As a document the graph has more than 64 MiB."),
                        m_parts.offset);
    m_isTooLarge = true;
    return false;
  }

  /// The attributes of this part as members; `hasMembers`: others are before them.
  void writeMembers(const GraphAttributes& attributes, const Origin& origin, bool hasMembers,
                    std::string_view leftOut) {
    for (const auto& [name, value] : attributes.all()) {
      const GraphMember* const member = graphAttributeOf(origin.part, name);
      if (member == nullptr || name == leftOut) {
        if (member == nullptr && name != kVersionAttribute && name != kLabel && name != kEdgeKind)
          m_parts.addUnread(name);
        continue;
      }
      const auto written = documentValue(*value, member->type);
      if (!written) {
        m_diagnostics.add(Code::schema,
                          translated("%1, %2: expected a list or an object as JSON, found %3.",
                                     {origin.name, name, inQuotes(value->text)}),
                          origin.offset, origin.elements);
        continue;
      }
      if (!append((hasMembers ? "," : "") + jsonString(member->member) + ':' + *written)) return;
      hasMembers = true;
    }
  }

  /// The name that a label shows, for what has no attribute "name"; std::nullopt where it shows no more than
  /// `key`. One that cannot be a name is not read.
  std::optional<std::string> nameInLabel(const GraphAttributes& attributes, std::string_view key) {
    const AttributeText* const label = attributes.find(kLabel);
    if (label == nullptr) return std::nullopt;
    const std::string text = lineOf(label->text);
    if (text.empty() || text == key || text == "\\N" || text == "\\G") return std::nullopt;
    const AttributeText* const name = attributes.find(kNameAttribute);
    if (name == nullptr && utf8Count(text) <= kMaxNameLength) return text;
    if (name == nullptr || name->text != text) m_parts.addUnread(kLabel);
    return std::nullopt;
  }

  /// A label in one line: its ends of lines and DOT's escapes for them are blanks.
  static std::string lineOf(std::string_view label) {
    std::string line;
    for (std::size_t i = 0; i < label.size(); ++i) {
      const bool isEscaped = label[i] == '\\' && i + 1 < label.size() &&
                             (label[i + 1] == 'n' || label[i + 1] == 'l' || label[i + 1] == 'r');
      const bool isBreak = isEscaped || static_cast<unsigned char>(label[i]) <= ' ';
      if (isEscaped) ++i;
      if (!isBreak) {
        line += label[i];
      } else if (!line.empty() && line.back() != ' ') {
        line += ' ';
      }
    }
    if (!line.empty() && line.back() == ' ') line.pop_back();
    return line;
  }

  void writeHead() {
    (void)append("{\"format\":\"geargraph\",\"version\":" + std::to_string(kFileVersion));
    m_graph = {translated("The graph"), m_parts.offset, GraphPart::graph};
    const auto label = nameInLabel(m_parts.attributes, m_parts.name);
    if (m_parts.attributes.find(kNameAttribute) == nullptr)
      (void)append(",\"name\":" + jsonString(label.value_or(m_parts.name)));
    writeMembers(m_parts.attributes, m_graph, true, {});
  }

  void writeLinks() {
    (void)append(",\"links\":[");
    for (const ReadNode& node : m_parts.nodes) {
      if (m_isTooLarge) return;
      const AttributeText* const given = node.attributes.find(kLinkId);
      const std::string id = given != nullptr ? given->text : node.key;
      const Origin& origin = m_origins["links"].emplace_back(Origin{
          translated("The node %1", {inQuotes(node.key)}), node.offset, GraphPart::node, {LinkId(id)}});
      if (!m_links.emplace(node.key, id).second) {
        m_diagnostics.add(Code::duplicateId, translated("%1 is in the graph twice.", {origin.name}),
                          node.offset);
        continue;
      }
      if (!append((m_json.back() == '[' ? "{\"id\":" : ",{\"id\":") + jsonString(id))) return;
      if (const auto name = nameInLabel(node.attributes, node.key))
        (void)append(",\"name\":" + jsonString(*name));
      writeMembers(node.attributes, origin, true, kLinkId);
      (void)append("}");
    }
    (void)append("]");
  }

  /// Without `axes` of the graph: those that joints name, without a place.
  void writeAxes() {
    if (m_parts.attributes.find("axes") != nullptr) return;
    constexpr std::size_t kMaxIdLength = 4 * kMaxNameLength;  // bytes
    std::unordered_set<std::string> known;
    std::vector<std::string> names;
    (void)append(",\"axes\":[");
    for (const ReadEdge* const joint : m_joints) {
      const AttributeText* const axis = joint->attributes.find("axis");
      // What is too long for an id is reported at the joint.
      if (axis == nullptr || axis->text.size() > kMaxIdLength || !known.insert(axis->text).second) continue;
      if (!append((names.empty() ? "{\"id\":" : ",{\"id\":") + jsonString(axis->text) + "}")) return;
      names.push_back(axis->text);
    }
    (void)append("]");
    constexpr std::size_t kMaxNames = 10;
    if (!names.empty())
      m_notes.push_back(translated("The graph has no places of axes: %1 are placed from the tooth counts.",
                                   {listed(names, kMaxNames)}));
  }

  void writeEdges(GraphPart part, const char* list, const std::vector<const ReadEdge*>& edges) {
    const bool isMesh = part == GraphPart::meshEdge;
    int label = static_cast<int>(m_parts.nodes.size() + (isMesh ? m_joints.size() : 0));
    std::size_t withoutKind = 0;
    (void)append(",\"" + std::string(list) + "\":[");
    for (const ReadEdge* const edge : edges) {
      if (m_isTooLarge) return;
      const AttributeText* const given = edge->attributes.find(kEdgeId);
      const std::string id = given != nullptr ? given->text : std::to_string(label);
      ++label;
      const ElementId element = isMesh ? ElementId(MeshId(id)) : ElementId(JointId(id));
      const Origin& origin =
          m_origins[list].emplace_back(Origin{nameOf(*edge), edge->offset, part, {element}});
      if (!hasWhatItNeeds(*edge, origin)) continue;
      if (isMesh && edge->attributes.find("meshKind") == nullptr &&
          edge->attributes.find("pitchPoint") == nullptr)
        ++withoutKind;
      if (!append((m_json.back() == '[' ? "{\"id\":" : ",{\"id\":") + jsonString(id) + ",\"tail\":" +
                  jsonString(m_links.at(edge->source)) + ",\"head\":" + jsonString(m_links.at(edge->target))))
        return;
      writeMembers(edge->attributes, origin, true, kEdgeId);
      if (const AttributeText* const shown = edge->attributes.find(kLabel);
          shown != nullptr && !lineOf(shown->text).empty() && !wholeNumber(shown->text))
        m_parts.addUnread(kLabel);  // joints and meshes have no names
      (void)append("}");
    }
    (void)append("]");
    if (withoutKind > 0 && !m_isOurs)
      m_notes.push_back(withoutKind == 1 ? translated("1 mesh has no \"meshKind\": external between parallel "
                                                      "axes, bevel between intersecting ones.")
                                         : translated("%1 meshes have no \"meshKind\": external between "
                                                      "parallel axes, bevel between intersecting ones.",
                                                      {std::to_string(withoutKind)}));
  }

  /// Not of a belt by diameters, nor of a kind that has none.
  static bool statesTeeth(const GraphAttributes& attributes) {
    if (attributes.find("tailDiameter") != nullptr && attributes.find("headDiameter") != nullptr)
      return false;
    const AttributeText* const named = attributes.find("meshKind");
    const auto kind = named != nullptr ? meshKindFrom(named->text) : std::nullopt;
    return !kind || pairKind(*kind).hasTeeth;
  }

  bool hasWhatItNeeds(const ReadEdge& edge, const Origin& origin) {
    bool isComplete = true;
    const auto need = [&](std::string_view attribute, const char* sentence) {
      if (edge.attributes.find(attribute) != nullptr) return;
      isComplete = false;
      m_diagnostics.add(Code::schema, filled(translated(sentence), {origin.name, attribute}), edge.offset,
                        origin.elements);
    };
    if (origin.part == GraphPart::turningEdge) {
      need("axis", toTranslate("%1 lacks the attribute \"%2\": the name of the axis that the joint turns "
                               "about, the same for joints on one axis."));
    } else if (statesTeeth(edge.attributes)) {
      need("tailTeeth",
           toTranslate("%1 lacks the attribute \"%2\": the number of teeth of the gear on its first node."));
      need("headTeeth",
           toTranslate("%1 lacks the attribute \"%2\": the number of teeth of the gear on its second node."));
    }
    for (const std::string* const end : {&edge.source, &edge.target}) {
      if (m_links.contains(*end)) continue;
      isComplete = false;
      m_diagnostics.add(Code::unknownId,
                        translated("%1: there is no node %2.", {origin.name, inQuotes(*end)}), edge.offset,
                        origin.elements);
    }
    return isComplete;
  }

  /// A diagnostic about the document, as one about the graph.
  void addDiagnostic(const Diagnostic& found) {
    std::string_view rest = found.pointer;
    const auto step = [&rest] {
      const std::size_t end = std::min(rest.find('/', 1), rest.size());
      const std::string name(rest.substr(std::min<std::size_t>(1, end), end - std::min<std::size_t>(1, end)));
      rest.remove_prefix(end);
      return name;
    };
    const Origin* origin = &m_graph;
    std::string list = step();
    std::string path = list;
    if (const auto origins = m_origins.find(list); origins != m_origins.end()) {
      const auto position = wholeNumber(step());
      if (position && static_cast<std::size_t>(*position) < origins->second.size()) {
        origin = &origins->second[static_cast<std::size_t>(*position)];
        const std::string member = step();
        const GraphMember* const attribute = graphMemberOf(origin->part, member);
        path = attribute != nullptr ? std::string(attribute->attribute) : member;
      }
    }
    path += rest;
    std::string message = found.message;
    const std::string prefix = found.pointer + ": ";
    if (!found.pointer.empty() && message.starts_with(prefix)) {
      message = origin->name + (path.empty() ? ": " : ", " + path + ": ") + message.substr(prefix.size());
    }
    m_diagnostics.add(found.code, std::move(message), origin->offset,
                      found.elements.empty() ? origin->elements : found.elements);
  }

  void addUnread() {
    constexpr std::size_t kMaxNames = 10;
    const std::vector<std::string> names(m_parts.unread.begin(), m_parts.unread.end());
    if (!names.empty())
      m_notes.push_back(translated("Attributes without a meaning for the mechanism were not read: %1.",
                                   {listed(names, kMaxNames)}));
  }

  std::string_view m_text;
  GraphParts m_parts;
  GraphDiagnostics m_diagnostics;
  std::string m_json;  ///< the document so far
  Origin m_graph;
  std::map<std::string, std::vector<Origin>> m_origins;  ///< by list of the document, in its order
  std::map<std::string, std::string> m_links;            ///< ids by the keys of the nodes
  std::vector<const ReadEdge*> m_joints;
  std::vector<const ReadEdge*> m_meshes;
  std::vector<std::string> m_notes;
  bool m_isOurs = false;
  bool m_isTooLarge = false;
};

Expected<GraphParts> readParts(std::string_view bytes, GraphForm form) {
  switch (form) {
    case GraphForm::dot:
      return readDot(bytes);
    case GraphForm::graphMl:
      return readGraphMl(bytes);
    case GraphForm::nodeLink:
      return readNodeLink(bytes);
  }
  return GraphParts{};
}

/// Does the text begin with the head of a graph in DOT?
bool beginsAsDot(std::string_view bytes) {
  constexpr std::string_view kBlanks = " \t\r\n";
  while (!bytes.empty()) {
    bytes.remove_prefix(std::min(bytes.find_first_not_of(kBlanks), bytes.size()));
    const bool isLine = bytes.starts_with("//") || bytes.starts_with("#");
    if (!isLine && !bytes.starts_with("/*")) break;
    const std::size_t end = isLine ? bytes.find('\n') : bytes.find("*/", 2);
    bytes.remove_prefix(end == std::string_view::npos ? bytes.size() : end + (isLine ? 1 : 2));
  }
  const std::string_view word = bytes.substr(0, bytes.find_first_of(" \t\r\n{\"/"));
  if (word.size() == bytes.size()) return false;
  return isTrueOrFalse(word, "strict") || isTrueOrFalse(word, "graph") || isTrueOrFalse(word, "digraph");
}

}  // namespace

std::optional<GraphForm> graphFormOf(std::string_view bytes) {
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return std::nullopt;
  if (bytes[first] == '<' || bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF"))
    return GraphForm::graphMl;
  if (bytes[first] != '{') return beginsAsDot(bytes) ? std::optional(GraphForm::dot) : std::nullopt;
  const auto document = JsonDocument::parse(bytes);
  if (!document || document->root().member("format")) return std::nullopt;
  const auto nodes = document->root().member("nodes");
  if (!nodes || !nodes->is(JsonKind::array)) return std::nullopt;
  return GraphForm::nodeLink;
}

Expected<GraphReading> readMechanismGraph(std::string_view bytes, GraphForm form) {
  if (bytes.size() > kLargestFile) {
    return Diagnostic{
        Code::schema,
        translated("The file has %1 bytes; at most 64 MiB are read.", {std::to_string(bytes.size())}),
        {},
        {},
        0,
        0};
  }
  auto parts = readParts(bytes, form);
  if (!parts) return parts.error();
  return MechanismGraphReader(bytes, std::move(parts).value()).run();
}

Expected<GraphReading> readAnyMechanism(std::string_view bytes) {
  // JSON is parsed for its form only where it is no document.
  if (!looksLikeTable(bytes)) {
    auto document = readMechanism(bytes);
    const bool isOther = !document && document.error().front().code == Code::format;
    const auto form = isOther ? graphFormOf(bytes) : std::nullopt;
    if (form) return readMechanismGraph(bytes, *form);
    if (!document) return document.error();
    return GraphReading{std::move(document).value()};
  }
  if (bytes.size() <= kLargestFile) {
    if (const auto form = graphFormOf(bytes)) return readMechanismGraph(bytes, *form);
  }
  auto table = readMechanismTable(bytes);
  if (!table) return table.error();
  return GraphReading{std::move(table).value()};
}

}  // namespace geargraph
