#include "core/presentation/drawing/tikz_writer.h"

#include <map>

#include "core/presentation/drawing/latex_text.h"
#include "core/presentation/drawing/sheet_number.h"

namespace geargraph {
namespace {

std::string pair(CanvasPoint p) {
  return "(" + sheetNumber(p.x) + "," + sheetNumber(p.y) + ")";
}

/// Marks in units of the picture, whose y axis points down like that of the sheet.
class TikzWriter {
 public:
  explicit TikzWriter(double points) : m_points(points) {}

  std::string picture(const DisplayList& list) {
    std::string marks;
    for (const Mark& mark : list.marks) marks += std::visit(*this, mark.what);
    std::string text = "\\begin{tikzpicture}[x=" + length(1) + ",y=-" + length(1) + "]\n";
    for (const auto& [hex, name] : m_colors) text += "\\definecolor{" + name + "}{HTML}{" + hex + "}\n";
    return text + marks + "\\end{tikzpicture}";
  }

  std::string operator()(const Stroke& stroke) {
    return "\\draw[" + colorNamed(stroke.tint) + ",line width=" + length(stroke.width) + dashed(stroke.dash) +
           corners(stroke.shape) + "] " + std::visit(Path(), stroke.shape) + ";\n";
  }
  std::string operator()(const Fill& fill) {
    return "\\fill[" + colorNamed(fill.tint) + corners(fill.shape) + "] " + std::visit(Path(), fill.shape) +
           ";\n";
  }
  std::string operator()(const Text& text) {
    constexpr double kNormalSize = 10;  // size of the document's words, points
    return "\\node[" + colorNamed(text.tint) +
           ",inner sep=0pt,scale=" + sheetNumber(text.size * m_points / kNormalSize) + "] at " +
           pair(text.center) + " {\\sffamily" + (text.bold ? "\\bfseries{}" : "{}") +
           escapedLatex(text.text) + "};\n";
  }

 private:
  struct Path {
    std::string operator()(const Circle& circle) const {
      return pair(circle.center) + " circle[radius=" + sheetNumber(circle.radius) + "]";
    }
    std::string operator()(const Box& box) const {
      return pair({box.extent.left(), box.extent.top()}) + " rectangle " +
             pair({box.extent.right(), box.extent.bottom()});
    }
    std::string operator()(const Polyline& line) const {
      std::string path;
      for (const CanvasPoint p : line.points) path += (path.empty() ? "" : " -- ") + pair(p);
      return line.closed ? path + " -- cycle" : path;
    }
    std::string operator()(const Curve& curve) const {
      if (curve.isStraight()) return pair(curve.from) + " -- " + pair(curve.to);
      return pair(curve.from) + " .. controls " + pair(curve.leaving) + " and " + pair(curve.arriving) +
             " .. " + pair(curve.to);
    }
  };

  [[nodiscard]] std::string length(double units) const { return sheetNumber(units * m_points) + "pt"; }
  [[nodiscard]] std::string corners(const Shape& shape) const {
    const auto* box = std::get_if<Box>(&shape);
    return box != nullptr && box->corner > 0 ? ",rounded corners=" + length(box->corner) : std::string();
  }
  [[nodiscard]] std::string dashed(Dash dash) const {
    const auto pattern = [this](double on, double off) {
      return " on " + length(on) + " off " + length(off);
    };
    switch (dash) {
      case Dash::solid:
        break;
      case Dash::dashed:
        return ",dash pattern=" + pattern(6.5, 4.5);
      case Dash::dashDotted:
        return ",dash pattern=" + pattern(12, 3) + pattern(2, 3);
      case Dash::dotted:
        return ",line cap=round,dash pattern=" + pattern(0.1, 6);
    }
    return {};
  }
  std::string colorNamed(const Tint& tint) {
    const std::string hex = hexOf(colorOf(tint, Theme::light)).substr(1);
    return m_colors.try_emplace(hex, "gg" + std::to_string(m_colors.size() + 1)).first->second;
  }

  double m_points = 1;
  std::map<std::string, std::string> m_colors;  ///< hexadecimal digits -> name in the document
};

}  // namespace

std::string tikzOf(const DisplayList& list, double points) {
  return TikzWriter(points).picture(list);
}

}  // namespace geargraph
