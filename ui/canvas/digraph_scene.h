#pragma once

#include "core/drawing/digraph_drawing.h"
#include "ui/canvas/drawing_scene.h"

namespace geargraph {

/// The drawing of the digraph on a scene. It places and draws again only what changed, so that dragging a
/// node of a thousand stays smooth.
class DigraphScene final : public DrawingScene {
  Q_OBJECT

 public:
  using DrawingScene::DrawingScene;

  /// Shows a mechanism with its nodes at these places.
  void show(const Mechanism& mechanism, NodePositions positions);

  [[nodiscard]] const NodePositions& positions() const { return m_positions; }
  using DrawingScene::displayList;
  [[nodiscard]] DisplayList displayList(const Emphases& emphases) const override;

 protected:
  void drawAgain(const std::unordered_set<ElementId>& changed) override;

 private:
  void redraw(const ElementId& element, DisplayList drawing, int depth);
  void drawAll();
  void drawWhatDiffers(const DigraphGeometry& former);
  std::vector<Outline> draw(const NodePlace& node);
  std::vector<Outline> draw(const EdgePlace& edge);

  NodePositions m_positions;
  DigraphGeometry m_geometry;
};

}  // namespace geargraph
