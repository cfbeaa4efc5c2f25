#pragma once

#include <QGraphicsView>
#include <optional>

#include "core/analysis/analysis.h"
#include "core/drawing/palette.h"
#include "ui/canvas/cycle_walk.h"
#include "ui/canvas/digraph_scene.h"
#include "ui/canvas/tool_controller.h"
#include "ui/document/document.h"
#include "ui/selection/selection.h"

class QMenu;

namespace geargraph {

/// The digraph of the document, drawn and edited [AU, Fig. 2].
///
/// Keys while it has the focus: V L T G I H pick a tool, Esc cancels, then deselects, then goes back to
/// Select; Delete and Backspace delete; arrows nudge by 10 (Shift: by 1); F2 renames, X flips, F or Ctrl+0
/// fits, Ctrl+plus, minus and 1 zoom; Ctrl+A selects all. The wheel zooms at the mouse; the middle button, or
/// Space with the left one, pans.
class DigraphView : public QGraphicsView {
  Q_OBJECT

 public:
  DigraphView(Document* document, Selection* selection, QWidget* parent = nullptr);

  [[nodiscard]] ToolKind tool() const;
  void setTool(ToolKind tool);
  /// What the tool expects next, as last told by hintChanged().
  [[nodiscard]] QString hint() const;

  /// The newest analysis, for the cycles; the drawing itself needs none.
  void setSnapshot(const SnapshotPtr& snapshot);
  /// Shows the fundamental cycle of this mesh as a walk. With an empty id the view decides: the cycle all of
  /// which is hovered (a row of C in the matrices), else that of the mesh that is selected alone.
  void showCycle(MeshId mesh);

  void setDark(bool dark);
  [[nodiscard]] Theme theme() const;

 public slots:
  void fit();  ///< all of the drawing in the window, at most at twice its size
  void zoomIn();
  void zoomOut();
  void resetZoom();
  void selectAll();
  void deleteSelected();
  void flipSelected();    ///< tail and head of the selected arrows exchanged
  void renameSelected();  ///< opens the editor in place on the one selected link
  void toggleInputs();    ///< drives the selected joints, or those that carry the selected links, or stops
                          ///< driving them
  void tidy();            ///< lays the whole drawing out anew, as one undo step

  [[nodiscard]] DisplayList displayList() const;  ///< what is drawn, for export
  /// The entries for what is at a place of the viewport; the caller owns the menu.
  [[nodiscard]] QMenu* contextMenuAt(QPoint viewportPlace);

 signals:
  void toolChanged(geargraph::ToolKind tool);
  void hintChanged(const QString& hint);
  /// While an arrow is being drawn: the joint it would make; nothing when it is done or given up.
  void previewChanged(const std::optional<geargraph::JointPreview>& preview);
  /// A double click on what has no name to edit in place: show its properties.
  void propertiesWanted(const geargraph::ElementId& element);
  /// Space was tapped, not held for panning: play or pause.
  void spaceTapped();

 protected:
  bool event(QEvent* event) override;
  bool viewportEvent(QEvent* event) override;
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void drawForeground(QPainter* painter, const QRectF& rect) override;

 private:
  enum class Grip { none, tool, pan };

  void rebuild();
  void showAnotherDocument();
  void updateEmphases();
  [[nodiscard]] std::optional<CycleWalk> shownCycle() const;
  void applyTheme(Theme theme);
  void updateCursor();
  void openRenameEditor(LinkId link);
  void escape();
  bool editKey(const QKeyEvent& event);
  bool viewKey(const QKeyEvent& event);
  bool toolKeyPressed(const QKeyEvent& event);
  void drawCaption(QPainter& painter, const QString& text) const;
  void drawMessage(QPainter& painter, const QString& text) const;
  void zoomAt(QPointF viewportPlace, double factor);
  void panBy(QPointF sheetUnits);
  void moveView(QPointF pixels);
  [[nodiscard]] double scaleNow() const { return transform().m11(); }
  [[nodiscard]] std::optional<ElementId> elementUnder(QPointF viewportPlace) const;
  [[nodiscard]] Pointer pointerAt(QPointF viewportPlace, Qt::KeyboardModifiers modifiers) const;
  [[nodiscard]] QString toolTipFor(const ElementId& element) const;

  Document* m_document;
  Selection* m_selection;
  DigraphScene* m_scene;
  NodePlacer* m_placer;
  ToolController* m_controller;
  SnapshotPtr m_snapshot;
  MeshId m_wantedCycle;
  QString m_caption;
  Grip m_grip = Grip::none;
  bool m_spaceDown = false;
  bool m_spaceUsed = false;
  bool m_fitted = true;        ///< the drawing still fills the window, as nobody moved it
  bool m_themeChosen = false;  ///< setDark() was called: the palette does not decide any more
  bool m_bare = false;         ///< a message stands where the drawing will be
  bool m_hovering = false;     ///< what is hovered is under our mouse
};

}  // namespace geargraph
