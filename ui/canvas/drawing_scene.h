#pragma once

#include <QGraphicsScene>
#include <functional>
#include <memory>
#include <unordered_map>
#include <unordered_set>

#include "core/presentation/drawing/display_list.h"
#include "core/presentation/drawing/emphasis.h"
#include "ui/canvas/mark_item.h"

namespace geargraph::inline canvas {

/// Plays a drawing on a scene: the marks of one element at one depth are one item, repainted only where they
/// changed. Picking asks outlines(), never the items.
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
  /// All that is drawn, without halos.
  [[nodiscard]] QRectF drawnRect() const;

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
  void endDrawing();
  void growSheet();  ///< where the drawing has come near its end
  [[nodiscard]] std::vector<Outline>& editableOutlines() { return m_outlines; }

 private:
  using PartKey = std::pair<ElementId, int>;
  struct PartHash {
    std::size_t operator()(const PartKey& key) const {
      return std::hash<ElementId>{}(key.first) * 31 + static_cast<std::size_t>(key.second);
    }
  };
  struct Part {
    std::unique_ptr<MarkItem> item;
    quint64 drawing = 0;  ///< the last one that it was in
  };

  void play(DisplayList drawing);

  Draw m_draw;
  Emphases m_emphases;
  std::vector<Outline> m_outlines;
  Theme m_theme = Theme::light;
  std::unordered_map<PartKey, Part, PartHash> m_parts;
  quint64 m_drawing = 0;
  MarkItem* m_overlay = nullptr;  ///< owned by the scene
};

}  // namespace geargraph::inline canvas
