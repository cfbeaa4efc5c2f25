#pragma once

#include <memory>
#include <optional>

#include "core/presentation/drawing/digraph_drawing.h"
#include "ui/canvas/drawing_scene.h"
#include "ui/service/turns.h"

namespace geargraph {

using DigraphGeometryPtr = std::shared_ptr<const DigraphGeometry>;

/// The drawing of the digraph on a scene. Only changed parts are placed and drawn again, so that dragging one
/// node of a thousand stays smooth; a large new drawing, and changes of thousands of elements, are drawn in
/// slices, between which the window stays responsive.
class DigraphScene final : public DrawingScene {
  Q_OBJECT

 public:
  using DrawingScene::DrawingScene;

  /// Shows a mechanism with its nodes at these places.
  void show(const Mechanism& mechanism, NodePositions positions);
  /// The same with the result of digraphGeometry() for them.
  void show(NodePositions positions, DigraphGeometryPtr geometry);

  /// Never null.
  [[nodiscard]] const DigraphGeometryPtr& geometry() const { return m_geometry; }
  /// Is everything drawn in its place? Highlights may still be pending.
  [[nodiscard]] bool isDrawn() const { return !m_putUp && !m_isMoving; }

  [[nodiscard]] const NodePositions& positions() const { return m_positions; }
  [[nodiscard]] Draw drawing() const override;

 signals:
  void drawn();  ///< a large drawing, or a change of one, is complete

 protected:
  void drawAgain(const std::unordered_set<ElementId>& changed) override;

 private:
  void redraw(const ElementId& element, DisplayList drawing, int depth);
  void drawAll();
  void putUp(std::size_t end);
  void putUpSlice();
  void drawWhatDiffers(const DigraphGeometry& former);
  void markStale(std::size_t at);
  void drawStale();
  void drawStaleSlice();
  [[nodiscard]] ElementId elementAt(std::size_t at) const;
  std::vector<Outline> drawAt(std::size_t at);
  std::vector<Outline> draw(const NodePlace& node);
  std::vector<Outline> draw(const EdgePlace& edge);
  std::vector<Outline> draw(const ShiftElementPlace& place);
  std::vector<Outline> draw(const NotePlace& place);

  NodePositions m_positions;
  DigraphGeometryPtr m_geometry = std::make_shared<const DigraphGeometry>();
  std::optional<std::size_t> m_putUp;  ///< arrows, nodes, ... drawn so far; empty: not drawing
  // By arrow, node, coupling, note, in this order:
  std::vector<std::size_t> m_slots;  ///< its first outline
  std::vector<bool> m_isStale;       ///< it is to be drawn again
  std::size_t m_staleCount = 0;
  std::size_t m_staleFrom = 0;  ///< index of the first stale one
  bool m_isMoving = false;      ///< some stale ones have moved
  CoalescedTask m_sliceTurn{this, [this] { drawStaleSlice(); }};
};

}  // namespace geargraph
