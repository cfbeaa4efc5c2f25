#pragma once

#include <QGraphicsView>
#include <optional>

#include "core/analysis/analysis.h"
#include "core/drawing/palette.h"
#include "ui/document/document.h"
#include "ui/selection/selection.h"
#include "ui/tools/tool.h"

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
  ~DigraphView() override;

  [[nodiscard]] ToolKind tool() const;
  void setTool(ToolKind tool);
  /// What the tool expects next, as last told by hintChanged().
  [[nodiscard]] QString hint() const;

  /// The newest analysis, for the cycles; the drawing itself needs none.
  void setSnapshot(const SnapshotPtr& snapshot);
  /// Shows the fundamental cycle of this mesh as a walk; an empty id shows none. Without it, the cycle of a
  /// mesh that is selected alone is shown.
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

 signals:
  void toolChanged(geargraph::ToolKind tool);
  void hintChanged(const QString& hint);
  /// While an arrow is being drawn: the joint it would make; nothing when it is done or given up.
  void previewChanged(const std::optional<geargraph::JointPreview>& preview);
  /// A double click on what has no name to edit in place: show its properties.
  void propertiesWanted(const geargraph::ElementId& element);
  /// Space was tapped, not held for panning: play or pause.
  void spaceTapped();

 private:
  class Private;
  std::unique_ptr<Private> d;
};

}  // namespace geargraph
