#pragma once

#include "ui/canvas/digraph_scene.h"
#include "ui/canvas/graph_view.h"
#include "ui/canvas/node_placer.h"
#include "ui/service/service.h"

namespace geargraph {

/// The digraph of the document, drawn and edited [AU, Fig. 2]. The fundamental cycle of the chosen mesh is
/// highlighted as a walk.
class DigraphView final : public GraphView {
  Q_OBJECT

 public:
  DigraphView(Document* document, Selection* selection, QWidget* parent = nullptr);

  /// Are all links placed and drawn?
  [[nodiscard]] bool isSettled() const override;
  [[nodiscard]] PowerDraw powerDraw() const override;
  [[nodiscard]] bool showsNotes() const override { return true; }

 signals:
  void settled();

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
  [[nodiscard]] Expected<Mechanism> withLinkAt(const Mechanism& mechanism, CanvasPoint at) const override;
  [[nodiscard]] Expected<Mechanism> withNoteAt(const Mechanism& mechanism, CanvasPoint at,
                                               const std::string& text) const override;

 private:
  /// A request for a large drawing, whose arrows and labels are placed on a background thread.
  struct Request {
    MechanismPtr mechanism;
    NodePositions places;
    DigraphGeometryPtr former;
  };
  struct Drawing {
    NodePositions places;
    DigraphGeometryPtr geometry;
  };
  using Drawings = Service<Request, Drawing>;

  void emitSettledIfIdle();

  DigraphScene* m_scene;
  NodePlacer* m_placer;
  Drawings* m_drawings;  ///< of large documents
  MechanismPtr m_drawn;  ///< whose digraph is on the scene; null while a large one is being drawn
  bool m_fitWhenDrawn = false;
};

[[nodiscard]] ViewEntry digraphView();

}  // namespace geargraph
