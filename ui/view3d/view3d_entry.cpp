// What the window has to know of the 3D view, and what the view says while there are no gears.

#include "core/presentation/mechanism_scene/mechanism_scene.h"
#include "ui/view3d/view3d.h"
#include "ui/workbench/views.h"
#include "ui/workbench/workbench.h"

namespace geargraph {
namespace {

QString unavailableReason(const AnalysisSnapshot& snapshot) {
  if (snapshot.mechanism->n() == 0)
    return View3D::tr("The gears appear here. Draw the first link: L, then click.");
  if (!snapshot.tree) {
    return View3D::tr(
        "The gears appear when the turning joints tie every link to the ground and close no loop.");
  }
  if (snapshot.mechanism->n() > kMaxStageLinks) {
    return View3D::tr("The 3D view shows trains of up to %1 links; this one has %2.")
        .arg(kMaxStageLinks)
        .arg(snapshot.mechanism->n());
  }
  if (snapshot.kinematics && snapshot.mechanism->c() > 0) return View3D::waitingText();
  return View3D::tr("The gears appear when a mesh joins two of the links: G, then drag.");
}

}  // namespace

void View3D::setSnapshot(const SnapshotPtr& snapshot) {
  setEmptyText(unavailableReason(*snapshot));
}

ViewEntry view3dView() {
  return {
      .id = QStringLiteral("view3d"),
      .title = View3D::tr("3D"),
      .purpose = View3D::tr("The gears in motion. Drag a gear to turn the train, drag elsewhere to orbit."),
      .helpPage = QStringLiteral("teeth-axes-and-3d#the-3d-view"),
      .searchWords = QStringLiteral("3d model solid picture view render"),
      .place = ViewPlace::top,
      .holdsAnswers = false,
      .make = [](Views& views, QWidget* parent) -> ResultsView* {
        auto* view = new View3D(views.selection(), parent);
        view->setMeasuring(&views.workbench().measuring());
        QObject::connect(&views, &Views::momentWanted, view, [view, &views](double time) {
          view->showMoment(time);
          emit views.revealWanted(view);
        });
        return view;
      }};
}

}  // namespace geargraph
