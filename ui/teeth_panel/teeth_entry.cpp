// What the window has to know of the panel of teeth for wanted ratios.

#include "ui/models/term_tips.h"
#include "ui/teeth_panel/teeth_panel.h"
#include "ui/workbench/edit_trial.h"
#include "ui/workbench/views.h"
#include "ui/workbench/workbench.h"

namespace geargraph {

ViewEntry teethView() {
  return {.id = QStringLiteral("teeth"),
          .title = TeethPanel::tr("Teeth"),
          .purpose =
              TeethPanel::tr("Whole teeth with which the train has the ratios that you want, all of them."),
          .helpPage = QStringLiteral("teeth-axes-and-3d#teeth-for-ratios"),
          .searchWords = QStringLiteral(
              "ratio ratios tooth counts number of teeth wanted wish search synthesis hunting certificate"),
          .place = ViewPlace::bottom,
          .make = [](Views& views, QWidget* parent) -> ResultsView* {
            auto* panel = new TeethPanel(views.document(), parent);
            Workbench& workbench = views.workbench();
            QObject::connect(panel, &TeethPanel::settled, &views, &Views::settled);
            QObject::connect(panel, &TeethPanel::exportWanted, &views, &Views::tableExportWanted);
            QObject::connect(panel, &TeethPanel::rejected, &views, &Views::rejected);
            QObject::connect(panel, &TeethPanel::previewWanted, &views,
                             [&workbench, &views](const Edit& edit) {
                               const Diagnostics why = showTrial(workbench, edit);
                               if (!why.empty()) emit views.rejected(shownText(why.front().message));
                             });
            QObject::connect(panel, &TeethPanel::previewEnded, &views, [&workbench] { workbench.request(); });
            return panel;
          }};
}

}  // namespace geargraph
