#pragma once

#include <memory>
#include <optional>

#include "core/presentation/drawing/digraph_drawing.h"
#include "ui/canvas/drawing_scene.h"

namespace geargraph::inline canvas {

using DigraphGeometryPtr = std::shared_ptr<const DigraphGeometry>;

/// The drawing of the digraph on a scene. It places and draws again only what changed, so that dragging a
/// node of a thousand stays smooth; a large drawing that is new, and changes of thousands of elements, are
/// put up in slices, between which the window answers.
class DigraphScene final : public DrawingScene {
  Q_OBJECT

 public:
  using DrawingScene::DrawingScene;

  /// Shows a mechanism with its nodes at these places.
  void show(const Mechanism& mechanism, NodePositions positions);
  /// The same with what digraphGeometry() makes of both, from geometry() or from nothing.
  void show(NodePositions positions, DigraphGeometryPtr geometry);

  /// Never null.
  [[nodiscard]] const DigraphGeometryPtr& geometry() const { return m_geometry; }
  /// Is everything there, where it belongs? What stands out may still be drawn again.
  [[nodiscard]] bool isDrawn() const { return !m_putUp && !m_isMoving; }

  [[nodiscard]] const NodePositions& positions() const { return m_positions; }
  using DrawingScene::displayList;
  [[nodiscard]] DisplayList displayList(const Emphases& emphases) const override;

 signals:
  void drawn();  ///< a large drawing or a change of one, wholly

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
  std::vector<Outline> draw(const CouplingPlace& place);
  std::vector<Outline> draw(const NotePlace& place);

  NodePositions m_positions;
  DigraphGeometryPtr m_geometry = std::make_shared<const DigraphGeometry>();
  std::optional<std::size_t> m_putUp;  ///< while that goes on: how many arrows, nodes, ... are there
  // By arrow, node, coupling, note, in this order:
  std::vector<std::size_t> m_slots;  ///< its first outline
  std::vector<bool> m_isStale;       ///< it is to be drawn again
  std::size_t m_staleCount = 0;
  std::size_t m_staleFrom = 0;  ///< none before this one
  bool m_isMoving = false;      ///< some of these have other places than they are drawn at
  bool m_isSliceDue = false;    ///< of those that are to be drawn again
};

}  // namespace geargraph::inline canvas
