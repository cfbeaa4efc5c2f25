#pragma once

#include <string>
#include <variant>
#include <vector>

#include "core/foundations/base/id.h"
#include "core/presentation/drawing/palette.h"
#include "core/presentation/drawing/planar.h"

namespace geargraph {

/// The purpose of a mark.
enum class MarkRole { halo, line, arrowhead, walk, node, label, name, hatching, input, preview };

struct Circle {
  CanvasPoint center;
  double radius = 0;
  friend bool operator==(const Circle&, const Circle&) = default;
};
/// An upright rectangle with rounded corners.
struct Box {
  Extent extent;
  double corner = 0;
  friend bool operator==(const Box&, const Box&) = default;
};
struct Polyline {
  std::vector<CanvasPoint> points;
  bool closed = false;
  friend bool operator==(const Polyline&, const Polyline&) = default;
};
using Shape = std::variant<Circle, Box, Polyline, Curve>;

/// The dash pattern of a line, in px at zoom 1. Dots have round caps, all others flat ones.
enum class Dash { solid, dashed, dashDotted, dotted };

struct Stroke {
  Shape shape;
  Tint tint;
  double width = 1;
  Dash dash = Dash::solid;
  friend bool operator==(const Stroke&, const Stroke&) = default;
};
struct Fill {
  Shape shape;
  Tint tint;
  friend bool operator==(const Fill&, const Fill&) = default;
};
/// One line of text, centred on a point: horizontally, and vertically by the middle of digits and capitals.
struct Text {
  std::string text;
  CanvasPoint center;
  double size = 12;  ///< px of the em
  bool bold = false;
  Tint tint;
  friend bool operator==(const Text&, const Text&) = default;
};

/// A stroke, a fill or a text, and the element that it shows. Marks of greater z are painted above.
struct Mark {
  ElementId element;
  MarkRole role = MarkRole::line;
  int z = 0;
  std::variant<Stroke, Fill, Text> what;
  friend bool operator==(const Mark&, const Mark&) = default;
};

/// Where an element can be hit: inside the shape, or within halfWidth of a curve.
struct Outline {
  ElementId element;
  int z = 0;
  Shape shape;
  double halfWidth = 0;
  friend bool operator==(const Outline&, const Outline&) = default;
};

/// A drawing as data: screen, SVG, PDF, picking and golden tests all read the same list, in the same order.
/// Colours are named by their role, so a list fits a light and a dark sheet.
struct DisplayList {
  std::vector<Mark> marks;
  std::vector<Outline> outlines;

  void append(DisplayList other);
  /// Sorts the marks into painting order: by z, equal ones in the order of insertion.
  void sortByDepth();
  friend bool operator==(const DisplayList&, const DisplayList&) = default;
};

[[nodiscard]] Extent extentOf(const Shape& shape);
/// With the width of its line, or the estimated size of its text.
[[nodiscard]] Extent extentOf(const Mark& mark);
/// All marks together; a point at the origin for an empty list.
[[nodiscard]] Extent extentOf(const DisplayList& list);

/// One line per mark and per outline, numbers to a tenth, for golden tests.
[[nodiscard]] std::string textOf(const DisplayList& list);

}  // namespace geargraph
