#include "ui/canvas/digraph_view.h"

#include "core/mechanism/edits.h"
#include "ui/canvas/cycle_walk.h"

namespace geargraph {
namespace {

bool isMesh(const ElementId& element) {
  return element.kind == ElementKind::gearMesh;
}

}  // namespace

DigraphView::DigraphView(Document* document, Selection* selection, QWidget* parent)
    : GraphView(document, selection, new DigraphScene, parent),
      m_scene(static_cast<DigraphScene*>(scene())),
      m_placer(new NodePlacer(this)) {
  setAccessibleName(tr("Digraph"));
  connect(m_placer, &NodePlacer::placesFound, this, [this] {
    rebuild();
    updateMessage();
    fit();
  });
  connect(m_placer, &NodePlacer::laidOut, this, [this](const NodePositions& positions) {
    place(positions);
    fit();
  });
  rebuild();
  updateMessage();
}

void DigraphView::rebuild() {
  const MechanismPtr& now = document().mechanism();
  m_scene->show(*now, m_placer->placesOf(now));
}

void DigraphView::forgetDocument() {
  m_placer->forget();
  m_wantedCycle = {};
}

QString DigraphView::message() const {
  if (m_placer->isSeeking()) return tr("Laying out %1 links").arg(mechanism().links.size());
  return GraphView::message();
}

std::optional<CycleWalk> DigraphView::shownCycle() const {
  if (!snapshot()) return std::nullopt;
  if (!m_wantedCycle.empty()) return cycleWalk(*snapshot(), m_wantedCycle);
  // Another view that shows a row of C under the mouse hovers all that is on the cycle.
  const std::set<ElementId>& hovered = selection().hovered();
  const auto mesh = std::find_if(hovered.begin(), hovered.end(), isMesh);
  if (hovered.size() > 1 && mesh != hovered.end()) {
    std::optional<CycleWalk> walk = cycleWalk(*snapshot(), MeshId(mesh->id));
    const auto isOn = [&](const ElementId& element) { return walk->emphases.contains(element); };
    if (walk && walk->emphases.size() == hovered.size() &&
        std::all_of(hovered.begin(), hovered.end(), isOn)) {
      return walk;
    }
  }
  const std::set<ElementId>& selected = selection().selected();
  if (selected.size() != 1 || !isMesh(*selected.begin())) return std::nullopt;
  return cycleWalk(*snapshot(), MeshId(selected.begin()->id));
}

DrawingView::Highlight DigraphView::highlight() const {
  std::optional<CycleWalk> walk = shownCycle();
  if (!walk) return {};
  return {std::move(walk->emphases), {walk->caption}};
}

void DigraphView::showCycle(MeshId mesh) {
  m_wantedCycle = mesh;
  updateEmphases();
}

void DigraphView::tidy() {
  m_placer->layOut(document().mechanism());
}

Expected<Mechanism> DigraphView::withMoved(const Mechanism& mechanism, const NodeMoves& places) const {
  return withNodesMoved(m_placer->adopted(mechanism), places);
}

Expected<Mechanism> DigraphView::withLinkAt(const Mechanism& mechanism, SheetPoint at) const {
  return withLink(m_placer->adopted(mechanism), at);
}

}  // namespace geargraph
