#include "core/presentation/typeset/tex_reader.h"

#include <cctype>
#include <map>

#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

const std::map<std::string_view, std::string_view>& letters() {
  static const std::map<std::string_view, std::string_view> known{
      {"Gamma", "Γ"}, {"ell", "ℓ"},    {"omega", "ω"}, {"tau", "τ"},
      {"theta", "θ"}, {"varphi", "φ"}, {"cos", "cos"}, {"sin", "sin"}};
  return known;
}

const std::map<std::string_view, std::string_view>& signs() {
  static const std::map<std::string_view, std::string_view> known{
      {"times", "×"}, {"circ", "∘"}, {"cdot", "⋅"}, {"pm", "±"}, {"mid", "|"}, {"approx", "≈"}};
  return known;
}

constexpr std::string_view kSigns = "+-=/()[]|,.;:!*<>";

class TexReader {
 public:
  explicit TexReader(std::string_view tex) : m_tex(tex), m_rest(tex) {}

  ReadFormula all() {
    ReadFormula result{row(), {}};
    if (!m_rest.empty()) fail("nothing that begins here ends so");
    result.fault = m_fault;
    return result;
  }

 private:
  static bool isLetter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
  static bool isDigit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

  /// Nothing more is read: every loop ends where no text is left.
  FormulaNode fail(const std::string& why) {
    if (m_fault.empty()) {
      const std::size_t at = m_tex.size() - m_rest.size();
      m_fault = "At " + std::to_string(at) + ", \"" + std::string(m_rest.substr(0, 20)) + "\": " + why + ".";
    }
    m_rest = {};
    return {};
  }

  [[nodiscard]] char front() const { return m_rest.empty() ? '\0' : m_rest.front(); }
  void skipBlanks() {
    while (front() == ' ' || front() == '\n') m_rest.remove_prefix(1);
  }
  /// The name of the command that comes next, empty where none does; "\\" for the end of a line.
  [[nodiscard]] std::string_view command() const {
    if (m_rest.size() < 2 || m_rest.front() != '\\') return {};
    std::size_t end = 1;
    while (end < m_rest.size() && isLetter(m_rest[end])) ++end;
    return m_rest.substr(1, end == 1 ? 1 : end - 1);
  }
  void take(std::string_view text) {
    skipBlanks();
    if (m_rest.substr(0, text.size()) == text) {
      m_rest.remove_prefix(text.size());
    } else {
      fail("\"" + std::string(text) + "\" is missing");
    }
  }
  /// What stands between braces, unread.
  std::string_view braced() {
    take("{");
    const std::size_t end = m_rest.find('}');
    if (end == std::string_view::npos) {
      fail("a brace does not close");
      return {};
    }
    const std::string_view inside = m_rest.substr(0, end);
    m_rest.remove_prefix(end + 1);
    return inside;
  }

  /// Up to a brace, a cell's or a line's end, or the end of what was begun.
  FormulaNode row() {
    FormulaNode result;
    while (true) {
      skipBlanks();
      if (m_rest.empty() || front() == '}' || front() == '&') break;
      const std::string_view next = command();
      if (next == "\\" || next == "end" || next == "right") break;
      if (front() == '-' && isOpen(result)) {
        take("-");
        result.parts.push_back({FormulaKind::negative});
      } else {
        FormulaNode part = scripted();
        if (!m_fault.empty()) break;  // half an element cannot be set
        result.parts.push_back(std::move(part));
      }
    }
    return result;
  }

  /// Is what comes next the first of a term?
  static bool isOpen(const FormulaNode& row) {
    if (row.parts.empty()) return true;
    const FormulaNode& last = row.parts.back();
    return last.kind == FormulaKind::sign && (last.text == "=" || last.text == "(");
  }

  FormulaNode scripted() {
    FormulaNode result{FormulaKind::scripts};
    result.parts.push_back(atom());
    while (true) {
      skipBlanks();
      std::vector<FormulaNode>* place = nullptr;
      FormulaNode script;
      if (front() == '_' || front() == '^') {
        place = front() == '_' ? &result.below : &result.above;
        m_rest.remove_prefix(1);
        script = group();
      } else if (front() == '\'') {
        place = &result.above;
        script.kind = FormulaKind::sign;
        for (; front() == '\''; m_rest.remove_prefix(1)) script.text += "′";
      } else {
        break;
      }
      if (!place->empty()) return fail("a second script at one place");
      place->push_back(std::move(script));
    }
    if (result.below.empty() && result.above.empty()) return std::move(result.parts.front());
    return result;
  }

  /// One element: what braces hold, or the next sign.
  FormulaNode group() {
    skipBlanks();
    if (front() != '{') return atom();
    take("{");
    FormulaNode inside = row();
    take("}");
    return inside;
  }

  /// One more element within another: the reader and the typesetter recurse into them.
  FormulaNode nested(FormulaNode (TexReader::*read)()) {
    if (m_depth == kDeepest) return fail("nested too deeply");
    ++m_depth;
    FormulaNode inside = (this->*read)();
    --m_depth;
    return inside;
  }

