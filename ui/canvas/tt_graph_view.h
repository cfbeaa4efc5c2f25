#pragma once

#include "core/foundations/base/request_worker.h"
#include "ui/canvas/graph_view.h"
#include "ui/canvas/tt_graph_scene.h"
#include "ui/service/background_work.h"

namespace geargraph {

/// The T-T graph of the document [AU, Figs. 5 and 6]: the tree of turning joints with the levels of its
/// branches, the chords of every mesh to its transfer vertex. For the chosen mesh the two f-circuits are
/// highlighted as walks, with its equations as text.
///
/// Levels and transfer vertices come from the analysis, so the drawing follows setSnapshot(); places follow
/// the document immediately, for drags. Nodes are placed by the layout; dragged ones keep their places, which
/// the document stores in View::ttNodes.
class TtGraphView final : public GraphView, public BackgroundWork {
  Q_OBJECT

 public:
  TtGraphView(Document* document, Selection* selection, QWidget* parent = nullptr);
  ~TtGraphView() override;

  void setSnapshot(const SnapshotPtr& snapshot) override;
  /// Is the last requested drawing shown? A hidden view requests none.
  [[nodiscard]] bool isUpToDate() const { return m_shown == m_wanted; }
  [[nodiscard]] bool isSettled() const override { return isUpToDate(); }
  [[nodiscard]] QString whyNoPicture() const override;
  void requestStop() override;
  [[nodiscard]] bool hasStopped() const override { return m_worker.hasStopped(); }

 signals:
  void drawn();

 public slots:
  void tidy() override;  ///< returns all dragged nodes to the layout

 protected:
  void rebuild() override;
  void catchUp() override;
  void forgetDocument() override;
  void showEvent(QShowEvent* event) override;
  [[nodiscard]] Highlight highlight() const override;
  [[nodiscard]] QString message() const override;
  [[nodiscard]] QString toolTipFor(const ElementId& element) const override;
  [[nodiscard]] QString captionToolTip() const override;

  [[nodiscard]] const NodePositions& positions() const override;
  [[nodiscard]] Expected<Mechanism> withMoved(const Mechanism& mechanism,
                                              const NodeMoves& places) const override;
  [[nodiscard]] Expected<Mechanism> withLinkAt(const Mechanism& mechanism, CanvasPoint at) const override;

 private:
  /// Is the analysis up to date with the document, except for places?
  [[nodiscard]] bool isAnalyzed() const;
  /// Null where the turning joints are no spanning tree.
  [[nodiscard]] const TtGraph* graph() const;
  /// A request for a drawing; a large one is made on a background thread.
  struct Request {
    MechanismPtr mechanism;
    SnapshotPtr snapshot;  ///< of the same mechanism except for places
    NodePositions layout;  ///< empty where it is not known
    quint64 number = 0;
    std::stop_token stop;  ///< when the document is no longer shown, not for newer requests
  };
  void draw();
  void drawNow();
  void arrived(const Request& request, const TtGraphSheetPtr& sheet);
  void tellWhatIsMissing();
  [[nodiscard]] QString meshTip(int mesh) const;

  TtGraphScene* m_scene;
  NodePositions m_layout;           ///< of the analysis, without dragged nodes; empty until it is drawn
  quint64 m_wanted = 0;             ///< number of the newest request
  quint64 m_shown = 0;              ///< number of the newest drawing shown
  bool m_toFit = true;              ///< a new document is not drawn yet
  bool m_behind = false;            ///< the drawing is out of date because it is hidden
  std::stop_source m_stop;          ///< of the requests of this document
  RequestWorker<Request> m_worker;  ///< last: stopped before the members it uses are destroyed
};

[[nodiscard]] ViewEntry ttGraphView();

}  // namespace geargraph
