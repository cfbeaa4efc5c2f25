#include "ui/canvas/context_menu.h"

#include <QCoreApplication>
#include <QMenu>
#include <algorithm>

#include "core/mechanism/model/pins.h"
#include "core/mechanism/model/shift_edits.h"
#include "ui/canvas/brake_edits.h"
#include "ui/canvas/canvas_edits.h"
#include "ui/canvas/menu_preview.h"
#include "ui/canvas/weld_edits.h"
#include "ui/models/axis_choices.h"

namespace geargraph {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("canvas", text);
}

/// An entry; with a reason why it is not possible it is grey and shows the reason. The key is shown only: the
/// view answers to it, wherever it was pressed.
QAction* add(QMenu& menu, const QString& text, const QString& key, const std::function<void()>& action,
             const QString& whyNot = {}) {
  const QString shown = whyNot.isEmpty() ? text : text + " (" + whyNot + ")";
  QAction* entry = menu.addAction(key.isEmpty() ? shown : shown + "\t" + key);
  entry->setEnabled(whyNot.isEmpty());
  QObject::connect(entry, &QAction::triggered, &menu, [action] { action(); });
  return entry;
}

/// An entry with a tick, which turns something on and off.
void addTick(QMenu& menu, const QString& text, bool on, const std::function<void(bool)>& action) {
  QAction* entry = menu.addAction(text);
  entry->setCheckable(true);
  entry->setChecked(on);
  QObject::connect(entry, &QAction::triggered, &menu, [action](bool now) { action(now); });
}

const ShiftElement* couplingOf(const Mechanism& mechanism, ShiftElementKind kind,
                               const std::set<LinkId>& links) {
  for (const ShiftElement& coupling : mechanism.couplings) {
    if (coupling.kind == kind && std::set<LinkId>(coupling.links.begin(), coupling.links.end()) == links)
      return &coupling;
  }
  return nullptr;
}

/// To engage a coupling, or to release it.
void addEngage(QMenu& menu, const Mechanism& mechanism, ShiftElementId coupling,
               const ContextActions& actions) {
  const bool isNow = isEngaged(mechanism, coupling);
  const QString what = describe(mechanism, {coupling});
  QAction* entry = add(menu, (isNow ? tr("Release %1") : tr("Engage %1")).arg(what), {},
                       [engage = actions.engage, coupling, isNow] { engage(coupling, !isNow); });
  MenuPreview::of(menu).add(entry, engageEdit(mechanism, coupling, !isNow));
}

void fillForBrake(QMenu& menu, const Mechanism& mechanism, LinkId link, const ContextActions& actions) {
  const bool ground = mechanism.links.front().id == link;
  if (const ShiftElement* brake = couplingOf(mechanism, ShiftElementKind::brake, {link})) {
    const ElementId id = brake->id;
    addEngage(menu, mechanism, brake->id, actions);
    add(menu, tr("Take %1 off").arg(describe(mechanism, {id})), {},
        [removeCoupling = actions.removeCoupling, id] { removeCoupling(id); });
  } else {
    QAction* entry = add(menu, tr("Hold it with a brake"), "B", actions.addBrake,
                         ground ? tr("the ground does not move") : QString());
    MenuPreview::of(menu).add(entry, brakeEdit(mechanism, link));
  }
}

/// One for each link that may not overtake the other.
void addFreewheels(QMenu& menu, const Mechanism& mechanism, LinkId one, LinkId other,
                   const ContextActions& actions) {
  if (couplingOf(mechanism, ShiftElementKind::freewheel, {one, other}) != nullptr) return;
  for (const auto& [first, second] : {std::pair(one, other), std::pair(other, one)}) {
    QAction* entry = add(menu,
                         tr("Freewheel: %1 cannot overtake %2")
                             .arg(describe(mechanism, {first}), describe(mechanism, {second})),
                         {}, [addFreewheel = actions.addFreewheel, first = first, second = second] {
                           addFreewheel(first, second);
                         });
    entry->setToolTip(
        tr("It locks where the first link would turn faster, about the direction of their axis."));
  }
}

