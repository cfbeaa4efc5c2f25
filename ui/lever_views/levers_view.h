#pragma once

#include <optional>

#include "core/presentation/diagrams/lever_drawing.h"
#include "core/presentation/diagrams/nomogram.h"
#include "core/presentation/diagrams/point_plan.h"
#include "ui/canvas/drawing_view.h"
#include "ui/lever_views/levers_service.h"
#include "ui/lever_views/speed_drag.h"

class QVariantAnimation;

namespace geargraph {

class LeversBar;
class PointOffers;

/// The links of the ground's axis as points on levers, the states of a gearbox as a nomogram, the plane of
/// two freedoms, and Kutzbach's speed plan; a row above the drawing chooses one. Laid out on a background
/// thread for each snapshot while it is shown; the last drawing stays meanwhile.
///
/// A click on a point of a lever or of the plane offers to hold its link and to lock it with another one.
/// Levers: an arrow of a speed is dragged, and the train turns live, as one undo step; a double click or
/// Return on a point types its speed; a disc dragged onto another one engages a new clutch between them. The
/// arrow keys walk along a bar, Tab goes to the next one and after the last one on to the next control.
/// Nomogram: a click on a line or a tag engages its state; Up and Down walk from state to state, Return
/// engages; the state that is looked at is told by stateLookedAtChanged(). Plane: a coupling that is engaged
/// projects it, animated.
class LeversView final : public DrawingView {
  Q_OBJECT

 public:
  LeversView(Document* document, Selection* selection, QWidget* parent = nullptr);

  void setSnapshot(const SnapshotPtr& snapshot) override;
  void setAnswersOpen(bool isOpen) override;
  /// Does a lesson's step ask to read this view? Then it is shown without numbers, and cannot be edited, also
  /// while answers are closed.
  void setRead(bool isRead);
  /// Is the newest analysis drawn?
  [[nodiscard]] bool isUpToDate() const;
  /// Has all been drawn that was asked for? A hidden view asks for nothing.
  [[nodiscard]] bool isSettled() const override { return m_service->isUpToDate() && !m_projecting; }
  [[nodiscard]] QString whyNoPicture() const override;

  [[nodiscard]] LeversPage page() const;
  void setPage(LeversPage page);
  [[nodiscard]] LeversBar& bar() const { return *m_bar; }

  /// The points of the levers as drawn now, and the nomogram; empty on other pages.
  [[nodiscard]] const std::vector<LeverSpot>& spots() const { return m_levers.spots; }
  [[nodiscard]] const NomogramSheet& nomogram() const { return m_nomogram; }
  /// The points of the plane as drawn now; empty on other pages.
  [[nodiscard]] const std::vector<PointPlanSheet::Spot>& planSpots() const { return m_points.spots; }
  /// What is offered at the point that was clicked.
  [[nodiscard]] PointOffers& offers() const { return *m_offers; }
  /// The state that is looked at by mouse or keys, by position.
  [[nodiscard]] std::optional<int> stateLookedAt() const { return m_state; }
  /// The card of a point, as rich text.
  [[nodiscard]] QString cardOf(const LeverSpot& spot) const;

 public slots:
  /// Looks at the state under the mouse in another view; -1: at none.
  void lookAtState(int state);

 signals:
  /// What was asked for is drawn.
  void drawn();
  /// By mouse or keys in the nomogram; -1: at none.
  void stateLookedAtChanged(int state);

 protected:
  void rebuild() override;
  void catchUp() override;
  void forgetDocument() override;
  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;
  bool viewportEvent(QEvent* event) override;
  bool focusNextPrevChild(bool next) override;
  [[nodiscard]] QString message() const override;
  [[nodiscard]] QString toolTipFor(const ElementId& element) const override;
  void adjustMenu(ContextActions& actions, CanvasPoint at) override;
  void openElement(const ElementId& element) override;
  void pressed(const Pointer& pointer) override;
  void moved(const Pointer& pointer) override;
  void released(const Pointer& pointer) override;
  [[nodiscard]] bool isIdle() const override { return !m_pull && !m_tie; }
  bool cancel() override;
  void nudge(double dx, double dy, bool repeated) override;

