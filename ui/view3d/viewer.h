#pragma once

#include <QObject>
#include <QPointF>
#include <QTimer>
#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "core/presentation/painting/renderer.h"
#include "core/presentation/stage/stage.h"
#include "core/presentation/stage/stage_view.h"
#include "ui/selection/selection.h"
#include "ui/view3d/overlay.h"
#include "ui/view3d/view_options.h"

class QKeyEvent;
class QNativeGestureEvent;
class QMouseEvent;
class QWheelEvent;

namespace geargraph::inline view3d {

/// What the middle button does, with Shift and Ctrl, as other programs have it.
enum class Navigation {
  blender,     ///< orbit; Shift: pan; Ctrl: zoom
  freeCad,     ///< pan; Shift: orbit; Ctrl: zoom
  solidWorks,  ///< orbit; Ctrl: pan; Shift: zoom
};

/// What a canvas of the 3D view shows and how the hand moves it, without any painting: the stage, the poses
/// of the moment, the camera, what is lit up, and the gestures.
///
///     left drag on a part        turn the train wheel         zoom at the pointer
///     left drag elsewhere        orbit          click         select (Ctrl: add or take away)
///     right or Shift+left drag   pan            right click   menuWanted()
///     Ctrl+left drag on a part   turn it        arrows        orbit (Shift: pan)
///     two fingers on a pad       pan            + -           zoom
///     pinch, or with Ctrl        zoom           middle drag   as Navigation says
///
/// A part that is dragged takes the train with it as its inputs run: the time goes where the part is held.
/// One that their speeds leave at rest, and any with Ctrl, is turned by hand: it takes the inputs with it, as
/// little as will do (least squares), and they all the rest.
class Viewer : public QObject {
  Q_OBJECT

  enum class Gesture { none, orbit, pan, zoom, time, turn, grab };

 public:
  using Answer = std::function<void(const std::optional<Hit>& hit)>;
  enum class PickFor { hover, gesture };
  /// Asks the canvas what is under a place of the picture. It answers at once or later, on the viewer's
  /// thread and in the order of the questions; for hovering only the newest question has to be answered.
  using Pick = std::function<void(const Frame& frame, double x, double y, PickFor use, Answer answer)>;

  explicit Viewer(Selection* selection, QObject* parent = nullptr);

  /// What is shown. Camera, time and traced paths stay, paths for links that are still there.
  void setStage(StagePtr stage);
  /// The next stage is that of another document: it is fitted, or seen from where the document says.
  void startAnew(const std::optional<Camera>& camera);
  [[nodiscard]] const StagePtr& stage() const { return m_stage; }
  /// Poses for this time: all inputs run at their speeds from where hands have put them.
  void setTime(double seconds);
  /// Moves the inputs so instead of at their speeds; null: at their speeds. The paths of traced points
  /// follow.
  void setTrajectory(InputTrajectoryPtr trajectory);
  /// The clock runs: a view that gets lower or higher does not fit the train anew.
  void setRunning(bool running) { m_isRunning = running; }
  /// Angles that hands have added to the inputs, rad.
  [[nodiscard]] const std::vector<double>& turnedByHand() const { return m_view.turned; }
  void setTurnedByHand(std::vector<double> angles);
  [[nodiscard]] std::span<const Pose> poses() const { return m_seen.poses; }
  [[nodiscard]] std::span<const Showing> showing() const { return m_showing; }
  [[nodiscard]] std::optional<CutPlane> cut() const;

  [[nodiscard]] const ViewOptions& options() const { return m_options; }
  void setOptions(const ViewOptions& options);
  /// The link that stands still while all else moves about it; none: the ground.
  [[nodiscard]] const std::optional<ElementId>& ridden() const { return m_view.ridden; }
  void rideAlong(const std::optional<ElementId>& link);
  [[nodiscard]] const std::set<ElementId>& hidden() const { return m_view.hidden; }
  void setHidden(std::set<ElementId> links);
  /// Forces of the stage, which the marks of the options show; null: there are none.
  /// `caption`: why some are missing, or all.
  void setForces(StageForces forces, const QString& caption);
  [[nodiscard]] const QString& forcesCaption() const { return m_forcesCaption; }
  [[nodiscard]] ShownForces shownForces() const;
  /// The direction of the line that a link turns about, as it is seen; none where it does not turn.
  [[nodiscard]] std::optional<Eigen::Vector3d> axisOf(const ElementId& link) const;

  /// Shows the path of the point over one period, or a minute where there is none, as the ridden link sees
  /// it. False where nothing moves.
  bool trace(const Hit& hit);
  void clearTraces();
  [[nodiscard]] const std::vector<ShownTrace>& traces() const { return m_view.traces; }

  [[nodiscard]] const Camera& camera() const { return m_view.camera; }
  /// Somebody has chosen the camera, here or in the document: it is worth being kept.
  [[nodiscard]] bool isCameraChosen() const { return m_isCameraChosen; }
  /// All that is shown, as a picture elsewhere takes it.
  [[nodiscard]] const StageView& view() const { return m_view; }
  void setCamera(const Camera& camera);
  void showFrom(StandardView view);
  void fit();

  void setNavigation(Navigation navigation) { m_navigation = navigation; }
  void setLook(const Look& look);
  /// Open questions are dropped.
  void setPick(Pick pick);
  /// The canvas' size in device pixels, and how many of them a logical pixel is.
  void setViewport(const Viewport& viewport, double pixelRatio);
  [[nodiscard]] const Viewport& viewport() const { return m_viewport; }
  [[nodiscard]] double pixelRatio() const { return m_pixelRatio; }

