#pragma once

#include "ui/canvas/axis_drag.h"
#include "ui/canvas/drawing_view.h"
#include "ui/schematic/schematic_service.h"
#include "ui/tools/section_tool.h"

namespace geargraph::inline ui_schematic {

/// The functional schematic of the document [AU, Figs. 1 and 3]. The program lays it out, on a thread of its
/// own, whenever the document changes; until then the last drawing stands. One that nobody sees waits until
/// it is shown, or until its picture() is asked for.
///
/// The tools draw in it: Link a shaft, on an axis that is there or on a new one; Turning joint a shaft that a
/// link carries; Gear mesh two wheels in mesh, or a wheel and a ring. Select drags axes: the module follows
/// the mouse, and where the axis is dropped the tooth counts that come near it are offered. All of that is
/// one undo step; the last valid picture stands while something cannot be.
class SchematicView : public DrawingView {
  Q_OBJECT

 public:
  SchematicView(Document* document, Selection* selection, QWidget* parent = nullptr);

  /// Is the document as it is now drawn?
  [[nodiscard]] bool isUpToDate() const { return !m_behind && isSettled(); }
  /// Has all that was to be laid out been drawn? While nobody sees it that may be less than the document.
  [[nodiscard]] bool isSettled() const { return m_service->isUpToDate(); }
  [[nodiscard]] QString whyNoPicture() const override;
  void setTool(ToolKind tool) override;
  [[nodiscard]] PowerDraw powerDraw() const override;

 signals:
  /// The document as it is now is drawn.
  void drawn();

 protected:
  void rebuild() override;
  /// Waits no longer than a moment: isUpToDate() tells whether that was long enough.
  void catchUp() override;
  void showEvent(QShowEvent* event) override;
  void forgetDocument() override { m_fitNext = true; }
  [[nodiscard]] QString message() const override;
  void adjustMenu(ContextActions& actions, SheetPoint at) override;
  /// An axis has its places among the properties of its joints.
  void openElement(const ElementId& element) override;
  void pressed(const Pointer& pointer) override;
  void moved(const Pointer& pointer) override;
  void released(const Pointer& pointer) override;
  [[nodiscard]] bool isIdle() const override { return m_state.index() == 0 && !m_rim; }
  bool cancel() override;
  /// Moves the axis of what is selected, as one step.
  void nudge(double dx, double dy, bool repeated) override;
  [[nodiscard]] std::optional<Pointer> keyStrokeEnd(const Pointer& begin) const override;

 private:
  /// An axis that goes along with the mouse, until the offer after it is closed.
  struct DraggedOn {
    SchematicPtr schematic;  ///< as it was when the drag began: what the mouse means
    AxisId axis;
  };

  /// The rim of a gear that goes along with the mouse: its teeth change.
  struct RimDrag {
    quint64 gesture = 0;
    PlacedMechanism before;
    SheetRim rim;
    SheetPoint from;
    std::optional<DraggedTeeth> teeth = {};  ///< as the mouse wants them, since it has been moved
    int shown = 0;                           ///< teeth of the gear as they are; 0: as they were
    SheetPoint at = {};
  };

  void showDrawing(const SchematicPtr& schematic);
  bool grabRim(const Pointer& pointer);
  void dragRim(const Pointer& pointer);
  void endRim();
  [[nodiscard]] DisplayList rimLabel() const;
  void dragAxis(const section_tool::DragAxis& drag);
  void endDrag();
  [[nodiscard]] std::optional<Mark> axisGhost(SheetPoint moved) const;
  void step(const ToolEvent& event);
  /// A bearing stands for the shaft in it, as far as tools go.
  [[nodiscard]] Pointer meant(Pointer pointer) const;
  void addShaft(const section_tool::AddShaft& shaft);
  void meshLinks(const section_tool::MeshLinks& mesh);
  void showState();

  SchematicService* m_service;
  DrawingScene* m_sheet;
  SchematicPtr m_schematic;
  section_tool::State m_state;
  canvas::AxisDrag* m_axisDrag;
  std::optional<DraggedOn> m_drag;
  std::optional<RimDrag> m_rim;
  bool m_fitNext = true;  ///< the next drawing is another document's
  bool m_behind = false;  ///< the document has changed since, while nobody saw it
};

}  // namespace geargraph::inline ui_schematic
