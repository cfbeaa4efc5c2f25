#include "ui/designer/hit_card.h"

#include <QBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <array>

#include "core/design/gearboxes/section_rules.h"
#include "core/foundations/base/spoken.h"
#include "ui/designer/hit_words.h"
#include "ui/designer/lever_preview.h"
#include "ui/models/printed_number.h"
#include "ui/models/term_tips.h"
#include "ui/theme/theme_colors.h"

namespace geargraph::inline designer {
namespace {

enum StateColumn { name, wanted, engaged, ratio, decimal, error, efficiency, circulating, stateColumns };

QTableWidgetItem* cellOf(const QString& text, bool isWord = false) {
  auto* item = new QTableWidgetItem(text);
  item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
  item->setTextAlignment((isWord ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
  item->setToolTip(text);
  return item;
}

}  // namespace

HitCard::HitCard(QWidget* parent)
    : QWidget(parent),
      m_title(new QLabel(this)),
      m_levers(new LeverPreview(this)),
      m_states(new QTableWidget(0, stateColumns, this)),
      m_words(new QLabel(this)),
      m_open(new QPushButton(tr("Open"), this)) {
  m_title->setProperty("look", "title");
  m_title->setObjectName(QStringLiteral("hitTitle"));
  m_states->setObjectName(QStringLiteral("hitStates"));
  m_states->setAccessibleName(tr("Shift table of the chosen gearbox"));
  m_states->setHorizontalHeaderLabels({tr("state"), tr("wanted"), tr("engaged"), tr("ratio"), tr("decimal"),
                                       tr("error"), QStringLiteral("η"), tr("circulating")});
  m_states->horizontalHeaderItem(circulating)
      ->setToolTip(tr("The largest circulating power, as a part of the power at the input"));
  m_states->verticalHeader()->hide();
  m_states->verticalHeader()->setDefaultSectionSize(scaledPixels(22));
  m_states->horizontalHeader()->setHighlightSections(false);
  m_states->setShowGrid(false);
  m_states->setWordWrap(false);
  m_states->setTabKeyNavigation(false);
  m_states->setFrameShape(QFrame::NoFrame);
  m_words->setWordWrap(true);
  m_words->setTextFormat(Qt::PlainText);
  m_words->setObjectName(QStringLiteral("hitWords"));
  m_words->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_open->setObjectName(QStringLiteral("openHit"));
  m_open->setToolTip(tr("Opens this gearbox as a document with its states, in a new window"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(12, 8, 12, 10);
  layout->addWidget(m_title);
  layout->addWidget(m_levers, 2);
  layout->addWidget(m_states, 3);
  layout->addWidget(m_words);
  layout->addWidget(m_open);
  connect(m_open, &QPushButton::clicked, this, &HitCard::openWanted);
  setHit(nullptr, nullptr, 0);
}

void HitCard::setHit(const GearboxWishPtr& wish, const GearboxPtr& gearbox, int number) {
  const bool isOther = gearbox != m_gearbox;
  m_wish = wish;
  m_gearbox = gearbox;
  m_open->setEnabled(gearbox != nullptr);
  m_states->setVisible(gearbox != nullptr);
  m_open->setText(gearbox ? tr("Open No. %1").arg(number) : tr("Open"));
  if (gearbox) m_title->setText(tr("No. %1").arg(number));
  if (!gearbox) m_title->setText(tr("Choose a gearbox of the list."));
  if (!isOther) return;
  m_detail = nullptr;
  m_levers->setDrawing({});
  m_states->setRowCount(0);
  m_words->clear();
  if (!gearbox) return;
  fillTable(*gearbox);
  m_words->setText(elementsOf(*wish, *gearbox) + '\n' + linksOf(*wish, *gearbox) + '\n' +
                   tr("Teeth, sun planet ring: %1").arg(teethOf(*gearbox)) + '\n' +
                   (gearbox->brokenRule ? shownText(sectionRuleReason(*gearbox->brokenRule))
                                        : tr("Its section can be drawn without crossing shafts.")));
}

void HitCard::setDetail(const HitDetailPtr& detail) {
  if (!detail || detail->asked != m_gearbox) return;
  m_detail = detail;
  m_levers->setDrawing(detail->levers);
  fillTable(*detail->gearbox);
}

QString HitCard::wantedOf(std::size_t gear) const {
  const auto text = [](const WantedRatio& ratio) { return QString::fromStdString(spokenNumber(ratio.text)); };
  if (gear < m_wish->forward.size()) return text(m_wish->forward[gear]);
  return m_wish->reverseRatio ? withPrintedMinus('-' + text(*m_wish->reverseRatio)) : tr("any");
}

void HitCard::fillTable(const Gearbox& gearbox) {
  m_states->setRowCount(static_cast<int>(gearbox.gears.size()));
  m_states->setColumnHidden(efficiency, !gearbox.losses || !m_wish->efficiency);
  m_states->setColumnHidden(circulating, !gearbox.losses);
  for (std::size_t i = 0; i < gearbox.gears.size(); ++i) {
    const GearState& gear = gearbox.gears[i];
    const int row = static_cast<int>(i);
    QStringList letters;
    for (const int each : gear.engaged) letters << elementLetter(each);
    m_states->setItem(row, name, cellOf(QString::fromStdString(gear.name), true));
    m_states->setItem(row, wanted, cellOf(wantedOf(i)));
    m_states->setItem(row, engaged, cellOf(letters.join(' '), true));
    auto* exact = cellOf(fractionOf(gear.ratio));
    QFont bold = m_states->font();
    bold.setBold(true);
    exact->setFont(bold);
    m_states->setItem(row, ratio, exact);
    m_states->setItem(row, decimal, cellOf(decimalOf(gear.ratio)));
    m_states->setItem(row, error, cellOf(percentOf(gear.error)));
    if (!gearbox.losses) continue;
    const auto shown = [&](const std::optional<Rational>& value) {
      return cellOf(value ? decimalOf(*value) : tr("none"));
    };
    m_states->setItem(row, efficiency, shown(gearbox.losses->efficiencies[i]));
    m_states->setItem(row, circulating, shown(gearbox.losses->circulating[i]));
  }
  m_states->resizeColumnsToContents();
}

}  // namespace geargraph::inline designer

#include "moc_hit_card.cpp"
