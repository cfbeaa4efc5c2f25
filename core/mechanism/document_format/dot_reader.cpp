// Graphviz' DOT, by a reader of its own: libcgraph joins two groups of nodes by all pairs of edges and gives
// every node every attribute, so that a short text can take all memory, and it is not made for threads.

#include <algorithm>
#include <map>
#include <set>

#include "core/foundations/base/translation.h"
#include "core/foundations/files/utf8.h"
#include "core/mechanism/document_format/graph_parts.h"

namespace geargraph {
namespace {

struct DotToken {
  enum class Kind { end, id, quotedId, edge, symbol, fault };
  Kind kind = Kind::end;
  std::string text{};  ///< of an id; the character of a symbol; what is wrong
  std::size_t offset = 0;

  [[nodiscard]] bool is(char symbol) const { return kind == Kind::symbol && text.front() == symbol; }
  [[nodiscard]] bool isId() const { return kind == Kind::id || kind == Kind::quotedId; }
  /// Keywords have no case and no quotes.
  [[nodiscard]] bool isWord(std::string_view word) const {
    return kind == Kind::id &&
           std::equal(text.begin(), text.end(), word.begin(), word.end(), [](char a, char b) {
             return (a >= 'A' && a <= 'Z' ? static_cast<char>(a - 'A' + 'a') : a) == b;
           });
  }
};

class DotScanner {
 public:
  explicit DotScanner(std::string_view text) : m_text(text) {
    if (m_text.starts_with("\xEF\xBB\xBF")) m_at = 3;
  }

  DotToken next() {
    if (!skipBlanks()) return fault(translated("The comment has no end."));
    m_begin = m_at;
    if (m_at == m_text.size()) return {DotToken::Kind::end, "", m_at};
    const char c = m_text[m_at];
    if (c == '"') return quotedText();
    if (c == '<') return html();
    if (m_text.substr(m_at).starts_with("->") || m_text.substr(m_at).starts_with("--")) {
      m_at += 2;
      return {DotToken::Kind::edge, std::string(m_text.substr(m_begin, 2)), m_begin};
    }
    if (std::string_view("{}[]=;,:+").find(c) != std::string_view::npos) {
      ++m_at;
      return {DotToken::Kind::symbol, std::string(1, c), m_begin};
    }
    if (isDigit(c) || c == '.' || c == '-') return numeral();
    if (!isLetter(c)) return fault(translated("This character is no part of DOT."));
    while (m_at < m_text.size() && (isLetter(m_text[m_at]) || isDigit(m_text[m_at]))) ++m_at;
    return {DotToken::Kind::id, std::string(m_text.substr(m_begin, m_at - m_begin)), m_begin};
  }

 private:
  static bool isDigit(char c) { return c >= '0' && c <= '9'; }
  static bool isLetter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' ||
           static_cast<unsigned char>(c) >= 0x80;
  }
  DotToken fault(std::string why) { return {DotToken::Kind::fault, std::move(why), m_at}; }

  /// Blanks and comments; lines that begin with # are comments, too.
  bool skipBlanks() {
    while (m_at < m_text.size()) {
      const char c = m_text[m_at];
      const std::string_view rest = m_text.substr(m_at);
      const bool isFirst = m_at == 0 || m_text[m_at - 1] == '\n';
      if (c == ' ' || c == '\t' || c == '\r' || c == '\n') {
        ++m_at;
      } else if (rest.starts_with("//") || (c == '#' && isFirst)) {
        m_at = std::min(m_text.find('\n', m_at), m_text.size());
      } else if (rest.starts_with("/*")) {
        const std::size_t end = m_text.find("*/", m_at + 2);
        if (end == std::string_view::npos) return false;
        m_at = end + 2;
      } else {
        break;
      }
    }
    return true;
  }

  DotToken quotedText() {
    DotToken token{DotToken::Kind::quotedId, "", m_at};
    for (++m_at; m_at < m_text.size(); ++m_at) {
      const char c = m_text[m_at];
      if (c == '"') {
        ++m_at;
        return token;
      }
      if (c != '\\' || m_at + 1 == m_text.size()) {
        token.text += c;
        continue;
      }
      const char escaped = m_text[++m_at];
      if (escaped == '\n') continue;  // the line goes on
      if (escaped != '"' && escaped != '\\') token.text += '\\';
      token.text += escaped;
    }
    m_at = token.offset;
    return fault(translated("The quote has no end."));
  }

  DotToken html() {
    int depth = 0;
    for (std::size_t at = m_at; at < m_text.size(); ++at) {
      if (m_text[at] == '<') ++depth;
      if (m_text[at] == '>') --depth;
      if (depth > 0) continue;
      DotToken token{DotToken::Kind::quotedId, std::string(m_text.substr(m_at + 1, at - m_at - 1)), m_at};
      m_at = at + 1;
      return token;
    }
    return fault(translated("The text in angle brackets has no end."));
  }

