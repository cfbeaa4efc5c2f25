#pragma once

#include <QGraphicsView>
#include <functional>
#include <map>
#include <optional>

#include "core/foundations/base/triple.h"
#include "core/presentation/drawing/palette.h"
#include "core/theory/analysis/analysis.h"
#include "ui/canvas/drawing_scene.h"
#include "ui/canvas/element_commands.h"
#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/service/turns.h"
#include "ui/tools/load_tool.h"
#include "ui/workbench/results_view.h"
#include "ui/workbench/view_entry.h"

class QMenu;

namespace geargraph {
class Measuring;
struct PowerPicture;
struct ShownTorque;
}  // namespace geargraph

namespace geargraph {

/// The common base of drawings of the document. It zooms, pans and fits, highlights what is hovered and
/// selected in any view, picks by the drawing's outlines, shows tool tips and menus, and carries out the
/// commands on elements. A derived drawing fills the scene in rebuild() and handles the mouse for its tools.
///
/// Keys while it has the focus: V L T G I W N M H choose a tool, Esc cancels, then deselects, then returns to
/// Select; Delete and Backspace delete; arrows nudge by 10 (Shift: by 1); F2 renames, X flips, F or Ctrl+0
/// fits, Shift+F fits what is selected, Ctrl+plus, minus and 1 zoom; Ctrl+A selects all. The wheel zooms at
/// the mouse; the middle button, or Space with the left one, pans.
///
/// Without a mouse: Page down and up select the next and the last element, Ctrl and an arrow key the nearest
/// one in that direction, with Shift in addition to the selection. Return acts like a click with the tool: an
/// arrow begins at the current element and ends at the next one; with Select it opens the element. The Menu
/// key opens its menu, Tab moves to the next control.
class DrawingView : public QGraphicsView, public ResultsView {
  Q_OBJECT

 public:
  /// Takes ownership of the scene.
  DrawingView(Document* document, Selection* selection, DrawingScene* scene, QWidget* parent = nullptr);

  [[nodiscard]] virtual ToolKind tool() const { return m_tool; }
  virtual void setTool(ToolKind tool);
  /// What the tool expects next, as last emitted by hintChanged().
  [[nodiscard]] QString hint() const { return m_hint; }

  [[nodiscard]] QWidget& widget() override { return *this; }
  void setSnapshot(const SnapshotPtr& snapshot) override;
  [[nodiscard]] QString emptyText() const override { return message(); }

  /// Measures what is clicked with the tool Measure, and shows what is measured.
  void setMeasuring(Measuring* measuring);

  void setTheme(Theme theme);
  /// Switches a grid to which new and dragged nodes snap, if the drawing has nodes; Alt suspends it.
  virtual void setGrid(bool /*on*/) {}
  /// Sets the largest scale of fit() for small drawings; it is larger for presentations.
  void setLargestFit(double scale);
  static constexpr double kLargestFit = 1.25;
  [[nodiscard]] Theme theme() const;

  /// Does this drawing show the document's notes?
  [[nodiscard]] virtual bool showsNotes() const { return false; }

  /// Why no load can be put on the selection, as a sentence; empty if one can.
  [[nodiscard]] QString whyNoLoad() const;
  /// Why no gear can be attached to the one selected link, as a sentence; empty if one can.
  [[nodiscard]] QString whyNoGear() const;
  /// Why the selected links cannot be welded, or the selected one not be split, as sentences; empty if they
  /// can.
  [[nodiscard]] QString whyNoWeld() const;
  [[nodiscard]] QString whyNoSplit() const;

  /// Draws the power bands of a mechanism, and the torques that act on it, for the present state of the
  /// drawing. Thread-safe.
  using PowerDraw =
      std::function<DisplayList(const PowerPicture&, const std::vector<ShownTorque>&, const Mechanism&)>;
  /// Empty if the drawing shows neither, or is not up to date.
  [[nodiscard]] virtual PowerDraw powerDraw() const { return {}; }
  /// Sets what is painted under the drawing: such bands, or nothing.
  void setUnderlay(DisplayList underlay);
  /// Sets additional text for the tooltips of those marks, by element.
  void setUnderlayTips(std::map<ElementId, QString> tips) { m_underlayTips = std::move(tips); }
  /// Writes names and teeth beside links and meshes, where there is room (drawing/captions.h); pictures of
  /// the drawing have them too.
  void setCaptioned(bool on);
  [[nodiscard]] bool isCaptioned() const { return m_isCaptioned; }
  [[nodiscard]] bool hasUnderlay() const { return !m_scene->underlay().marks.empty(); }

  [[nodiscard]] DisplayList displayList() const;  ///< as shown, with highlights
  /// The same without highlights, for export. pictureMaker() makes it of what is shown now, on any thread:
  /// that of a large document takes a while.
  [[nodiscard]] DisplayList picture() { return pictureMaker()(); }
  [[nodiscard]] std::function<DisplayList()> pictureMaker();
  /// Why picture() was not up to date with the document, as a sentence; empty if it was.
  [[nodiscard]] virtual QString whyNoPicture() const { return {}; }
  /// The menu for the element at a point of the viewport; the caller owns it.
  [[nodiscard]] QMenu* contextMenuAt(QPoint viewportPlace);
  /// The menu for an element shown by another view, or for the sheet; the caller owns it.
  [[nodiscard]] QMenu* contextMenuFor(const std::optional<ElementId>& element, CanvasPoint at);
  /// The lines in the box at the lower left, and those at the upper left.
  [[nodiscard]] QStringList caption() const;
  [[nodiscard]] QStringList notice() const { return m_notice; }

