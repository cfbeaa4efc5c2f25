#pragma once

#include "ui/canvas/axis_drag.h"
#include "ui/canvas/drawing_view.h"
#include "ui/canvas/schematic_service.h"
#include "ui/tools/section_tool.h"

namespace geargraph {

/// The functional schematic of the document [AU, Figs. 1 and 3]. It is laid out on a background thread
/// whenever the document changes; until then the last drawing is shown. A hidden view waits until it is
/// shown, or until its picture() is requested.
///
/// Tools: Link draws a shaft on an existing or a new axis; Turning joint draws a shaft carried by a link;
/// Gear mesh draws two meshing gears, or a gear and a ring gear. Select drags axes: the module follows the
/// mouse, and when the axis is dropped, tooth numbers that approximate its place are offered. All of that is
/// one undo step; while a position is impossible the last valid drawing stays.
class SchematicView : public DrawingView {
  Q_OBJECT

 public:
  SchematicView(Document* document, Selection* selection, QWidget* parent = nullptr);

  /// Is the current document drawn?
  [[nodiscard]] bool isUpToDate() const { return !m_behind && isSettled(); }
  /// Have all requested layouts been drawn? While hidden, the view may not have requested the current
  /// document's.
  [[nodiscard]] bool isSettled() const override { return m_service->isUpToDate(); }
  [[nodiscard]] QString whyNoPicture() const override;
  void setTool(ToolKind tool) override;
  [[nodiscard]] PowerDraw powerDraw() const override;

 signals:
  /// The current document is drawn.
  void drawn();

 protected:
  void rebuild() override;
  /// Waits for the layout, but only briefly: isUpToDate() tells whether it arrived.
  void catchUp() override;
  void showEvent(QShowEvent* event) override;
  void forgetDocument() override { m_fitNext = true; }
  [[nodiscard]] QString message() const override;
  void adjustMenu(ContextActions& actions, CanvasPoint at) override;
  /// For an axis, opens the properties of its joints, which include its place.
  void openElement(const ElementId& element) override;
  void pressed(const Pointer& pointer) override;
  void moved(const Pointer& pointer) override;
  void released(const Pointer& pointer) override;
  [[nodiscard]] bool isIdle() const override { return m_state.index() == 0 && !m_rim; }
  bool cancel() override;
  /// Moves the axis of the selected element, as one undo step.
  void nudge(double dx, double dy, bool repeated) override;
  [[nodiscard]] std::optional<Pointer> keyStrokeEnd(const Pointer& begin) const override;
  [[nodiscard]] std::optional<Vector3> spaceAt(CanvasPoint place) const override;

 private:
  /// A drag of an axis, until the offer of tooth numbers after it is closed.
  struct DraggedOn {
    SchematicPtr schematic;  ///< at the start of the drag, for interpreting the mouse
    AxisId axis;
  };

  /// A drag of a gear's rim, which changes its tooth count.
  struct RimDrag {
    quint64 gesture = 0;
    PlacedMechanism before;
    SheetRim rim;
    CanvasPoint from;
    std::optional<DraggedTeeth> teeth = {};  ///< requested by the mouse; empty until it has moved
    int shown = 0;                           ///< the last tooth count that was applied; 0: none yet
    CanvasPoint at = {};
  };

  void showDrawing(const SchematicPtr& schematic);
  bool grabRim(const Pointer& pointer);
  void dragRim(const Pointer& pointer);
  void endRim();
  [[nodiscard]] DisplayList rimLabel() const;
  void dragAxis(const section_tool::DragAxis& drag);
  void endDrag();
  [[nodiscard]] std::optional<Mark> axisPreview(CanvasPoint moved) const;
  void step(const ToolEvent& event);
  /// For the tools, a bearing is replaced by the shaft in it.
  [[nodiscard]] Pointer meant(Pointer pointer) const;
  void addShaft(const section_tool::AddShaft& shaft);
  void meshLinks(const section_tool::MeshLinks& mesh);
  void showState();

  SchematicService* m_service;
  DrawingScene* m_sheet;
  SchematicPtr m_schematic;
  section_tool::State m_state;
  AxisDrag* m_axisDrag;
  std::optional<DraggedOn> m_drag;
  std::optional<RimDrag> m_rim;
  bool m_fitNext = true;  ///< the next drawing is of another document
  bool m_behind = false;  ///< the document has changed while the view was hidden
};

[[nodiscard]] ViewEntry schematicView();

}  // namespace geargraph