  DotToken numeral() {
    if (m_text[m_at] == '-') ++m_at;
    std::size_t digits = 0;
    bool hasPoint = false;
    for (; m_at < m_text.size(); ++m_at) {
      if (isDigit(m_text[m_at])) {
        ++digits;
      } else if (m_text[m_at] == '.' && !hasPoint) {
        hasPoint = true;
      } else {
        break;
      }
    }
    if (digits > 0) return {DotToken::Kind::id, std::string(m_text.substr(m_begin, m_at - m_begin)), m_begin};
    m_at = m_begin;
    return fault(translated("This is no number."));
  }

  std::string_view m_text;
  std::size_t m_at = 0;
  std::size_t m_begin = 0;
};

class DotReader {
 public:
  explicit DotReader(std::string_view text) : m_text(text), m_scanner(text) {}

  Expected<GraphParts> run() {
    for (std::size_t at = 0; at < m_text.size();) {
      const std::size_t length = utf8Length(m_text, at);
      if (length == 0) return makeDiagnostics(Code::syntax, translated("The text is not UTF-8."), at);
      at += length;
    }
    next();
    if (!readHead() || !readStatements()) return std::move(m_failure);
    if (m_token.kind != DotToken::Kind::end) {
      fail(m_token, translated("Behind the graph is something else; a file with one graph is read."));
      return std::move(m_failure);
    }
    return std::move(m_parts);
  }

 private:
  /// Attributes that nodes and edges have without stating them, here and in the groups inside.
  struct Scope {
    GraphAttributes nodes;
    GraphAttributes edges;
  };
  using Given = std::vector<std::pair<std::string, AttributePtr>>;

  Diagnostics makeDiagnostics(Code code, std::string message, std::size_t offset) const {
    GraphDiagnostics diagnostics(m_text);
    diagnostics.add(code, std::move(message), offset);
    return diagnostics.inOrder();
  }
  /// Always false. What the scanner has found wrong goes first.
  bool fail(const DotToken& at, const std::string& message, Code code = Code::syntax) {
    const bool isFault = at.kind == DotToken::Kind::fault;
    m_failure = makeDiagnostics(isFault ? Code::syntax : code, isFault ? at.text : message, at.offset);
    return false;
  }
  bool expected(const std::string& what) {
    const bool isEnd = m_token.kind == DotToken::Kind::end;
    return fail(m_token, isEnd ? translated("Expected %1, found the end.", {what})
                               : translated("Expected %1, found %2.", {what, inQuotes(m_token.text)}));
  }

  void next() { m_token = m_scanner.next(); }
  bool take(char symbol) {
    if (!m_token.is(symbol)) return false;
    next();
    return true;
  }

  bool readHead() {
    if (m_token.isWord("strict")) {
      m_isStrict = true;
      next();
    }
    m_parts.offset = m_token.offset;
    if (m_token.isWord("graph")) {
      m_failure = undirectedGraph(m_text, m_token.offset);
      return false;
    }
    if (!m_token.isWord("digraph")) return expected("\"digraph\"");
    next();
    if (m_token.isId() && !readId(m_parts.name)) return false;
    return take('{') || expected("{");
  }

  /// An id, or several quoted ones with + between.
  bool readId(std::string& id) {
    if (!m_token.isId()) return expected(translated("a name"));
    id = std::move(m_token.text);
    bool isQuoted = m_token.kind == DotToken::Kind::quotedId;
    next();
    while (isQuoted && take('+')) {
      if (m_token.kind != DotToken::Kind::quotedId) return expected(translated("a quoted text"));
      id += m_token.text;
      next();
    }
    return true;
  }

  /// Up to the bracket that closes the graph.
  bool readStatements() {
    m_scopes.emplace_back();
    while (!m_scopes.empty()) {
      if (take(';')) continue;
      if (m_token.is('}')) {
        m_scopes.pop_back();
        next();
        if (m_token.kind == DotToken::Kind::edge) return edgesOfGroup();
      } else if (m_token.is('{') || m_token.isWord("subgraph")) {
        if (!openGroup()) return false;
      } else if (!readStatement()) {
        return false;
      }
    }
    return true;
  }

  bool openGroup() {
    if (m_token.isWord("subgraph")) {
      next();
      std::string name;
      if (m_token.isId() && !readId(name)) return false;
    }
    if (!m_token.is('{')) return expected("{");
    if (m_scopes.size() >= static_cast<std::size_t>(kDeepestNesting))
      return fail(m_token, translated("Groups are nested deeper than 64."), Code::schema);
    next();
    m_scopes.push_back(m_scopes.back());
    return true;
  }

  bool edgesOfGroup() {
    return fail(m_token,
                translated("An edge between groups is not read; write an edge for each joint and mesh."),
                Code::schema);
  }