  /// "12{,}5": digits, a comma that is no sign of a list, and the digits after it.
  FormulaNode decimalComma(std::size_t before) {
    constexpr std::size_t kComma = 3;
    std::size_t length = before + kComma;
    while (length < m_rest.size() && isDigit(m_rest[length])) ++length;
    FormulaNode result;
    result.kind = FormulaKind::number;
    result.text = std::string(m_rest.substr(0, before)) + ',' +
                  std::string(m_rest.substr(before + kComma, length - before - kComma));
    m_rest.remove_prefix(length);
    return result;
  }

  FormulaNode atom() {
    skipBlanks();
    const char c = front();
    if (c == '{') return nested(&TexReader::group);
    if (c == '\\') return nested(&TexReader::commanded);
    FormulaNode result;
    std::size_t length = 1;
    if (isDigit(c)) {
      result.kind = FormulaKind::number;
      while (length < m_rest.size() && (isDigit(m_rest[length]) || m_rest[length] == '.')) ++length;
      if (m_rest.substr(length).starts_with("{,}")) return decimalComma(length);
    } else if (isLetter(c)) {
      result.kind = FormulaKind::letter;
    } else if (c != '\0' && kSigns.find(c) != std::string_view::npos) {
      result.kind = FormulaKind::sign;
    } else {
      return fail(m_rest.empty() ? "the formula breaks off" : "no sign of a formula");
    }
    result.text = c == '-' ? "−" : std::string(m_rest.substr(0, length));
    m_rest.remove_prefix(length);
    return result;
  }

  FormulaNode commanded() {
    const std::string_view all = m_rest;
    const std::string_view name = command();
    m_rest.remove_prefix(1 + name.size());
    if (const auto letter = letters().find(name); letter != letters().end()) {
      return {FormulaKind::letter, std::string(letter->second)};
    }
    if (const auto sign = signs().find(name); sign != signs().end()) {
      return {FormulaKind::sign, std::string(sign->second)};
    }
    if (name == "frac") {
      FormulaNode result{FormulaKind::fraction};
      result.parts.push_back(group());
      result.parts.push_back(group());
      return result;
    }
    if (name == "dot" || name == "ddot" || name == "hat") {
      FormulaNode result{FormulaKind::accent, name == "dot" ? "˙" : name == "ddot" ? "¨" : "^"};
      result.parts.push_back(group());
      return result;
    }
    if (name == "quad") return {FormulaKind::space, "1em", 1};
    if (name == ",") return {FormulaKind::space, "0.17em", 0.17};
    if (name == "left") return fenced();
    if (name == "begin") return environment();
    m_rest = all;
    return fail("no command that is known");
  }

  FormulaNode fenced() {
    FormulaNode result{FormulaKind::fenced};
    result.text = delimiter();
    result.parts.push_back(row());
    take("\\right");
    result.text += delimiter();
    return result;
  }
  std::string delimiter() {
    skipBlanks();
    if (front() == '\0' || std::string_view("()[]").find(front()) == std::string_view::npos) {
      fail("no bracket that is known");
      return {};
    }
    const std::string sign(1, front());
    m_rest.remove_prefix(1);
    return sign;
  }

  FormulaNode environment() {
    const std::string_view name = braced();
    FormulaNode result{FormulaKind::table};
    if (name == "array") {
      columnsOf(braced(), result);
    } else if (name == "pmatrix") {
      result.table = FormulaTableKind::brackets;
    } else if (name == "aligned") {
      result.table = FormulaTableKind::aligned;
    } else {
      return fail("no environment that is known");
    }
    readCells(result);
    take("\\end");
    if (m_fault.empty() && braced() != name) return fail("another environment ends");
    return result;
  }

  void columnsOf(std::string_view text, FormulaNode& table) {
    bool bar = false;
    for (const char c : text) {
      if (c == '|') {
        bar = true;
      } else if (c == 'l' || c == 'c' || c == 'r') {
        table.alignment += c;
        table.bars.push_back(bar ? 1 : 0);
        bar = false;
      } else {
        fail("the alignment of a column is l, c or r");
      }
    }
  }

  void readCells(FormulaNode& table) {
    bool more = true;
    while (more && m_fault.empty()) {
      table.rules.push_back(tookLine() ? 1 : 0);
      table.cells.emplace_back();
      while (true) {
        table.cells.back().push_back(row());
        skipBlanks();
        if (front() != '&') break;
        m_rest.remove_prefix(1);
      }
      more = command() == "\\";
      if (more) m_rest.remove_prefix(2);
    }
  }
  bool tookLine() {
    skipBlanks();
    if (command() != "hline") return false;
    take("\\hline");
    return true;
  }

  static constexpr int kDeepest = 100;

  std::string_view m_tex;
  std::string_view m_rest;
  std::string m_fault;
  int m_depth = 0;
};

}  // namespace

char FormulaNode::alignmentOf(std::size_t column) const {
  if (table == FormulaTableKind::aligned) return column % 2 == 0 ? 'r' : 'l';
  return column < alignment.size() ? alignment[column] : 'c';
}

ReadFormula readTex(std::string_view tex) {
  return TexReader(tex).all();
}

FormulaNode formulaOf(std::string_view tex) {
  ReadFormula read = readTex(tex);
  GEARGRAPH_REQUIRE(read.fault.empty());
  return std::move(read.formula);
}

}  // namespace geargraph
