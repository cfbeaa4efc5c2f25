#include "ui/panels/mesh_efficiency_field.h"

#include <QEvent>

#include "core/mechanism/model/load_edits.h"
#include "ui/theme/theme_colors.h"

namespace geargraph {

constexpr int kEfficiencyPixels = 84;

MeshEfficiencyField::MeshEfficiencyField(Document* document, QWidget* parent)
    : NumberField(parent), m_document(document) {
  setAccessibleName(tr("Efficiency of a mesh"));
  setToolTip(meaning());
  setOptional(true);
  setEmptyText(tr("none"));
  setStep(Rational(1, 100));
  setFixedWidth(scaledPixels(kEfficiencyPixels));
  connect(this, &NumberField::editingStarted, this, [this] { m_gesture = m_document->newGesture(); });
  connect(this, &NumberField::edited, this, [this](const std::optional<Number>& efficiency) {
    if (efficiency && (efficiency->exact().sign() <= 0 || efficiency->exact() > Rational(1)))
      return reject(tr("An efficiency is above 0 and at most 1."));
    apply(*m_document, efficiency, m_gesture);
  });
  connect(document, &Document::changed, this, &MeshEfficiencyField::renew);
  renew();
}

QString MeshEfficiencyField::meaning() {
  return tr(
      "The efficiency of meshes that state none: the power that a mesh delivers over what it takes, "
      "seen from its carrier. Empty: they lose nothing.");
}

void MeshEfficiencyField::apply(Document& document, const std::optional<Number>& efficiency,
                                quint64 gesture) {
  document.apply(
      {tr("Set efficiency"),
       [efficiency](const Mechanism& before) { return withDefaultLosses(before, efficiency, std::nullopt); },
       gesture});
}

/// Larger type needs a wider field.
void MeshEfficiencyField::changeEvent(QEvent* event) {
  NumberField::changeEvent(event);
  if (event->type() == QEvent::FontChange) setFixedWidth(scaledPixels(kEfficiencyPixels));
}

void MeshEfficiencyField::renew() {
  const auto& defaults = m_document->mechanism()->gearDefaults;
  setNumber(defaults ? defaults->efficiency : std::nullopt);
}

}  // namespace geargraph

#include "moc_mesh_efficiency_field.cpp"
