#pragma once

#include <QGraphicsView>
#include <functional>
#include <map>
#include <optional>

#include "core/presentation/drawing/palette.h"
#include "core/theory/analysis/analysis.h"
#include "ui/canvas/drawing_scene.h"
#include "ui/canvas/element_commands.h"
#include "ui/document/document.h"
#include "ui/selection/selection.h"
#include "ui/tools/load_tool.h"

class QMenu;

namespace geargraph::inline power_drawing {
struct PowerPicture;
struct ShownTorque;
}  // namespace geargraph::inline power_drawing

namespace geargraph::inline canvas {

/// A drawing of the document: what all of them have in common. It zooms, pans and fits, lights up what is
/// hovered and selected in any view, picks by the drawing's outlines, gives tips and menus, and carries out
/// the commands on elements. A drawing of its own derives from it, fills the scene in rebuild() and says what
/// its tools do with the mouse.
///
/// Keys while it has the focus: V L T G I W N H pick a tool, Esc cancels, then deselects, then goes back to
/// Select; Delete and Backspace delete; arrows nudge by 10 (Shift: by 1); F2 renames, X flips, F or Ctrl+0
/// fits, Shift+F fits what is selected, Ctrl+plus, minus and 1 zoom; Ctrl+A selects all. The wheel zooms at
/// the mouse; the middle button, or Space with the left one, pans.
///
/// Without a mouse: Page down and up select the next and the last element, Ctrl and an arrow key the nearest
/// one that way, with Shift besides what is selected. Return does what a click on it does with the tool, an
/// arrow begins at one and ends at the next; with Select it opens the element. The Menu key opens its menu,
/// Tab goes on to the next control.
class DrawingView : public QGraphicsView {
  Q_OBJECT

 public:
  /// Takes the scene over.
  DrawingView(Document* document, Selection* selection, DrawingScene* scene, QWidget* parent = nullptr);

  [[nodiscard]] virtual ToolKind tool() const { return m_tool; }
  virtual void setTool(ToolKind tool);
  /// What the tool expects next, as last told by hintChanged().
  [[nodiscard]] QString hint() const { return m_hint; }

  /// The newest analysis.
  virtual void setSnapshot(const SnapshotPtr& snapshot);

  void setTheme(Theme theme);
  /// A grid of dots that new and dragged nodes keep to, where the drawing has nodes; Alt suspends it.
  virtual void setGrid(bool /*on*/) {}
  /// How far fit() enlarges a small drawing; a lecture hall wants more than a desk.
  void setLargestFit(double scale);
  static constexpr double kLargestFit = 1.25;
  [[nodiscard]] Theme theme() const;

  /// Are the document's notes on this drawing?
  [[nodiscard]] virtual bool showsNotes() const { return false; }

  /// Why no load can be put on what is selected, as a sentence; empty where one can.
  [[nodiscard]] QString whyNoLoad() const;
  /// Why no gear can be attached to the one selected link, as a sentence; empty where one can.
  [[nodiscard]] QString whyNoGear() const;

  /// Makes the bands of a mechanism's power, and the torques that act on it, for the drawing as it is now, on
  /// any thread.
  using PowerDraw =
      std::function<DisplayList(const PowerPicture&, const std::vector<ShownTorque>&, const Mechanism&)>;
  /// None where the drawing shows neither, or is not that of the document now.
  [[nodiscard]] virtual PowerDraw powerDraw() const { return {}; }
  /// What is painted under the drawing: such bands, or nothing.
  void setUnderlay(DisplayList underlay);
  /// Further words for the tooltips of what is painted there, by element.
  void setUnderlayTips(std::map<ElementId, QString> tips) { m_underlayTips = std::move(tips); }
  [[nodiscard]] bool hasUnderlay() const { return !m_scene->underlay().marks.empty(); }

  [[nodiscard]] DisplayList displayList() const;  ///< what is drawn, as it stands out now
  [[nodiscard]] DisplayList picture();            ///< the same with nothing standing out, for export
  /// Why picture() was not that of the document as it is now, as a sentence; empty where it was.
  [[nodiscard]] virtual QString whyNoPicture() const { return {}; }
  /// The entries for what is at a place of the viewport; the caller owns the menu.
  [[nodiscard]] QMenu* contextMenuAt(QPoint viewportPlace);
  /// The entries for an element that another view shows, or for the sheet; the caller owns the menu.
  [[nodiscard]] QMenu* contextMenuFor(const std::optional<ElementId>& element, SheetPoint at);
  /// The lines in the box at the lower left, and the ones at the upper left; empty where there is none.
  [[nodiscard]] QStringList caption() const { return m_caption; }
  [[nodiscard]] QStringList notice() const { return m_notice; }

