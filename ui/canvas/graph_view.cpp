#include "ui/canvas/graph_view.h"

#include "ui/canvas/context_menu.h"

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

}  // namespace geargraph