 private:
  /// The drag of a speed.
  struct Pull {
    quint64 gesture = 0;
    PlacedMechanism before;
    SpeedHandle handle;
    double left = 0;   ///< x of speed 0 on the sheet
    double scale = 0;  ///< px for 1 rad/s
    bool hasMoved = false;
  };
  /// A disc of a lever or of the plane.
  struct Disc {
    LinkOrdinal link;  ///< the first at the point
    CanvasPoint center;
    int spot = -1;  ///< of the levers
  };
  /// The drag from one disc to another, or the line to the mouse after "Lock with".
  struct Tie {
    LinkOrdinal from;
    CanvasPoint begin;
    CanvasPoint end;
    bool hasMoved = false;
    bool isOffered = false;  ///< the next click ends it
  };

  void ask();
  void receive(const DrawnLeversPtr& drawn);
  void choosePage();
  void redraw();
  void showOverlay();
  void layOutBar();
  /// What is wrong with the page, as a sentence; empty if it shows something.
  [[nodiscard]] QString missing() const;
  [[nodiscard]] bool shows(LeversPage page) const;
  [[nodiscard]] const Mechanism& drawnMechanism() const { return *m_drawn->snapshot->mechanism; }
  [[nodiscard]] const LeverPoint& pointOf(const LeverSpot& spot) const;
  [[nodiscard]] LinkId linkOf(const LeverSpot& spot) const;
  /// The point of a lever whose disc is there; -1 for none.
  [[nodiscard]] int discAt(CanvasPoint place) const;
  /// The same on levers and in the plane.
  [[nodiscard]] std::optional<Disc> anyDiscAt(CanvasPoint place) const;
  void offer(const Disc& disc);
  void hideOffers();
  void startTie();
  void endTie(const Pointer& pointer);
  void project(const DrawnLeversPtr& before);
  /// The point whose arrow of a speed ends there, beside its disc; -1 for none.
  [[nodiscard]] int arrowAt(CanvasPoint place) const;
  [[nodiscard]] std::optional<int> stateAt(CanvasPoint place) const;
  void lookAt(std::optional<int> state);
  void engageState(int state);
  bool grabTip(const Pointer& pointer);
  void pull(const Pointer& pointer);
  void endPull();
  void typeSpeed(const LeverSpot& spot);
  void setSpeedOf(LinkId link, const QString& typed);
  void tie(LinkOrdinal from, LinkOrdinal to);
  /// The point that the keys are at: of the selected link; -1 for none.
  [[nodiscard]] int current() const;
  void goTo(int spot);
  bool walkBars(int steps);
  bool walkStates(int steps);
  void tellWhatToDo();

  LeversService* m_service;
  DrawingScene* m_sheet;
  LeversBar* m_bar;
  DrawnLeversPtr m_drawn;  ///< null before the first answer, and for another document
  LeverSheet m_levers;
  NomogramSheet m_nomogram;
  PointPlanSheet m_points;
  PointOffers* m_offers;
  std::optional<Disc> m_offered;
  QVariantAnimation* m_projecting = nullptr;  ///< while a coupling projects the plane
  std::optional<Pull> m_pull;
  std::optional<Tie> m_tie;
  std::optional<int> m_state;
  std::optional<int> m_pressedState;
  int m_walked = -1;         ///< the point where the keys were last
  bool m_isOverTip = false;  ///< an arrow that can be dragged is under the mouse
  bool m_isOpen = true;      ///< as setAnswersOpen() says
  bool m_isRead = false;     ///< as setRead() says
  bool m_fitNext = true;     ///< the next drawing is of another document or page
  bool m_behind = false;     ///< the snapshot has changed while the view was hidden
};

[[nodiscard]] ViewEntry leversView();

}  // namespace geargraph
