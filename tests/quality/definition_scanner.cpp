#include "tests/quality/definition_scanner.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace geargraph::test {
namespace {

struct Token {
  std::string text;
  int line = 0;
};

bool isNameCharacter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' ||
         static_cast<unsigned char>(c) >= 0x80;
}

/// Splits a source into names, literals and punctuation, without comments and preprocessor lines.
class Tokenizer {
 public:
  explicit Tokenizer(std::string_view source) : m_source(source) {}

  std::vector<Token> run() {
    while (m_at < m_source.size()) step();
    return std::move(m_tokens);
  }

 private:
  [[nodiscard]] bool follows(std::string_view text) const { return m_source.substr(m_at).starts_with(text); }

  void moveTo(std::size_t end) {
    end = std::min(end, m_source.size());
    m_line += static_cast<int>(std::count(m_source.begin() + static_cast<std::ptrdiff_t>(m_at),
                                          m_source.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
    m_at = end;
  }

  /// Past the next `end`, or to the end of the source.
  void skipPast(std::string_view end, std::size_t from) {
    const std::size_t found = m_source.find(end, from);
    moveTo(found == std::string_view::npos ? m_source.size() : found + end.size());
  }

  void step() {
    const char c = m_source[m_at];
    if (follows("//")) return skipPast("\n", m_at);
    if (follows("/*")) return skipPast("*/", m_at + 2);
    if (c == '#') return skipDirective();
    if (std::isspace(static_cast<unsigned char>(c)) != 0) return moveTo(m_at + 1);
    if (c == '"') return skipString();
    if (c == '\'') return skipQuoted('\'');
    if (isNameCharacter(c)) return addName();
    for (const std::string_view pair : {"::", "&&", "->", "=="}) {
      if (follows(pair)) return add(pair.size());
    }
    add(1);
  }

  void add(std::size_t length) {
    m_tokens.push_back({std::string(m_source.substr(m_at, length)), m_line});
    moveTo(m_at + length);
  }

  void addName() {
    std::size_t end = m_at;
    const bool isNumber = std::isdigit(static_cast<unsigned char>(m_source[m_at])) != 0;
    while (end < m_source.size() &&
           (isNameCharacter(m_source[end]) || (isNumber && (m_source[end] == '\'' || m_source[end] == '.'))))
      ++end;
    add(end - m_at);
  }

  void skipDirective() {
    std::size_t end = m_source.find('\n', m_at);
    while (end != std::string_view::npos && m_source[end - 1] == '\\') end = m_source.find('\n', end + 1);
    moveTo(end == std::string_view::npos ? m_source.size() : end);
  }

  void skipString() {
    const bool isRaw =
        !m_tokens.empty() && m_at > 0 && m_source[m_at - 1] == 'R' && m_tokens.back().text.ends_with('R');
    if (!isRaw) return skipQuoted('"');
    const std::size_t open = m_source.find('(', m_at);
    const std::string end = ")" + std::string(m_source.substr(m_at + 1, open - m_at - 1)) + "\"";
    skipPast(end, open);
  }

  void skipQuoted(char quote) {
    std::size_t end = m_at + 1;
    while (end < m_source.size() && m_source[end] != quote) end += m_source[end] == '\\' ? 2 : 1;
    m_tokens.push_back({"\"\"", m_line});
    moveTo(end + 1);
  }

  std::string_view m_source;
  std::size_t m_at = 0;
  int m_line = 1;
  std::vector<Token> m_tokens;
};

bool isName(const std::string& token) {
  return isNameCharacter(token.front()) && std::isdigit(static_cast<unsigned char>(token.front())) == 0;
}

bool isKeywordOfType(const std::string& token) {
  constexpr std::array kWords{"const", "volatile", "unsigned", "signed", "long",   "short", "int",
                              "char",  "bool",     "float",    "double", "struct", "class", "typename"};
  return std::find(kWords.begin(), kWords.end(), token) != kWords.end();
}

/// Reads the statements at namespace scope.
class Scanner {
 public:
  explicit Scanner(std::vector<Token> tokens) : m_tokens(std::move(tokens)) {}

  std::vector<Definition> run() {
    while (m_at < m_tokens.size()) step();
    return std::move(m_found);
  }

 private:
  using Tokens = std::vector<Token>;

  void step() {
    const std::string& text = m_tokens[m_at].text;
    if (text == "}") {
      if (!m_scopes.empty()) m_scopes.pop_back();
      m_statement.clear();
    } else if (text == ";") {
      addVariable();
      m_statement.clear();
    } else if (text == "{") {
      return openBrace();
    } else {
      m_statement.push_back(m_tokens[m_at]);
    }
    ++m_at;
  }

  void openBrace() {
    if (isNamespace()) {
      m_scopes.push_back(namespaceName());
      m_statement.clear();
      ++m_at;
      return;
    }
    if (!m_statement.empty() && m_statement[0].text == "extern") {  // extern "C" { ... }
      m_scopes.emplace_back();
      m_statement.clear();
      ++m_at;
      return;
    }
    if (hasTopLevel("=")) return skipBraces();  // an initializer; the statement goes on
    if (const auto type = typeName(); !type.empty()) {
      record(type);
      skipBraces();
      m_statement.clear();
      m_statement.push_back({"type", 0});  // variables of it may follow
      return;
    }
    if (hasTopLevel("(")) {
      addFunction();
      skipBraces();
      m_statement.clear();
      return;
    }
    skipBraces();  // a variable's initializer
  }

  [[nodiscard]] bool isNamespace() const {
    return std::any_of(m_statement.begin(), m_statement.end(),
                       [](const Token& t) { return t.text == "namespace"; });
  }

  /// "a::b" of namespace a::b; "" of an unnamed one.
  [[nodiscard]] std::string namespaceName() const {
    std::string name;
    bool after = false;
    for (const Token& token : m_statement) {
      if (after) name += token.text;
      after = after || token.text == "namespace";
    }
    return name.empty() ? "-" : name;
  }

  /// The position of the first `text` outside of parentheses, brackets and template lists.
  [[nodiscard]] std::size_t topLevel(std::string_view text, std::size_t from = 0) const {
    int depth = 0;
    int angles = 0;
    for (std::size_t i = from; i < m_statement.size(); ++i) {
      const std::string& token = m_statement[i].text;
      if (depth == 0 && angles == 0 && token == text) return i;
      if (token == "(" || token == "[") ++depth;
      if (token == ")" || token == "]") --depth;
      if (depth == 0 && token == "<" && i > 0 && m_statement[i - 1].text != "operator") ++angles;
      if (depth == 0 && token == ">" && angles > 0) --angles;
    }
    return m_statement.size();
  }
  [[nodiscard]] bool hasTopLevel(std::string_view text) const { return topLevel(text) < m_statement.size(); }

  /// Past a list in angle brackets that begins at `at`.
  [[nodiscard]] std::size_t pastAngles(std::size_t at) const {
    int depth = 0;
    for (; at < m_statement.size(); ++at) {
      if (m_statement[at].text == "<") ++depth;
      if (m_statement[at].text == ">" && --depth == 0) return at + 1;
    }
    return at;
  }

  /// The name of the type that the statement defines, with template arguments; "" where it defines none.
  [[nodiscard]] std::string typeName() const {
    std::size_t at = m_statement.size();
    for (const std::string_view key : {"class", "struct", "union", "enum"}) at = std::min(at, topLevel(key));
    if (at == m_statement.size()) return {};
    ++at;
    if (at < m_statement.size() && (m_statement[at].text == "class" || m_statement[at].text == "struct"))
      ++at;
    while (at < m_statement.size() && (m_statement[at].text == "[" || m_statement[at].text == "alignas")) {
      const bool isAttribute = m_statement[at].text == "[";
      int depth = 0;
      if (!isAttribute) ++at;
      do {
        if (m_statement[at].text == "[" || m_statement[at].text == "(") ++depth;
        if (m_statement[at].text == "]" || m_statement[at].text == ")") --depth;
        ++at;
      } while (depth > 0 && at < m_statement.size());
    }
    std::string name;
    while (at < m_statement.size() && m_statement[at].text != ":" && m_statement[at].text != "final") {
      if (m_statement[at].text == "(") return {};  // a function that returns one
      name += m_statement[at].text;
      ++at;
    }
    return name;
  }

  void addFunction() {
    const auto has = [this](std::string_view word) { return hasTopLevel(word); };
    if (has("static") || !(has("inline") || has("constexpr") || has("template"))) return;
    std::size_t open = topLevel("(");
    while (open > 0 && m_statement[open - 1].text == "requires") open = topLevel("(", open + 1);
    std::size_t begin = open;
    while (begin > 0) {
      const std::string& before = m_statement[begin - 1].text;
      const bool isOperator = begin >= 2 && m_statement[begin - 2].text == "operator";
      if (!(isName(before) || before == "::" || before == "operator" || isOperator)) break;
      if (isName(before) && before != "operator" && begin < open && m_statement[begin].text != "::" &&
          m_statement[begin - 1].text != "operator")
        break;  // the return type
      --begin;
    }
    std::string name;
    for (std::size_t i = begin; i < open; ++i) name += m_statement[i].text;
    if (!name.empty()) record(name + parameters(open) + (has("template") ? templateKey() : std::string()));
  }

  /// Template parameters, by number and kind: two templates may differ in them alone.
  [[nodiscard]] std::string templateKey() const {
    std::string key = " template ";
    for (std::size_t i = 1; i < pastAngles(1); ++i) {
      const std::string& text = m_statement[i].text;
      const bool isParameterName = i > 1 && isName(m_statement[i - 1].text) && isName(text);
      if (!isParameterName) key += text;
    }
    return key;
  }

  /// The types of the parameters, without names and default values.
  [[nodiscard]] std::string parameters(std::size_t open) const {
    std::string all = "(";
    std::vector<std::string> one;
    bool isDefault = false;
    int depth = 0;
    const auto close = [&] {
      const bool named = one.size() >= 2 && isName(one.back()) && !isKeywordOfType(one.back()) &&
                         one[one.size() - 2] != "::" && one[one.size() - 2] != "const";
      if (named) one.pop_back();
      for (const std::string& text : one) all += text + " ";
      one.clear();
      isDefault = false;
    };
    for (std::size_t i = open + 1; i < m_statement.size(); ++i) {
      const std::string& text = m_statement[i].text;
      if (depth == 0 && text == ")") break;
      if (text == "(" || text == "<" || text == "[" || text == "{") ++depth;
      if (text == ")" || text == ">" || text == "]" || text == "}") --depth;
      if (depth == 0 && text == ",") {
        close();
        all += ",";
        continue;
      }
      isDefault = isDefault || (depth == 0 && text == "=");
      if (!isDefault) one.push_back(text);
    }
    close();
    return all + ")";
  }

  /// `inline constexpr int kX = 1;`
  void addVariable() {
    if (!hasTopLevel("inline") || hasTopLevel("(")) return;
    std::size_t end = topLevel("=");
    if (end == 0 || !isName(m_statement[end - 1].text)) return;
    record(m_statement[end - 1].text);
  }

  void record(const std::string& name) {
    std::string qualified;
    for (const std::string& scope : m_scopes) {
      if (scope == "-") return;
      if (!scope.empty()) qualified += scope + "::";
    }
    m_found.push_back({qualified + name, m_statement.empty() ? 0 : m_statement.back().line});
  }

  void skipBraces() {
    int depth = 0;
    for (; m_at < m_tokens.size(); ++m_at) {
      if (m_tokens[m_at].text == "{") ++depth;
      if (m_tokens[m_at].text == "}" && --depth == 0) break;
    }
    ++m_at;
  }

  Tokens m_tokens;
  std::size_t m_at = 0;
  Tokens m_statement;
  std::vector<std::string> m_scopes;  ///< namespaces; "-" is unnamed, "" adds no name
  std::vector<Definition> m_found;
};

}  // namespace

std::vector<Definition> definitionsIn(std::string_view source) {
  return Scanner(Tokenizer(source).run()).run();
}

std::vector<std::string> repeatedDefinitions(const std::map<std::string, std::string>& sources) {
  std::map<std::string, std::vector<std::string>> places;
  for (const auto& [file, text] : sources) {
    for (const Definition& definition : definitionsIn(text))
      places[definition.name].push_back(file + ":" + std::to_string(definition.line));
  }
  std::vector<std::string> repeated;
  for (const auto& [name, where] : places) {
    if (where.size() < 2) continue;
    std::string line = name + ":";
    for (const std::string& place : where) line += (line.back() == ':' ? " " : ", ") + place;
    repeated.push_back(line);
  }
  return repeated;
}

}  // namespace geargraph::test
