#include "core/presentation/mechanism_scene/scene_labels.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <sstream>

#include "core/foundations/base/translation.h"
#include "core/presentation/drawing/text_metrics.h"
#include "core/presentation/mechanism_scene/power_overlay.h"
#include "core/presentation/mechanism_scene/train_forces.h"
#include "core/presentation/scene3d/force_arrow_shape.h"

namespace geargraph {
namespace {

constexpr double kTextSize = 12;
constexpr double kRing = 2.2;
constexpr double kLine = 1.4, kDot = 2.2, kRim = 1;  // of a label's line; its rim sets it off from any part
constexpr double kMaxBarLength = 110, kFromEdge = 16, kFromBelow = 24, kTick = 4;

/// The tint that a label's colour is: that of a link.
Tint tintOf(const MechanismScene& stage, const SceneLabel& label) {
  for (const SceneLabel& other : stage.labels) {
    if (other.kind == LabelKind::link && other.colour == label.colour)
      return Tint::ofLink(std::stoi(other.text), other.colourNumber);
  }
  return ColorRole::secondary;
}

Box boxAbout(CanvasPoint middle, double halfWidth, double halfHeight, double corner) {
  const CanvasPoint half{halfWidth, halfHeight};
  return {Extent::spanning(middle - half, middle + half), corner};
}

Shape plateOf(LabelKind kind, CanvasPoint middle) {
  constexpr double kHalf = kLabelRadius;
  if (kind == LabelKind::link) return Circle{middle, kHalf};
  if (kind == LabelKind::joint) return boxAbout(middle, kHalf - 1, kHalf - 1, 0);
  return boxAbout(middle, kHalf, kHalf - 2, 4);
}

CanvasPoint sheetPoint(const Eigen::Vector2d& point) {
  return {point.x(), point.y()};
}

/// The line to what the label speaks of, with a dot at its end.
void addLine(DisplayList& list, const MechanismScene& stage, const LabelPlate& place) {
  const SceneLabel& label = stage.labels[place.label];
  const Tint tint = tintOf(stage, label);
  const auto add = [&](auto what) {
    list.marks.push_back({label.element, MarkRole::line, 0, std::move(what)});
  };
  const Curve line = Curve::straight(sheetPoint(place.rim()), sheetPoint(place.anchor));
  const Shape dot = Circle{sheetPoint(place.anchor), kDot};
  add(Stroke{line, ColorRole::sheet, kLine + 2 * kRim, Dash::solid});
  add(Fill{Circle{sheetPoint(place.anchor), kDot + kRim}, ColorRole::sheet});
  add(Stroke{line, tint, kLine, Dash::solid});
  add(Fill{dot, tint});
}

void addLabel(DisplayList& list, const MechanismScene& stage, const LabelPlate& place) {
  const SceneLabel& label = stage.labels[place.label];
  const CanvasPoint middle = sheetPoint(place.middle);
  const Shape plate = plateOf(label.kind, middle);
  const auto add = [&](MarkRole role, auto what) {
    list.marks.push_back({label.element, role, 0, std::move(what)});
  };
  add(MarkRole::node, Fill{plate, ColorRole::sheet});
  if (label.kind != LabelKind::axis)
    add(MarkRole::node, Stroke{plate, tintOf(stage, label), kRing, Dash::solid});
  const bool bold = label.kind != LabelKind::axis;
  const double room = 2 * kLabelRadius - 7, width = textWidth(label.text, kTextSize, bold);
  const double size = width > room ? std::max(6.0, kTextSize * room / width) : kTextSize;
  add(MarkRole::label, Text{label.text, middle, size, bold, ColorRole::ink});
}

/// As long as a round number of length units, at the depth of the view's middle.
void addScaleBar(DisplayList& list, const ScenePainter& painter) {
  const Viewport& size = painter.rendering().size;
  const double ratio = painter.pixelRatio();
  const double perPixel = painter.view().camera.millimetresPerPixel(size) * ratio;
  const double length = niceLength(perPixel, kMaxBarLength);
  const double right = size.width / ratio - kFromEdge, left = right - length / perPixel;
  const double y = size.height / ratio - kFromBelow;
  const auto bar = [&](CanvasPoint from, CanvasPoint to) {
    list.marks.push_back(
        {ElementId(), MarkRole::line, 0, Fill{Box{Extent::spanning(from, to), 0}, ColorRole::secondary}});
  };
  bar({left, y - 1}, {right, y + 0.6});
  bar({left, y - kTick}, {left + 1.6, y + kTick});
  bar({right - 1.6, y - kTick}, {right, y + kTick});
  std::array<char, 32> number{};
  std::snprintf(number.data(), number.size(), "%.6g ", length);
  const std::string text = number.data() + painter.rendering().stage->unit;
  const CanvasPoint middle{right - textWidth(text, kTextSize, false) / 2, y - 13};
  list.marks.push_back(
      {ElementId(), MarkRole::label, 0, Text{text, middle, kTextSize, false, ColorRole::secondary}});
}

Tint tintOf(ForceKind kind) {
  return kind == ForceKind::tooth ? ColorRole::ink : ColorRole::accent;
}

/// Cased in the colour of the sheet, shaft and head as one.
std::vector<Mark> arrowMarks(const ForceArrowShape& shape, const Tint& tint) {
  std::vector<Mark> marks;
  const auto put = [&](auto what) { marks.push_back({ElementId(), MarkRole::line, 0, std::move(what)}); };
  if (shape.isDisc) {
    put(Fill{Circle{sheetPoint(shape.from), kForceDisc + kForceCasing}, ColorRole::sheet});
    put(Fill{Circle{sheetPoint(shape.from), kForceDisc}, tint});
    return marks;
  }
  const Shape shaft = Curve::straight(sheetPoint(shape.from), sheetPoint(shape.neck));
  Polyline head;
  for (const Eigen::Vector2d& corner : shape.head) head.points.push_back(sheetPoint(corner));
  head.closed = true;
  put(Stroke{shaft, ColorRole::sheet, kForceShaft + 2 * kForceCasing, Dash::solid});
  put(Stroke{head, ColorRole::sheet, 2 * kForceCasing, Dash::solid});
  put(Stroke{shaft, tint, kForceShaft, Dash::solid});
  put(Fill{head, tint});
  return marks;
}

/// The arrows, a box in the arrow's colour beside each of the greatest forces, and the legend. Returns where
/// the legend ends.
double addForceLabels(DisplayList& list, ScenePainter& painter, const LabelGround& ground) {
  const SceneView& view = painter.seen().view();
  const std::vector<ForceArrow> arrows = painter.seen().forceArrows();
  if (arrows.empty()) return kFromEdge;
  const auto put = [&](const ElementId& element, MarkRole role, auto what) {
    list.marks.push_back({element, role, 0, std::move(what)});
  };
  for (const ForceArrow& arrow : arrows) {
    const SceneForce& force = (*view.forces)[arrow.force];
    for (Mark& mark : arrowMarks(forceArrowShape(arrow, ground), tintOf(force.kind))) {
      mark.element = force.element;
      list.marks.push_back(std::move(mark));
    }
  }
  const auto widthOf = [](const std::string& text) { return textWidth(text, kTextSize, false); };
  for (const ForceLabel& label : placeForceLabels(*view.forces, arrows, {}, ground, widthOf)) {
    const SceneForce& force = (*view.forces)[label.force];
    const Box box = boxAbout(sheetPoint(label.middle), label.half.x(), label.half.y(), 2);
    put(force.element, MarkRole::node, Fill{box, ColorRole::sheet});
    put(force.element, MarkRole::node, Stroke{box, tintOf(force.kind), 1.2, Dash::solid});
    put(force.element, MarkRole::label,
        Text{force.text, sheetPoint(label.middle), kTextSize, false, ColorRole::ink});
  }
  double line = kFromEdge;
  const double widest = std::max(widthOf(translated(forceLegend(ForceKind::tooth))),
                                 widthOf(translated(forceLegend(ForceKind::bearing))));
  for (const ForceKind kind : {ForceKind::tooth, ForceKind::bearing}) {
    const std::string text = translated(forceLegend(kind));
    const double width = widthOf(text);
    put({}, MarkRole::line,
        Fill{boxAbout({kFromEdge + (widest + 44) / 2, line}, (widest + 52) / 2, 10, 0), ColorRole::sheet});
    put({}, MarkRole::line,
        Stroke{Polyline{{{kFromEdge + 4, line}, {kFromEdge + 30, line}}, false}, tintOf(kind), 2.8,
               Dash::solid});
    put({}, MarkRole::label,
        Text{text, {kFromEdge + 40 + width / 2, line}, kTextSize, false, ColorRole::ink});
    line += 20;
  }
  return line;
}

/// Its words in lines that are no wider than `room`.
std::vector<std::string> wrapped(const std::string& text, double room) {
  std::vector<std::string> lines;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const std::string longer = lines.empty() ? word : lines.back() + ' ' + word;
    if (!lines.empty() && textWidth(longer, kTextSize, false) <= room) {
      lines.back() = longer;
    } else {
      lines.push_back(word);
    }
  }
  return lines;
}

/// From this line on, on a plate of the sheet's colour, its lines below each other in the middle. Returns
/// where the next line is.
double addCaption(DisplayList& list, const ScenePainter& painter, const std::string& caption, double line) {
  constexpr double kWidestCaption = 380;
  constexpr double kLineHeight = 16;
  const double room = painter.rendering().size.width / painter.pixelRatio() - 2 * kFromEdge;
  const std::vector<std::string> lines = wrapped(caption, std::min(kWidestCaption, room));
  if (lines.empty()) return line;
  double half = 0;
  for (const std::string& text : lines) half = std::max(half, textWidth(text, kTextSize, false) / 2);
  const double height = kLineHeight * static_cast<double>(lines.size());
  const CanvasPoint middle{kFromEdge + 4 + half, line + (height - kLineHeight) / 2};
  list.marks.push_back({ElementId(), MarkRole::line, 0,
                        Fill{boxAbout(middle, half + 4, height / 2 + 2, 0), ColorRole::sheet}});
  for (const std::string& text : lines) {
    list.marks.push_back(
        {ElementId(), MarkRole::label, 0, Text{text, {middle.x, line}, kTextSize, false, ColorRole::ink}});
    line += kLineHeight;
  }
  return line + 4;
}

}  // namespace

