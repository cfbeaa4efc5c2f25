#include "ui/panels/parts_forms.h"

#include <QPushButton>

#include "core/mechanism/model/shift_edits.h"
#include "core/theory/states/state_edits.h"
#include "ui/models/term_tips.h"
#include "ui/panels/link_parts.h"

namespace geargraph {

AxisForm::AxisForm(Document* document, const ElementId& axis)
    : PropertyForm(document, {axis}), m_joints(addParts(tr("Joints"), Term::turningJoint)) {
  setTitle(tr("Axis %1").arg(shownText(axis.id.text())));
  addNote(tr("Its joints have its place and direction: select one to change them."));
}

void AxisForm::refresh() {
  showParts(*m_joints, jointsOn(mechanism(), index(), AxisId(elements().front().id)));
}

CouplingForm::CouplingForm(Document* document, const ElementId& coupling)
    : PropertyForm(document, {coupling}),
      m_links(addParts(tr("Links"), Term::link)),
      m_engage(new QPushButton(this)) {
  m_engage->setObjectName(QStringLiteral("engage"));
  addButtons({m_engage});
  connect(m_engage, &QPushButton::clicked, this, [this] {
    newGesture();
    apply((isEngagedNow() ? tr("Release %1") : tr("Engage %1")).arg(shownText(elements().front().id.text())),
          [engaged = !isEngagedNow()](const Mechanism& before, const ElementId& element) {
            return withCouplingEngaged(before, ShiftElementId(element.id), engaged);
          });
  });
}

bool CouplingForm::isEngagedNow() const {
  return isEngaged(mechanism(), ShiftElementId(elements().front().id));
}

void CouplingForm::refresh() {
  const ShiftElement& coupling = *mechanism().find(ShiftElementId(elements().front().id));
  const bool isBrake = coupling.kind == ShiftElementKind::brake;
  const bool isFreewheel = coupling.kind == ShiftElementKind::freewheel;
  setTitle((isBrake       ? tr("Brake %1")
            : isFreewheel ? tr("Freewheel %1")
                          : tr("Clutch %1"))
               .arg(shownText(coupling.id.text())));
  showParts(*m_links, linksOf(coupling, index()));
  m_engage->setText(isEngagedNow() ? tr("Release") : tr("Engage"));
  m_engage->setToolTip(isBrake       ? tr("While it is engaged the brake holds its link.")
                       : isFreewheel ? tr("It locks where its first link would turn faster than its second.")
                                     : tr("While it is engaged the clutch makes its links turn as one."));
}

}  // namespace geargraph

#include "moc_parts_forms.cpp"
