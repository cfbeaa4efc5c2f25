#pragma once

#include <QObject>
#include <QPointF>
#include <QTimer>
#include <functional>
#include <vector>

#include "core/render/renderer.h"
#include "core/render/stage.h"
#include "ui/selection/selection.h"

class QKeyEvent;
class QMouseEvent;
class QWheelEvent;

namespace geargraph {

/// What a canvas of the 3D view shows and how the hand moves it, without any painting: the stage, the poses
/// of the moment, the camera, what is lit up, and the gestures.
///
///     left or middle drag        orbit          wheel      zoom at the pointer
///     right or Shift+left drag   pan            click      select (Ctrl: add or take away)
///     Ctrl+left drag on a part   turn it        arrows     orbit
///                                               + -        zoom
///
/// A part that is turned by hand takes the inputs with it, as little as will do (least squares), and they all
/// the rest.
class Viewer : public QObject {
  Q_OBJECT

 public:
  /// What is under a place of the picture; the canvas knows.
  using Pick = std::function<std::optional<Hit>(const Frame& frame, double x, double y)>;

  explicit Viewer(Selection* selection, QObject* parent = nullptr);

  void setStage(StagePtr stage);
  [[nodiscard]] const StagePtr& stage() const { return m_stage; }
  /// Poses for this time: all inputs run at their speeds from where hands have put them.
  void setTime(double seconds);
  /// Angles that hands have added to the inputs, rad.
  [[nodiscard]] const std::vector<double>& turnedByHand() const { return m_turned; }
  void setTurnedByHand(std::vector<double> angles);
  [[nodiscard]] std::span<const Pose> poses() const { return m_poses; }

  [[nodiscard]] const Camera& camera() const { return m_camera; }
  void setCamera(const Camera& camera);
  void showFrom(StandardView view);
  void fit();

  void setLook(const Look& look);
  void setPick(Pick pick) { m_pick = std::move(pick); }
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

  /// @return the event was one of the gestures above
  bool mousePress(const QMouseEvent& event);
  bool mouseMove(const QMouseEvent& event);
  bool mouseRelease(const QMouseEvent& event);
  bool wheel(const QWheelEvent& event);
  bool keyPress(const QKeyEvent& event);
  void leave();

 signals:
  void sceneChanged();  ///< other solids or instances
  void viewChanged();   ///< anything that is painted
  void cameraChanged();
  void moving();  ///< the hand or the clock moves the picture: more changes will follow at once

 private:
  enum class Gesture { none, orbit, pan, turn };

  void lightUp();
  void place();
  void turn(const QPointF& step);
  void lightUpHovered();
  [[nodiscard]] std::optional<Hit> hitAt(const QPointF& place) const;
  void zoomAt(const QPointF& place, double factor);

  Selection* m_selection;
  StagePtr m_stage;
  std::vector<Pose> m_poses;
  double m_time = 0;
  std::vector<double> m_turned;
  std::vector<Emphasis> m_emphasis;
  Camera m_camera = Camera::home();
  Look m_look = Look::light();
  Viewport m_viewport;
  double m_pixelRatio = 1;
  bool m_fitted = false;  ///< the first size a stage is seen in fits it
  Pick m_pick;
  Gesture m_gesture = Gesture::none;
  QPointF m_pressedAt;
  QPointF m_last;
  bool m_dragged = false;
  std::optional<Hit> m_held;  ///< what Ctrl was pressed on, and where, in the world
  double m_pictureCost = 0;   ///< ms
  QTimer m_whenHandRests;
};

}  // namespace geargraph
