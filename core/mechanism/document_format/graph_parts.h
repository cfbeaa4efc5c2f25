#pragma once

#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/foundations/base/diagnostic.h"
#include "core/foundations/base/expected.h"
#include "core/mechanism/document_format/graph_members.h"

namespace geargraph {

constexpr std::size_t kMaxNodes = 100'000;
constexpr std::size_t kMaxEdges = 200'000;
constexpr int kDeepestNesting = 64;  ///< of groups and elements

struct AttributeText {
  std::string text;
  bool isJson = false;  ///< the text is a JSON value other than a string
};
using AttributePtr = std::shared_ptr<const AttributeText>;  ///< a default value is shared by its users

/// The attributes of a node, an edge or the graph that a mechanism is read from. Names are unique.
class GraphAttributes {
 public:
  /// Replaces an earlier value. @pre `name` is from knownAttribute()
  void set(std::string_view name, AttributePtr value);
  [[nodiscard]] const AttributeText* find(std::string_view name) const;
  [[nodiscard]] const std::vector<std::pair<std::string_view, AttributePtr>>& all() const { return m_all; }

 private:
  std::vector<std::pair<std::string_view, AttributePtr>> m_all;
};

struct ReadNode {
  std::string key;
  std::size_t offset = 0;  ///< in the text
  GraphAttributes attributes{};
};

struct ReadEdge {
  std::string source;  ///< keys of nodes
  std::string target;
  std::size_t offset = 0;
  GraphAttributes attributes{};
};

/// The content of a graph in any format, before it is interpreted as a mechanism.
struct GraphParts {
  std::string name{};
  std::size_t offset = 0;  ///< of the graph
  GraphAttributes attributes{};
  std::vector<ReadNode> nodes{};
  std::vector<ReadEdge> edges{};
  std::set<std::string, std::less<>> unread{};  ///< some of the names of ignored attributes

  /// Sets a known attribute; records the name of any other in `unread`.
  void set(AttributeOwner owner, GraphAttributes& attributes, std::string_view name, AttributePtr value);
  void addUnread(std::string_view name);
};

/// Collects at most 100 diagnostics about the text of a graph.
class GraphDiagnostics {
 public:
  explicit GraphDiagnostics(std::string_view text) : m_text(text) {}

  void add(Code code, std::string message, std::size_t offset, std::vector<ElementId> elements = {});
  [[nodiscard]] bool empty() const { return m_diagnostics.empty(); }
  [[nodiscard]] bool isFull() const { return m_diagnostics.size() >= kMax; }
  /// All diagnostics in the order of the text, with line and column. Cost: O(text).
  [[nodiscard]] Diagnostics inOrder() const;

 private:
  static constexpr std::size_t kMax = 100;
  std::string_view m_text;
  std::vector<std::pair<std::size_t, Diagnostic>> m_diagnostics;
};

/// A text of the file, quoted for a sentence; a long one is truncated.
[[nodiscard]] std::string inQuotes(std::string_view text);

// The readers of the formats. A failure has one diagnostic. Undirected graphs are rejected: without tail and
// head of an edge, the signs and the assignment of the tooth counts are unknown.

[[nodiscard]] Expected<GraphParts> readDot(std::string_view text);
[[nodiscard]] Expected<GraphParts> readGraphMl(std::string_view text);
[[nodiscard]] Expected<GraphParts> readNodeLink(std::string_view text);

/// The diagnostic for an undirected graph.
[[nodiscard]] Diagnostics undirectedGraph(std::string_view text, std::size_t offset);

}  // namespace geargraph