  /// Is a gesture of mouse or keys under way, which Esc gives up?
  [[nodiscard]] bool isDrawing() const { return !isIdle() || isLoadDragged(); }
  /// All elements that are drawn, as keys walk along them: links, joints, meshes, what else there is, each in
  /// the order of the document. Cost: O(elements).
  [[nodiscard]] std::vector<ElementId> drawnElements() const;
  /// The one that the keys are at; none where nothing drawn is selected.
  [[nodiscard]] std::optional<ElementId> currentElement() const;
  /// The box of an element in the viewport; null where it is not drawn. Cost: O(elements).
  [[nodiscard]] QRect boxOf(const ElementId& element) const;
  /// What an element is, and what is known of it: as its tip says.
  [[nodiscard]] QString describe(const ElementId& element) const { return toolTipFor(element); }
  [[nodiscard]] bool isSelected(const ElementId& element) const { return m_selection->isSelected(element); }
  /// Selects an element as the keys do, and brings it into sight.
  void walkTo(const ElementId& element, bool add = false);

 public slots:
  void fit();  ///< all of the drawing in the window, at most at twice its size
  void fitSelected();
  void zoomIn();
  void zoomOut();
  void resetZoom();
  void selectAll();
  void deleteSelected();
  void flipSelected();    ///< tail and head of the selected arrows exchanged
  void renameSelected();  ///< opens the editor in place on the one selected link or note
  void attachGear();      ///< a new gear in mesh with the one selected link
  virtual void
  toggleInputs();         ///< drives the selected joints, or those that carry the selected links, or stops
  void editLoad();        ///< opens the editor in place for the torque on the one selected joint or link
  void toggleBrake();     ///< holds the one selected link, or releases it
  virtual void tidy() {}  ///< lays the drawing out anew, as one undo step

 signals:
  void toolChanged(geargraph::ToolKind tool);
  void hintChanged(const QString& hint);
  /// While an arrow is being drawn: the joint it would make; nothing when it is done or given up.
  void previewChanged(const std::optional<geargraph::JointPreview>& preview);
  /// A double click on what has no name to edit in place: show its properties.
  void propertiesWanted(const geargraph::ElementId& element);
  /// The drawing has other places: what is painted under it belongs to the former ones.
  void redrawn();
  /// A context menu has been made for an element, or for the sheet: others may add what they know of it.
  void menuOpening(QMenu* menu, const std::optional<geargraph::ElementId>& element);
  /// Keys have selected an element: for those who do not see the drawing.
  void walkedTo(const geargraph::ElementId& element);
  /// Space was tapped, not held for panning: play or pause.
  void spaceTapped();

 protected:
  /// Shows the document as it is now. Called after every change; a drawing calls it once when it is made.
  virtual void rebuild() = 0;
  /// The drawing is wanted though nobody sees it: what was put off until it is shown is to be done now.
  virtual void catchUp() {}
  /// Another document has come: what was known of the last one counts no more. rebuild() follows.
  virtual void forgetDocument() {}

  /// What a drawing shows besides what is selected and hovered: a cycle, say, and lines that put it in words.
  struct Highlight {
    Emphases emphases;
    QStringList caption;
    std::vector<ColorRole> colors;  ///< by line of the caption; accent for those beyond its end
  };
  [[nodiscard]] virtual Highlight highlight() const { return {}; }
  /// What stands where there is no drawing yet.
  [[nodiscard]] virtual QString message() const { return {}; }
  [[nodiscard]] virtual QString toolTipFor(const ElementId& element) const;
  /// What the words of the caption mean.
  [[nodiscard]] virtual QString captionToolTip() const { return {}; }
  /// May drop entries of the menu, or tell it how to add a link and to tidy the drawing.
  virtual void adjustMenu(struct ContextActions&, SheetPoint /*at*/) {}
  virtual void fillMenuFurther(QMenu&, const std::optional<ElementId>&, SheetPoint /*at*/) {}
  /// A double click with the Select tool.
  virtual void openElement(const ElementId& element);

  // What the mouse does with the current tool. Select as it stands picks elements.
  virtual void pressed(const Pointer& pointer);
  virtual void moved(const Pointer&) {}
  virtual void released(const Pointer&) {}
  /// Is no gesture under way, so that menus may open?
  [[nodiscard]] virtual bool isIdle() const { return true; }
  /// Esc: false where there was nothing to give up.
  virtual bool cancel() { return false; }
  virtual void nudge(double /*dx*/, double /*dy*/, bool /*repeated*/) {}
  /// Where what Return has begun with the tool ends at once; none: at the element of the next Return.
  [[nodiscard]] virtual std::optional<Pointer> keyStrokeEnd(const Pointer& begin) const;
  /// A place on the sheet near the middle of the view where nothing is drawn.
  [[nodiscard]] SheetPoint freePlace() const;

