#pragma once

#include <QGraphicsScene>
#include <functional>
#include <unordered_set>

#include "core/presentation/drawing/display_list.h"
#include "core/presentation/drawing/emphasis.h"
#include "ui/canvas/mark_item.h"
#include "ui/canvas/parts_item.h"

namespace geargraph::inline canvas {

/// Plays a drawing on a scene: the marks of one element at one depth are one part, repainted only where they
/// changed. Picking asks outlines(), never the scene.
class DrawingScene : public QGraphicsScene {
  Q_OBJECT

 public:
  /// Makes the drawing for what stands out.
  using Draw = std::function<DisplayList(const Emphases&)>;

  explicit DrawingScene(QObject* parent = nullptr);
  ~DrawingScene() override;

  /// Shows what `draw` makes, now and again whenever the emphases change.
  void show(Draw draw);
  void setEmphases(Emphases emphases);
  void setTheme(Theme theme);
  [[nodiscard]] Theme theme() const { return m_theme; }

  /// What can be hit where.
  [[nodiscard]] const std::vector<Outline>& outlines() const { return m_outlines; }
  /// The drawing as one list, for export: as it is seen, or with other emphases.
  [[nodiscard]] DisplayList displayList() const { return displayList(m_emphases); }
  [[nodiscard]] virtual DisplayList displayList(const Emphases& emphases) const;
  /// All that is drawn, with what is under it, without halos.
  [[nodiscard]] QRectF drawnRect() const;

  /// The parts of the drawing, for what is drawn at which depth.
  [[nodiscard]] const SheetParts& parts() const { return m_item->parts(); }
  /// How many parts have been drawn since the scene was made: what a change costs.
  [[nodiscard]] quint64 drawnParts() const { return m_drawnParts; }
  /// What of the viewport the view is about to paint.
  void beginPainting(const QRegion& exposed);
  void endPainting() { m_item->setExposed({}); }

  /// Marks under the drawing, that can be hit where nothing of it can.
  void setUnderlay(DisplayList underlay);
  [[nodiscard]] const DisplayList& underlay() const { return m_underlayList; }

  /// Marks over the drawing: what is being drawn, the rubber band, guides.
  void setOverlay(DisplayList overlay);

 protected:
  [[nodiscard]] const Emphases& emphases() const { return m_emphases; }
  /// The emphases of these elements changed. Draws everything again; a drawing that knows better overrides
  /// it.
  virtual void drawAgain(const std::unordered_set<ElementId>& changed);

  // For scenes that draw element by element. Parts that are not set between beginDrawing() and endDrawing()
  // vanish; in between drawings single parts may be set anew.
  void beginDrawing();
  void setPart(const ElementId& element, int depth, std::vector<Mark> marks);
  /// All parts of an element.
  void setElement(const ElementId& element, std::vector<Mark> marks);
  void endDrawing();
  /// A drawing that is ready, instead of the one that there is. Cost: that of freeing the latter.
  void setParts(SheetParts parts, std::vector<Outline> outlines);
  void growSheet();  ///< where the drawing has come near its end
  [[nodiscard]] std::vector<Outline>& editableOutlines() { return m_outlines; }

 private:
  void play(DisplayList drawing);
  void repaint(const QRectF& area);
  void setSheet(const QRectF& area);

  Draw m_draw;
  Emphases m_emphases;
  std::vector<Outline> m_outlines;
  Theme m_theme = Theme::light;
  quint64 m_drawnParts = 0;
  int m_repaints = 0;           ///< areas that wait to be painted, or more than can be told apart
  PartsItem* m_item = nullptr;  ///< owned by the scene, as the next one
  MarkItem* m_overlay = nullptr;
  MarkItem* m_underlay = nullptr;
  DisplayList m_underlayList;
};

}  // namespace geargraph::inline canvas
