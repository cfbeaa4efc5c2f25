#include "ui/forces/totals_strip.h"

#include <QBoxLayout>
#include <QLabel>
#include <algorithm>

#include "core/teaching/force_tables/force_table.h"
#include "ui/models/printed_number.h"
#include "ui/models/term_tips.h"

namespace geargraph {
namespace {

QString objectNameOf(const char* total) {
  return QStringLiteral("total.") + QLatin1String(total);
}

}  // namespace

TotalsStrip::TotalsStrip(QLayout& layout, QWidget* parent) {
  add(layout, parent, "fed", QObject::tr("fed, W"),
      QObject::tr("The power that loads and balances feed into the train."));
  add(layout, parent, "taken", QObject::tr("taken, W"),
      QObject::tr("The power that loads and balances take from the train."));
  add(layout, parent, "lost", QObject::tr("lost, W"), QObject::tr("What the meshes lose: fed less taken."));
  add(layout, parent, "efficiency", QObject::tr("efficiency"), QObject::tr("Power taken over power fed."));
  add(layout, parent, "efficiencyBack", QObject::tr("backward"),
      QObject::tr("The efficiency of the same motion with all known torques reversed: the output drives."));
  add(layout, parent, "latent", QObject::tr("latent ratio"),
      QObject::tr("What all meshes pass, seen from their carriers, over the power fed: the losses are "
                  "about this many times those of one mesh."));
  add(layout, parent, "circulating", QObject::tr("circulating, W"),
      QObject::tr("The greatest power that goes round in a loop of shafts and gear sets."));
}

void TotalsStrip::add(QLayout& layout, QWidget* parent, const char* name, const QString& title,
                      const QString& meaning) {
  auto* pair = new QWidget(parent);
  auto* row = new QHBoxLayout(pair);
  row->setContentsMargins(0, 0, 6, 0);
  row->setSpacing(4);
  auto* head = new QLabel(title, pair);
  head->setProperty("look", "hint");
  auto* value = new QLabel(pair);
  value->setObjectName(objectNameOf(name));
  value->setTextInteractionFlags(Qt::TextSelectableByMouse);
  value->setWhatsThis(meaning);
  for (QLabel* label : {head, value}) {
    label->setToolTip(meaning);
    row->addWidget(label);
  }
  layout.addWidget(pair);
  m_pairs.push_back(pair);
  m_values.push_back(value);
}

void TotalsStrip::setVisible(bool isVisible) {
  for (QWidget* pair : m_pairs) pair->setVisible(isVisible);
}

void TotalsStrip::set(const char* name, const QString& text, const QString& exact) {
  QLabel* label = *std::find_if(m_values.begin(), m_values.end(), [name](const QLabel* each) {
    return each->objectName() == objectNameOf(name);
  });
  label->setText(withPrintedMinus(text));
  const QString meaning = label->whatsThis();
  label->setToolTip(exact.isEmpty() ? meaning
                                    : meaning + QLatin1Char('\n') + QObject::tr("Exactly %1").arg(exact));
}

void TotalsStrip::setReal(const char* name, const Real& value) {
  set(name, shownText(shownNumber(value.number())),
      value.isExact() ? shownText(shownReal(value)) : QString());
}

void TotalsStrip::setEfficiency(const char* name, const std::optional<LossySolution>& solution,
                                const std::optional<PowerSums>& sums) {
  if (!solution) return;
  if (solution->outcome == LossySolution::Outcome::selfLocking) return set(name, QObject::tr("locks itself"));
  const bool isSolved = solution->outcome == LossySolution::Outcome::solved;
  if (const auto value = isSolved && sums ? sums->efficiency() : std::nullopt) setReal(name, *value);
}

void TotalsStrip::show(const ForcesPtr& forces) {
  for (const char* name : {"fed", "taken", "lost", "efficiency", "efficiencyBack", "latent", "circulating"})
    set(name, QStringLiteral("–"));
  if (!forces || !forces->report) return;
  const StaticsReport& report = *forces->report;
  setEfficiency("efficiency", report.lossy, report.sums);
  setEfficiency("efficiencyBack", report.backward, report.backwardSums);
  if (!report.sums) return;
  setReal("fed", report.sums->fed);
  setReal("taken", report.sums->taken);
  setReal("lost", report.sums->lost);
  if (report.latentRatio) setReal("latent", *report.latentRatio);
  if (!report.circulations) return;
  if (report.circulations->empty()) return set("circulating", QObject::tr("none"));
  setReal("circulating", report.circulations->front().power);
}

}  // namespace geargraph
