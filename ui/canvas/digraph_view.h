#pragma once

#include "ui/canvas/cycle_walk.h"
#include "ui/canvas/digraph_scene.h"
#include "ui/canvas/graph_view.h"
#include "ui/canvas/node_placer.h"

namespace geargraph {

/// The digraph of the document, drawn and edited [AU, Fig. 2].
class DigraphView final : public GraphView {
  Q_OBJECT

 public:
  DigraphView(Document* document, Selection* selection, QWidget* parent = nullptr);

  /// Shows the fundamental cycle of this mesh as a walk. With an empty id the view decides: the cycle all of
  /// which is hovered (a row of C in the matrices), else that of the mesh that is selected alone.
  void showCycle(MeshId mesh);

 public slots:
  void tidy() override;

 protected:
  void rebuild() override;
  void forgetDocument() override;
  [[nodiscard]] Highlight highlight() const override;
  [[nodiscard]] QString message() const override;

  [[nodiscard]] const NodePositions& positions() const override { return m_scene->positions(); }
  [[nodiscard]] Expected<Mechanism> withMoved(const Mechanism& mechanism,
                                              const NodeMoves& places) const override;
  [[nodiscard]] Expected<Mechanism> withLinkAt(const Mechanism& mechanism, SheetPoint at) const override;

 private:
  [[nodiscard]] std::optional<CycleWalk> shownCycle() const;

  DigraphScene* m_scene;
  NodePlacer* m_placer;
  MeshId m_wantedCycle;
};

}  // namespace geargraph
