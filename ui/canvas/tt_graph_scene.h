#pragma once

#include <deque>
#include <memory>
#include <stop_token>

#include "core/presentation/drawing/tt_graph_drawing.h"
#include "ui/canvas/drawing_scene.h"
#include "ui/service/turns.h"

namespace geargraph {

/// A T-T graph with layout, geometry and parts: a value that any thread can make.
struct TtGraphSheet {
  NodePositions layout;     ///< without dragged nodes
  NodePositions positions;  ///< with dragged nodes
  TtGraphGeometry geometry;
  TtElements elements;  ///< of the geometry
  SheetParts parts;     ///< without highlights
  std::vector<Outline> outlines;
};
using TtGraphSheetPtr = std::shared_ptr<TtGraphSheet>;

/// `layout` may be empty: then it is computed too. Cost: near linear in links + joints + meshes, some 300 ms
/// for 10,000 links; null if `stop` was requested meanwhile.
/// @pre `graph` is the mechanism's, or null where the turning joints are no spanning tree
[[nodiscard]] TtGraphSheetPtr ttGraphSheet(const Mechanism& mechanism, const TtGraph* graph,
                                           NodePositions layout, const std::stop_token& stop = {});

/// The drawing of the T-T graph on a scene. A new one is replaced as a whole; highlights are drawn element by
/// element, thousands of them in slices, between which the window stays responsive.
class TtGraphScene final : public DrawingScene {
  Q_OBJECT

 public:
  explicit TtGraphScene(QObject* parent = nullptr);

  /// Shows the sheet, moving its parts out of it.
  void show(TtGraphSheetPtr sheet);
  /// Null until the first one is shown.
  [[nodiscard]] const TtGraphSheet* sheet() const { return m_sheet.get(); }
  [[nodiscard]] Draw drawing() const override;

 protected:
  void drawAgain(const std::unordered_set<ElementId>& changed) override;

 private:
  void drawSlice();

  TtGraphSheetPtr m_sheet;
  std::unordered_set<ElementId> m_stale;  ///< to be drawn again
  CoalescedTask m_sliceTurn{this, [this] { drawSlice(); }};
};

}  // namespace geargraph
