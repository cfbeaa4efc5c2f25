// What the window has to know of the panel of forces, and what this panel shares with other views.

#include "ui/forces/duality_line.h"
#include "ui/forces/forces_caption.h"
#include "ui/forces/forces_panel.h"
#include "ui/panels/matrices_panel.h"
#include "ui/panels/matrix_view.h"
#include "ui/view3d/view3d.h"
#include "ui/workbench/views.h"
#include "ui/workbench/workbench.h"

namespace geargraph {
namespace {

/// The entry that an equation of speeds and its dual of torques share is framed in Matrices, too: a click on
/// it shows it there, in P or where that is too large in Q, and the cell under the mouse there is shown in
/// Forces.
void shareEntry(DualityLine& line, MatricesPanel& matrices, Views& views) {
  MatrixView& view = matrices.view();
  QObject::connect(&line, &DualityLine::entryChanged, &view, &MatrixView::setFramed);
  QObject::connect(&view, &MatrixView::entryHovered, &line, &DualityLine::pointAt);
  QObject::connect(&line, &DualityLine::entryWanted, &matrices, [&matrices, &view, &views] {
    emit views.revealWanted(&matrices);
    matrices.showResult(*resultNamed("p"));
    if (!view.showFramed()) matrices.showResult(resultOf(MatrixKind::cutset));
    view.showFramed();
  });
}

}  // namespace

ViewEntry forcesView() {
  return {.id = QStringLiteral("forces"),
          .title = ForcesPanel::tr("Forces"),
          .purpose = ForcesPanel::tr("Loads, and the torques, forces and powers that they cause."),
          .helpPage = QStringLiteral("forces-and-dynamics"),
          .searchWords = QStringLiteral(
              "torque force load moment power flow efficiency losses statics bearing reaction self-locking "
              "circulating sharing friction cutset"),
          .place = ViewPlace::bottom,
          .make = [](Views& views, QWidget* parent) -> ResultsView* {
            ForcesService& service = views.workbench().forces();
            auto* panel = new ForcesPanel(views.document(), views.selection(), &service, parent);
            QObject::connect(panel, &ForcesPanel::exportWanted, &views, &Views::tableExportWanted);
            shareEntry(panel->dualityLine(), views.get<MatricesPanel>(), views);
            auto* view3d = &views.get<View3D>();
            view3d->setForces(nullptr, forcesCaption(nullptr));
            service.onAnswer(view3d, [view3d](const ForcesPtr& forces) {
              view3d->setForces(forces ? forces->arrows : nullptr, forcesCaption(forces));
            });
            return panel;
          }};
}

}  // namespace geargraph
