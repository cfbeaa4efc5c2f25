#pragma once

#include <QObject>
#include <QPointF>
#include <QTimer>
#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "core/presentation/scene/renderer.h"
#include "core/presentation/scene3d/scene_view.h"
#include "core/presentation/scene3d/stage.h"
#include "ui/document/selection.h"
#include "ui/service/service.h"
#include "ui/view3d/overlay.h"
#include "ui/view3d/view_options.h"

class QKeyEvent;
class QNativeGestureEvent;
class QMouseEvent;
class QWheelEvent;

namespace geargraph {

/// The function of the middle mouse button, alone and with Shift or Ctrl, as in other programs.
enum class Navigation {
  blender,     ///< orbit; Shift: pan; Ctrl: zoom
  freeCad,     ///< pan; Shift: orbit; Ctrl: zoom
  solidWorks,  ///< orbit; Ctrl: pan; Shift: zoom
};

/// The state and the gestures of the 3D view, without rendering: the stage, the current poses, the camera,
/// the highlights.
///
///     left drag on a part        turn the train    wheel         zoom at the pointer
///     left drag elsewhere        orbit             click         select (Ctrl: add or remove)
///     right or Shift+left drag   pan               right click   menuWanted()
///     Ctrl+left drag on a part   turn it           arrows        orbit (Shift: pan)
///     two-finger scroll          pan               + -           zoom
///     pinch, or with Ctrl        zoom              middle drag   according to Navigation
///
/// Dragging a part moves the train by changing the time, so that the part follows the pointer. A part that is
/// at rest at the inputs' speeds, and any part with Ctrl, is turned by hand instead: the inputs are turned by
/// the smallest angles (least squares) that give the part's rotation.
class Viewer : public QObject {
  Q_OBJECT

  enum class Gesture { none, orbit, pan, zoom, time, turn, grab };

 public:
  using Answer = std::function<void(const std::optional<Hit>& hit)>;
  enum class PickFor { hover, gesture };
  /// Asks the canvas for the part at a place of the picture. The answer comes immediately or later, on the
  /// viewer's thread and in the order of the questions; for hovering only the newest question need be
  /// answered.
  using Pick = std::function<void(const Frame& frame, double x, double y, PickFor use, Answer answer)>;
  /// Is told where the pointer is and what is there, when it hovers and when it clicks. True: it has used the
  /// click, which then selects nothing.
  using Probe = std::function<bool(const QPointF& place, const std::optional<Hit>& hit, bool isClick)>;

  explicit Viewer(Selection* selection, QObject* parent = nullptr);

  /// Sets the stage to show. Camera and time are kept, and traced paths if their links still exist.
  void setScene(MechanismScenePtr stage);
  /// The next stage is that of another document: it is fitted, or seen from where the document says.
  void startAnew(const std::optional<Camera>& camera);
  [[nodiscard]] const MechanismScenePtr& stage() const { return m_stage; }
  /// Sets the time in s: the inputs turn at their speeds, starting from turnedByHand().
  void setTime(double seconds);
  /// Moves the inputs along this trajectory; null: at their constant speeds. Traced paths are updated.
  void setTrajectory(InputTrajectoryPtr trajectory);
  /// Tells whether the time runs: then a change of the view's size does not fit the train again.
  void setRunning(bool running) { m_isRunning = running; }
  /// The angles added to the inputs by hand, rad, one per input.
  [[nodiscard]] const std::vector<double>& turnedByHand() const { return m_view.turned; }
  void setTurnedByHand(std::vector<double> angles);
  [[nodiscard]] std::span<const Pose> poses() const { return m_seen.poses; }
  [[nodiscard]] std::span<const Visibility> visibility() const { return m_visibility; }
  [[nodiscard]] std::optional<CutPlane> cut() const;

  [[nodiscard]] const ViewOptions& options() const { return m_options; }
  void setOptions(const ViewOptions& options);
  /// The link that the reference frame is fixed to; std::nullopt: the ground.
  [[nodiscard]] const std::optional<ElementId>& referenceLink() const { return m_view.referenceLink; }
  void fixReferenceFrame(const std::optional<ElementId>& link);
  [[nodiscard]] const std::set<ElementId>& hidden() const { return m_view.hidden; }
  void setHidden(std::set<ElementId> links);
  /// Sets the forces of the stage, shown according to ViewOptions::marks; null: there are none. `caption`:
  /// why some or all are not drawn; empty if all are.
  void setForces(SceneForces forces, const QString& caption);
  [[nodiscard]] const QString& forcesCaption() const { return m_forcesCaption; }
  [[nodiscard]] ShownForces shownForces() const;
  /// Is something else with labels painted over the view? Takes effect with the next picture.
  void setLabelsShared(bool shared) { m_areLabelsShared = shared; }
  /// The direction of a link's axis of rotation in the displayed frame; std::nullopt if the link does not
  /// turn.
  [[nodiscard]] std::optional<Eigen::Vector3d> axisOf(const ElementId& link) const;

  /// Shows the path of the point over one period, or over a minute if there is none, relative to the
  /// reference link, when it has been computed (traced()). False if nothing moves.
  bool trace(const Hit& hit);
  void clearTraces();
  /// Paths that are being computed are empty or, after a change of the stage, the former ones.
  [[nodiscard]] const std::vector<ShownTrace>& traces() const { return m_view.traces; }

