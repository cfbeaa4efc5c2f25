#pragma once

#include <memory>
#include <optional>

#include "core/drawing/digraph_drawing.h"
#include "ui/canvas/drawing_scene.h"

namespace geargraph {

using DigraphGeometryPtr = std::shared_ptr<const DigraphGeometry>;

/// The drawing of the digraph on a scene. It places and draws again only what changed, so that dragging a
/// node of a thousand stays smooth; a large drawing that is new is put up in slices, between which the window
/// answers.
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
  /// Is there nothing left to put up?
  [[nodiscard]] bool isDrawn() const { return !m_putUp; }

  [[nodiscard]] const NodePositions& positions() const { return m_positions; }
  using DrawingScene::displayList;
  [[nodiscard]] DisplayList displayList(const Emphases& emphases) const override;

 signals:
  void drawn();  ///< a large drawing, wholly

 protected:
  void drawAgain(const std::unordered_set<ElementId>& changed) override;

 private:
  void redraw(const ElementId& element, DisplayList drawing, int depth);
  void drawAll();
  void putUp(std::size_t end);
  void putUpSlice();
  void drawWhatDiffers(const DigraphGeometry& former);
  std::vector<Outline> draw(const NodePlace& node);
  std::vector<Outline> draw(const EdgePlace& edge);
  std::vector<Outline> draw(const CouplingPlace& place);

  NodePositions m_positions;
  DigraphGeometryPtr m_geometry = std::make_shared<const DigraphGeometry>();
  std::optional<std::size_t> m_putUp;  ///< while that goes on: how many arrows, nodes, couplings are there
};

}  // namespace geargraph
