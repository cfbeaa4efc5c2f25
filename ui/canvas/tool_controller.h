#pragma once

#include <QObject>
#include <QPointF>

#include "core/mechanism/geometry_edits/axis_choice.h"
#include "ui/canvas/node_sheet.h"
#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/tools/snapping.h"
#include "ui/tools/tool_machine.h"

namespace geargraph {

/// Carries out the proposals of tools: as edits of the document, as selection, and as overlay of the drawing;
/// it numbers the gestures. The only place where the mouse changes a document.
class ToolController final : public QObject {
  Q_OBJECT

 public:
  ToolController(Document& document, Selection& selection, NodeSheet& sheet, QObject* parent);

  static constexpr double kGridStep = 20;

  [[nodiscard]] ToolKind tool() const { return m_machine.tool(); }
  void setGrid(bool on) { m_grid = on; }
  [[nodiscard]] bool hasGrid() const { return m_grid; }
  void setTool(ToolKind tool);
  [[nodiscard]] bool isIdle() const { return m_machine.isIdle(); }
  [[nodiscard]] QString hint() const { return m_hint; }

  /// Is a turning joint being drawn?
  [[nodiscard]] bool isDrawingJoint() const;
  /// Sets the axis of that joint; without it the program guesses. Applies to this joint only.
  void setAxisOfStroke(AxisChoice::Way way);

  /// `scale`: pixels per unit of the sheet, for the width of the overlay's lines.
  void handle(const ToolEvent& event, double scale);

  // Commands of keys and menus, one undo step each.
  void toggleInputs(const std::set<ElementId>& elements);
  void nudge(double dx, double dy, bool repeated);
  void addLink(CanvasPoint at);
  void place(const NodePositions& positions);

 signals:
  /// The user wants to type the text of a note: of a new one centred at `at`, or of `note`.
  void noteWanted(geargraph::CanvasPoint at, const std::optional<geargraph::NoteId>& note);
  void toolChanged(geargraph::ToolKind tool);
  void hintChanged(const QString& hint);
  void previewChanged(const std::optional<geargraph::JointPreview>& preview);
  void panned(QPointF by);  ///< sheet units

 private:
  struct Drag {
    quint64 gesture = 0;
    MechanismPtr before;
    NodeMoves moving;  ///< the nodes' places before
    NoteMoves notes;   ///< the notes' places before
    std::vector<CanvasPoint> resting;
  };

  void carryOut(const Proposal& proposal);
  void moveSelected(const MoveSelected& move);
  void cancelMove();
  void moveTo(const QString& text, NodeMoves places, NoteMoves notes, quint64 gesture);
  void writeNote(const WriteNote& note);
  void addJoint(const AddJoint& joint);
  void selectInside(const SelectInside& band);
  [[nodiscard]] Drag beginDrag();
  void apply(const QString& text, Reduce reduce, quint64 gesture = 0);
  void showState();
  [[nodiscard]] QString withAxisOfStroke(const QString& hint) const;
  [[nodiscard]] QString previewAndHint(std::optional<JointPreview>& preview) const;
  /// A line through all nodes of a row or column.
  [[nodiscard]] Curve guide(const std::function<bool(CanvasPoint)>& isOnLine) const;
  [[nodiscard]] DisplayList overlay() const;

  Document& m_document;
  Selection& m_selection;
  NodeSheet& m_sheet;
  ToolMachine m_machine{ToolKind::select};
  std::optional<Drag> m_drag;
  Snap m_snap;
  std::optional<AxisChoice::Way> m_axisOfStroke;
  quint64 m_nudge = 0;  ///< the gesture of the arrow key that is held
  double m_scale = 1;
  bool m_grid = false;
  QString m_notice;  ///< why the last click did nothing; kept until the next one
  QString m_hint;
  std::optional<JointPreview> m_preview;
};

}  // namespace geargraph