  [[nodiscard]] const Camera& camera() const { return m_view.camera; }
  /// Has the camera been chosen, by the user or in the document? Then it is to be saved.
  [[nodiscard]] bool isCameraChosen() const { return m_isCameraChosen; }
  /// The complete state of the view, for rendering it elsewhere.
  [[nodiscard]] const SceneView& view() const { return m_view; }
  void setCamera(const Camera& camera);
  void showFrom(StandardView view);
  void fit();

  void setNavigation(Navigation navigation) { m_navigation = navigation; }
  void setRenderStyle(const RenderStyle& style);
  /// Sets the picking function; pending questions are dropped.
  void setPick(Pick pick);
  void setProbe(Probe probe) { m_probe = std::move(probe); }
  /// Sets the size of the canvas in device pixels, and the number of device pixels per logical pixel.
  void setViewport(const Viewport& viewport, double pixelRatio);
  [[nodiscard]] const Viewport& viewport() const { return m_viewport; }
  [[nodiscard]] double pixelRatio() const { return m_pixelRatio; }

  /// Reports the time of the last frame in ms. While frames are slow, elements hovered in other views are
  /// highlighted here only when the mouse rests, so that a large train in software rendering does not delay
  /// other views.
  void setPictureCost(double milliseconds) { m_pictureCost = milliseconds; }

  /// The current frame; valid until the next change. `draft`: a draft, during movements in software
  /// rendering.
  [[nodiscard]] Frame frame(bool draft = false) const;

  /// Handles the gestures above for a canvas that has installed the viewer as its event filter.
  bool eventFilter(QObject* canvas, QEvent* event) override;
  /// @return the event was one of the gestures above
  bool keyPress(const QKeyEvent& event);

 signals:
  void sceneChanged();  ///< other solids or instances
  void viewChanged();   ///< anything that is painted
  void cameraChanged();
  void optionsChanged();                           ///< of options, reference link, hidden links, traces
  void traced(const geargraph::TracedPath& path);  ///< of the newest trace()
  void menuWanted(const std::optional<geargraph::Hit>& hit, const QPointF& place);
  void turnedByHandChanged();
  void timeWanted(double seconds);  ///< a drag has moved the train to this time
  /// A hint for the part under the pointer: what a drag would do. Empty: the pointer has left.
  void pointed(const QString& hint);
  void limitReached(const QString& joint);  ///< a drag tried to turn a joint beyond its limit
  void moving();  ///< a drag or the time moves the picture: more changes follow soon

 private:
  /// The pointer's movements until it is known what was grabbed.
  struct Grab {
    std::vector<QPointF> steps;
    bool isByHand = false;  ///< Ctrl is held
  };
  /// The points of all traces, and how they move.
  struct PathsRequest {
    MechanismScenePtr stage;
    std::vector<TracedPoint> points;
    std::vector<double> start;      ///< rad, one per input
    InputTrajectoryPtr trajectory;  ///< null: at the inputs' speeds
  };
  /// Wheel steps until it is known what is under the pointer.
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
  void updateHighlight();
  void place();
  void updateVisibility();
  void updateMarks();
  [[nodiscard]] std::vector<Eigen::Vector3d> outlinePoints();
  [[nodiscard]] bool isAllInside();
  void fitNow();
  [[nodiscard]] std::optional<std::size_t> instance(const std::optional<ElementId>& link) const;
  void updateTraces(const MechanismScene& before);
  void requestPaths();
  void showPaths(const std::vector<TracedPath>& paths);
  void turn(Hit& held, const QPointF& step);
  void updateHoverHighlight();
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

  static TracedPath pathOf(const TracedPoint& point, const PathsRequest& request,
                           const std::stop_token& stop);

  Selection* m_selection;
  Service<PathsRequest, std::vector<TracedPath>>* m_paths;
  bool m_isTraceNew = false;  ///< traced() is to be emitted for the last one
  MechanismScenePtr m_stage;
  SceneView m_view;
  QString m_forcesCaption;
  bool m_areLabelsShared = false;
  SeenPoses m_seen;
  std::optional<double> m_floor;  ///< height of the floor, if not the scene's
  // These visit every vertex, so they are computed on demand, not at every step of a drag.
  std::vector<Eigen::Vector3d>
      m_explosionOffsets;  ///< of the stage, after its first exploded view; else empty
  std::shared_ptr<const SolidOutlines> m_outlines;  ///< of the stage, after it was first fitted
  mutable std::optional<Bounds> m_bounds;           ///< of the scene, after it was first cut
  ViewOptions m_options;
  std::vector<Highlight> m_emphasis;
  std::vector<Visibility> m_visibility;
  std::vector<MarkLine> m_marks;
  Viewport m_viewport;
  double m_pixelRatio = 1;
  bool m_fitted = false;  ///< to its first size; with an unchosen camera to every size
  bool m_isRunning = false;
  bool m_isAnew = false;  ///< the next stage is that of another document
  bool m_isCameraChosen = false;
  std::optional<Camera> m_opening;  ///< camera stored in that document
  Pick m_pick;
  Probe m_probe;
  Gesture m_gesture = Gesture::none;
  Navigation m_navigation = Navigation::blender;
  QPointF m_pressedAt;
  QPointF m_last;
  bool m_dragged = false;
  std::optional<Hit> m_held;  ///< the held part, and where, in world coordinates
  std::shared_ptr<Grab> m_grab;
  std::shared_ptr<Zoom> m_zoom;
  bool m_isPointedAt = false;  ///< the pointer is inside the picture
  int m_dropped = 0;           ///< how often pending questions were dropped
  double m_pictureCost = 0;    ///< ms
  QTimer m_whenHandRests;
};

}  // namespace geargraph