  bool readStatement() {
    for (const std::string_view word : {"graph", "node", "edge"}) {
      if (m_token.isWord(word)) return readDefaults(word);
    }
    const std::size_t offset = m_token.offset;
    std::string id;
    if (!readId(id)) return false;
    if (take('=')) {
      std::string value;
      if (!readId(value)) return false;
      if (m_scopes.size() == 1) setOfGraph(id, std::make_shared<const AttributeText>(AttributeText{value}));
      return true;
    }
    if (!skipPort()) return false;
    return m_token.kind == DotToken::Kind::edge ? readEdges(id, offset) : readNode(id, offset);
  }

  bool readDefaults(std::string_view word) {
    next();
    Given given;
    if (!m_token.is('[')) return expected("[");
    if (!readAttributes(given)) return false;
    for (auto& [name, value] : given) {
      if (word == "graph") {
        if (m_scopes.size() == 1) setOfGraph(name, value);
      } else if (word == "node") {
        m_parts.set(AttributeOwner::node, m_scopes.back().nodes, name, value);
      } else {
        m_parts.set(AttributeOwner::edge, m_scopes.back().edges, name, value);
      }
    }
    return true;
  }

  void setOfGraph(const std::string& name, const AttributePtr& value) {
    m_parts.set(AttributeOwner::graph, m_parts.attributes, name, value);
  }

  /// All lists of attributes that follow.
  bool readAttributes(Given& given) {
    while (take('[')) {
      while (!take(']')) {
        std::string name, value = "true";
        if (!readId(name)) return false;
        if (take('=') && !readId(value)) return false;
        given.emplace_back(std::move(name),
                           std::make_shared<const AttributeText>(AttributeText{std::move(value)}));
        if (!take(',')) (void)take(';');
      }
    }
    return true;
  }

  /// Where a drawn edge touches its node: `a:port:n`.
  bool skipPort() {
    std::string port;
    while (take(':')) {
      if (!readId(port)) return false;
    }
    return true;
  }

  bool readNode(const std::string& id, std::size_t offset) {
    Given given;
    if (!readAttributes(given)) return false;
    ReadNode* const node = nodeOf(id, offset);
    if (node == nullptr) return false;
    for (auto& [name, value] : given) m_parts.set(AttributeOwner::node, node->attributes, name, value);
    return true;
  }

  bool readEdges(std::string id, std::size_t offset) {
    std::vector<std::string> ids{std::move(id)};
    while (m_token.kind == DotToken::Kind::edge) {
      if (m_token.text == "--")
        return fail(m_token, translated("An edge of a directed graph is written ->."));
      next();
      if (m_token.is('{') || m_token.isWord("subgraph")) return edgesOfGroup();
      if (!readId(ids.emplace_back()) || !skipPort()) return false;
      if (ids.size() > kMaxEdges) return tooManyEdges(offset);
    }
    Given given;
    if (!readAttributes(given)) return false;
    for (const std::string& end : ids) {
      if (nodeOf(end, offset) == nullptr) return false;
    }
    for (std::size_t i = 0; i + 1 < ids.size(); ++i) {
      if (m_parts.edges.size() == kMaxEdges) return tooManyEdges(offset);
      if (m_isStrict && !m_pairs.emplace(ids[i], ids[i + 1]).second) {
        m_failure =
            makeDiagnostics(Code::schema,
                            translated("The graph is strict, and a second edge leads from %1 to %2: it would "
                                       "be one with the first. Leave out \"strict\".",
                                       {inQuotes(ids[i]), inQuotes(ids[i + 1])}),
                            offset);
        return false;
      }
      ReadEdge& edge =
          m_parts.edges.emplace_back(ReadEdge{ids[i], ids[i + 1], offset, m_scopes.back().edges});
      for (auto& [name, value] : given) m_parts.set(AttributeOwner::edge, edge.attributes, name, value);
    }
    return true;
  }

  bool tooManyEdges(std::size_t offset) {
    m_failure =
        makeDiagnostics(Code::schema, translated("A graph of at most 200,000 edges is read."), offset);
    return false;
  }

  /// The node of this name; a new one has the defaults of its place.
  ReadNode* nodeOf(const std::string& id, std::size_t offset) {
    const auto [known, isNew] = m_positions.try_emplace(id, m_parts.nodes.size());
    if (isNew) {
      if (m_parts.nodes.size() == kMaxNodes) {
        m_failure =
            makeDiagnostics(Code::schema, translated("A graph of at most 100,000 nodes is read."), offset);
        return nullptr;
      }
      m_parts.nodes.push_back({id, offset, m_scopes.back().nodes});
    }
    return &m_parts.nodes[known->second];
  }

  std::string_view m_text;
  DotScanner m_scanner;
  DotToken m_token;
  bool m_isStrict = false;
  std::vector<Scope> m_scopes;
  GraphParts m_parts;
  std::map<std::string, std::size_t> m_positions;
  std::set<std::pair<std::string, std::string>> m_pairs;  ///< of a strict graph
  Diagnostics m_failure;
};

}  // namespace

Expected<GraphParts> readDot(std::string_view text) {
  return DotReader(text).run();
}

}  // namespace geargraph
