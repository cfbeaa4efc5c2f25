#include "ui/motion_panel/equation_page.h"

#include <QBoxLayout>
#include <QLabel>

#include "ui/reading/formula_label.h"
#include "ui/theme/sideways_scroll.h"

namespace geargraph {

EquationPage::EquationPage(Selection* selection, QWidget* parent)
    : QWidget(parent),
      m_model(new ValueTableModel(this)),
      m_table(new LinkedTable(m_model, selection, this)),
      m_numbers(new FormulaLabel) {
  m_table->setObjectName(QStringLiteral("equationTable"));
  m_table->setAccessibleName(tr("Equation of motion"));
  auto* symbols = new FormulaLabel;
  symbols->setTex(
      "M \\left( \\theta \\right) \\ddot{\\theta} + h \\left( \\theta , \\dot{\\theta} \\right) = \\tau + "
      "\\ell");
  const QString meaning =
      tr("M: the generalised inertia of the inputs. h: what motors have to give at constant speeds, for "
         "Coriolis "
         "and centrifugal forces and for weight. τ: torques of the motors. ℓ: what the loads contribute.");
  symbols->setToolTip(meaning);
  m_numbers->setToolTip(meaning);
  auto* formulas = new QWidget(this);
  auto* row = new QHBoxLayout(formulas);
  row->setContentsMargins(12, 2, 12, 2);
  row->setSpacing(24);
  row->addWidget(symbols, 0, Qt::AlignVCenter);
  row->addWidget(m_numbers, 0, Qt::AlignVCenter);
  row->addStretch(1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  layout->addWidget(new SidewaysScroll(formulas, this));
  auto* margin = new QHBoxLayout;
  margin->setContentsMargins(8, 0, 0, 0);
  margin->addWidget(m_table);
  layout->addLayout(margin, 1);
}

void EquationPage::show(const DynamicsPtr& dynamics) {
  std::shared_ptr<const ValueTable> table;
  std::string tex;
  if (dynamics && dynamics->train) {
    const Mechanism& mechanism = *dynamics->snapshot->mechanism;
    table = std::make_shared<const ValueTable>(equationTable(mechanism, *dynamics->train, dynamics->state));
    tex = equationTex(mechanism, *dynamics->train, dynamics->state);
  }
  m_model->showTable(std::move(table));
  m_numbers->setTex(tex);
  m_numbers->setVisible(!tex.empty());
  m_table->resizeColumnsToContents();
  m_table->selectRowOfSelection();
}

const std::string& EquationPage::tex() const {
  return m_numbers->tex();
}

}  // namespace geargraph

#include "moc_equation_page.cpp"
