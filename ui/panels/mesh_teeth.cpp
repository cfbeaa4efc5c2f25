// The teeth of a mesh, typed or slid, and their helix.

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <algorithm>

#include "core/mechanism/geometry_edits/fitted_edits.h"
#include "core/mechanism/model/edits.h"
#include "ui/panels/element_forms.h"
#include "ui/panels/number_field.h"
#include "ui/panels/teeth_slider.h"

namespace geargraph {
namespace {

Expected<PlacedMechanism> withTeethOf(const PlacedMechanism& before, const ElementId& id, bool ofTail,
                                      int teeth) {
  const GearMesh& mesh = *before.mechanism().find(MeshId(id.id));
  return withTeethFitted(before, mesh.id, ofTail ? teeth : mesh.tailTeeth, ofTail ? mesh.headTeeth : teeth);
}

}  // namespace

void MeshForm::addTeethRow(const QString& name, NumberField* field, TeethSlider* slider) {
  auto* row = new QWidget(this);
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(8);
  layout->addWidget(field, 2);
  layout->addWidget(slider, 3);
  slider->setObjectName(field->objectName() + QStringLiteral("Slider"));
  field->setAccessibleName(name);
  slider->setAccessibleName(name);
  addRow(name, Term::teeth, row);
}

void MeshForm::connectTeeth() {
  for (const bool ofTail : {true, false}) {
    NumberField* field = ofTail ? m_tailTeeth : m_headTeeth;
    field->setWhole(kMinTeeth, kMaxTeeth);
    field->setEmptyText(tr("several"));
    connect(field, &NumberField::edited, this, [this, ofTail](const std::optional<Number>& number) {
      if (!number) return;
      applyFitted(tr("Change teeth"), [ofTail, teeth = static_cast<int>(number->value())](
                                          const PlacedMechanism& before, const ElementId& id) {
        return withTeethOf(before, id, ofTail, teeth);
      });
    });
    const TeethSlider* slider = ofTail ? m_tailSlider : m_headSlider;
    connect(slider, &TeethSlider::started, this, [this] {
      newGesture();
      m_slidFrom = placed();
    });
    connect(slider, &TeethSlider::slid, this, [this, ofTail](int teeth) { slideTeeth(ofTail, teeth); });
    connect(slider, &TeethSlider::putBack, this, [this] {
      if (m_slidFrom)
        applyAtOnce(tr("Change teeth"), [before = *m_slidFrom](const PlacedMechanism&) { return before; });
    });
  }
}

/// Each edit of a drag begins where the drag did, so that what follows the teeth comes back with them.
void MeshForm::slideTeeth(bool ofTail, int teeth) {
  if (!m_slidFrom) return;
  applyAtOnce(tr("Change teeth"),
              [from = *m_slidFrom, ids = elements(), ofTail,
               teeth](const PlacedMechanism&) -> Expected<PlacedMechanism> {
                Expected<PlacedMechanism> next = from;
                for (const ElementId& id : ids) {
                  if (next) next = withTeethOf(*next, id, ofTail, teeth);
                }
                return next;
              });
}

void MeshForm::addHelixRow() {
  m_hand->setObjectName(QStringLiteral("hand"));
  m_hand->setAccessibleName(tr("Hand of the helix"));
  m_hand->addItem(tr("usual hand"));
  for (const Hand hand : {Hand::right, Hand::left}) m_hand->addItem(QString::fromStdString(handWord(hand)));
  m_hand->setToolTip(tr("The hand of the first gear's teeth. Usual: right-hand, or what fits the axes."));
  m_herringbone->setObjectName(QStringLiteral("herringbone"));
  m_herringbone->setToolTip(
      tr("The helix changes its hand at the middle of the face, so that no axial force is left."));
  m_crossed->setObjectName(QStringLiteral("crossed"));
  m_crossed->setToolTip(tr("The strands cross between the pulleys, which then turn against each other."));
  m_helix->setAccessibleName(tr("Helix angle"));
  auto* layout = new QHBoxLayout(m_helixRow);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(8);
  layout->addWidget(m_helix, 2);
  layout->addWidget(m_hand, 2);
  layout->addWidget(m_herringbone);
  addRow(tr("Helix angle"), Term::helixAngle, m_helixRow);
  addWide(m_crossed);
}

void MeshForm::connectHelix() {
  m_helix->setEmptyText(tr("straight"));
  connect(m_helix, &NumberField::edited, this, [this](const std::optional<Number>& degrees) {
    apply(tr("Change helix angle"), [degrees](Mechanism before, const ElementId& id) {
      return withHelixAngle(std::move(before), MeshId(id.id), degrees);
    });
  });
  connect(m_hand, &QComboBox::activated, this, [this](int index) {
    newGesture();
    apply(tr("Change hand"), [index](Mechanism before, const ElementId& id) {
      std::optional<Hand> hand;
      if (index > 0) hand = index == 1 ? Hand::right : Hand::left;
      return withHand(std::move(before), MeshId(id.id), hand);
    });
  });
  connect(m_herringbone, &QCheckBox::clicked, this, [this](bool on) {
    newGesture();
    apply(tr("Change herringbone"), [on](Mechanism before, const ElementId& id) {
      return withHerringbone(std::move(before), MeshId(id.id), on);
    });
  });
  connect(m_crossed, &QCheckBox::clicked, this, [this](bool on) {
    newGesture();
    apply(tr("Cross strands"), [on](Mechanism before, const ElementId& id) {
      return withCrossed(std::move(before), MeshId(id.id), on);
    });
  });
}

void MeshForm::refreshHelix(const std::vector<const GearMesh*>& meshes) {
  const auto all = [&](const auto& has) {
    return std::all_of(meshes.begin(), meshes.end(), [&](const GearMesh* mesh) { return has(*mesh); });
  };
  const auto kindOf = [](const GearMesh& mesh) -> const PairKind& { return pairKind(saidKind(mesh)); };
  const bool isHelical =
      all([&](const GearMesh& mesh) { return kindOf(mesh).touches && kindOf(mesh).statesHelix; });
  const bool isWorm = all([&](const GearMesh& mesh) { return kindOf(mesh).isThreaded; });
  const bool isParallel =
      all([&](const GearMesh& mesh) { return kindOf(mesh).axes == LinePosition::parallel; });
  const bool isBevel =
      all([&](const GearMesh& mesh) { return kindOf(mesh).axes == LinePosition::intersecting; });
  setRowShown(m_helixRow, isHelical,
              isWorm    ? tr("Hand of the helix")
              : isBevel ? tr("Spiral angle")
                        : tr("Helix angle"));
  m_herringbone->setVisible(isParallel);
  m_helix->setVisible(!isWorm);
  m_crossed->setVisible(all([&](const GearMesh& mesh) { return kindOf(mesh).canCross; }));
  const QSignalBlocker quietHand(m_hand);
  const GearMesh& first = *meshes.front();
  m_helix->setEmptyText(isParallel || isBevel ? tr("straight") : tr("equal on both"));
  const bool isSameAngle = all([&](const GearMesh& mesh) { return mesh.helixAngle == first.helixAngle; });
  m_helix->setNumber(isSameAngle ? first.helixAngle : std::nullopt);
  const bool isSameHand = all([&](const GearMesh& mesh) { return mesh.hand == first.hand; });
  m_hand->setPlaceholderText(tr("several"));
  m_hand->setCurrentIndex(!isSameHand ? -1 : !first.hand ? 0 : *first.hand == Hand::right ? 1 : 2);
  m_herringbone->setChecked(all([](const GearMesh& mesh) { return mesh.herringbone; }));
  m_crossed->setChecked(all([](const GearMesh& mesh) { return mesh.crossed; }));
}

}  // namespace geargraph
