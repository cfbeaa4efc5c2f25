#pragma once

#include <QWidget>

#include "core/presentation/scene/camera.h"
#include "core/presentation/scene3d/scene_forces.h"
#include "core/presentation/scene3d/stage.h"
#include "ui/document/selection.h"
#include "ui/view3d/axis_pull.h"
#include "ui/view3d/playback.h"
#include "ui/view3d/viewer.h"
#include "ui/workbench/results_view.h"
#include "ui/workbench/view_entry.h"

class QMenu;

namespace geargraph {

class Measuring;

/// The 3D view: a stage that can be turned, zoomed and played. While a single axis or turning joint is
/// selected, its axis has a handle; grabbing it returns the train to its reference pose.
///
/// Keys while it has the focus: Space plays and pauses, F or Home fits, 0 isometric, 1 front, 2 right, 3 top;
/// arrows orbit, + and - zoom; , and . step the time backwards and forwards; R fixes the reference frame to
/// the selected link or releases it, A looks along its axis, S toggles the section, E the exploded view, H
/// hides the selected links or shows all; Backspace resets the angles turned by hand; Page Down and Up select
/// the next and the previous link, the Menu key opens its menu. Mouse: viewer.h.
class View3D : public QWidget, public ResultsView {
  Q_OBJECT

 public:
  explicit View3D(Selection* selection, QWidget* parent = nullptr);
  ~View3D() override;

  /// To be called before the QApplication is created: makes OpenGL contexts shared, so that a dock that
  /// becomes floating need not upload its data again.
  static void prepareApplication();
  /// Renderer, vendor and version of the display's OpenGL, or why there is none. @pre a QGuiApplication
  /// exists
  [[nodiscard]] static QString driver();

  /// Sets the stage to show. Camera and time are kept; the first stage is fitted into the view.
  void setScene(const MechanismScenePtr& stage);
  [[nodiscard]] const MechanismScenePtr& stage() const;
  /// Sets the forces on the parts, for the menu entry "Forces"; null: there are none. `caption`: shown beside
  /// the legend, why some or all are not drawn; empty if all are.
  void setForces(SceneForces forces, const QString& caption = {});
  [[nodiscard]] const QString& forcesCaption() const;
  [[nodiscard]] QWidget& widget() override { return *this; }
  /// Sets the text shown instead of an empty stage from what the mechanism lacks.
  void setSnapshot(const SnapshotPtr& snapshot) override;
  [[nodiscard]] QString emptyText() const override;
  /// Sets the text shown instead of an empty stage: the reason, and what to do.
  void setEmptyText(const QString& text);
  /// Sets a sentence shown over the picture: why it does not show the current document. Empty: it does.
  void setNote(const QString& text);

  [[nodiscard]] Playback& playback();
  /// Plays this motion of the inputs repeatedly from its beginning, instead of their constant speeds; null:
  /// constant speeds again. A button over the picture ends it, and so does a stage with other inputs.
  void setTrajectory(const InputTrajectoryPtr& trajectory);
  [[nodiscard]] const InputTrajectoryPtr& trajectory() const;
  /// Sets the angles (rad, one per input) added to those of the current time; dragging a part with Ctrl does
  /// the same.
  void setTurnedByHand(const std::vector<double>& angles);
  [[nodiscard]] const std::vector<double>& turnedByHand() const;

  [[nodiscard]] const Camera& camera() const;
  void setCamera(const Camera& camera);
  /// The next stage is that of another document: it is fitted, or seen from where the document says.
  void startAnew(const std::optional<Camera>& camera);
  /// Has the camera been chosen, by the user or in the document? Then it is to be saved.
  [[nodiscard]] bool isCameraChosen() const;
  /// The complete state of the view, for rendering it elsewhere.
  [[nodiscard]] const SceneView& view() const;
  /// The links with a visible part, in the order of Stage::labels.
  [[nodiscard]] std::vector<ElementId> shownLinks() const;
  [[nodiscard]] bool isSelected(const ElementId& link) const;
  void select(const ElementId& link);
  /// "link 3", "the ground"
  [[nodiscard]] QString nameOf(const ElementId& link) const;
  /// The function of the middle mouse button, from the settings; chooseNavigation() sets it for all views of
  /// the program.
  [[nodiscard]] static Navigation savedNavigation();
  void chooseNavigation(Navigation navigation);
  void setNavigation(Navigation navigation);
  /// Measures with clicks while `measuring` is on, in the reference pose; Return takes the selected link, Esc
  /// goes back and then ends.
  void setMeasuring(Measuring* measuring);
  void setDark(bool dark);
  [[nodiscard]] const ViewOptions& options() const;
  void setOptions(const ViewOptions& options);
  /// The link that the reference frame is fixed to; std::nullopt: the ground.
  [[nodiscard]] const std::optional<ElementId>& referenceLink() const;
  void fixReferenceFrame(const std::optional<ElementId>& link);
  [[nodiscard]] const std::set<ElementId>& hidden() const;
  void setHidden(std::set<ElementId> links);
  /// Pauses the motion at a time (s), with the inputs turned by their speeds only: ends a trajectory and
  /// resets turnedByHand().
  void showMoment(double time);
  /// Looks along the axis of rotation of the link.
  void lookAlong(const ElementId& link);
  [[nodiscard]] bool hasAxis(const ElementId& link) const;
  /// Gives the focus to the handle of the selected axis; false if there is none.
  bool takeAxisHandle();
  /// Shows the path of a point of a part; noteMade() reports its length and period.
  void trace(const Hit& hit);
  void clearTraces();
  [[nodiscard]] const std::vector<ShownTrace>& traces() const;
  /// The renderer's name according to the driver; empty before the first frame, or if there is no renderer.
  [[nodiscard]] QString rendererName() const;
  /// Is the view rendered offscreen and shown as an image? It is for software rendering, or if no OpenGL
  /// window is available.
  [[nodiscard]] bool isImage() const;
  /// Is the current frame shown? Images are rendered in the background.
  [[nodiscard]] bool isUpToDate() const;
  /// The text shown until the first frame of a train is ready.
  [[nodiscard]] static QString waitingText() { return tr("The gears are being made …"); }

 public slots:
  void fit();
  void showFrom(geargraph::StandardView view);

 signals:
  void cameraChanged();
  void contentChanged();     ///< another stage or other traces
  void trajectoryChanged();  ///< it plays another trajectory, or constant speeds again
  /// A context menu is about to open for an element or for the ground; receivers may add entries.
  void menuOpening(QMenu* menu, const std::optional<geargraph::ElementId>& element);
  void traceFileWanted();                 ///< the newest of traces() is to be saved
  void hintChanged(const QString& hint);  ///< what a drag would do; empty: the pointer has left
  void noteMade(const QString& text);     ///< a message of one line: a traced path's length
  /// Emitted repeatedly during one gesture, which axisDropped() or axisPutBack() ends.
  void axisPulled(const geargraph::AxisPull& pull);
  void axisDropped();
  void axisPutBack();
  void axisNudged(const geargraph::AxisPull& pull);  ///< a separate gesture

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  void walk(int steps);
  /// The display options: faces, section, exploded view, translucency, labels, marks of geometry and motion,
  /// hidden links, and the reference frame.
  void fillViewMenu(QMenu& menu);
  /// The commands for the part under the mouse, or for the background.
  void fillPartMenu(QMenu& menu, const std::optional<Hit>& hit);
  void placeNote();

  class Private;
  std::unique_ptr<Private> d;
};

[[nodiscard]] ViewEntry view3dView();

}  // namespace geargraph
