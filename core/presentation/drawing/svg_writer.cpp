#include "core/presentation/drawing/svg_writer.h"

#include <algorithm>
#include <string_view>

#include "core/foundations/base/text_lists.h"
#include "core/presentation/drawing/sheet_number.h"

namespace geargraph {
namespace {

std::string attribute(std::string_view name, double value) {
  return " " + std::string(name) + "=\"" + sheetNumber(value) + "\"";
}

std::string attribute(std::string_view name, std::string_view value) {
  return " " + std::string(name) + "=\"" + std::string(value) + "\"";
}

std::string pair(CanvasPoint p) {
  return sheetNumber(p.x) + " " + sheetNumber(p.y);
}

/// The tag of a shape without its end.
struct ShapeTag {
  std::string operator()(const Circle& circle) const {
    return "<circle" + attribute("cx", circle.center.x) + attribute("cy", circle.center.y) +
           attribute("r", circle.radius);
  }
  std::string operator()(const Box& box) const {
    return "<rect" + attribute("x", box.extent.left()) + attribute("y", box.extent.top()) +
           attribute("width", 2 * box.extent.halfWidth) + attribute("height", 2 * box.extent.halfHeight) +
           attribute("rx", box.corner);
  }
  std::string operator()(const Polyline& line) const {
    std::string points;
    for (const CanvasPoint p : line.points)
      points += (points.empty() ? "" : " ") + sheetNumber(p.x) + "," + sheetNumber(p.y);
    return (line.closed ? "<polygon" : "<polyline") + attribute("points", points);
  }
  std::string operator()(const Curve& curve) const {
    const std::string path = curve.isStraight() ? "M" + pair(curve.from) + " L" + pair(curve.to)
                                                : "M" + pair(curve.from) + " C" + pair(curve.leaving) + " " +
                                                      pair(curve.arriving) + " " + pair(curve.to);
    return "<path" + attribute("d", path);
  }
};

std::string_view dashArray(Dash dash) {
  switch (dash) {
    case Dash::solid:
      return {};
    case Dash::dashed:
      return "6.5 4.5";
    case Dash::dashDotted:
      return "12 3 2 3";
    case Dash::dotted:
      return "0.1 6";
  }
  return {};
}

struct MarkTag {
  Theme theme;

  std::string operator()(const Stroke& stroke) const {
    std::string tag = std::visit(ShapeTag{}, stroke.shape) + attribute("fill", "none") +
                      attribute("stroke", hexOf(colorOf(stroke.tint, theme))) +
                      attribute("stroke-width", stroke.width);
    if (stroke.dash != Dash::solid) tag += attribute("stroke-dasharray", dashArray(stroke.dash));
    if (stroke.dash == Dash::dotted) tag += attribute("stroke-linecap", "round");
    return tag + "/>";
  }
  std::string operator()(const Fill& fill) const {
    return std::visit(ShapeTag{}, fill.shape) + attribute("fill", hexOf(colorOf(fill.tint, theme))) + "/>";
  }
  std::string operator()(const Text& text) const {
    constexpr double kDigitHeight = 0.729;  // of DejaVu Sans, in em
    std::string tag = "<text" + attribute("x", text.center.x) +
                      attribute("y", text.center.y + kDigitHeight * text.size / 2) +
                      attribute("font-size", text.size) + attribute("fill", hexOf(colorOf(text.tint, theme)));
    if (text.bold) tag += attribute("font-weight", "bold");
    return tag + ">" + escapedXml(text.text) + "</text>";
  }
};

}  // namespace

Extent sheetOf(const DisplayList& list, const SheetStyle& style) {
  Extent sheet = extentOf(list).grown(std::max(style.margin, 0.5));
  if (!style.size) return sheet;
  const double shape = static_cast<double>(style.size->width) / style.size->height;
  sheet.halfWidth = std::max(sheet.halfWidth, sheet.halfHeight * shape);
  sheet.halfHeight = std::max(sheet.halfHeight, sheet.halfWidth / shape);
  return sheet;
}

std::string svgOf(const DisplayList& list, const SheetStyle& style, std::string_view title) {
  const Extent sheet = sheetOf(list, style);
  const std::string width = sheetNumber(2 * sheet.halfWidth);
  const std::string height = sheetNumber(2 * sheet.halfHeight);
  std::string svg =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" "
      "version=\"1.1\"" +
      attribute("width", style.size ? std::to_string(style.size->width) : width) +
      attribute("height", style.size ? std::to_string(style.size->height) : height) +
      attribute("viewBox",
                sheetNumber(sheet.left()) + " " + sheetNumber(sheet.top()) + " " + width + " " + height) +
      ">\n";
  if (!title.empty()) svg += "<title>" + escapedXml(title) + "</title>\n";
  if (!style.transparent) {
    svg += "<rect" + attribute("x", sheet.left()) + attribute("y", sheet.top()) + attribute("width", width) +
           attribute("height", height) + attribute("fill", hexOf(colorOf(ColorRole::sheet, style.theme))) +
           "/>\n";
  }
  svg += "<g font-family=\"DejaVu Sans, Verdana, Arial, sans-serif\" text-anchor=\"middle\">\n";
  for (const Mark& mark : list.marks) {
    svg += "<g" + attribute("data-list", listName(mark.element.kind)) +
           attribute("data-id", escapedXml(mark.element.id.text())) + ">" +
           std::visit(MarkTag{style.theme}, mark.what) + "</g>\n";
  }
  return svg + "</g>\n</svg>\n";
}

}  // namespace geargraph
