#include "ui/canvas/digraph_view.h"

#include "core/mechanism/model/difference.h"
#include "core/mechanism/model/edits.h"
#include "ui/canvas/cycle_walk.h"

namespace geargraph::inline canvas {
namespace {

constexpr std::size_t kLarge = 1'500;  ///< links; up to here a frame is enough to place all arrows

}  // namespace

DigraphView::DigraphView(Document* document, Selection* selection, QWidget* parent)
    : GraphView(document, selection, new DigraphScene, parent),
      m_scene(static_cast<DigraphScene*>(scene())),
      m_placer(new NodePlacer(this)),
      m_worker([this](const Request& request, const std::stop_token&) { seek(request); }) {
  setAccessibleName(tr("Digraph"));
  connect(m_placer, &NodePlacer::placesFound, this, [this] {
    m_fitWhenDrawn = true;
    rebuild();
    tellWhenSettled();
  });
  connect(m_placer, &NodePlacer::laidOut, this, [this](const NodePositions& positions) {
    m_fitWhenDrawn = true;
    place(positions);
    tellWhenSettled();
  });
  connect(m_scene, &DigraphScene::drawn, this, &DigraphView::tellWhenSettled);
  rebuild();
  updateMessage();
}

void DigraphView::rebuild() {
  const MechanismPtr& now = document().mechanism();
  NodePositions places = m_placer->placesOf(now);
  ++m_wanted;
  if (now->links.size() > kLarge) {
    m_worker.request({now, std::move(places), m_scene->geometry(), m_wanted});
    m_drawn.reset();
    return;
  }
  const bool isThere = m_drawn && isSameDigraph(*m_drawn, *now) && places == m_scene->positions();
  if (!isThere) m_scene->show(*now, std::move(places));
  m_drawn = now;
  m_shown = m_wanted;
}

void DigraphView::seek(const Request& request) {
  auto geometry = std::make_shared<const DigraphGeometry>(
      digraphGeometry(*request.mechanism, request.places, *request.former));
  QMetaObject::invokeMethod(
      this, [this, request, geometry = std::move(geometry)] { arrived(request, geometry); },
      Qt::QueuedConnection);
}

void DigraphView::arrived(const Request& request, const DigraphGeometryPtr& geometry) {
  if (request.number <= m_shown) return;  // of another document, or overtaken
  m_shown = request.number;
  m_scene->show(request.places, geometry);
  tellWhenSettled();
}

bool DigraphView::isSettled() const {
  return !m_placer->isSeeking() && m_shown == m_wanted && m_scene->isDrawn();
}

void DigraphView::tellWhenSettled() {
  updateMessage();
  if (!isSettled()) return;
  if (m_fitWhenDrawn) fit();
  m_fitWhenDrawn = false;
  emit settled();
}

void DigraphView::forgetDocument() {
  GraphView::forgetDocument();
  m_placer->forget();
  m_shown = m_wanted;
  m_fitWhenDrawn = true;
}

QString DigraphView::message() const {
  if (!isSettled()) return tr("Laying out %1 links").arg(mechanism().links.size());
  return GraphView::message();
}

DrawingView::Highlight DigraphView::highlight() const {
  const MeshId mesh = chosenMesh();
  if (mesh.empty()) return {};
  std::optional<CycleWalk> walk = cycleWalk(*snapshot(), mesh);
  if (!walk) return {};
  return {std::move(walk->emphases), {walk->caption}, {}};
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

}  // namespace geargraph::inline canvas
