// The strip of totals below the tables of ForcesPanel.

#include <QBoxLayout>
#include <QLabel>
#include <QToolButton>

#include "core/mechanism/model/load_edits.h"
#include "core/teaching/force_tables/force_table.h"
#include "ui/forces/forces_panel.h"
#include "ui/models/term_tips.h"
#include "ui/theme/control_button.h"

namespace geargraph {
namespace {

/// The least width at which a text fits beside a title above a value.
int widthInTwoLines(const QLabel& label) {
  const QFontMetrics metrics(label.font());
  const auto linesAt = [&](int width) {
    const QRect box = metrics.boundingRect(QRect(0, 0, width, 1000), Qt::TextWordWrap, label.text());
    return box.width() <= width ? box.height() / metrics.lineSpacing() : 3;
  };
  int width = metrics.horizontalAdvance(label.text());
  constexpr int kStep = 4;
  while (width > kStep && linesAt(width - kStep) <= 2) width -= kStep;
  return width + kStep;
}

QString numberText(const Real& value) {
  return shownText(shownNumber(value.number()));
}

}  // namespace

QWidget* ForcesPanel::makeTotals() {
  auto* strip = new QWidget(this);
  auto* layout = new QHBoxLayout(strip);
  layout->setContentsMargins(12, 2, 10, 4);
  layout->setSpacing(8);
  addTotal(layout, "fed", tr("fed, W"), tr("The power that loads and balances feed into the train."));
  addTotal(layout, "taken", tr("taken, W"), tr("The power that loads and balances take from the train."));
  addTotal(layout, "lost", tr("lost, W"), tr("What the meshes lose: fed less taken."));
  addTotal(layout, "efficiency", tr("efficiency"),
           tr("The power taken over the power fed; backward and in symbols it is on the card Efficiency."));
  addTotal(layout, "latent", tr("latent ratio"),
           tr("What all meshes pass, seen from their carriers, over the power fed: the losses are about this "
              "many times those of one mesh."));
  addTotal(layout, "circulating", tr("circulating, W"),
           tr("The greatest power that goes round in a loop of shafts and gear sets."));
  m_verdict = new QLabel(strip);
  m_verdict->setProperty("look", "hint");
  m_verdict->setWordWrap(true);  // beside two lines, in two: some languages have long words
  layout->addWidget(m_verdict, 1);
  return strip;
}

QWidget* ForcesPanel::makeShareButton() {
  m_share = controlButton(QStringLiteral("shareByStiffness"), tr("Share by stiffness"),
                          tr("Meshes that share a load in unknown parts: assume that all teeth are equally "
                             "stiff, without clearance, on rigid bodies"),
                          this);
  m_share->setCheckable(true);
  connect(m_share, &QToolButton::clicked, this, [this](bool isOn) {
    const auto sharing = isOn ? std::optional(LoadSharing::stiffness) : std::nullopt;
    m_document->apply(
        {tr("Set load sharing"),
         [sharing](const Mechanism& before) -> Expected<Mechanism> { return withSharing(before, sharing); },
         0});
  });
  return m_share;
}

/// A title above its value.
void ForcesPanel::addColumn(QHBoxLayout* layout, const QString& text, const QString& meaning,
                            QWidget* value) {
  auto* title = new QLabel(text, this);
  title->setProperty("look", "hint");
  title->setToolTip(meaning);
  value->setToolTip(meaning);
  auto* column = new QVBoxLayout;
  column->setSpacing(0);
  column->addWidget(title);
  column->addWidget(value);
  layout->addLayout(column);
}

void ForcesPanel::addTotal(QHBoxLayout* layout, const char* name, const QString& text,
                           const QString& meaning) {
  auto* value = new QLabel(this);
  value->setObjectName(QStringLiteral("total.") + QLatin1String(name));
  value->setTextInteractionFlags(Qt::TextSelectableByMouse);
  value->setWhatsThis(meaning);
  addColumn(layout, text, meaning, value);
}

void ForcesPanel::setTotal(const char* name, const QString& text, const QString& exact) {
  auto* label = findChild<QLabel*>(QStringLiteral("total.") + QLatin1String(name));
  label->setText(text);
  const QString meaning = label->whatsThis();
  label->setToolTip(exact.isEmpty() ? meaning : meaning + QLatin1Char('\n') + tr("Exactly %1").arg(exact));
}

QString ForcesPanel::total(const QString& name) const {
  const auto* label = findChild<QLabel*>(QStringLiteral("total.") + name);
  return label == nullptr ? QString() : label->text();
}

void ForcesPanel::showTotals() {
  for (const char* name : {"fed", "taken", "lost", "efficiency", "latent", "circulating"})
    setTotal(name, QStringLiteral("–"));
  const bool isAsked = m_document->mechanism()->sharing == LoadSharing::stiffness;
  m_share->setChecked(isAsked);
  m_share->setVisible(false);
  m_verdict->clear();
  const ForcesPtr& shown = forces();
  if (!shown || !shown->report) return;
  const StaticsReport& report = *shown->report;
  m_share->setVisible(report.isSolved && (isAsked || report.lossless.indeterminate() > 0));
  if (report.agreement) {
    m_verdict->setText(report.agreement->equal ? tr("both methods agree")
                                               : tr("The two methods do not agree"));
    m_verdict->setMinimumWidth(widthInTwoLines(*m_verdict));
  }
  if (!report.sums) return;
  setTotal("fed", numberText(report.sums->fed));
  setTotal("taken", numberText(report.sums->taken));
  setTotal("lost", numberText(report.sums->lost));
  const bool hasLosses = report.lossy && report.lossy->outcome == LossySolution::Outcome::solved;
  const auto efficiency = hasLosses ? report.sums->efficiency() : std::nullopt;
  if (efficiency)
    setTotal("efficiency", numberText(*efficiency),
             efficiency->isExact() ? shownText(shownReal(*efficiency)) : QString());
  if (report.latentRatio) setTotal("latent", numberText(*report.latentRatio));
  if (report.circulations)
    setTotal("circulating",
             report.circulations->empty() ? tr("none") : numberText(report.circulations->front().power));
}

}  // namespace geargraph
