#include "ui/canvas/digraph_scene.h"

#include <algorithm>
#include <utility>

#include "core/presentation/drawing/coupling_marks.h"
#include "core/presentation/drawing/note_marks.h"

namespace geargraph {
namespace {

constexpr std::size_t kSlice = 1'000;  ///< elements, which take some 12 ms

/// How many outlines an element has: an arrow's line and label, a node's disc and badge, a coupling's line
/// and plates, a note's box.
std::size_t outlinesOf(const EdgePlace&) {
  return 2;
}
std::size_t outlinesOf(const NodePlace& node) {
  return node.input ? 2 : 1;
}
std::size_t outlinesOf(const ShiftElementPlace&) {
  return 2;
}
std::size_t outlinesOf(const NotePlace&) {
  return 1;
}

/// Do both show the same elements in the same order?
bool hasSameOutlines(const DigraphGeometry& a, const DigraphGeometry& b) {
  const auto sameEdge = [](const EdgePlace& x, const EdgePlace& y) { return x.element == y.element; };
  const auto sameNode = [](const NodePlace& x, const NodePlace& y) {
    return x.link == y.link && x.input == y.input;
  };
  return std::equal(a.edges.begin(), a.edges.end(), b.edges.begin(), b.edges.end(), sameEdge) &&
         std::equal(a.nodes.begin(), a.nodes.end(), b.nodes.begin(), b.nodes.end(), sameNode) &&
         std::equal(a.couplings.begin(), a.couplings.end(), b.couplings.begin(), b.couplings.end(),
                    [](const ShiftElementPlace& x, const ShiftElementPlace& y) {
                      return x.coupling == y.coupling;
                    }) &&
         std::equal(a.notes.begin(), a.notes.end(), b.notes.begin(), b.notes.end(),
                    [](const NotePlace& x, const NotePlace& y) { return x.note == y.note; });
}

/// Of everything that is put up.
std::size_t sizeOf(const DigraphGeometry& geometry) {
  return geometry.edges.size() + geometry.nodes.size() + geometry.couplings.size() + geometry.notes.size();
}

}  // namespace

void DigraphScene::show(const Mechanism& mechanism, NodePositions positions) {
  auto geometry = std::make_shared<const DigraphGeometry>(digraphGeometry(mechanism, positions, *m_geometry));
  show(std::move(positions), std::move(geometry));
}

void DigraphScene::show(NodePositions positions, DigraphGeometryPtr geometry) {
  m_positions = std::move(positions);
  const DigraphGeometryPtr former = std::exchange(m_geometry, std::move(geometry));
  if (!m_putUp && hasSameOutlines(*former, *m_geometry)) {
    drawWhatDiffers(*former);
  } else {
    drawAll();
  }
}

void DigraphScene::drawAll() {
  constexpr std::size_t kLarge = 2'000;  // elements, which take some 25 ms
  const std::size_t size = sizeOf(*m_geometry);
  const bool isUnderWay = m_putUp.has_value();
  editableOutlines().clear();
  m_slots.clear();
  std::size_t slot = 0;
  const auto take = [&](const auto& places) {
    for (const auto& place : places) m_slots.push_back(std::exchange(slot, slot + outlinesOf(place)));
  };
  take(m_geometry->edges);
  take(m_geometry->nodes);
  take(m_geometry->couplings);
  take(m_geometry->notes);
  m_isStale.assign(size, false);
  m_staleCount = 0;
  m_staleFrom = 0;
  m_isMoving = false;
  beginDrawing();
  m_putUp = 0;
  if (size <= kLarge) {
    putUp(size);
  } else if (!isUnderWay) {
    GuiTaskQueue::instance().later(this, [this] { putUpSlice(); });
  }  // else the next slice comes by itself
}

void DigraphScene::putUp(std::size_t end) {
  std::vector<Outline>& all = editableOutlines();
  for (; *m_putUp < end; ++*m_putUp) {
    const std::vector<Outline> outlines = drawAt(*m_putUp);
    all.insert(all.end(), outlines.begin(), outlines.end());
  }
  if (end < sizeOf(*m_geometry)) return;
  m_putUp.reset();
  endDrawing();
}

void DigraphScene::putUpSlice() {
  if (!m_putUp) return;  // a small drawing came in between
  const std::size_t size = sizeOf(*m_geometry);
  putUp(std::min(*m_putUp + kSlice, size));
  if (isDrawn()) {
    emit drawn();
  } else {
    GuiTaskQueue::instance().later(this, [this] { putUpSlice(); });
  }
}

void DigraphScene::drawWhatDiffers(const DigraphGeometry& former) {
  std::size_t at = 0;
  const auto compare = [&](const auto& before, const auto& now) {
    for (std::size_t i = 0; i < now.size(); ++i, ++at) {
      if (!(before[i] == now[i])) markStale(at);
    }
  };
  compare(former.edges, m_geometry->edges);
  compare(former.nodes, m_geometry->nodes);
  compare(former.couplings, m_geometry->couplings);
  compare(former.notes, m_geometry->notes);
  m_isMoving = m_staleCount > kSlice;
  drawStale();
}

void DigraphScene::markStale(std::size_t at) {
  if (m_isStale[at]) return;
  m_isStale[at] = true;
  ++m_staleCount;
  m_staleFrom = std::min(m_staleFrom, at);
}

void DigraphScene::drawStale() {
  if (m_staleCount <= kSlice) return drawStaleSlice();
  m_sliceTurn.request();
}

void DigraphScene::drawStaleSlice() {
  for (std::size_t left = std::min(kSlice, m_staleCount); left > 0; ++m_staleFrom) {
    if (!m_isStale[m_staleFrom]) continue;
    m_isStale[m_staleFrom] = false;
    --m_staleCount;
    --left;
    const std::vector<Outline> outlines = drawAt(m_staleFrom);
    if (!m_putUp) {  // else they come with the others
      std::copy(outlines.begin(), outlines.end(),
                editableOutlines().begin() + static_cast<std::ptrdiff_t>(m_slots[m_staleFrom]));
    }
  }
  if (m_staleCount > 0) return drawStale();
  m_staleFrom = m_isStale.size();
  if (!m_putUp) growSheet();
  if (std::exchange(m_isMoving, false)) emit drawn();
}

ElementId DigraphScene::elementAt(std::size_t at) const {
  const std::size_t edges = m_geometry->edges.size();
  const std::size_t nodes = m_geometry->nodes.size();
  if (at < edges) return m_geometry->edges[at].element;
  if (at < edges + nodes) return m_geometry->nodes[at - edges].link;
  const std::size_t couplings = m_geometry->couplings.size();
  if (at < edges + nodes + couplings) return m_geometry->couplings[at - edges - nodes].coupling;
  return m_geometry->notes[at - edges - nodes - couplings].note;
}

std::vector<Outline> DigraphScene::drawAt(std::size_t at) {
  const std::size_t edges = m_geometry->edges.size();
  const std::size_t nodes = m_geometry->nodes.size();
  if (at < edges) return draw(m_geometry->edges[at]);
  if (at < edges + nodes) return draw(m_geometry->nodes[at - edges]);
  const std::size_t couplings = m_geometry->couplings.size();
  if (at < edges + nodes + couplings) return draw(m_geometry->couplings[at - edges - nodes]);
  return draw(m_geometry->notes[at - edges - nodes - couplings]);
}

std::vector<Outline> DigraphScene::draw(const NodePlace& node) {
  DisplayList drawing = nodeDrawing(node, emphasisOf(emphases(), node.link));
  std::vector<Outline> outlines = std::move(drawing.outlines);
  redraw(node.link, std::move(drawing), kNodeDepth);
  return outlines;
}

std::vector<Outline> DigraphScene::draw(const EdgePlace& edge) {
  DisplayList drawing = edgeDrawing(edge, emphasisOf(emphases(), edge.element));
  std::vector<Outline> outlines = std::move(drawing.outlines);
  redraw(edge.element, std::move(drawing), kLineDepth);
  return outlines;
}

std::vector<Outline> DigraphScene::draw(const ShiftElementPlace& place) {
  DisplayList drawing = couplingDrawing(place, emphasisOf(emphases(), place.coupling));
  std::vector<Outline> outlines = std::move(drawing.outlines);
  redraw(place.coupling, std::move(drawing), kLineDepth);
  return outlines;
}

std::vector<Outline> DigraphScene::draw(const NotePlace& place) {
  DisplayList drawing = noteDrawing(place, emphasisOf(emphases(), place.note));
  std::vector<Outline> outlines = std::move(drawing.outlines);
  redraw(place.note, std::move(drawing), kNoteDepth);
  return outlines;
}

void DigraphScene::redraw(const ElementId& element, DisplayList drawing, int depth) {
  const auto behind = std::stable_partition(drawing.marks.begin(), drawing.marks.end(),
                                            [](const Mark& mark) { return mark.role != MarkRole::halo; });
  std::vector<Mark> halo(std::make_move_iterator(behind), std::make_move_iterator(drawing.marks.end()));
  drawing.marks.erase(behind, drawing.marks.end());
  setPart(element, depth, std::move(drawing.marks));
  setPart(element, kHaloDepth, std::move(halo));
}

void DigraphScene::drawAgain(const std::unordered_set<ElementId>& changed) {
  for (std::size_t at = 0; at < m_isStale.size(); ++at) {
    if (changed.contains(elementAt(at))) markStale(at);
  }
  drawStale();
}

DrawingScene::Draw DigraphScene::drawing() const {
  return [geometry = m_geometry](const Emphases& emphases) { return digraphDrawing(*geometry, emphases); };
}

}  // namespace geargraph

#include "moc_digraph_scene.cpp"
