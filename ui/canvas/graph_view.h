#pragma once

#include "core/presentation/drawing/captions.h"
#include "ui/canvas/drawing_view.h"
#include "ui/canvas/node_sheet.h"
#include "ui/canvas/tool_controller.h"

namespace geargraph {

/// A drawing in which links are nodes: all tools of the tool bar apply.
class GraphView : public DrawingView, protected NodeSheet {
  Q_OBJECT

 public:
  GraphView(Document* document, Selection* selection, DrawingScene* scene, QWidget* parent = nullptr);
  ~GraphView() override;

  [[nodiscard]] ToolKind tool() const override { return m_controller->tool(); }
  void setTool(ToolKind tool) override { m_controller->setTool(tool); }
  void setGrid(bool on) override;
  [[nodiscard]] bool showsNotes() const override { return false; }  // overrides both bases
  /// Opens the in-place editor for a new note centred at `at`, or for the text of `note`.
  void openNoteEditor(CanvasPoint at, const std::optional<NoteId>& note = {});

  /// Highlights the circuit of this mesh. With an empty id the view decides: the mesh of a completely hovered
  /// cycle (a row of C in the matrices), else a mesh that is selected alone.
  void showCycle(MeshId mesh);
  /// While they are hidden no circuit is highlighted: a question may ask for it.
  void setAnswersOpen(bool isOpen) override;

 public slots:
  void toggleInputs() override;

 protected:
  [[nodiscard]] double captionSize() const override { return kGraphNameSize; }
  void forgetDocument() override { m_wantedCycle = {}; }
  [[nodiscard]] QString message() const override;
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void drawBackground(QPainter* painter, const QRectF& rect) override;
  void adjustMenu(ContextActions& actions, CanvasPoint at) override;
  void openElement(const ElementId& element) override;
  void pressed(const Pointer& pointer) override;
  void moved(const Pointer& pointer) override;
  void released(const Pointer& pointer) override;
  [[nodiscard]] bool isIdle() const override { return m_controller->isIdle(); }
  bool cancel() override;
  void nudge(double dx, double dy, bool repeated) override { m_controller->nudge(dx, dy, repeated); }

  /// The mesh whose circuit is highlighted; empty if there is none, or no analysis yet.
  [[nodiscard]] MeshId chosenMesh() const;
  /// The choice of axis by a key while a joint is being drawn.
  [[nodiscard]] std::optional<AxisChoice::Way> axisKey(const QKeyEvent& event) const;
  /// Moves all these links to their places, as one undo step.
  void place(const NodePositions& positions) { m_controller->place(positions); }

  /// Adds a note, if the drawing shows notes.
  [[nodiscard]] virtual Expected<Mechanism> withNoteAt(const Mechanism& mechanism, CanvasPoint at,
                                                       const std::string& text) const;

  [[nodiscard]] const std::vector<Outline>& outlines() const override { return m_sheet->outlines(); }
  void setOverlay(DisplayList overlay) override { m_sheet->setOverlay(std::move(overlay)); }

 private:
  void takeNote(CanvasPoint at, const std::optional<NoteId>& note, const std::string& text);

  DrawingScene* m_sheet;
  ToolController* m_controller;
  MeshId m_wantedCycle;
  bool m_showsCircuits = true;
};

}  // namespace geargraph
