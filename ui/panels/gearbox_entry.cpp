// What the window has to know of the panel of brakes, clutches and states.

#include <QLabel>
#include <QStackedWidget>

#include "ui/lever_views/levers_view.h"
#include "ui/panels/gearbox_panel.h"
#include "ui/workbench/views.h"
#include "ui/workbench/workbench.h"

namespace geargraph {

QString GearboxPanel::emptyText() const {
  return m_pages->currentWidget() == m_empty ? m_empty->text() : QString();
}

ViewEntry gearboxView() {
  return {.id = QStringLiteral("gearbox"),
          .title = GearboxPanel::tr("Gearbox"),
          .purpose = GearboxPanel::tr("Brakes and clutches, what is engaged, and the states of a gearbox."),
          .helpPage = QStringLiteral("gearboxes"),
          .searchWords =
              QStringLiteral("brake clutch hold engage release state shift gearbox transmission gear ratio"),
          .place = ViewPlace::right,
          .make = [](Views& views, QWidget* parent) -> ResultsView* {
            ForcesService& service = views.workbench().forces();
            auto* panel = new GearboxPanel(views.document(), views.selection(), parent);
            QObject::connect(panel, &GearboxPanel::exportWanted, &views, &Views::tableExportWanted);
            QObject::connect(panel, &GearboxPanel::torquesWanted, &service,
                             [panel, &service](bool wanted) { service.setWatched(panel, wanted); });
            service.onAnswer(panel, [panel, &service](const ForcesPtr& forces) {
              const ForceTable* const torques = forces ? forces->table(ForceTableKind::states) : nullptr;
              // A first part comes without: the torques before it stay, else they would blink.
              if (torques == nullptr && !service.isComplete()) return;
              panel->setTorques(std::shared_ptr<const ForceTable>(forces, torques),
                                forces ? forces->snapshot->mechanism : nullptr);
            });
            auto& levers = views.get<LeversView>();
            QObject::connect(panel, &GearboxPanel::stateHovered, &levers, &LeversView::lookAtState);
            QObject::connect(&levers, &LeversView::stateLookedAtChanged, panel, &GearboxPanel::showLookedAt);
            return panel;
          }};
}

}  // namespace geargraph
