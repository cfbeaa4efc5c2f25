// What the window has to know of the gearbox designer and of the search for hardware.

#include "ui/designer/designer_panel.h"
#include "ui/designer/hub_panel.h"
#include "ui/workbench/views.h"

namespace geargraph {

ViewEntry designerView() {
  return {.id = QStringLiteral("designer"),
          .title = DesignerPanel::tr("Gearbox designer"),
          .tip = DesignerPanel::tr(
              "Gearboxes with the ratios that you want. Space ticks one for comparison, Enter opens it as a "
              "document, Esc pauses the search."),
          .purpose = DesignerPanel::tr(
              "Searches for planetary sets, brakes and clutches that have the ratios you want."),
          .helpPage = QStringLiteral("gearboxes#gearbox-designer"),
          .searchWords = QStringLiteral(
              "design synthesis search wanted ratios automatic transmission speeds layout find invent"),
          .place = ViewPlace::drawings,
          .holdsAnswers = false,
          .wantsRoom = true,
          .make = [](Views& views, QWidget* parent) -> ResultsView* {
            auto* panel = new DesignerPanel(parent);
            QObject::connect(panel, &DesignerPanel::settled, &views, &Views::settled);
            QObject::connect(panel, &DesignerPanel::rejected, &views, &Views::rejected);
            QObject::connect(panel, &DesignerPanel::openWanted, &views, &Views::documentWanted);
            return panel;
          }};
}

ViewEntry hardwareView() {
  return {.id = QStringLiteral("hardware"),
          .title = HubPanel::tr("Ratios to hardware"),
          .tip = HubPanel::tr("What may be inside a hub gear with the ratios of its maker's sheet, and which "
                              "wheel to count. Enter "
                              "opens a candidate as a document."),
          .purpose = HubPanel::tr("Finds the planetary sets that may be inside a hub gear with given ratios, "
                                  "and what to count in it."),
          .helpPage = QStringLiteral("gearboxes#ratios-to-hardware"),
          .searchWords =
              QStringLiteral("hub gear bicycle inside teeth count reverse engineer sheet ratios identify"),
          .place = ViewPlace::drawings,
          .holdsAnswers = false,
          .wantsRoom = true,
          .make = [](Views& views, QWidget* parent) -> ResultsView* {
            auto* panel = new HubPanel(parent);
            QObject::connect(panel, &HubPanel::settled, &views, &Views::settled);
            QObject::connect(panel, &HubPanel::openWanted, &views, &Views::documentWanted);
            return panel;
          }};
}

}  // namespace geargraph
