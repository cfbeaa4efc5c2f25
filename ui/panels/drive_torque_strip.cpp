#include "ui/panels/drive_torque_strip.h"

#include <QHBoxLayout>
#include <QLabel>

#include "core/mechanism/model/load_edits.h"
#include "core/theory/statics/shift_statics.h"
#include "ui/models/printed_number.h"
#include "ui/panels/number_field.h"
#include "ui/theme/theme_colors.h"

namespace geargraph {

DriveTorqueStrip::DriveTorqueStrip(Document* document, QWidget* parent)
    : QWidget(parent), m_document(document), m_field(new NumberField(this)) {
  const QString tip =
      tr("At the drive of every state, about its first axis; empty: that of the loads at drives, else 1 N m");
  auto* title = new QLabel(tr("Torque at the drive, N m"), this);
  title->setProperty("look", "hint");
  title->setToolTip(tip);
  m_field->setObjectName(QStringLiteral("driveTorque"));
  m_field->setAccessibleName(title->text());
  m_field->setToolTip(tip);
  m_field->setOptional(true);
  m_field->setFixedWidth(scaledPixels(96));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(16, 4, 12, 0);
  layout->setSpacing(6);
  layout->addWidget(title);
  layout->addWidget(m_field);
  layout->addStretch(1);
  connect(m_field, &NumberField::editingStarted, this, [this] { m_gesture = m_document->newGesture(); });
  connect(m_field, &NumberField::edited, this, [this](const std::optional<Number>& torque) {
    m_document->apply({tr("Set torque at the drive"),
                       [torque](const Mechanism& before) { return withDriveTorque(before, torque); },
                       m_gesture});
  });
  connect(document, &Document::changed, this, &DriveTorqueStrip::renew);
  renew();
}

void DriveTorqueStrip::renew() {
  const Mechanism& mechanism = *m_document->mechanism();
  setVisible(!mechanism.states.empty());
  if (mechanism.states.empty()) return;
  const std::optional<Rational> otherwise = driveTorqueOf(mechanism, 0);
  m_field->setEmptyText(otherwise ? printedFraction(*otherwise) : tr("found"));
  m_field->setNumber(mechanism.driveTorque);
}

}  // namespace geargraph
