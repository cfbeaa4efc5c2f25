// What the window has to know of the gearbox designer.

#include "ui/designer/designer_panel.h"
#include "ui/views/views.h"

namespace geargraph::inline designer {

ViewEntry designerView() {
  return {
      .id = QStringLiteral("designer"),
      .title = DesignerPanel::tr("Gearbox designer"),
      .purpose = DesignerPanel::tr(
          "Searches for planetary sets, brakes and clutches that have the ratios you want."),
      .helpPage = QStringLiteral("gearboxes#gearbox-designer"),
      .searchWords = QStringLiteral(
          "design synthesis search wanted ratios automatic transmission speeds layout find invent"),
      .place = ViewPlace::bottom,
      .minimumSize = {260, 120},
      .holdsAnswers = false,
      .make = [](Views& /*views*/, QWidget* parent) -> ResultsView* { return new DesignerPanel(parent); }};
}

}  // namespace geargraph::inline designer
