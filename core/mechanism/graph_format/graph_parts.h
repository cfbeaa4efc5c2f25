#pragma once

#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/foundations/base/diagnostic.h"
#include "core/foundations/base/expected.h"
#include "core/mechanism/graph_format/graph_members.h"

namespace geargraph::inline graph_format {

constexpr std::size_t kMostNodes = 100'000;
constexpr std::size_t kMostEdges = 200'000;
constexpr int kDeepestNesting = 64;  ///< of groups and elements

struct AttributeText {
  std::string text;
  bool isJson = false;  ///< the text is a JSON value other than a string
};
using AttributePtr = std::shared_ptr<const AttributeText>;  ///< defaults are shared by all that have them

/// The attributes of a node, an edge or the graph that a mechanism is made of, each once.
class GraphAttributes {
 public:
  /// The last value counts. `name` is of knownAttribute().
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

/// What the text of a graph holds, in any form, before it is asked what it means.
struct GraphParts {
  std::string name{};
  std::size_t offset = 0;  ///< of the graph
  GraphAttributes attributes{};
  std::vector<ReadNode> nodes{};
  std::vector<ReadEdge> edges{};
  std::set<std::string, std::less<>> unread{};  ///< names of attributes that say nothing here, some of them

  /// Sets the attribute where it is a known one, else remembers its name.
  void set(AttributeOwner owner, GraphAttributes& attributes, std::string_view name, AttributePtr value);
  void addUnread(std::string_view name);
};

/// Findings about the text of a graph: the first 100.
class GraphFindings {
 public:
  explicit GraphFindings(std::string_view text) : m_text(text) {}

  void add(Code code, std::string message, std::size_t offset, std::vector<ElementId> elements = {});
  [[nodiscard]] bool empty() const { return m_findings.empty(); }
  [[nodiscard]] bool isFull() const { return m_findings.size() >= kMost; }
  /// In the order of the text, with line and column. Cost: O(text).
  [[nodiscard]] Diagnostics inOrder() const;

 private:
  static constexpr std::size_t kMost = 100;
  std::string_view m_text;
  std::vector<std::pair<std::size_t, Diagnostic>> m_findings;
};

/// A text of the file in a sentence, quoted; the beginning of a long one.
[[nodiscard]] std::string quoted(std::string_view text);

// The readers of the forms. A failure has one finding. Undirected graphs are not read: tail and head of their
// edges are unknown, and with them the signs and which teeth are whose.

[[nodiscard]] Expected<GraphParts> readDot(std::string_view text);
[[nodiscard]] Expected<GraphParts> readGraphMl(std::string_view text);
[[nodiscard]] Expected<GraphParts> readNodeLink(std::string_view text);

/// The finding of an undirected graph.
[[nodiscard]] Diagnostics undirectedGraph(std::string_view text, std::size_t offset);

}  // namespace geargraph::inline graph_format
