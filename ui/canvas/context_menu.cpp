#include "ui/canvas/context_menu.h"

#include <QCoreApplication>
#include <QMenu>

#include "ui/canvas/canvas_edits.h"

namespace geargraph {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("canvas", text);
}

/// An entry; with a reason why it is not possible it is grey and shows the reason. The key is shown only: the
/// view answers to it, wherever it was pressed.
void add(QMenu& menu, const QString& text, const QString& key, const std::function<void()>& action,
         const QString& whyNot = {}) {
  const QString shown = whyNot.isEmpty() ? text : text + " (" + whyNot + ")";
  QAction* entry = menu.addAction(key.isEmpty() ? shown : shown + "\t" + key);
  entry->setEnabled(whyNot.isEmpty());
  QObject::connect(entry, &QAction::triggered, &menu, [action] { action(); });
}

void fillForLink(QMenu& menu, const Mechanism& mechanism, LinkId link, const ContextActions& actions) {
  const bool ground = mechanism.links.front().id == link;
  const Carrying carrying = carryingJoint(mechanism, link);
  const bool driven = carrying.joint && isInput(mechanism, *carrying.joint);
  add(menu, tr("Rename"), "F2", actions.rename);
  add(menu, driven ? tr("Stop driving it") : tr("Drive it"), {}, actions.toggleInput, carrying.why);
  add(menu, tr("Make it the ground"), {}, actions.makeGround, ground ? tr("it is the ground") : QString());
  if (actions.attachGear) add(menu, tr("Attach a gear"), "Ctrl+G", actions.attachGear, carrying.why);
  menu.addSeparator();
  add(menu, tr("Delete"), tr("Del"), actions.remove, ground ? tr("the ground cannot be deleted") : QString());
}

void fillForArrow(QMenu& menu, const Mechanism& mechanism, const ElementId& arrow,
                  const ContextActions& actions) {
  const bool joint = arrow.kind == ElementKind::turningJoint;
  const bool driven = joint && isInput(mechanism, JointId(arrow.id));
  add(menu, driven ? tr("Stop driving it") : tr("Drive it"), {}, actions.toggleInput,
      joint ? QString() : tr("only turning joints can be driven"));
  add(menu, tr("Flip the arrow"), "X", actions.flip);
  menu.addSeparator();
  add(menu, tr("Delete"), tr("Del"), actions.remove);
}

void fillForAxis(QMenu& menu, const ContextActions& actions) {
  add(menu, tr("Delete with its joints"), tr("Del"), actions.remove);
}

}  // namespace

void fillContextMenu(QMenu& menu, const Mechanism& mechanism, const std::optional<ElementId>& element,
                     const ContextActions& actions) {
  if (!element) {
    if (actions.addLink) add(menu, tr("New link here"), {}, actions.addLink);
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
    fillForAxis(menu, actions);
  } else {
    fillForArrow(menu, mechanism, *element, actions);
  }
}

}  // namespace geargraph
