#include "ui/canvas/brake_edits.h"

#include <QCoreApplication>
#include <algorithm>
#include <utility>

#include "core/mechanism/model/shift_edits.h"
#include "core/theory/states/state_edits.h"
#include "ui/canvas/canvas_edits.h"

namespace geargraph {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("canvas", text);
}

/// The coupling that was added is engaged at once.
Expected<Mechanism> withLastEngaged(Expected<Mechanism> added) {
  if (!added) return added;
  const ShiftElementId coupling = added->couplings.back().id;
  return withCouplingEngaged(*std::move(added), coupling, true);
}

}  // namespace

Edit brakeEdit(const Mechanism& now, LinkId link) {
  return {tr("Hold %1").arg(describe(now, {link})),
          [link](const Mechanism& mechanism) { return withLastEngaged(withBrake(mechanism, link)); }, 0};
}

Edit clutchEdit(LinkId one, LinkId other) {
  return {
      tr("Connect links"),
      [one, other](const Mechanism& mechanism) { return withLastEngaged(withClutch(mechanism, one, other)); },
      0};
}

Edit freewheelEdit(LinkId one, LinkId other) {
  return {tr("Add freewheel"),
          [one, other](const Mechanism& mechanism) { return withFreewheel(mechanism, one, other); }, 0};
}

Edit engageEdit(const Mechanism& now, ShiftElementId coupling, bool engaged) {
  return {(engaged ? tr("Engage %1") : tr("Release %1")).arg(describe(now, {coupling})),
          [=](const Mechanism& mechanism) { return withCouplingEngaged(mechanism, coupling, engaged); }, 0};
}

Edit toggleBrakeEdit(const Mechanism& now, LinkId link) {
  const auto brake = std::find_if(now.couplings.begin(), now.couplings.end(), [&](const ShiftElement& each) {
    return each.kind == ShiftElementKind::brake && each.links.front() == link;
  });
  if (brake == now.couplings.end()) return brakeEdit(now, link);
  return engageEdit(now, brake->id, !isEngaged(now, brake->id));
}

}  // namespace geargraph