  /// Is a gesture of mouse or keys in progress, which Esc cancels?
  [[nodiscard]] bool isDrawing() const { return !isIdle() || isLoadDragged(); }
  /// All drawn elements in keyboard order: links, joints, meshes, others, each in the order of the document.
  /// Cost: O(elements).
  [[nodiscard]] std::vector<ElementId> drawnElements() const;
  /// The current element for the keyboard; std::nullopt if no drawn element is selected.
  [[nodiscard]] std::optional<ElementId> currentElement() const;
  /// The box of an element in the viewport; null if it is not drawn. Cost: O(elements).
  [[nodiscard]] QRect boxOf(const ElementId& element) const;
  /// The description of an element, as in its tool tip.
  [[nodiscard]] QString describe(const ElementId& element) const { return toolTipFor(element); }
  [[nodiscard]] bool isSelected(const ElementId& element) const { return m_selection->isSelected(element); }
  /// Selects an element as the keyboard does, and scrolls it into view.
  void walkTo(const ElementId& element, bool add = false);

 public slots:
  void fit();  ///< all of the drawing in the window, at most at twice its size
  void fitSelected();
  void zoomIn();
  void zoomOut();
  void resetZoom();
  void selectAll();
  void deleteSelected();
  void flipSelected();    ///< exchanges tail and head of the selected joints and meshes
  void renameSelected();  ///< opens the in-place editor for the one selected link or note
  void attachGear();      ///< a new gear in mesh with the one selected link
  virtual void
  toggleInputs();       ///< makes the selected joints, or those that carry the selected links, inputs, or not
  void editLoad();      ///< opens the in-place editor for the torque on the one selected joint or link
  void weldSelected();  ///< makes the two selected links one
  void splitSelected();   ///< divides the selected link
  void toggleBrake();     ///< holds the selected link by a brake, or releases it
  virtual void tidy() {}  ///< computes a new layout, as one undo step

 signals:
  void toolChanged(geargraph::ToolKind tool);
  void hintChanged(const QString& hint);
  /// While an arrow is being drawn: the joint that it would make; std::nullopt when it is finished or
  /// cancelled.
  void previewChanged(const std::optional<geargraph::JointPreview>& preview);
  /// A double click on an element without a name to edit in place: its properties should be shown.
  void propertiesWanted(const geargraph::ElementId& element);
  /// The places of the drawing have changed, so that the underlay is out of date.
  void redrawn();
  /// A context menu has been made for an element, or for the sheet: others may add entries.
  void menuOpening(QMenu* menu, const std::optional<geargraph::ElementId>& element);
  /// The keyboard has selected an element, for screen readers.
  void walkedTo(const geargraph::ElementId& element);
  /// Space was pressed briefly, not held for panning: play or pause.
  void spaceTapped();

 protected:
  /// Shows the current document. Called after every change; a drawing calls it once in its constructor.
  virtual void rebuild() = 0;
  /// The drawing is needed although it is hidden: do now what was postponed until it is shown.
  virtual void catchUp() {}
  /// The document was replaced: discard everything about the old one. rebuild() follows.
  virtual void forgetDocument() {}

  /// Highlights of a drawing in addition to selection and hovering, for example a cycle, with an explanation.
  struct Highlight {
    Emphases emphases;
    QStringList caption;
    std::vector<ColorRole> colors;  ///< by line of the caption; accent for further ones
  };
  [[nodiscard]] virtual Highlight highlight() const { return {}; }
  /// The text shown while there is no drawing.
  [[nodiscard]] virtual QString message() const { return {}; }
  [[nodiscard]] virtual QString toolTipFor(const ElementId& element) const;
  /// The explanation of the caption's terms.
  [[nodiscard]] virtual QString captionToolTip() const { return {}; }
  /// May remove entries of the menu, or set its actions for adding a link and tidying the drawing.
  virtual void adjustMenu(struct ContextActions&, CanvasPoint /*at*/) {}
  virtual void fillMenuFurther(QMenu&, const std::optional<ElementId>&, CanvasPoint /*at*/) {}
  /// A double click with the Select tool.
  virtual void openElement(const ElementId& element);

  // The mouse with the current tool. The default implements picking by Select.
  virtual void pressed(const Pointer& pointer);
  virtual void moved(const Pointer&) {}
  virtual void released(const Pointer&) {}
  /// Is no gesture in progress, so that menus may open?
  [[nodiscard]] virtual bool isIdle() const { return true; }
  /// Esc: false if there was nothing to cancel.
  virtual bool cancel() { return false; }
  virtual void nudge(double /*dx*/, double /*dy*/, bool /*repeated*/) {}
  /// Where a stroke begun by Return ends immediately; std::nullopt: at the element of the next Return.
  [[nodiscard]] virtual std::optional<Pointer> keyStrokeEnd(const Pointer& begin) const;
  /// A place on the sheet near the middle of the view where nothing is drawn.
  [[nodiscard]] CanvasPoint freePlace() const;

