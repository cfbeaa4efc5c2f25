#include "ui/panels/drive_torque_strip.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include "core/mechanism/model/load_edits.h"
#include "core/theory/statics/shift_statics.h"
#include "ui/models/printed_number.h"
#include "ui/panels/mesh_efficiency_field.h"
#include "ui/panels/number_field.h"
#include "ui/theme/control_button.h"
#include "ui/theme/flow_layout.h"
#include "ui/theme/theme_colors.h"

namespace geargraph {

constexpr int kTorqueWidth = 96;

DriveTorqueStrip::DriveTorqueStrip(Document* document, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_field(new NumberField(this)),
      m_share(controlButton(QStringLiteral("shareInStates"), tr("Share by stiffness"),
                            tr("Meshes that share a load in unknown parts: assume that all teeth are equally "
                               "stiff, without clearance, on rigid bodies"),
                            this)),
      m_spread(new QLabel(this)) {
  auto* flow = new FlowLayout(this);
  flow->setContentsMargins(16, 4, 12, 0);
  flow->setSpacing(6);
  m_field->setObjectName(QStringLiteral("driveTorque"));
  m_field->setOptional(true);
  m_field->setFixedWidth(scaledPixels(kTorqueWidth));
  addPair(
      tr("Torque at the drive, N m"),
      tr("At the drive of every state, about its first axis; empty: that of the loads at drives, else 1 N m"),
      m_field);
  auto* efficiency = new MeshEfficiencyField(document, this);
  efficiency->setObjectName(QStringLiteral("gearboxEfficiency"));
  addPair(tr("η of a mesh"), MeshEfficiencyField::meaning(), efficiency);
  makeShare();
  flow->addWidget(m_share);
  m_spread->setObjectName(QStringLiteral("spread"));
  m_spread->setProperty("look", "hint");
  m_spread->setToolTip(tr("The largest ratio over the smallest, of the states that turn forward"));
  m_spread->hide();
  flow->addWidget(m_spread);
  connect(m_field, &NumberField::editingStarted, this, [this] { m_gesture = m_document->newGesture(); });
  connect(m_field, &NumberField::edited, this, [this](const std::optional<Number>& torque) {
    m_document->apply({tr("Set torque at the drive"),
                       [torque](const Mechanism& before) { return withDriveTorque(before, torque); },
                       m_gesture});
  });
  connect(document, &Document::changed, this, &DriveTorqueStrip::renew);
  renew();
}

/// A title and its field stay together where the strip has two lines.
void DriveTorqueStrip::addPair(const QString& title, const QString& tip, QWidget* field) {
  auto* pair = new QWidget(this);
  auto* row = new QHBoxLayout(pair);
  row->setContentsMargins(0, 0, 6, 0);
  row->setSpacing(6);
  auto* label = new QLabel(title, pair);
  label->setProperty("look", "hint");
  label->setToolTip(tip);
  field->setAccessibleName(title);
  field->setToolTip(tip);
  row->addWidget(label);
  row->addWidget(field);
  layout()->addWidget(pair);
}

void DriveTorqueStrip::makeShare() {
  m_share->setCheckable(true);
  connect(m_share, &QToolButton::clicked, this, [this](bool isOn) {
    const auto sharing = isOn ? std::optional(LoadSharing::stiffness) : std::nullopt;
    m_document->apply(
        {tr("Set load sharing"),
         [sharing](const Mechanism& before) -> Expected<Mechanism> { return withSharing(before, sharing); },
         0});
  });
}

void DriveTorqueStrip::showSpread(const std::optional<double>& spread) {
  m_spread->setVisible(spread.has_value());
  if (spread) m_spread->setText(tr("spread %1").arg(printedNumber(*spread, 3, 'f')));
}

void DriveTorqueStrip::showSharing(bool isShared) {
  m_isShared = isShared;
  renew();
}

/// Larger type needs a wider field.
void DriveTorqueStrip::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange) m_field->setFixedWidth(scaledPixels(kTorqueWidth));
}

void DriveTorqueStrip::renew() {
  const Mechanism& mechanism = *m_document->mechanism();
  setVisible(!mechanism.states.empty());
  const bool isAsked = mechanism.sharing == LoadSharing::stiffness;
  m_share->setChecked(isAsked);
  m_share->setVisible(isAsked || m_isShared);
  if (mechanism.states.empty()) return;
  const std::optional<Rational> otherwise = driveTorqueOf(mechanism, 0);
  m_field->setEmptyText(otherwise ? printedFraction(*otherwise) : tr("found"));
  m_field->setNumber(mechanism.driveTorque);
}

}  // namespace geargraph

#include "moc_drive_torque_strip.cpp"