void fillForClutch(QMenu& menu, const Mechanism& mechanism, const ContextActions& actions) {
  std::vector<LinkId> links;
  for (const ElementId& element : actions.selected) {
    if (element.kind == ElementKind::link) links.emplace_back(element.id);
  }
  if (links.size() != 2) {
    add(
        menu, tr("Connect it to another link with a clutch"), {}, [] {}, tr("select two links"));
    return;
  }
  const LinkId one = links[0];
  const LinkId other = links[1];
  if (const ShiftElement* clutch = couplingOf(mechanism, ShiftElementKind::clutch, {one, other})) {
    const ElementId id = clutch->id;
    addEngage(menu, mechanism, clutch->id, actions);
    add(menu, tr("Take %1 off").arg(describe(mechanism, {id})), {},
        [removeCoupling = actions.removeCoupling, id] { removeCoupling(id); });
    return;
  }
  const bool ground = mechanism.links.front().id == one || mechanism.links.front().id == other;
  QAction* entry = add(
      menu,
      tr("Connect %1 and %2 with a clutch").arg(describe(mechanism, {one}), describe(mechanism, {other})), {},
      [addClutch = actions.addClutch, one, other] { addClutch(one, other); },
      ground ? tr("hold the link with a brake") : QString());
  MenuPreview::of(menu).add(entry, clutchEdit(one, other));
  addFreewheels(menu, mechanism, one, other, actions);
}

/// Two links to one, or one to two.
void fillForWeld(QMenu& menu, const Mechanism& mechanism, const ContextActions& actions) {
  if (const auto links = linksToWeld(mechanism, actions.selected)) {
    const QString why = whyNoWeld(mechanism, actions.selected);
    QAction* entry = add(menu,
                         tr("Weld %1 and %2 to one link")
                             .arg(describe(mechanism, {links->first}), describe(mechanism, {links->second})),
                         "Ctrl+J", actions.weld);
    entry->setEnabled(why.isEmpty());
    entry->setToolTip(why);
    menu.setToolTipsVisible(true);
    if (why.isEmpty()) MenuPreview::of(menu).add(entry, weldEdit(mechanism, links->first, links->second));
    return;
  }
  // Most links have nothing that could be split off; the menu of the window says why.
  if (whyNoSplit(mechanism, actions.selected).isEmpty())
    add(menu, tr("Split it in two"), "Ctrl+Shift+J", actions.split);
}

void fillForMesh(QMenu& menu, const Mechanism& mechanism, MeshId mesh, const ContextActions& actions) {
  const std::optional<MeshKind> kind = actions.kindOf(mesh);
  if (!kind) return;
  const GearMesh& element = *mechanism.find(mesh);
  if (hasIntersectingAxes(*kind)) {
    for (const bool ofTail : {true, false}) {
      add(menu,
          tr("Move gear %1 to the other side of the apex")
              .arg(QString::fromStdString(*labelOf(mechanism, ofTail ? element.tail : element.head))),
          {}, [flipSide = actions.flipSide, ofTail] { flipSide(ofTail); });
    }
  } else if (const std::optional<MeshKind> other = pairKind(*kind).other) {
    const QString text = hasRing(*other) ? tr("Make it internal")
                         : hasParallelAxes(*other)
                             ? tr("Make it external")
                             : tr("Change its kind: %1").arg(QString::fromStdString(kindWord(*other)));
    add(menu, text, {}, [setMeshKind = actions.setMeshKind, other] { setMeshKind(*other); });
  }
  addTick(menu, tr("Pin the module"), isPinned(element),
          [pin = actions.pin, mesh](bool on) { pin(mesh, on); });
}

void fillForLink(QMenu& menu, const Mechanism& mechanism, LinkId link, const ContextActions& actions) {
  const bool ground = mechanism.links.front().id == link;
  const CarryingJoint carrying = carryingJoint(mechanism, link);
  const bool driven = carrying.joint && isInput(mechanism, *carrying.joint);
  add(menu, tr("Rename"), "F2", actions.rename);
  add(menu, driven ? tr("Stop driving it") : tr("Drive it"), {}, actions.toggleInput, carrying.why);
  add(menu, tr("Make it the ground"), {}, actions.makeGround, ground ? tr("it is the ground") : QString());
  if (actions.attachGear) add(menu, tr("Attach a gear"), "Ctrl+G", actions.attachGear, carrying.why);
  menu.addSeparator();
  fillForBrake(menu, mechanism, link, actions);
  fillForClutch(menu, mechanism, actions);
  fillForWeld(menu, mechanism, actions);
  addTick(menu, tr("Pin the teeth of its gears"), isPinned(*mechanism.find(link)),
          [pin = actions.pin, link](bool on) { pin(link, on); });
  menu.addSeparator();
  add(menu, tr("Delete"), tr("Del"), actions.remove, ground ? tr("the ground cannot be deleted") : QString());
}

