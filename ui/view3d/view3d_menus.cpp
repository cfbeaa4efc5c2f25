// What the menus of the 3D view hold, each entry checked as it is when the menu opens.

#include "ui/view3d/view3d.h"

#include <QActionGroup>
#include <QMenu>

namespace geargraph {
namespace {

QString tr(const char* text) {
  return View3D::tr(text);
}

/// An entry that is checked as `read` says and does `write` to a copy of the options.
template <class Write>
QAction* addCheck(QMenu& menu, View3D& view, const char* name, const QString& text, bool checked,
                  Write write) {
  QAction* action = menu.addAction(text);
  action->setObjectName(QLatin1String(name));
  action->setCheckable(true);
  action->setChecked(checked);
  QObject::connect(action, &QAction::triggered, &view, [&view, write](bool on) {
    ViewOptions options = view.options();
    write(options, on);
    view.setOptions(options);
  });
  return action;
}

void addFaces(QMenu& menu, View3D& view) {
  const std::pair<Faces, QString> kinds[] = {{Faces::shaded, tr("Shaded")},
                                             {Faces::hiddenLine, tr("Lines, hidden ones left out")},
                                             {Faces::wireframe, tr("All edges")}};
  const char* names[] = {"view3dShaded", "view3dHiddenLine", "view3dWireframe"};
  auto* group = new QActionGroup(&menu);
  std::size_t at = 0;
  for (const auto& [faces, text] : kinds) {
    group->addAction(addCheck(menu, view, names[at++], text, view.options().faces == faces,
                              [kind = faces](ViewOptions& options, bool) { options.faces = kind; }));
  }
}

void addLabels(QMenu& menu, View3D& view) {
  const ViewOptions& now = view.options();
  QMenu* labels = menu.addMenu(tr("Labels"));
  addCheck(*labels, view, "view3dLinkLabels", tr("Links"), now.linkLabels,
           [](ViewOptions& options, bool on) { options.linkLabels = on; });
  addCheck(*labels, view, "view3dJointLabels", tr("Joints"), now.jointLabels,
           [](ViewOptions& options, bool on) { options.jointLabels = on; });
  addCheck(*labels, view, "view3dAxisLabels", tr("Axes"), now.axisLabels,
           [](ViewOptions& options, bool on) { options.axisLabels = on; });
  addCheck(*labels, view, "view3dScaleBar", tr("Scale bar"), now.scaleBar,
           [](ViewOptions& options, bool on) { options.scaleBar = on; });
}

void addMarks(QMenu& menu, View3D& view) {
  struct Entry {
    const char* name;
    QString text;
    bool MarkChoice::*member;
  };
  const Entry entries[] = {
      {"view3dPitchCircles", tr("Pitch circles and cones"), &MarkChoice::pitchCircles},
      {"view3dPitchPoints", tr("Pitch points"), &MarkChoice::pitchPoints},
      {"view3dAxes", tr("Axes"), &MarkChoice::axes},
      {"view3dInstantAxes", tr("Instantaneous axes"), &MarkChoice::instantAxes},
      {"view3dVelocities", tr("Velocities"), &MarkChoice::velocities},
      {"view3dForces", tr("Forces under the loads"), &MarkChoice::forces},
  };
  QMenu* show = menu.addMenu(tr("Show"));
  for (const Entry& entry : entries) {
    addCheck(*show, view, entry.name, entry.text, view.options().marks.*entry.member,
             [member = entry.member](ViewOptions& options, bool on) { options.marks.*member = on; });
  }
}

void addNavigation(QMenu& menu, View3D& view) {
  const std::pair<Navigation, QString> habits[] = {
      {Navigation::blender, tr("Orbit; Shift pans, Ctrl zooms (Blender)")},
      {Navigation::freeCad, tr("Pan; Shift orbits, Ctrl zooms (FreeCAD)")},
      {Navigation::solidWorks, tr("Orbit; Ctrl pans, Shift zooms (SolidWorks)")}};
  const char* names[] = {"view3dBlender", "view3dFreeCad", "view3dSolidWorks"};
  QMenu* middle = menu.addMenu(tr("Middle button"));
  auto* group = new QActionGroup(middle);
  std::size_t at = 0;
  for (const auto& [habit, text] : habits) {
    QAction* action =
        middle->addAction(text, &view, [&view, habit = habit] { view.chooseNavigation(habit); });
    action->setObjectName(QLatin1String(names[at++]));
    action->setCheckable(true);
    action->setChecked(View3D::savedNavigation() == habit);
    group->addAction(action);
  }
}

/// What undoes riding, hiding and tracing, where there is something of it.
void addWaysBack(QMenu& menu, View3D& view) {
  if (view.referenceLink()) {
    menu.addAction(tr("Stop riding along"), &view, [&view] { view.fixReferenceFrame(std::nullopt); })
        ->setObjectName("view3dStopRiding");
  }
  if (!view.hidden().empty()) {
    menu.addAction(tr("Show all parts"), &view, [&view] { view.setHidden({}); })
        ->setObjectName("view3dShowAll");
  }
  if (view.traces().empty()) return;
  // None yet while it is being computed.
  if (!view.traces().back().path.points.empty())
    menu.addAction(tr("Save the traced path as CSV…"), &view, [&view] { emit view.traceFileWanted(); });
  menu.addAction(tr("Clear traced paths"), &view, [&view] { view.clearTraces(); });
}

void hideOthers(View3D& view, const ElementId& link) {
  std::set<ElementId> others;
  for (const Instance& instance : view.stage()->scene.instances) {
    if (!(instance.element == link)) others.insert(instance.element);
  }
  view.setHidden(std::move(others));
}

}  // namespace

void View3D::fillViewMenu(QMenu& menu) {
  View3D& view = *this;
  const ViewOptions& now = view.options();
  const std::pair<StandardView, QString> more[] = {{StandardView::back, tr("From behind")},
                                                   {StandardView::left, tr("From the left")},
                                                   {StandardView::bottom, tr("From below")}};
  for (const auto& [from, text] : more)
    menu.addAction(text, &view, [&view, from = from] { view.showFrom(from); });
  menu.addSeparator();
  addFaces(menu, view);
  menu.addSeparator();
  addCheck(menu, view, "view3dSectionEntry", tr("Section"), now.section.has_value(),
           [](ViewOptions& options, bool on) {
             options.section = on ? std::optional(SectionChoice{}) : std::nullopt;
           });
  addCheck(menu, view, "view3dExploded", tr("Exploded view"), now.explosion > 0,
           [](ViewOptions& options, bool on) { options.explosion = on ? 1 : 0; });
  addCheck(menu, view, "view3dGhosts", tr("Dim what is not selected"), now.translucentOthers,
           [](ViewOptions& options, bool on) { options.translucentOthers = on; });
  addLabels(menu, view);
  addMarks(menu, view);
  addNavigation(menu, view);
  menu.addSeparator();
  addWaysBack(menu, view);
}

void View3D::fillPartMenu(QMenu& menu, const std::optional<Hit>& hit) {
  View3D& view = *this;
  if (hit) {
    const ElementId link = hit->element;
    const bool moves = view.stage()->place != nullptr;
    QAction* follow = menu.addAction(tr("Follow %1").arg(view.nameOf(link)), &view,
                                     [&view, link] { view.fixReferenceFrame(link); });
    follow->setObjectName("view3dRide");
    follow->setEnabled(moves && view.referenceLink() != std::optional(link));
    QAction* alongAxis =
        menu.addAction(tr("Look along its axis"), &view, [&view, link] { view.lookAlong(link); });
    alongAxis->setObjectName("view3dLookAlong");
    alongAxis->setEnabled(view.hasAxis(link));
    QAction* trace = menu.addAction(tr("Trace this point"), &view, [&view, at = *hit] { view.trace(at); });
    trace->setObjectName("view3dTrace");
    trace->setEnabled(moves);
    menu.addSeparator();
    menu.addAction(tr("Hide it"), &view,
                   [&view, link] {
                     std::set<ElementId> hidden = view.hidden();
                     hidden.insert(link);
                     view.setHidden(std::move(hidden));
                   })
        ->setObjectName("view3dHide");
    menu.addAction(tr("Hide all others"), &view, [&view, link] { hideOthers(view, link); })
        ->setObjectName("view3dHideOthers");
  } else {
    menu.addAction(tr("Fit"), &view, [&view] { view.fit(); });
  }
  addWaysBack(menu, view);
}

}  // namespace geargraph
