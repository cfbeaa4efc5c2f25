#include "core/report/mathml.h"

#include <cctype>
#include <map>
#include <vector>

#include "core/base/contract.h"
#include "core/base/wording.h"

namespace geargraph {
namespace {

const std::map<std::string_view, std::string_view>& letters() {
  static const std::map<std::string_view, std::string_view> known{
      {"Gamma", "Γ"}, {"omega", "ω"}, {"theta", "θ"}};
  return known;
}

const std::map<std::string_view, std::string_view>& signs() {
  static const std::map<std::string_view, std::string_view> known{
      {"times", "×"}, {"circ", "∘"}, {"cdot", "⋅"}, {"mid", "|"}, {"approx", "≈"}};
  return known;
}

/// How the columns of an array stand, and where its bars are.
struct Columns {
  std::string alignment;   ///< l, c or r by column
  std::vector<char> bars;  ///< by column: one left of it
};

class TexReader {
 public:
  explicit TexReader(std::string_view tex) : m_rest(tex) {}

  std::string all() {
    std::string result = row();
    GEARGRAPH_REQUIRE(m_rest.empty());
    return result;
  }

 private:
  static bool isLetter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
  static bool isDigit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

  void skipBlanks() {
    while (!m_rest.empty() && (m_rest.front() == ' ' || m_rest.front() == '\n')) m_rest.remove_prefix(1);
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
    GEARGRAPH_REQUIRE(m_rest.substr(0, text.size()) == text);
    m_rest.remove_prefix(text.size());
  }
  /// What stands between braces, unread.
  std::string_view braced() {
    take("{");
    const std::size_t end = m_rest.find('}');
    GEARGRAPH_REQUIRE(end != std::string_view::npos);
    const std::string_view inside = m_rest.substr(0, end);
    m_rest.remove_prefix(end + 1);
    return inside;
  }

  /// Up to a brace, a cell's or a line's end, or the end of what was begun.
  std::string row() {
    std::string result;
    while (true) {
      skipBlanks();
      if (m_rest.empty() || m_rest.front() == '}' || m_rest.front() == '&') break;
      const std::string_view next = command();
      if (next == "\\" || next == "end" || next == "right") break;
      result += m_rest.front() == '-' && isOpen(result) ? negative() : scripted();
    }
    return result;
  }

  /// Is what comes next the first of a term?
  static bool isOpen(std::string_view row) {
    return row.empty() || row.ends_with("<mo>=</mo>") || row.ends_with("<mo>(</mo>");
  }
  /// A minus sign close to its term.
  std::string negative() {
    take("-");
    return "<mo form=\"prefix\">−</mo>";
  }

  std::string scripted() {
    const std::string base = atom();
    std::string below, above;
    while (true) {
      skipBlanks();
      if (m_rest.empty()) break;
      if (m_rest.front() == '_') {
        m_rest.remove_prefix(1);
        below = group();
      } else if (m_rest.front() == '^') {
        m_rest.remove_prefix(1);
        above = group();
      } else if (m_rest.front() == '\'') {
        std::string primes;
        while (!m_rest.empty() && m_rest.front() == '\'') {
          primes += "′";
          m_rest.remove_prefix(1);
        }
        above = "<mo>" + primes + "</mo>";
      } else {
        break;
      }
    }
    if (below.empty() && above.empty()) return base;
    if (above.empty()) return "<msub>" + base + below + "</msub>";
    if (below.empty()) return "<msup>" + base + above + "</msup>";
    return "<msubsup>" + base + below + above + "</msubsup>";
  }

  /// One element: what braces hold, or the next sign.
  std::string group() {
    skipBlanks();
    if (m_rest.empty() || m_rest.front() != '{') return atom();
    take("{");
    std::string inside = row();
    take("}");
    return "<mrow>" + inside + "</mrow>";
  }

