#pragma once

#include "core/foundations/base/request_worker.h"
#include "ui/canvas/graph_view.h"
#include "ui/canvas/tt_graph_scene.h"
#include "ui/service/background_work.h"

namespace geargraph::inline canvas {

/// The T-T graph of the document [AU, Figs. 5 and 6]: the tree of turning joints with the levels of its
/// branches, the chords of every mesh to its transfer vertex. Of the chosen mesh it shows the two f-circuits
/// as walks, and its equations in words.
///
/// Levels and transfer vertices come from the analysis, so the drawing follows setSnapshot(); places follow
/// the document at once, for drags. Nodes stand where the layout puts them; those that are dragged stay where
/// they were dropped, in a member of the document of their own.
class TtGraphView final : public GraphView, public BackgroundWork {
  Q_OBJECT

 public:
  TtGraphView(Document* document, Selection* selection, QWidget* parent = nullptr);
  ~TtGraphView() override;

  void setSnapshot(const SnapshotPtr& snapshot) override;
  /// Is the newest drawing that was asked for on the scene? A hidden one is not asked for.
  [[nodiscard]] bool isUpToDate() const { return m_shown == m_wanted; }
  [[nodiscard]] QString whyNoPicture() const override;
  void tellToEnd() override;
  [[nodiscard]] bool hasEnded() const override { return m_worker.hasEnded(); }

 signals:
  void drawn();

 public slots:
  void tidy() override;  ///< gives all dragged nodes back to the layout

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
  [[nodiscard]] Expected<Mechanism> withLinkAt(const Mechanism& mechanism, SheetPoint at) const override;

 private:
  /// Is the analysis that of the document as it is now, but for where things stand?
  [[nodiscard]] bool isAnalyzed() const;
  /// Null where the turning joints are no spanning tree.
  [[nodiscard]] const TtGraph* graph() const;
  /// What makes a drawing; a large one takes a thread of its own.
  struct Request {
    MechanismPtr mechanism;
    SnapshotPtr snapshot;  ///< of the same but for where things are
    NodePositions layout;  ///< empty where it is not known
    quint64 number = 0;
    std::stop_token stop;  ///< once the document is no longer shown; newer requests let older ones end
  };
  void draw();
  void drawNow();
  void arrived(const Request& request, const TtGraphSheetPtr& sheet);
  void tellWhatIsMissing();
  [[nodiscard]] QString meshTip(int mesh) const;

  TtGraphScene* m_scene;
  NodePositions m_layout;           ///< of the analysis, without what was dragged; empty until it is drawn
  quint64 m_wanted = 0;             ///< the newest drawing asked for
  quint64 m_shown = 0;              ///< the newest one that is on the scene
  bool m_toFit = true;              ///< another document has come and is not drawn yet
  bool m_behind = false;            ///< the drawing is out of date, as it is hidden
  std::stop_source m_stop;          ///< of the requests of this document
  RequestWorker<Request> m_worker;  ///< last: it is stopped before what it uses goes
};

}  // namespace geargraph::inline canvas
