#include "ui/canvas/graph_view.h"

#include <QPainter>
#include <cmath>

#include "ui/canvas/context_menu.h"
#include "ui/canvas/mark_painter.h"

namespace geargraph {

GraphView::GraphView(Document* document, Selection* selection, DrawingScene* scene, QWidget* parent)
    : DrawingView(document, selection, scene, parent),
      m_sheet(scene),
      m_controller(new ToolController(*document, *selection, *this, this)) {
  connect(m_controller, &ToolController::toolChanged, this, [this](ToolKind tool) {
    updateCursor();
    emit toolChanged(tool);
  });
  connect(m_controller, &ToolController::hintChanged, this, &GraphView::setHint);
  connect(m_controller, &ToolController::previewChanged, this, &GraphView::previewChanged);
  connect(m_controller, &ToolController::panned, this, &GraphView::panBy);
  setHint(m_controller->hint());
}

QString GraphView::message() const {
  return mechanism().links.size() == 1 ? tr("Draw the first link: L, then click") : QString();
}

void GraphView::toggleInputs() {
  m_controller->toggleInputs(selection().selected());
}

void GraphView::adjustMenu(ContextActions& actions, SheetPoint at) {
  actions.addLink = [this, at] { m_controller->addLink(at); };
  actions.tidy = [this] { tidy(); };
}

void GraphView::pressed(const Pointer& pointer) {
  m_controller->handle(Pressed{pointer}, scaleNow());
}

void GraphView::moved(const Pointer& pointer) {
  m_controller->handle(Moved{pointer}, scaleNow());
}

void GraphView::released(const Pointer& pointer) {
  m_controller->handle(Released{pointer}, scaleNow());
}

bool GraphView::cancel() {
  if (m_controller->isIdle()) return false;
  m_controller->handle(Escaped{}, scaleNow());
  return true;
}

void GraphView::setGrid(bool on) {
  m_controller->setGrid(on);
  viewport()->update();
}

void GraphView::drawBackground(QPainter* painter, const QRectF& rect) {
  DrawingView::drawBackground(painter, rect);
  constexpr double kStep = ToolController::kGridStep;
  constexpr double kDensest = 7;  // px between two dots
  if (!m_controller->hasGrid() || kStep * scaleNow() < kDensest) return;
  QPen dots(toQColor(colorOf(ColorRole::secondary, theme())), 1.6 / scaleNow());
  dots.setCapStyle(Qt::RoundCap);
  painter->setPen(dots);
  for (double x = kStep * std::floor(rect.left() / kStep); x <= rect.right(); x += kStep) {
    for (double y = kStep * std::floor(rect.top() / kStep); y <= rect.bottom(); y += kStep) {
      painter->drawPoint(QPointF(x, y));
    }
  }
}

}  // namespace geargraph