void fillForPin(QMenu& menu, const Mechanism& mechanism, AxisId axis, const ContextActions& actions) {
  const Axis* found = mechanism.find(axis);
  if (found == nullptr) return;
  QString layTitle = tr("Lay axis %1").arg(QString::fromStdString(axis.text()));
  if (isPinned(*found)) layTitle += " (" + tr("it is pinned") + ")";
  QMenu* lay = menu.addMenu(layTitle);
  lay->setEnabled(!isPinned(*found));
  fillAxisMenu(*lay, axisChoices(mechanism, {axis}),
               [placeAxis = actions.placeAxis, axis](const AxisChoice& choice) { placeAxis(axis, choice); });
  addTick(menu, tr("Axis %1 pinned").arg(QString::fromStdString(axis.text())), isPinned(*found),
          [pin = actions.pin, axis](bool on) { pin(axis, on); });
}

void fillForArrow(QMenu& menu, const Mechanism& mechanism, const ElementId& arrow,
                  const ContextActions& actions) {
  const bool joint = arrow.kind == ElementKind::turningJoint;
  const bool driven = joint && isInput(mechanism, JointId(arrow.id));
  add(menu, driven ? tr("Stop driving it") : tr("Drive it"), {}, actions.toggleInput,
      joint ? QString() : tr("only turning joints can be driven"));
  add(menu, tr("Flip the arrow"), "X", actions.flip);
  if (joint) {
    fillForPin(menu, mechanism, mechanism.find(JointId(arrow.id))->axis, actions);
  } else {
    fillForMesh(menu, mechanism, MeshId(arrow.id), actions);
  }
  menu.addSeparator();
  add(menu, tr("Delete"), tr("Del"), actions.remove);
}

void fillForAxis(QMenu& menu, const Mechanism& mechanism, AxisId axis, const ContextActions& actions) {
  fillForPin(menu, mechanism, axis, actions);
  menu.addSeparator();
  add(menu, tr("Delete with its joints"), tr("Del"), actions.remove);
}

}  // namespace

void fillContextMenu(QMenu& menu, const Mechanism& mechanism, const std::optional<ElementId>& element,
                     const ContextActions& actions) {
  if (!element) {
    if (actions.addLink) add(menu, tr("New link here"), {}, actions.addLink);
    if (actions.addNote) add(menu, tr("New note here"), {}, actions.addNote);
    add(menu, tr("Select all"), "Ctrl+A", actions.selectAll);
    menu.addSeparator();
    const bool alone = mechanism.links.size() == 1;
    if (actions.tidy) {
      add(menu, tr("Tidy the drawing"), {}, actions.tidy, alone ? tr("nothing is drawn yet") : QString());
    }
    add(menu, tr("Fit"), "F", actions.fit);
    return;
  }
  menu.setTitle(describe(mechanism, {*element}));
  if (element->kind == ElementKind::link) {
    fillForLink(menu, mechanism, LinkId(element->id), actions);
  } else if (element->kind == ElementKind::axis) {
    fillForAxis(menu, mechanism, AxisId(element->id), actions);
  } else if (element->kind == ElementKind::coupling) {
    addEngage(menu, mechanism, ShiftElementId(element->id), actions);
    add(menu, tr("Take it off"), {},
        [removeCoupling = actions.removeCoupling, id = *element] { removeCoupling(id); });
  } else if (element->kind == ElementKind::note) {
    add(menu, tr("Change the text"), "F2", actions.open);
    add(menu, tr("Delete"), tr("Del"), actions.remove);
  } else {
    fillForArrow(menu, mechanism, *element, actions);
  }
}

}  // namespace geargraph
