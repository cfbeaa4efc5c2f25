#include "ui/canvas/digraph_view.h"

namespace geargraph {

class DigraphView::Private {
 public:
  ToolKind tool = ToolKind::select;
  Theme theme = Theme::light;
};

DigraphView::DigraphView(Document*, Selection*, QWidget* parent)
    : QGraphicsView(parent), d(std::make_unique<Private>()) {}
DigraphView::~DigraphView() = default;

ToolKind DigraphView::tool() const {
  return d->tool;
}
void DigraphView::setTool(ToolKind tool) {
  if (tool == d->tool) return;
  d->tool = tool;
  emit toolChanged(tool);
}
QString DigraphView::hint() const {
  return {};
}
void DigraphView::setSnapshot(const SnapshotPtr&) {}
void DigraphView::showCycle(MeshId) {}
void DigraphView::setDark(bool dark) {
  d->theme = dark ? Theme::dark : Theme::light;
}
Theme DigraphView::theme() const {
  return d->theme;
}
void DigraphView::fit() {}
void DigraphView::zoomIn() {}
void DigraphView::zoomOut() {}
void DigraphView::resetZoom() {}
void DigraphView::selectAll() {}
void DigraphView::deleteSelected() {}
void DigraphView::flipSelected() {}
void DigraphView::renameSelected() {}
void DigraphView::toggleInputs() {}
void DigraphView::tidy() {}

}  // namespace geargraph
