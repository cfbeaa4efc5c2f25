#include "core/presentation/drawing/display_list.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string_view>

#include "core/presentation/drawing/text_metrics.h"

namespace geargraph {
namespace {

constexpr std::array<std::string_view, 10> kRoleNames{"halo",  "line", "arrowhead", "walk",  "node",
                                                      "label", "name", "hatching",  "input", "ghost"};
constexpr std::array<std::string_view, 4> kDashNames{"solid", "dashed", "dash-dotted", "dotted"};

std::string number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1f", value);
  std::string out(text.data());
  for (char& c : out) {
    if (c == ',') c = '.';  // the locale of the process may not leak into the text
  }
  return out == "-0.0" ? "0.0" : out;
}

std::string pair(CanvasPoint p) {
  return number(p.x) + "," + number(p.y);
}

struct ShapeText {
  std::string operator()(const Circle& circle) const {
    return "circle " + pair(circle.center) + " r" + number(circle.radius);
  }
  std::string operator()(const Box& box) const {
    return "box " + pair(box.extent.center) + " " + number(2 * box.extent.halfWidth) + "x" +
           number(2 * box.extent.halfHeight);
  }
  std::string operator()(const Polyline& line) const {
    std::string text = line.closed ? "polygon" : "polyline";
    for (const CanvasPoint p : line.points) text += " " + pair(p);
    return text;
  }
  std::string operator()(const Curve& curve) const {
    if (curve.isStraight()) return "straight " + pair(curve.from) + " " + pair(curve.to);
    return "curve " + pair(curve.from) + " " + pair(curve.leaving) + " " + pair(curve.arriving) + " " +
           pair(curve.to);
  }
};

struct MarkText {
  std::string operator()(const Stroke& stroke) const {
    return "stroke " + std::visit(ShapeText{}, stroke.shape) + " | " + nameOf(stroke.tint) + " " +
           number(stroke.width) + " " + std::string(kDashNames[static_cast<std::size_t>(stroke.dash)]);
  }
  std::string operator()(const Fill& fill) const {
    return "fill " + std::visit(ShapeText{}, fill.shape) + " | " + nameOf(fill.tint);
  }
  std::string operator()(const Text& text) const {
    return "text \"" + text.text + "\" " + pair(text.center) + " | " + nameOf(text.tint) + " " +
           number(text.size) + (text.bold ? " bold" : "");
  }
};

std::string nameOf(const ElementId& element) {
  return std::string(listName(element.kind)) + "/" + element.id.text();
}

}  // namespace

void DisplayList::append(DisplayList other) {
  std::move(other.marks.begin(), other.marks.end(), std::back_inserter(marks));
  std::move(other.outlines.begin(), other.outlines.end(), std::back_inserter(outlines));
}

void DisplayList::sortByDepth() {
  std::stable_sort(marks.begin(), marks.end(), [](const Mark& a, const Mark& b) { return a.z < b.z; });
}

Extent extentOf(const Shape& shape) {
  struct Visitor {
    Extent operator()(const Circle& circle) const { return {circle.center, circle.radius, circle.radius}; }
    Extent operator()(const Box& box) const { return box.extent; }
    Extent operator()(const Polyline& line) const {
      Extent box{line.points.front(), 0, 0};
      for (const CanvasPoint p : line.points) box = box.united({p, 0, 0});
      return box;
    }
    Extent operator()(const Curve& curve) const { return curve.extent(); }
  };
  return std::visit(Visitor{}, shape);
}

Extent extentOf(const Mark& mark) {
  struct Visitor {
    Extent operator()(const Stroke& stroke) const { return extentOf(stroke.shape).grown(stroke.width / 2); }
    Extent operator()(const Fill& fill) const { return extentOf(fill.shape); }
    Extent operator()(const Text& text) const {
      return {text.center, textWidth(text.text, text.size, text.bold) / 2, text.size * 0.6};
    }
  };
  return std::visit(Visitor{}, mark.what);
}

Extent extentOf(const DisplayList& list) {
  if (list.marks.empty()) return {};
  Extent all = extentOf(list.marks.front());
  for (const Mark& mark : list.marks) all = all.united(extentOf(mark));
  return all;
}

std::string textOf(const DisplayList& list) {
  std::string text;
  for (const Mark& mark : list.marks) {
    text += std::to_string(mark.z) + " " + nameOf(mark.element) + " " +
            std::string(kRoleNames[static_cast<std::size_t>(mark.role)]) + ": " +
            std::visit(MarkText{}, mark.what) + "\n";
  }
  for (const Outline& outline : list.outlines) {
    text += "outline " + std::to_string(outline.z) + " " + nameOf(outline.element) + ": " +
            std::visit(ShapeText{}, outline.shape) + " ±" + number(outline.halfWidth) + "\n";
  }
  return text;
}

}  // namespace geargraph
