// The teeth of a mesh, typed or slid.

#include <QHBoxLayout>

#include "core/mechanism/geometry_edits/fitted_edits.h"
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

}  // namespace geargraph
