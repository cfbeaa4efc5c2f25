#pragma once

#include "ui/canvas/digraph_scene.h"
#include "ui/canvas/graph_view.h"
#include "ui/canvas/node_placer.h"

namespace geargraph::inline canvas {

/// The digraph of the document, drawn and edited [AU, Fig. 2]. The fundamental cycle of the chosen mesh is
/// shown as a walk.
class DigraphView final : public GraphView {
  Q_OBJECT

 public:
  DigraphView(Document* document, Selection* selection, QWidget* parent = nullptr);

  /// Are all links placed and drawn?
  [[nodiscard]] bool isSettled() const;

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
  [[nodiscard]] Expected<Mechanism> withLinkAt(const Mechanism& mechanism, SheetPoint at) const override;

 private:
  /// What makes a large drawing: placing its arrows and labels takes a thread of its own.
  struct Request {
    MechanismPtr mechanism;
    NodePositions places;
    DigraphGeometryPtr former;
    quint64 number = 0;
  };

  void seek(const Request& request);
  void arrived(const Request& request, const DigraphGeometryPtr& geometry);
  void tellWhenSettled();

  DigraphScene* m_scene;
  NodePlacer* m_placer;
  quint64 m_wanted = 0;  ///< the newest drawing asked for
  quint64 m_shown = 0;   ///< the newest one that is on the scene
  MechanismPtr m_drawn;  ///< whose digraph is on the scene; null while the worker places arrows
  bool m_fitWhenDrawn = false;
  RequestWorker<Request> m_worker;  ///< last: it is stopped before what it uses goes
};

}  // namespace geargraph::inline canvas
