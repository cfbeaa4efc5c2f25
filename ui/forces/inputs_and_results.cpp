#include "ui/forces/inputs_and_results.h"

#include <QBoxLayout>
#include <QFrame>

#include "ui/forces/torque_rows.h"
#include "ui/panels/inputs_panel.h"
#include "ui/panels/results_panel.h"
#include "ui/workbench/views.h"
#include "ui/workbench/workbench.h"

namespace geargraph {

InputsAndResults::InputsAndResults(Views& views, QWidget* parent)
    : QWidget(parent),
      m_inputs(new InputsPanel(views.document(), views.selection(), this)),
      m_results(new ResultsPanel(views.selection(), this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(m_inputs);
  layout->addWidget(new TorqueRows(views.document(), views.selection(), &views.workbench().forces(), this));
  auto* rule = new QFrame(this);
  rule->setProperty("look", "rule");
  rule->setFixedHeight(1);
  layout->addWidget(rule);
  layout->addWidget(m_results, 1);
  connect(m_results, &ResultsPanel::inputsWanted, m_inputs, &InputsPanel::drive);
  connect(m_results, &ResultsPanel::menuWanted, &views, &Views::menuWanted);
}

void InputsAndResults::setMechanism(const MechanismPtr& mechanism) {
  m_results->setNames(mechanism);
}

void InputsAndResults::setSnapshot(const SnapshotPtr& snapshot) {
  m_results->setSnapshot(snapshot);
  m_inputs->setSnapshot(snapshot);
}

void InputsAndResults::setAwake(bool awake) {
  m_results->setAwake(awake);
}

QString InputsAndResults::emptyText() const {
  return m_results->emptyText();
}

ViewEntry inputsView() {
  return {
      .id = QStringLiteral("inputs"),
      .title = InputsAndResults::tr("Inputs and results"),
      .purpose = InputsAndResults::tr("The speeds of the motors, and how fast every joint turns with them."),
      .helpPage = QStringLiteral("inputs-and-results"),
      .searchWords = QStringLiteral(
          "speed velocity rpm ratio transmission reduction result solution motor drive input output "
          "relative absolute"),
      .place = ViewPlace::right,
      .servesDrawing = true,
      .make = [](Views& views, QWidget* parent) -> ResultsView* {
        return new InputsAndResults(views, parent);
      }};
}

}  // namespace geargraph

#include "moc_inputs_and_results.cpp"
