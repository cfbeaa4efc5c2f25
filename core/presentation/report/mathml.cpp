#include "core/presentation/report/mathml.h"

#include <algorithm>

#include "core/foundations/base/text_lists.h"
#include "core/presentation/typeset/tex_reader.h"

namespace geargraph {
namespace {

std::string elementOf(const FormulaNode& node);

/// Bars in pairs are those of absolute values, close to what they enclose; one alone is a relation.
std::string partsOf(const FormulaNode& row) {
  const auto isBar = [](const FormulaNode& part) {
    return part.kind == FormulaKind::sign && part.text == "|";
  };
  const bool areFences = std::count_if(row.parts.begin(), row.parts.end(), isBar) % 2 == 0;
  bool isOpen = false;
  std::string text;
  for (const FormulaNode& part : row.parts) {
    if (!areFences || !isBar(part)) {
      text += elementOf(part);
      continue;
    }
    isOpen = !isOpen;
    text += std::string("<mo form=\"") + (isOpen ? "prefix" : "postfix") + "\" stretchy=\"false\">|</mo>";
  }
  return text;
}

std::string within(const char* element, const std::string& text) {
  return std::string("<") + element + ">" + text + "</" + element + ">";
}

std::string scripts(const FormulaNode& node) {
  const std::string base = elementOf(node.parts.front());
  if (node.above.empty()) return within("msub", base + elementOf(node.below.front()));
  if (node.below.empty()) return within("msup", base + elementOf(node.above.front()));
  return within("msubsup", base + elementOf(node.below.front()) + elementOf(node.above.front()));
}

std::string stretchy(const std::string& bracket) {
  return "<mo stretchy=\"true\">" + bracket + "</mo>";
}

/// A cell says in its classes how it is aligned and where its rules are.
std::string table(const FormulaNode& node) {
  const bool lines = node.table == FormulaTableKind::aligned;
  std::string text = lines ? "<mtable class=\"aligned\" displaystyle=\"true\">" : "<mtable>";
  for (std::size_t row = 0; row < node.cells.size(); ++row) {
    text += "<mtr>";
    for (std::size_t column = 0; column < node.cells[row].size(); ++column) {
      text += std::string("<mtd class=\"") + node.alignmentOf(column) + (node.hasBar(column) ? " bar" : "") +
              (node.hasRule(row) ? " rule" : "") + "\">" + partsOf(node.cells[row][column]) + "</mtd>";
    }
    text += "</mtr>";
  }
  text += "</mtable>";
  return node.table == FormulaTableKind::brackets ? within("mrow", stretchy("(") + text + stretchy(")"))
                                                  : text;
}

std::string elementOf(const FormulaNode& node) {
  switch (node.kind) {
    case FormulaKind::row:
      return within("mrow", partsOf(node));
    case FormulaKind::number:
      return within("mn", node.text);
    case FormulaKind::letter:
      return within("mi", node.text);
    case FormulaKind::sign:
      return within("mo", escapedXml(node.text));
    case FormulaKind::negative:
      return "<mo form=\"prefix\">−</mo>";
    case FormulaKind::scripts:
      return scripts(node);
    case FormulaKind::fraction:
      return within("mfrac", elementOf(node.parts[0]) + elementOf(node.parts[1]));
    case FormulaKind::accent:
      return "<mover accent=\"true\">" + elementOf(node.parts.front()) + within("mo", node.text) + "</mover>";
    case FormulaKind::space:
      return "<mspace width=\"" + node.text + "\"/>";
    case FormulaKind::fenced:
      return within("mrow", stretchy(node.text.substr(0, 1)) + partsOf(node.parts.front()) +
                                stretchy(node.text.substr(1)));
    case FormulaKind::table:
      return table(node);
  }
  return {};
}

}  // namespace

std::string mathMl(std::string_view tex) {
  return partsOf(formulaOf(tex));
}

}  // namespace geargraph
