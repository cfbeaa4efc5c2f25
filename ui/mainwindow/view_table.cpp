#include "ui/mainwindow/view_table.h"

#include "ui/atlas_panel/atlas_panel.h"
#include "ui/canvas/digraph_view.h"
#include "ui/canvas/schematic_view.h"
#include "ui/canvas/tt_graph_view.h"
#include "ui/designer/designer_panel.h"
#include "ui/designer/hub_panel.h"
#include "ui/forces/forces_panel.h"
#include "ui/forces/inputs_and_results.h"
#include "ui/lever_views/levers_view.h"
#include "ui/motion_panel/dynamics_panel.h"
#include "ui/motion_panel/vibration_panel.h"
#include "ui/panels/gearbox_panel.h"
#include "ui/panels/matrices_panel.h"
#include "ui/panels/problems_panel.h"
#include "ui/panels/properties_panel.h"
#include "ui/reading/derivation_panel.h"
#include "ui/teeth_panel/teeth_panel.h"
#include "ui/view3d/motion_panel.h"
#include "ui/view3d/view3d.h"

namespace geargraph {

std::vector<ViewEntry> viewTable() {
  return {
      digraphView(),  ttGraphView(),    schematicView(), leversView(),    matricesView(),
      problemsView(), view3dView(),     inputsView(),    gearboxView(),   propertiesView(),
      speedsView(),   derivationView(), forcesView(),    dynamicsView(),  teethView(),
      atlasView(),    designerView(),   hardwareView(),  vibrationView(),
  };
}

}  // namespace geargraph