  /// How long the last picture took. While one costs more than half a frame, what is pointed at in other
  /// views lights up here only when the hand rests, so that a large train painted by the processor holds
  /// nobody up.
  void setPictureCost(double milliseconds) { m_pictureCost = milliseconds; }

  /// The picture of the moment. `quick`: while it moves on slow hardware. Valid until the next change.
  [[nodiscard]] Frame frame(bool quick = false) const;

  /// The gestures above, of a canvas that has installed the viewer as its filter.
  bool eventFilter(QObject* canvas, QEvent* event) override;
  /// @return the event was one of the gestures above
  bool keyPress(const QKeyEvent& event);

 signals:
  void sceneChanged();  ///< other solids or instances
  void viewChanged();   ///< anything that is painted
  void cameraChanged();
  void optionsChanged();  ///< of options, the ridden link, what is hidden, the traces
  void menuWanted(const std::optional<geargraph::Hit>& hit, const QPointF& place);
  void turnedByHandChanged();
  void timeWanted(double seconds);  ///< a hand has taken the train there
  /// What the hand points at: a part that turns the train, another one, nothing. Empty: the pointer is gone.
  void pointed(const QString& hint);
  void limitReached(const QString& joint);  ///< a hand tried to turn a joint beyond its limit
  void moving();  ///< the hand or the clock moves the picture: more changes will follow at once

 private:
  /// What the pointer does before it is known what it has grabbed.
  struct Grab {
    std::vector<QPointF> steps;
    bool isByHand = false;  ///< Ctrl is held
  };
  /// Notches of a wheel until it is known what is under the pointer.
  struct Zoom {
    QPointF place;
    double factor = 1;
  };

  /// @return the event was one of the gestures
  bool mousePress(const QMouseEvent& event);
  bool mouseMove(const QMouseEvent& event);
  bool mouseRelease(const QMouseEvent& event);
  bool wheel(const QWheelEvent& event);
  bool nativeGesture(const QNativeGestureEvent& event);
  void leave();
  void lightUp();
  void place();
  void renewShowing();
  void renewMarks();
  [[nodiscard]] std::vector<Eigen::Vector3d> outlinePoints();
  [[nodiscard]] bool isAllInside();
  void fitNow();
  [[nodiscard]] std::optional<std::size_t> instance(const std::optional<ElementId>& link) const;
  void renewTraces(const Stage& before);
  [[nodiscard]] TracedPath pathOf(const TracedPoint& point) const;
  void turn(Hit& held, const QPointF& step);
  void lightUpHovered();
  void ask(const QPointF& place, PickFor use, Answer answer);
  void dropQuestions();
  void hover(const QPointF& place);
  void grab(const QPointF& place, bool isByHand);
  [[nodiscard]] Gesture gestureOf(const QMouseEvent& event) const;
  [[nodiscard]] Gesture gestureOn(const std::optional<Hit>& hit, bool isByHand) const;
  [[nodiscard]] double rateOf(std::size_t instance) const;
  [[nodiscard]] std::optional<double> angleOf(const Hit& held, const QPointF& step) const;
  [[nodiscard]] Pose displacementOf(std::size_t instance) const;
  void runTo(Hit& held, const QPointF& step);
  void drag(Gesture gesture, std::optional<Hit>& held, const QPointF& step);
  void click(const std::optional<Hit>& hit, bool isAdded);
  void zoomAt(const QPointF& place, double factor);

  Selection* m_selection;
  StagePtr m_stage;
  StageView m_view;
  QString m_forcesCaption;
  SeenPoses m_seen;
  std::optional<double> m_floor;  ///< where it is not that of the scene
  // Both look at every vertex: worked out where they are needed, not at every step of a drag.
  std::vector<Eigen::Vector3d> m_separations;  ///< of the stage once it has been pulled apart; else empty
  std::shared_ptr<const SolidOutlines> m_outlines;  ///< of the stage once it has been fitted
  mutable std::optional<Bounds> m_bounds;           ///< of the scene once it has been cut
  ViewOptions m_options;
  std::vector<Highlight> m_emphasis;
  std::vector<Showing> m_showing;
  std::vector<MarkLine> m_marks;
  Viewport m_viewport;
  double m_pixelRatio = 1;
  bool m_fitted = false;  ///< the first size a stage is seen in fits it, and every size of an unchosen camera
  bool m_isRunning = false;
  bool m_isAnew = false;  ///< the next stage is that of another document
  bool m_isCameraChosen = false;
  std::optional<Camera> m_opening;  ///< where that document wants to be seen from
  Pick m_pick;
  Gesture m_gesture = Gesture::none;
  Navigation m_navigation = Navigation::blender;
  QPointF m_pressedAt;
  QPointF m_last;
  bool m_dragged = false;
  std::optional<Hit> m_held;  ///< what Ctrl was pressed on, and where, in the world
  std::shared_ptr<Grab> m_grab;
  std::shared_ptr<Zoom> m_zoom;
  bool m_isPointedAt = false;  ///< the pointer is in the picture
  int m_dropped = 0;           ///< how often all open questions were dropped
  double m_pictureCost = 0;    ///< ms
  QTimer m_whenHandRests;
};

}  // namespace geargraph::inline view3d
