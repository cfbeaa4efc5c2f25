// What the window does for its 3D view: the commands of its menus, its camera in the document.

#include <QMenu>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ui/canvas/axis_drag.h"
#include "ui/canvas/brake_edits.h"
#include "ui/canvas/canvas_edits.h"
#include "ui/canvas/drawing_view.h"
#include "ui/canvas/menu_preview.h"
#include "ui/mainwindow/edit_preview.h"
#include "ui/mainwindow/main_window.h"
#include "ui/mainwindow/shapes_dialog.h"
#include "ui/mainwindow/status_line.h"
#include "ui/mainwindow/view_docks.h"
#include "ui/mainwindow/window_exports.h"
#include "ui/panels/properties_panel.h"
#include "ui/view3d/motion_panel.h"
#include "ui/view3d/view3d.h"

namespace geargraph {

namespace {

constexpr double kDegree = std::numbers::pi / 180;

Camera cameraOf(const ViewCamera& camera) {
  return Camera::from(camera.azimuth * kDegree, camera.elevation * kDegree)
      .placedAt({camera.target[0], camera.target[1], camera.target[2]}, camera.distance);
}

}  // namespace

void MainWindow::wireView3DCommands() {
  wireAxisDrag();
  connect(&view3d(), &View3D::hintChanged, this,
          [this](const QString& hint) { m_status->setHint(hint.isEmpty() ? drawingHint() : hint); });
  connect(&view3d(), &View3D::noteMade, m_status, &StatusLine::showNote);
  connect(&view3d(), &View3D::traceFileWanted, m_exports, &WindowExports::chooseAndSaveTrace);
  connect(&motion(), &MotionPanel::fileWanted, m_exports, &WindowExports::chooseAndSaveSpeeds);
  // The part that the menu is about is selected, so the commands of the menu bar mean it.
  connect(
      &view3d(), &View3D::menuOpening, this, [this](QMenu* menu, const std::optional<ElementId>& element) {
        menu->addSeparator();
        menu->addAction((*m_actions)[CommandId::copyPicture]->text(), m_exports,
                        [this] { m_exports->copyPicture(QStringLiteral("3d")); });
        if (!element) return;
        menu->addSeparator();
        menu->addActions({(*m_actions)[CommandId::drive], (*m_actions)[CommandId::hold],
                          (*m_actions)[CommandId::makeGround], (*m_actions)[CommandId::rename]});
        MenuPreview::of(*menu).add((*m_actions)[CommandId::hold],
                                   toggleBrakeEdit(*m_document->mechanism(), LinkId(element->id)));
        showPreviews(*menu, *m_workbench, [this](const QString& hint) {
          m_status->setHint(hint.isEmpty() ? drawingHint() : hint);
        });
        const CarryingJoint carrying = carryingJoint(*m_document->mechanism(), LinkId(element->id));
        QAction* axis =
            menu->addAction(carrying.joint ? tr("Move its axis") : tr("Move its axis (%1)").arg(carrying.why),
                            this, [this, joint = carrying.joint] {
                              m_selection->select({*joint});
                              view3d().takeAxisHandle();
                            });
        axis->setEnabled(carrying.joint.has_value());
        menu->addAction(tr("Attached 3D files…"), this, [this, link = LinkId(element->id)] {
          (new ShapesDialog(m_document, link, this))->show();
        });
        menu->addAction(tr("Properties"), this, [this] { m_docks->reveal(m_views->get<PropertiesPanel>()); });
      });
}

/// The handle of an axis in the 3D view, as the schematic drags one.
void MainWindow::wireAxisDrag() {
  auto* drag = new AxisDrag(m_document, &view3d());
  const auto axisOf = [this](const ElementId& element) {
    const TurningJoint* const joint = element.kind == ElementKind::turningJoint
                                          ? m_document->mechanism()->find(JointId(element.id))
                                          : nullptr;
    return joint != nullptr ? joint->axis : AxisId(element.id);
  };
  connect(&view3d(), &View3D::axisPulled, drag, [drag, axisOf](const AxisPull& pull) {
    drag->begin(axisOf(pull.element));
    drag->moveBy(pull.way, !pull.isFree);
  });
  connect(&view3d(), &View3D::axisDropped, drag, &AxisDrag::drop);
  connect(&view3d(), &View3D::axisPutBack, drag, &AxisDrag::putBack);
  connect(&view3d(), &View3D::axisNudged, drag,
          [drag, axisOf](const AxisPull& pull) { drag->nudge(axisOf(pull.element), pull.way); });
  connect(drag, &AxisDrag::hintChanged, m_status, &StatusLine::setHint);
  connect(drag, &AxisDrag::ended, this, [this] { m_status->setHint(drawingHint()); });
}

/// Another document: what was chosen for the last one goes, and the camera is its own.
void MainWindow::startView3DAnew() {
  m_hasPicture = false;
  const auto& camera = m_document->mechanism()->view.camera;
  view3d().startAnew(camera ? std::optional(cameraOf(*camera)) : std::nullopt);
  // The same mechanism, otherwise drawn: no other stage will come.
  if (m_document->mechanicsRevision() != m_document->revision()) view3d().setScene(view3d().stage());
}

Mechanism MainWindow::documentToSave() const {
  Mechanism saved = *m_document->mechanism();
  if (!view3d().isCameraChosen()) return saved;
  const Camera& camera = view3d().camera();
  const auto rounded = [](double value) { return std::round(value * 1e4) / 1e4; };
  const Eigen::Vector3d& target = camera.target();
  ViewCamera& kept = saved.view.camera ? *saved.view.camera : saved.view.camera.emplace();
  kept.target = {rounded(target.x()), rounded(target.y()), rounded(target.z())};
  kept.azimuth = rounded(camera.yaw() / kDegree);
  kept.elevation = rounded(camera.pitch() / kDegree);
  kept.distance = std::max(rounded(camera.distance()), 1e-4);
  return saved;
}

}  // namespace geargraph