SceneLabels::SceneLabels(const OverlayChoice& choice) : m_choice(choice) {
  m_places.setShown(LabelKind::link, choice.links);
  m_places.setShown(LabelKind::joint, choice.joints);
  m_places.setShown(LabelKind::axis, choice.axes);
}

DisplayList SceneLabels::over(ScenePainter& painter) {
  const MechanismScene& stage = painter.seen().stage();
  const VisibilityBuffer seen = painter.seenForLabels();
  const LabelGround ground = painter.labelGround(seen);
  const std::vector<LabelPlate> places = m_places.find(ground);
  DisplayList list;
  for (const LabelPlate& place : places) {
    if (place.hasLine()) addLine(list, stage, place);
  }
  for (const LabelPlate& place : places) addLabel(list, stage, place);
  double line = kFromEdge;
  if (m_choice.forces) line = addForceLabels(list, painter, ground);
  if (m_choice.forces || m_choice.power) line = addCaption(list, painter, m_caption, line);
  if (m_choice.power && m_power) {
    const DisplayList arrows = powerOver(*m_power, ground, basePose(stage, painter.seen().view()), line);
    list.marks.insert(list.marks.end(), arrows.marks.begin(), arrows.marks.end());
  }
  if (m_choice.scaleBar) addScaleBar(list, painter);
  return list;
}

}  // namespace geargraph
