#pragma once

#include <QGraphicsScene>
#include <functional>
#include <unordered_set>

#include "core/presentation/drawing/display_list.h"
#include "core/presentation/drawing/emphasis.h"
#include "ui/canvas/mark_item.h"
#include "ui/canvas/parts_item.h"

namespace geargraph {

/// Shows a drawing on a scene: the marks of one element at one depth are one part, repainted only if changed.
/// Picking uses outlines(), never the scene.
class DrawingScene : public QGraphicsScene {
  Q_OBJECT

 public:
  /// Makes the drawing for given emphases.
  using Draw = std::function<DisplayList(const Emphases&)>;

  explicit DrawingScene(QObject* parent = nullptr);
  ~DrawingScene() override;

  /// Shows the result of `draw`, and calls it again whenever the emphases change.
  void show(Draw draw);
  void setEmphases(Emphases emphases);
  void setTheme(Theme theme);
  [[nodiscard]] Theme theme() const { return m_theme; }

  /// The outlines for hit tests.
  [[nodiscard]] const std::vector<Outline>& outlines() const { return m_outlines; }
  /// The drawing as one list, as shown.
  [[nodiscard]] DisplayList displayList() const { return drawing()(m_emphases); }
  /// Draws what is shown now, whatever is shown later. Thread-safe.
  [[nodiscard]] virtual Draw drawing() const;
  /// The extent of the drawing and the underlay, without halos.
  [[nodiscard]] QRectF drawnRect() const;

  /// The parts of the drawing, by depth.
  [[nodiscard]] const SheetParts& parts() const { return m_item->parts(); }
  /// The number of parts drawn since the scene was made, to measure the cost of changes.
  [[nodiscard]] quint64 drawnParts() const { return m_drawnParts; }
  /// Tells the region of the viewport that the view is about to paint.
  void beginPainting(const QRegion& exposed);
  void endPainting() { m_item->setExposed({}); }

  /// Sets marks under the drawing, which are hit only where the drawing is not.
  void setUnderlay(DisplayList underlay);
  [[nodiscard]] const DisplayList& underlay() const { return m_underlayList; }

  /// Sets names and teeth beside the labels of the drawing, which are not hit.
  void setCaptions(std::vector<Mark> captions);
  [[nodiscard]] const std::vector<Mark>& captions() const { return m_captionMarks; }

  /// Sets marks over the drawing: previews, the rubber band, guides.
  void setOverlay(DisplayList overlay);

 protected:
  [[nodiscard]] const Emphases& emphases() const { return m_emphases; }
  /// Called when the emphases of these elements have changed. Draws everything again by default.
  virtual void drawAgain(const std::unordered_set<ElementId>& changed);

  // For scenes that draw element by element. Parts that are not set between beginDrawing() and endDrawing()
  // are removed; between drawings single parts may be set again.
  void beginDrawing();
  void setPart(const ElementId& element, int depth, std::vector<Mark> marks);
  /// All parts of an element.
  void setElement(const ElementId& element, std::vector<Mark> marks);
  void endDrawing();
  /// Replaces the drawing by a finished one. Cost: that of freeing the old one.
  void setParts(SheetParts parts, std::vector<Outline> outlines);
  void growSheet();  ///< if the drawing has come near its border
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
  int m_repaints = 0;           ///< number of areas waiting to be painted, up to the number kept apart
  PartsItem* m_item = nullptr;  ///< owned by the scene, as the next one
  MarkItem* m_overlay = nullptr;
  MarkItem* m_underlay = nullptr;
  MarkItem* m_captions = nullptr;
  DisplayList m_underlayList;
  std::vector<Mark> m_captionMarks;
};

}  // namespace geargraph
