#include "core/presentation/report/latex_lines.h"

#include <string_view>
#include <vector>

#include "core/presentation/typeset/tex_reader.h"
#include "core/presentation/typeset/typeset.h"

namespace geargraph {
namespace {

constexpr std::string_view kBegin = "\\begin{aligned}\n";
constexpr std::string_view kEnd = "\n\\end{aligned}";
constexpr double kIndent = 2;  // em of \qquad

double widthOf(const std::string& tex) {
  return typesetFormula(formulaOf(tex), FormulaPlace::ownLine).width;
}

/// By how much this place of a formula goes into a group, a bracket or a table, and how long the mark is.
struct Level {
  int change = 0;
  std::size_t length = 1;
};
Level levelAt(std::string_view rest) {
  for (const auto& [word, change] :
       {std::pair<std::string_view, int>{"\\begin", 1}, {"\\end", -1}, {"\\left", 1}, {"\\right", -1}}) {
    // Not the beginning of a longer name, such as \leftarrow.
    if (rest.starts_with(word) &&
        !(rest.size() > word.size() && rest[word.size()] >= 'a' && rest[word.size()] <= 'z'))
      return {change, word.size()};
  }
  if (rest.front() == '\\') return {0, 2};
  if (rest.front() == '{' || rest.front() == '(') return {1, 1};
  if (rest.front() == '}' || rest.front() == ')') return {-1, 1};
  return {};
}

/// The parts between these marks outside of groups, brackets and tables; each but the first keeps its mark.
std::vector<std::string> partsAt(std::string_view tex, const std::vector<std::string_view>& marks) {
  std::vector<std::string> parts(1);
  int depth = 0;
  for (std::size_t at = 0; at < tex.size();) {
    const std::string_view rest = tex.substr(at);
    bool isMark = false;
    for (const std::string_view mark : marks)
      isMark = isMark || (depth == 0 && at > 0 && rest.starts_with(mark));
    if (isMark) {
      parts.emplace_back();
      parts.back() += rest.front();
      ++at;
      continue;
    }
    const Level level = levelAt(rest);
    depth += level.change;
    parts.back() += rest.substr(0, level.length);
    at += level.length;
  }
  return parts;
}

/// The line as lines of "aligned" that fit.
std::vector<std::string> linesOf(const std::string& line, double width) {
  std::string plain;
  for (const std::string& part : partsAt(line, {"&"})) plain += part.starts_with('&') ? part.substr(1) : part;
  const bool isAligned = plain.size() < line.size();
  if (widthOf(plain) <= width) return {line};
  const std::vector<std::string> parts = partsAt(line, {" + ", " - ", " = ", " &= "});
  // What goes before the sign of alignment pushes all that follows to the right.
  const double before = isAligned ? widthOf(partsAt(line, {"&"}).front()) : 0;
  std::vector<std::string> lines;
  std::string current, measured;
  double indent = 0;
  for (const std::string& part : parts) {
    std::string bare;
    for (const char c : part) bare += c == '&' && part.starts_with(" &=") ? std::string() : std::string(1, c);
    const bool fits = indent + widthOf(measured + bare) <= width;
    if (!fits && !measured.empty() && indent + widthOf(measured) > before + kIndent) {
      lines.push_back(current);
      current = (isAligned ? "&\\quad\\quad {}" : "\\quad\\quad {}") + bare;
      measured = bare;
      indent = before + kIndent;
      continue;
    }
    current += part;
    measured += bare;
  }
  lines.push_back(current);
  return lines;
}

}  // namespace

std::string brokenLines(const std::string& tex, double width) {
  const bool isAligned =
      tex.starts_with(kBegin) && tex.ends_with(kEnd) && tex.find(kBegin, 1) == std::string::npos;
  const std::string inside =
      isAligned ? tex.substr(kBegin.size(), tex.size() - kBegin.size() - kEnd.size()) : tex;
  std::vector<std::string> lines;
  bool isBroken = false;
  if (!isAligned) {
    lines = linesOf(inside, width);
    isBroken = lines.size() > 1;
    // Without a sign of alignment all lines begin at one edge.
    if (isBroken)
      for (std::string& line : lines) line.insert(0, "&");
  } else {
    std::size_t begin = 0;
    int depth = 0;
    for (std::size_t at = 0; at <= inside.size();) {
      const std::string_view rest = std::string_view(inside).substr(at);
      if (at == inside.size() || (depth == 0 && rest.starts_with(" \\\\\n"))) {
        const std::vector<std::string> some = linesOf(inside.substr(begin, at - begin), width);
        isBroken = isBroken || some.size() > 1;
        lines.insert(lines.end(), some.begin(), some.end());
        begin = at + 4;
        at += at == inside.size() ? 1 : 4;
        continue;
      }
      const Level level = levelAt(rest);
      depth += level.change;
      at += level.length;
    }
  }
  if (!isBroken) return tex;
  std::string text(kBegin);
  for (std::size_t i = 0; i < lines.size(); ++i) text += (i > 0 ? " \\\\\n" : "") + lines[i];
  return text + std::string(kEnd);
}

}  // namespace geargraph
