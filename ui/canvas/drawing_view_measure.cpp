// Measuring in a drawing: what is clicked is taken, what is measured is painted over it.

#include <algorithm>

#include "ui/canvas/drawing_view.h"
#include "ui/canvas/mark_painter.h"
#include "ui/workbench/measuring.h"

namespace geargraph {
namespace {

/// The point of a line nearest to another point.
CanvasPoint footOn(const Curve& line, CanvasPoint from) {
  const CanvasPoint way = line.to - line.from;
  const double square = dot(way, way);
  const double along = square > 0 ? std::clamp(dot(from - line.from, way) / square, 0.0, 1.0) : 0;
  return line.from + along * way;
}

}  // namespace

void DrawingView::setMeasuring(Measuring* measuring) {
  m_measuring = measuring;
  connect(this, &DrawingView::toolChanged, measuring,
          [measuring](ToolKind tool) { measuring->setOn(tool == ToolKind::measure); });
  connect(measuring, &Measuring::switched, this, [this](bool on) {
    if (!on && tool() == ToolKind::measure) setTool(ToolKind::select);
  });
  connect(measuring, &Measuring::changed, this, [this] {
    if (m_measuring->isOn() && tool() == ToolKind::measure) setHint(m_measuring->hint());
    viewport()->update();
  });
}

void DrawingView::measureFrom(const Pointer& pointer) {
  if (m_measuring != nullptr && pointer.on) m_measuring->take(*pointer.on, spaceAt(pointer.at));
}

std::optional<CanvasPoint> DrawingView::placeOfTaken(std::size_t which, const CanvasPoint& other) const {
  const Measuring::Taken& taken = m_measuring->taken()[which];
  if (!taken.spot.isPoint()) {
    for (const Outline& outline : m_scene->outlines()) {
      const auto* line = std::get_if<Curve>(&outline.shape);
      if (line != nullptr && outline.element == taken.spot.element) return footOn(*line, other);
    }
  }
  const auto middle = middleOf(taken.element);
  return middle ? middle : middleOf(taken.spot.element);
}

void DrawingView::drawMeasured(QPainter& painter) const {
  if (m_measuring->taken().empty()) return;
  const CanvasPoint nowhere = toSheetPoint(mapToScene(viewport()->rect().center()));
  std::vector<QPointF> ends;
  const auto add = [&](const std::optional<CanvasPoint>& place) {
    if (place) ends.emplace_back(mapFromScene(toQPoint(*place)));
  };
  if (m_measuring->taken().size() == 1) {
    add(placeOfTaken(0, nowhere));
  } else {
    const CanvasPoint second = placeOfTaken(1, placeOfTaken(0, nowhere).value_or(nowhere)).value_or(nowhere);
    const auto first = placeOfTaken(0, second);
    add(first);
    add(placeOfTaken(1, first.value_or(nowhere)));
  }
  painter.setFont(font());
  paintMeasured(painter, ends, m_measuring->lines(), viewport()->rect(), theme() != Theme::light);
}

}  // namespace geargraph
