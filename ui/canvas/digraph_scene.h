#pragma once

#include <QGraphicsScene>
#include <memory>
#include <unordered_map>

#include "core/drawing/digraph_drawing.h"
#include "ui/canvas/mark_item.h"

namespace geargraph {

/// The drawing of the digraph on a scene: one item an element, repainted only where it changed.
class DigraphScene final : public QGraphicsScene {
  Q_OBJECT

 public:
  explicit DigraphScene(QObject* parent = nullptr);
  ~DigraphScene() override;

  /// Shows a mechanism with its nodes at these places.
  void show(const Mechanism& mechanism, NodePositions positions);
  void setEmphases(Emphases emphases);
  void setTheme(Theme theme);
  [[nodiscard]] Theme theme() const { return m_theme; }

  [[nodiscard]] const NodePositions& positions() const { return m_positions; }
  [[nodiscard]] const DigraphGeometry& geometry() const { return m_geometry; }
  /// What can be hit where.
  [[nodiscard]] const std::vector<Outline>& outlines() const { return m_outlines; }
  /// What is drawn, as one list: for export.
  [[nodiscard]] DisplayList displayList() const;
  [[nodiscard]] QRectF drawnRect() const;

  /// Marks over the drawing: what is being drawn, the rubber band, guides.
  void setOverlay(DisplayList overlay);

 private:
  struct Part {
    std::unique_ptr<MarkItem> item;
    std::unique_ptr<MarkItem> halo;  ///< only while there is one
    bool shown = false;              ///< in the drawing being built
  };

  void redraw(const ElementId& element, DisplayList drawing, double depth);
  void drawAll();
  void drawWhatDiffers(const DigraphGeometry& former);
  std::vector<Outline> draw(const NodePlace& node);
  std::vector<Outline> draw(const EdgePlace& edge);
  [[nodiscard]] Emphasis emphasisOf(const ElementId& element) const;

  NodePositions m_positions;
  DigraphGeometry m_geometry;
  Emphases m_emphases;
  std::vector<Outline> m_outlines;
  Theme m_theme = Theme::light;
  std::unordered_map<ElementId, Part> m_parts;
  MarkItem* m_overlay = nullptr;  ///< owned by the scene
};

}  // namespace geargraph