  std::string atom() {
    skipBlanks();
    GEARGRAPH_REQUIRE(!m_rest.empty());
    const char c = m_rest.front();
    if (c == '{') return group();
    if (c == '\\') return commanded();
    std::size_t length = 1;
    if (isDigit(c)) {
      while (length < m_rest.size() && (isDigit(m_rest[length]) || m_rest[length] == '.')) ++length;
    }
    const std::string text(m_rest.substr(0, length));
    m_rest.remove_prefix(length);
    if (isDigit(c)) return "<mn>" + text + "</mn>";
    if (isLetter(c)) return "<mi>" + text + "</mi>";
    if (c == '-') return "<mo>−</mo>";
    return "<mo>" + escapedXml(text) + "</mo>";
  }

  std::string commanded() {
    const std::string_view name = command();
    m_rest.remove_prefix(1 + name.size());
    if (const auto letter = letters().find(name); letter != letters().end()) {
      return "<mi>" + std::string(letter->second) + "</mi>";
    }
    if (const auto sign = signs().find(name); sign != signs().end()) {
      return "<mo>" + std::string(sign->second) + "</mo>";
    }
    if (name == "frac") {
      const std::string over = group();
      return "<mfrac>" + over + group() + "</mfrac>";
    }
    if (name == "dot") return "<mover accent=\"true\">" + group() + "<mo>˙</mo></mover>";
    if (name == "hat") return "<mover accent=\"true\">" + group() + "<mo>^</mo></mover>";
    if (name == "quad") return "<mspace width=\"1em\"/>";
    if (name == ",") return "<mspace width=\"0.17em\"/>";
    if (name == "left") return fenced();
    GEARGRAPH_REQUIRE(name == "begin");
    return environment();
  }

  std::string fenced() {
    const std::string open = delimiter();
    const std::string inside = row();
    take("\\right");
    return "<mrow>" + open + inside + delimiter() + "</mrow>";
  }
  std::string delimiter() {
    skipBlanks();
    GEARGRAPH_REQUIRE(!m_rest.empty());
    const std::string sign(1, m_rest.front());
    m_rest.remove_prefix(1);
    return "<mo stretchy=\"true\">" + sign + "</mo>";
  }

  std::string environment() {
    const std::string_view name = braced();
    Columns columns;
    if (name == "array") columns = columnsOf(braced());
    const std::string table = cells(name, columns);
    take("\\end");
    GEARGRAPH_REQUIRE(braced() == name);
    if (name != "pmatrix") return table;
    return "<mrow><mo stretchy=\"true\">(</mo>" + table + "<mo stretchy=\"true\">)</mo></mrow>";
  }

  static Columns columnsOf(std::string_view text) {
    Columns columns;
    bool bar = false;
    for (const char c : text) {
      if (c == '|') {
        bar = true;
        continue;
      }
      columns.alignment += c;
      columns.bars.push_back(bar ? 1 : 0);
      bar = false;
    }
    return columns;
  }

  /// The classes of a cell: how it is aligned and where its rules are.
  static std::string classesOf(std::string_view environment, const Columns& columns, std::size_t column,
                               bool rule) {
    std::string classes(1, 'c');
    if (environment == "aligned") classes = column % 2 == 0 ? "r" : "l";
    if (column < columns.alignment.size()) classes = std::string(1, columns.alignment[column]);
    if (column < columns.bars.size() && columns.bars[column] != 0) classes += " bar";
    if (rule) classes += " rule";
    return classes;
  }

  std::string cells(std::string_view environment, const Columns& columns) {
    std::string text =
        environment == "aligned" ? "<mtable class=\"aligned\" displaystyle=\"true\">" : "<mtable>";
    bool more = true;
    while (more) {
      const bool rule = tookLine();
      text += "<mtr>";
      for (std::size_t column = 0;; ++column) {
        text += "<mtd class=\"" + classesOf(environment, columns, column, rule) + "\">" + row() + "</mtd>";
        skipBlanks();
        GEARGRAPH_REQUIRE(!m_rest.empty());
        if (m_rest.front() != '&') break;
        m_rest.remove_prefix(1);
      }
      text += "</mtr>";
      more = command() == "\\";
      if (more) m_rest.remove_prefix(2);
    }
    return text + "</mtable>";
  }
  bool tookLine() {
    skipBlanks();
    if (command() != "hline") return false;
    take("\\hline");
    return true;
  }

  std::string_view m_rest;
};

}  // namespace

std::string mathMl(std::string_view tex) {
  return TexReader(tex).all();
}

}  // namespace geargraph
