#pragma once

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
  void moved(const Pointer& pointer) override { step(Moved{meant(pointer)}); }
  void released(const Pointer& pointer) override { step(Released{meant(pointer)}); }
  [[nodiscard]] bool isIdle() const override { return m_state.index() == 0; }
  bool cancel() override;
  /// Moves the axis of what is selected, as one step.
  void nudge(double dx, double dy, bool repeated) override;
  [[nodiscard]] std::optional<Pointer> keyStrokeEnd(const Pointer& begin) const override;

 private:
  /// An axis that goes along with the mouse, until the offer after it is closed.
  struct AxisDrag {
    quint64 gesture = 0;
    PlacedMechanism before;
    SchematicPtr schematic;  ///< as it was then: what the mouse means
    AxisId axis;
  };

  void showDrawing(const SchematicPtr& schematic);
  void dragAxis(const section_tool::DragAxis& drag);
  void offerTeeth();
  void applyDragged(const Reduce& reduce);
  void endDrag();
  [[nodiscard]] std::optional<Mark> axisGhost(SheetPoint moved) const;
  /// "48 mm from axis a, module 2.3 mm"; empty where the axis has no such neighbour.
  [[nodiscard]] QString reachText();
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
  std::optional<AxisDrag> m_drag;
  bool m_fitNext = true;  ///< the next drawing is another document's
  bool m_behind = false;  ///< the document has changed since, while nobody saw it
};

}  // namespace geargraph::inline ui_schematic