  /// A point in space that tells which of an element's places is meant on the sheet, for measuring.
  [[nodiscard]] virtual std::optional<Vector3> spaceAt(CanvasPoint /*place*/) const { return std::nullopt; }

  // For the drawing's use.
  [[nodiscard]] const Mechanism& mechanism() const { return *m_document->mechanism(); }
  [[nodiscard]] Document& document() { return *m_document; }
  [[nodiscard]] Selection& selection() const { return *m_selection; }
  [[nodiscard]] ElementCommands& commands() { return m_commands; }
  [[nodiscard]] const SnapshotPtr& snapshot() const { return m_snapshot; }
  void captionLater();  ///< the marks of the drawing have changed
  void setHint(const QString& hint);
  void setNotice(const QStringList& lines);
  void updateEmphases();
  void updateMessage();
  void updateCursor();
  void panBy(QPointF sheetUnits);
  void openRenameEditor(LinkId link);
  /// Does the drawing still fit the window, not moved by the user since?
  [[nodiscard]] bool isFitted() const { return m_fitted; }
  [[nodiscard]] double scaleNow() const { return transform().m11(); }
  [[nodiscard]] std::optional<ElementId> elementUnder(QPointF viewportPlace) const;

  bool event(QEvent* event) override;
  bool viewportEvent(QEvent* event) override;
  void changeEvent(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void showEvent(QShowEvent* event) override;
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
  [[nodiscard]] Highlight wantedHighlight() const;
  void showEmphases();
  void applyTheme(Theme theme);
  void escape();
  bool editKey(const QKeyEvent& event);
  bool viewKey(const QKeyEvent& event);
  bool toolKeyPressed(const QKeyEvent& event);
  bool walkKey(const QKeyEvent& event);
  void walk(int steps, bool add);
  void walkTowards(CanvasPoint direction, bool add);
  void clickCurrent();
  [[nodiscard]] QString whyNoLoadOn(const ElementId& element) const;
  /// The element of the load whose chip is at that point.
  [[nodiscard]] std::optional<ElementId> loadUnder(QPointF viewportPlace) const;
  [[nodiscard]] QString tipAt(const ElementId& element, QPointF viewportPlace) const;
  /// Handles a press on a load; false: it belongs to the tool.
  bool grabLoad(QPointF viewportPlace, Pointer pointer);
  void stepLoad(const ToolEvent& event);
  void pullLoad(const load_tool::PullTorque& pull);
  [[nodiscard]] bool isLoadDragged() const { return m_load.index() != 0; }
  [[nodiscard]] std::optional<CanvasPoint> middleOf(const ElementId& element) const;
  struct LineBox {
    QRect box;
    QStringList lines;  ///< elided to the available space
  };
  [[nodiscard]] QFont lineFont() const;
  [[nodiscard]] LineBox boxOf(const QStringList& lines, Qt::Corner corner) const;
  void updateCaptions();
  /// px of names; 0: as large as the numbers of links.
  [[nodiscard]] virtual double captionSize() const { return 0; }
  void drawLines(QPainter& painter, const LineBox& shown, const std::vector<ColorRole>& colors) const;
  void drawMessage(QPainter& painter, const QString& text) const;
  void measureFrom(const Pointer& pointer);
  void drawMeasured(QPainter& painter) const;
  /// Where a spot is on the sheet: an axis at the foot of the perpendicular from `other`, else the middle of
  /// its element; empty if that is not drawn.
  [[nodiscard]] std::optional<CanvasPoint> placeOfTaken(std::size_t which, const CanvasPoint& other) const;
  void fitTo(const QRectF& area);
  void zoomAt(QPointF viewportPlace, double factor);
  void moveView(QPointF pixels);
  [[nodiscard]] Pointer pointerAt(QPointF viewportPlace, Qt::KeyboardModifiers modifiers) const;

  Document* m_document;
  Selection* m_selection;
  Measuring* m_measuring = nullptr;
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
  bool m_isCaptioned = false;
  bool m_fitsCaptions = false;  ///< the next captions may move the sheet
  CoalescedTask m_captionTurn{this, [this] { updateCaptions(); }};
  bool m_overLoad = false;  ///< a load that can be dragged is under the mouse
  double m_largest = kLargestFit;
  QPointF m_panFrom;
  bool m_spaceDown = false;
  bool m_spaceUsed = false;
  bool m_fitted = true;                ///< the drawing was not moved by the user: it fits the window
  bool m_themeChosen = false;          ///< setTheme() was called: the palette no longer decides
  bool m_hovering = false;             ///< the hovered element was hovered in this view
  bool m_areEmphasesBehind = false;    ///< to be shown when the drawing is
  bool m_showsFocus = false;           ///< the focus came by the keyboard
  std::optional<ElementId> m_current;  ///< the last element selected by the keyboard
};

}  // namespace geargraph
