#pragma once

#include <QWidget>

#include "core/presentation/painting/camera.h"
#include "core/presentation/stage/stage.h"
#include "core/presentation/stage/stage_forces.h"
#include "ui/selection/selection.h"
#include "ui/view3d/axis_pull.h"
#include "ui/view3d/playback.h"
#include "ui/view3d/viewer.h"

class QMenu;

namespace geargraph::inline view3d {

/// The 3D view: a stage that can be turned, zoomed and played. Where one axis or turning joint is selected,
/// its axis has a handle; the train goes to its reference pose when it is grabbed.
///
/// Keys while it has the focus: Space plays and pauses, F or Home fits, 0 isometric, 1 front, 2 right, 3 top;
/// arrows orbit, + and - zoom; , and . step the time back and on; R rides along with the selected link or
/// stops it, A looks along its axis, S cuts a section, E pulls apart, H hides what is selected or shows all;
/// Backspace undoes what hands have turned; Page down and up select the next and the last link, the Menu key
/// opens its menu.
/// Mouse: viewer.h.
class View3D : public QWidget {
  Q_OBJECT

 public:
  explicit View3D(Selection* selection, QWidget* parent = nullptr);
  ~View3D() override;

  /// Call before the QApplication is made: contexts are shared, so that a dock that floats uploads nothing
  /// again.
  static void prepareApplication();
  /// Renderer, vendor and version of the display's OpenGL, or why there is none. @pre there is an application
  [[nodiscard]] static QString driver();

  /// What is shown. Camera and time stay; the first stage is fitted into the view.
  void setStage(const StagePtr& stage);
  [[nodiscard]] const StagePtr& stage() const;
  /// The forces on its parts, for the entry "Forces" of its menu; null: there are none.
  /// `caption`: beside the legend, why some are not drawn, or all; empty where all are.
  void setForces(StageForces forces, const QString& caption = {});
  [[nodiscard]] const QString& forcesCaption() const;
  /// Shown in place of an empty stage: why there is nothing, and what to do.
  void setEmptyText(const QString& text);
  /// A sentence over the picture: why it is not that of the document as it is now. Empty: it is.
  void setNote(const QString& text);

  [[nodiscard]] Playback& playback();
  /// Plays this motion of the inputs instead of their speeds, from its beginning, over and over; null: their
  /// speeds again. A button over the picture ends it, and so does a stage with other inputs.
  void setTrajectory(const InputTrajectoryPtr& trajectory);
  [[nodiscard]] const InputTrajectoryPtr& trajectory() const;
  /// Angles that are added to what the time makes of the inputs (rad, one an input): dragging a part with
  /// Ctrl does the same.
  void setTurnedByHand(const std::vector<double>& angles);
  [[nodiscard]] const std::vector<double>& turnedByHand() const;

  [[nodiscard]] const Camera& camera() const;
  void setCamera(const Camera& camera);
  /// The next stage is that of another document: it is fitted, or seen from where the document says.
  void startAnew(const std::optional<Camera>& camera);
  /// Somebody has chosen the camera, here or in the document: it is worth being kept.
  [[nodiscard]] bool isCameraChosen() const;
  /// All that is shown, as a picture elsewhere takes it.
  [[nodiscard]] const StageView& view() const;
  /// The links that have a part in sight, by their labels.
  [[nodiscard]] std::vector<ElementId> shownLinks() const;
  [[nodiscard]] bool isSelected(const ElementId& link) const;
  void select(const ElementId& link);
  /// "link 3", "the ground"
  [[nodiscard]] QString nameOf(const ElementId& link) const;
  /// What the middle button does, of the settings; for all views of the program when it is chosen.
  [[nodiscard]] static Navigation savedNavigation();
  void chooseNavigation(Navigation navigation);
  void setNavigation(Navigation navigation);
  void setDark(bool dark);
  [[nodiscard]] const ViewOptions& options() const;
  void setOptions(const ViewOptions& options);
  /// The link that is seen standing still; none: the ground.
  [[nodiscard]] const std::optional<ElementId>& ridden() const;
  void rideAlong(const std::optional<ElementId>& link);
  [[nodiscard]] const std::set<ElementId>& hidden() const;
  void setHidden(std::set<ElementId> links);
  /// Stops the motion at a time, with the inputs where their speeds take them: a trajectory and what
  /// hands have added go.
  void showMoment(double time);
  /// Looks along the line that the link turns about.
  void lookAlong(const ElementId& link);
  [[nodiscard]] bool hasAxis(const ElementId& link) const;
  /// Gives the focus to the handle of the selected axis; false where there is none.
  bool takeAxisHandle();
  /// Shows the path of a point of a part, and says its length and period.
  void trace(const Hit& hit);
  void clearTraces();
  [[nodiscard]] const std::vector<ShownTrace>& traces() const;
  /// What paints, as the driver says; empty before the first picture, or where there is none.
  [[nodiscard]] QString rendererName() const;
  /// Is the picture painted beside the screen and shown as an image? So it is where there is no window of the
  /// graphics card, or where the processor stands for one.
  [[nodiscard]] bool isImage() const;
  /// An image is painted while the window does other work: is that of the moment on the screen?
  [[nodiscard]] bool isUpToDate() const;
  /// What stands in the view until the first picture of a train is there.
  [[nodiscard]] static QString waitingText() { return tr("The gears are being made …"); }

 public slots:
  void fit();
  void showFrom(geargraph::StandardView view);

 signals:
  void cameraChanged();
  void contentChanged();     ///< another stage, other traces: what moves, and what is said of it
  void trajectoryChanged();  ///< it plays another motion, or that of the speeds again
  /// A context menu is about to open for an element, or for the ground: others may add what they know of it.
  void menuOpening(QMenu* menu, const std::optional<geargraph::ElementId>& element);
  void traceFileWanted();                 ///< the newest of traces() is to be saved
  void hintChanged(const QString& hint);  ///< what a drag would do there; empty: the pointer has left
  void noteMade(const QString& text);     ///< something to be said in a line: a traced path's length
  void axisPulled(
      const geargraph::AxisPull& pull);  ///< many of them make one gesture, which one of the next two ends
  void axisDropped();
  void axisPutBack();
  void axisNudged(const geargraph::AxisPull& pull);  ///< a gesture of its own

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  void walk(int steps);
  /// What the view can show: faces, section, exploded view, translucency, labels, marks of geometry and
  /// motion, and what is hidden or the reference frame is fixed to.
  void fillViewMenu(QMenu& menu);
  /// For the part under the mouse, or for the background.
  void fillPartMenu(QMenu& menu, const std::optional<Hit>& hit);
  void placeNote();

  class Private;
  std::unique_ptr<Private> d;
};

}  // namespace geargraph::inline view3d
