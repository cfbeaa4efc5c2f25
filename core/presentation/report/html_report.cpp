#include <cctype>
#include <string_view>

#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"
#include "core/presentation/drawing/svg_writer.h"
#include "core/presentation/report/mathml.h"
#include "core/presentation/report/report.h"

namespace geargraph {
namespace {

constexpr std::string_view kStyle = R"(
:root { color-scheme: light dark; --ink: #1d2126; --soft: #5c6670; --rule: #c9d0d8; --ground: #ffffff; --sheet: #ffffff; }
@media (prefers-color-scheme: dark) { :root { --ink: #e6e9ed; --soft: #a3adb8; --rule: #454d57; --ground: #1b1e23; } }
body { margin: 0 auto; padding: 2rem 1.5rem 4rem; max-width: 62rem; color: var(--ink); background: var(--ground);
       font: 16px/1.55 "DejaVu Sans", "Segoe UI", Helvetica, Arial, sans-serif; }
h1 { font-size: 1.7rem; } h2 { font-size: 1.3rem; margin-top: 2.2rem; border-bottom: 1px solid var(--rule); }
h3 { font-size: 1.05rem; margin-top: 1.6rem; }
.whole { white-space: nowrap; }
.equation { display: flex; align-items: center; gap: 1.5rem; margin: 0.9rem 0; break-inside: avoid; }
.equation > div { flex: 1; overflow-x: auto; text-align: center; }
.number { color: var(--soft); min-width: 3rem; text-align: right; }
table { border-collapse: collapse; margin: 1rem 0; break-inside: avoid; }
th, td { text-align: left; padding: 0.2rem 1.2rem 0.2rem 0; border-bottom: 1px solid var(--rule); }
th { color: var(--soft); font-weight: normal; }
figure { margin: 1.2rem 0; text-align: center; break-inside: avoid; }
figure svg { max-width: 100%; height: auto; background: var(--sheet); border-radius: 4px; }
figcaption { color: var(--soft); }
mtd { padding: 0.15em 0.45em; } mtd.r { text-align: right; } mtd.l { text-align: left; } mtd.c { text-align: center; }
mtd.bar { border-left: 1px solid; } mtd.rule { border-top: 1px solid; }
mtable.aligned mtd { padding: 0.25em 0.1em; }
@media (max-width: 40rem) { body { padding: 1rem 0.9rem 3rem; } .equation { gap: 0.5rem; } table { display: block; overflow-x: auto; } }
@media screen and (prefers-color-scheme: dark) { figure svg { filter: invert(0.88) hue-rotate(180deg); } }
@media print { :root { --ink: #000; --ground: #fff; } body { max-width: none; padding: 0; } }
)";

std::string formula(const std::string& tex, bool onItsOwn) {
  return std::string("<math") + (onItsOwn ? " display=\"block\"" : "") + ">" + mathMl(tex) + "</math>";
}

/// Words of a sentence, which browsers would break behind any hyphen, and before and behind formulas.
class WordWriter {
 public:
  std::string written(const ReportWords& spans) {
    for (const ReportSpan& span : spans) {
      if (span.isFormula) {
        m_html += formula(span.text, false);
        ++m_formulas;
        continue;
      }
      for (const char c : span.text) {
        if (c != ' ' && c != '\n') {
          m_word += c;
          m_html += escapedXml(std::string_view(&c, 1));
          continue;
        }
        endWord();
        m_text += c;
      }
    }
    endWord();
    return std::move(m_text);
  }

 private:
  /// "(n = 7)", "f-circuit" and "(31)-(38)" stay on one line.
  void endWord() {
    const bool hasMark = m_formulas == 1 && !m_word.empty();
    const bool isName =
        m_word.size() > 2 && m_word[1] == '-' && std::isalpha(static_cast<unsigned char>(m_word[0])) != 0;
    const bool isKept = hasMark || isName || m_word.find(")-(") != std::string::npos;
    m_text += isKept ? "<span class=\"whole\">" + m_html + "</span>" : m_html;
    m_word.clear();
    m_html.clear();
    m_formulas = 0;
  }

  std::string m_text;
  std::string m_word;  ///< the plain part of the word that is being read
  std::string m_html;
  int m_formulas = 0;  ///< in that word
};

std::string words(const ReportWords& spans) {
  return WordWriter().written(spans);
}

/// A drawing's own prolog has no place within a page.
std::string_view withoutProlog(std::string_view svg) {
  const std::size_t start = svg.find("<svg");
  return start == std::string_view::npos ? svg : svg.substr(start);
}

class HtmlWriter {
 public:
  HtmlWriter(const ReportDrawings& drawings, bool tellsElements)
      : m_drawings(drawings), m_tellsElements(tellsElements) {}

  std::string operator()(const ReportHeading& heading) const {
    const std::string tag = "h" + std::to_string(heading.level + 1);
    return "<" + tag + ">" + escapedXml(heading.text) + "</" + tag + ">\n";
  }
  std::string operator()(const ReportParagraph& paragraph) const {
    return "<p>" + words(paragraph.words) + "</p>\n";
  }
  std::string operator()(const ReportEquation& equation) const {
    std::string text =
        "<div class=\"equation\"" + elementsOf(equation) + "><div>" + lines(equation) + "</div>";
    if (equation.number) {
      const std::string place = std::to_string(*equation.number) + (equation.isDual ? "-dual" : "");
      text += "<span class=\"number\" id=\"eq" + place + "\">(" + equation.label() + ")</span>";
    }
    return text + "</div>\n";
  }
  std::string operator()(const ReportTable& table) const {
    std::string text = "<table>\n<tr>";
    for (const std::string& cell : table.head)
      text += cell.empty() ? "<td></td>" : "<th>" + escapedXml(cell) + "</th>";
    text += "</tr>\n";
    for (const auto& row : table.rows) {
      text += "<tr>";
      for (const ReportWords& cell : row) text += "<td>" + words(cell) + "</td>";
      text += "</tr>\n";
    }
    return text + "</table>\n";
  }
  std::string operator()(const ReportList& list) const {
    std::string text = "<ul>\n";
    for (const ReportWords& item : list.items) text += "<li>" + words(item) + "</li>\n";
    return text + "</ul>\n";
  }
  std::string operator()(const ReportFigure& figure) const {
    const std::string& svg = m_drawings[figure.drawing];
    return svg.empty() ? std::string() : figureOf(svg, figure.caption);
  }
  std::string operator()(const ReportCurves& curves) const {
    return figureOf(svgOf(chartDrawing(curves.charts), {}, curves.caption), curves.caption);
  }

 private:
  static std::string figureOf(const std::string& svg, const std::string& caption) {
    return "<figure>\n" + std::string(withoutProlog(svg)) + "<figcaption>" + escapedXml(caption) +
           "</figcaption>\n</figure>\n";
  }
  static std::string attributeOf(const ElementId& element) {
    return " data-el=\"" + std::string(listName(element.kind)) + "/" + escapedXml(element.id.text()) + "\"";
  }
  [[nodiscard]] std::string elementsOf(const ReportEquation& equation) const {
    if (!m_tellsElements || equation.elements.size() != 1) return {};
    return attributeOf(equation.elements.front());
  }

  /// The formula; where each of its lines speaks of an element of its own, each tells it.
  [[nodiscard]] std::string lines(const ReportEquation& equation) const {
    constexpr std::string_view kRow = "<mtr>";
    std::string text = formula(equation.tex, true);
    if (!m_tellsElements || equation.elements.size() < 2) return text;
    std::vector<std::size_t> rows;
    for (std::size_t at = text.find(kRow); at != std::string::npos; at = text.find(kRow, at + 1))
      rows.push_back(at);
    if (rows.size() != equation.elements.size()) return text;  // some entry is a matrix itself
    for (std::size_t row = rows.size(); row-- > 0;)
      text.insert(rows[row] + kRow.size() - 1, attributeOf(equation.elements[row]));
    return text;
  }

  const ReportDrawings& m_drawings;
  bool m_tellsElements = false;
};

}  // namespace

std::string reportHtml(const Report& report, const ReportDrawings& drawings) {
  const std::string title = escapedXml(report.title);
  std::string text = "<!DOCTYPE html>\n<html lang=\"" + translated("en") +
                     "\">\n<head>\n<meta charset=\"utf-8\">\n"
                     "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
                     title + "</title>\n<style>" + std::string(kStyle) + "</style>\n</head>\n<body>\n<h1>" +
                     title + "</h1>\n";
  const HtmlWriter writer(drawings, false);
  for (const ReportBlock& block : report.blocks) text += std::visit(writer, block);
  return text + "</body>\n</html>\n";
}

std::string reportHtmlBlocks(const std::vector<ReportBlock>& blocks) {
  const ReportDrawings none;
  const HtmlWriter writer(none, true);
  std::string text;
  for (const ReportBlock& block : blocks) text += std::visit(writer, block);
  return text;
}

}  // namespace geargraph
