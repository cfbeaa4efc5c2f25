#include "ui/canvas/tt_graph_scene.h"

#include <utility>

#include "core/presentation/drawing/tt_graph_layout.h"

namespace geargraph {
namespace {

constexpr std::size_t kTtSlice = 1'000;  ///< elements, which take some 10 ms

}  // namespace

TtGraphSheetPtr ttGraphSheet(const Mechanism& mechanism, const TtGraph* graph, NodePositions layout,
                             const std::stop_token& stop) {
  if (layout.empty()) layout = ttLayout(mechanism, graph);
  if (stop.stop_requested()) return nullptr;
  NodePositions positions = ttPositions(layout, mechanism.view.ttNodes);
  TtGraphGeometry geometry = ttGraphGeometry(mechanism, graph, positions);
  if (stop.stop_requested()) return nullptr;
  TtElements elements(geometry);
  DisplayList drawing = ttGraphDrawing(geometry, {});
  return std::make_shared<TtGraphSheet>(
      TtGraphSheet{std::move(layout), std::move(positions), std::move(geometry), std::move(elements),
                   SheetParts(std::move(drawing.marks)), std::move(drawing.outlines)});
}

TtGraphScene::TtGraphScene(QObject* parent) : DrawingScene(parent) {}

void TtGraphScene::show(TtGraphSheetPtr sheet) {
  m_sheet = std::move(sheet);
  setParts(std::move(m_sheet->parts), std::move(m_sheet->outlines));
  m_stale.clear();
  std::unordered_set<ElementId> outstanding;
  for (const auto& [element, emphasis] : emphases()) outstanding.insert(element);
  drawAgain(outstanding);
}

void TtGraphScene::drawAgain(const std::unordered_set<ElementId>& changed) {
  if (m_stale.empty()) {
    m_stale = changed;
  } else {
    m_stale.insert(changed.begin(), changed.end());
  }
  if (m_stale.size() <= kTtSlice) return drawSlice();
  m_sliceTurn.request();
}

void TtGraphScene::drawSlice() {
  if (!m_sheet) return m_stale.clear();
  for (std::size_t left = kTtSlice; left > 0 && !m_stale.empty(); --left) {
    const ElementId element = *m_stale.begin();
    m_stale.erase(m_stale.begin());
    DisplayList drawing =
        m_sheet->elements.drawing(m_sheet->geometry, element, emphasisOf(emphases(), element));
    setElement(element, std::move(drawing.marks));
  }
  if (!m_stale.empty()) m_sliceTurn.request();
}

DrawingScene::Draw TtGraphScene::drawing() const {
  return [sheet = std::shared_ptr<const TtGraphSheet>(m_sheet)](const Emphases& emphases) {
    return sheet ? ttGraphDrawing(sheet->geometry, emphases) : DisplayList{};
  };
}

}  // namespace geargraph

#include "moc_tt_graph_scene.cpp"