  // For the drawing's use.
  [[nodiscard]] const Mechanism& mechanism() const { return *m_document->mechanism(); }
  [[nodiscard]] Document& document() { return *m_document; }
  [[nodiscard]] Selection& selection() const { return *m_selection; }
  [[nodiscard]] ElementCommands& commands() { return m_commands; }
  [[nodiscard]] const SnapshotPtr& snapshot() const { return m_snapshot; }
  void setHint(const QString& hint);
  void setNotice(const QStringList& lines);
  void updateEmphases();
  void updateMessage();
  void updateCursor();
  void panBy(QPointF sheetUnits);
  void openRenameEditor(LinkId link);
  /// Does all of the drawing fill the window, as nobody moved it since?
  [[nodiscard]] bool isFitted() const { return m_fitted; }
  [[nodiscard]] double scaleNow() const { return transform().m11(); }
  [[nodiscard]] std::optional<ElementId> elementUnder(QPointF viewportPlace) const;

  bool event(QEvent* event) override;
  bool viewportEvent(QEvent* event) override;
  void changeEvent(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void drawForeground(QPainter* painter, const QRectF& rect) override;

 private:
  enum class Grip { none, tool, pan };
  /// The drag of a torque: one undo step.
  struct LoadDrag {
    quint64 gesture = 0;
    MechanismPtr before;
  };

  void showDocument();
  void showAnotherDocument();
  void applyTheme(Theme theme);
  void escape();
  bool editKey(const QKeyEvent& event);
  bool viewKey(const QKeyEvent& event);
  bool toolKeyPressed(const QKeyEvent& event);
  bool walkKey(const QKeyEvent& event);
  void walk(int steps, bool add);
  void walkTowards(SheetPoint direction, bool add);
  void clickCurrent();
  [[nodiscard]] QString whyNoLoadOn(const ElementId& element) const;
  /// The element of a load whose chip is there, beside the drawing.
  [[nodiscard]] std::optional<ElementId> loadUnder(QPointF viewportPlace) const;
  [[nodiscard]] QString tipAt(const ElementId& element, QPointF viewportPlace) const;
  /// A press that concerns a load; false: it is the tool's.
  bool grabLoad(QPointF viewportPlace, Pointer pointer);
  void stepLoad(const ToolEvent& event);
  void pullLoad(const load_tool::PullTorque& pull);
  [[nodiscard]] bool isLoadDragged() const { return m_load.index() != 0; }
  [[nodiscard]] std::optional<SheetPoint> middleOf(const ElementId& element) const;
  struct LineBox {
    QRect box;
    QStringList lines;  ///< cut to the room there is
  };
  [[nodiscard]] QFont lineFont() const;
  [[nodiscard]] LineBox boxOf(const QStringList& lines, Qt::Corner corner) const;
  void drawLines(QPainter& painter, const LineBox& shown, const std::vector<ColorRole>& colors) const;
  void drawMessage(QPainter& painter, const QString& text) const;
  void fitTo(const QRectF& area);
  void zoomAt(QPointF viewportPlace, double factor);
  void moveView(QPointF pixels);
  [[nodiscard]] Pointer pointerAt(QPointF viewportPlace, Qt::KeyboardModifiers modifiers) const;

  Document* m_document;
  Selection* m_selection;
  DrawingScene* m_scene;
  ElementCommands m_commands;
  SnapshotPtr m_snapshot;
  ToolKind m_tool = ToolKind::select;
  QString m_hint;
  std::map<ElementId, QString> m_underlayTips;
  QStringList m_caption;
  std::vector<ColorRole> m_captionColors;
  QStringList m_notice;
  QString m_message;
  Grip m_grip = Grip::none;
  load_tool::State m_load;
  std::optional<LoadDrag> m_loadDrag;
  QString m_hintBeforeLoad;
  bool m_overLoad = false;  ///< a load that can be dragged is under the mouse
  double m_largest = kLargestFit;
  QPointF m_panFrom;
  bool m_spaceDown = false;
  bool m_spaceUsed = false;
  bool m_fitted = true;                ///< the drawing was not moved: it fills the window
  bool m_themeChosen = false;          ///< setTheme() was called: the palette does not decide any more
  bool m_hovering = false;             ///< what is hovered is under our mouse
  bool m_showsFocus = false;           ///< the focus came by a key
  std::optional<ElementId> m_current;  ///< the element that was walked to last
};

}  // namespace geargraph::inline canvas
