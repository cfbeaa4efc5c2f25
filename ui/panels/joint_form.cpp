#include <QComboBox>
#include <QHBoxLayout>
#include <QMenu>
#include <QPushButton>

#include "core/mechanism/model/axis_letters.h"
#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/slide_edits.h"
#include "ui/models/axis_choices.h"
#include "ui/panels/element_forms.h"
#include "ui/panels/number_field.h"

namespace geargraph {
QPushButton* JointForm::makeLayButton() {
  auto* button = new QPushButton(tr("Lay axis"), this);
  button->setObjectName(QStringLiteral("layAxis"));
  button->setToolTip(
      tr("Lay the axis along x, y or z, or as another axis lies. The kinds of its meshes follow."));
  auto* menu = new QMenu(button);
  menu->setObjectName(QStringLiteral("layAxisMenu"));
  button->setMenu(menu);
  connect(menu, &QMenu::aboutToShow, this, [this, menu] {
    menu->clear();
    std::set<AxisId> axes;
    for (const TurningJoint* joint : joints()) axes.insert(joint->axis);
    fillAxisMenu(*menu, axisChoices(mechanism(), axes), [this](const AxisChoice& choice) {
      newGesture();
      applyFitted(tr("Lay axis"), [choice](const PlacedMechanism& before, const ElementId& joint) {
        return withAxisChosen(before, before.mechanism().find(JointId(joint.id))->axis, choice);
      });
    });
  });
  return button;
}

void JointForm::addKind() {
  m_jointKind->setObjectName(QStringLiteral("jointKind"));
  m_jointKind->addItem(tr("turning"));
  m_jointKind->setItemData(0, tr("The head turns about the axis, against the tail."), Qt::ToolTipRole);
  m_jointKind->addItem(tr("sliding"));
  m_jointKind->setItemData(1, tr("The head slides along the axis, against the tail."), Qt::ToolTipRole);
  m_jointKind->setPlaceholderText(tr("several"));
  addRow(tr("Kind"), Term::turningJoint, m_jointKind);
  connect(m_jointKind, &QComboBox::activated, this, [this](int item) {
    newGesture();
    const JointKind kind = item == 1 ? JointKind::sliding : JointKind::turning;
    apply(tr("Change kind of joint"), [kind](Mechanism before, const ElementId& joint) {
      return withJointKind(std::move(before), JointId(joint.id), kind);
    });
  });
}

/// Two angles in degrees, or places of what slides, from the reference pose, side by side; an empty field is
/// an open end.
void JointForm::addLimits() {
  m_limits = new QWidget(this);
  auto* row = new QHBoxLayout(m_limits);
  row->setContentsMargins(0, 0, 0, 0);
  for (NumberField* field : {m_low, m_high}) {
    const bool isLow = field == m_low;
    field->setOptional(true);
    field->setQuantity(Quantity::angle);
    field->setStep(Rational(5));
    row->addWidget(field);
    connect(field, &NumberField::edited, this, [this, isLow](const std::optional<Number>& number) {
      apply(tr("Limit joint"), [number, isLow](Mechanism before, const ElementId& joint) {
        JointLimits limits = before.find(JointId(joint.id))->limits;
        (isLow ? limits.low : limits.high) = number;
        return withJointLimits(std::move(before), JointId(joint.id), limits);
      });
    });
  }
  addRow(tr("Limits, deg"), Term::jointLimits, m_limits);
}

void JointForm::chooseAxis(int item) {
  newGesture();
  if (item == m_axis->count() - 1) {
    std::vector<JointId> ids;
    for (const ElementId& element : elements()) ids.emplace_back(element.id);
    applyAtOnce(tr("New axis"), [ids](const Mechanism& before) {
      return withAxisLettersAsBefore(before, withNewAxis(before, ids));
    });
    return;
  }
  applyToEach(tr("Change axis"), [ids = elements(), axis = AxisId(m_axis->currentText().toStdString())](
                                     const PlacedMechanism& before, const LongEdit::Progress& progress) {
    const Expected<Mechanism> next = changedInTurn<Mechanism>(
        before.mechanism(), ids, progress, [axis](Mechanism mechanism, const ElementId& joint) {
          return withJointAxis(std::move(mechanism), JointId(joint.id), axis);
        });
    return unplaced(withAxisLettersAsBefore(before, next));
  });
}

void JointForm::showLimit(NumberField& field, const std::optional<std::optional<Number>>& limit) {
  field.setEmptyText(limit ? tr("none") : tr("several"));
  field.setNumber(limit ? *limit : std::nullopt);
}

}  // namespace geargraph
