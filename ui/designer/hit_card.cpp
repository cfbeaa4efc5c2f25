#include "ui/designer/hit_card.h"

#include <QBoxLayout>
#include <QButtonGroup>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QTableWidget>
#include <QToolButton>
#include <initializer_list>

#include "core/design/gearboxes/section_rules.h"
#include "core/foundations/base/locale.h"
#include "ui/canvas/drawing_preview.h"
#include "ui/designer/hit_words.h"
#include "ui/models/printed_number.h"
#include "ui/models/term_tips.h"
#include "ui/theme/theme_colors.h"

namespace geargraph {
namespace {

constexpr int kRowHeight = 20;  // px

QTableWidgetItem* hitCell(const QString& text, bool isWord = false) {
  auto* item = new QTableWidgetItem(text);
  item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
  item->setTextAlignment((isWord ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
  item->setToolTip(text);
  return item;
}

QTableWidgetItem* boldCell(const QString& text) {
  QTableWidgetItem* const item = hitCell(text);
  QFont bold = item->font();
  bold.setBold(true);
  item->setFont(bold);
  return item;
}

QString engagedLetters(const GearState& gear) {
  QStringList letters;
  for (const int each : gear.engaged) letters << elementLetter(each);
  return letters.join(' ');
}

/// As high as its rows, so that what is around it scrolls; columns give way one by one where all are too
/// wide.
void fitTable(QTableWidget& table, std::initializer_list<int> giveWay = {}) {
  const int head = table.horizontalHeader()->isHidden() ? 0 : table.horizontalHeader()->sizeHint().height();
  table.setFixedHeight(head + table.rowCount() * table.verticalHeader()->defaultSectionSize() + 4);
  table.resizeColumnsToContents();
  for (const int column : giveWay)
    if (table.horizontalHeader()->length() > table.viewport()->width()) table.setColumnHidden(column, true);
}

QString sectionWords(const Gearbox& gearbox) {
  return gearbox.brokenRule ? shownText(sectionRuleReason(*gearbox.brokenRule))
                            : HitCard::tr("Its section can be drawn without crossing shafts.");
}

}  // namespace

HitCard::HitCard(QWidget* parent)
    : QWidget(parent),
      m_states(makeTable("hitStates")),
      m_measures(makeTable("hitMeasures")),
      m_words(new QLabel(this)),
      m_variants(new QToolButton(this)),
      m_variantMenu(new QMenu(this)) {
  setObjectName(QStringLiteral("hitCard"));
  m_states->setAccessibleName(tr("Shift table of the chosen gearbox"));
  m_measures->setAccessibleName(tr("What gearboxes are compared by"));
  m_measures->horizontalHeader()->hide();
  m_words->setWordWrap(true);
  m_words->setTextFormat(Qt::PlainText);
  m_words->setObjectName(QStringLiteral("hitWords"));
  m_words->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_variants->setText(tr("Variants"));
  m_variants->setObjectName(QStringLiteral("hitVariants"));
  m_variants->setToolTip(tr("Brakes and clutches with the same speeds, but other torques and slips"));
  m_variants->setPopupMode(QToolButton::InstantPopup);
  m_variants->setMenu(m_variantMenu);
  connect(m_variantMenu, &QMenu::aboutToShow, this, &HitCard::fillVariants);

  auto* room = new QWidget;
  auto* content = new QVBoxLayout(room);
  content->setContentsMargins(12, 8, 12, 4);
  content->addWidget(makePictures(), 1);
  content->addWidget(m_states);
  content->addWidget(m_measures);
  content->addWidget(m_words);
  auto* scroll = new QScrollArea(this);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidgetResizable(true);
  scroll->setWidget(room);
  auto* foot = new QHBoxLayout;
  foot->setContentsMargins(12, 4, 12, 10);
  for (std::size_t i = 0; i < kMost; ++i) {
    m_open[i] = new QPushButton(this);
    m_open[i]->setObjectName(i == 0 ? QStringLiteral("openHit") : QStringLiteral("openOtherHit"));
    m_open[i]->setToolTip(tr("Opens this gearbox as a document with its states, in a new window"));
    foot->addWidget(m_open[i], 1);
    connect(m_open[i], &QPushButton::clicked, this, [this, i] { emit openWanted(m_hits[i].gearbox); });
  }
  foot->addWidget(m_variants);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(scroll, 1);
  layout->addLayout(foot);
  setHits(nullptr, {});
}

QTableWidget* HitCard::makeTable(const char* name) {
  auto* table = new QTableWidget(this);
  table->setObjectName(QLatin1String(name));
  table->verticalHeader()->hide();
  table->verticalHeader()->setDefaultSectionSize(scaledPixels(kRowHeight));
  table->horizontalHeader()->setHighlightSections(false);
  table->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  table->setShowGrid(false);
  table->setWordWrap(false);
  table->setTabKeyNavigation(false);
  table->setFrameShape(QFrame::NoFrame);
  return table;
}

QWidget* HitCard::makePictures() {
  auto* pictures = new QWidget;
  auto* grid = new QGridLayout(pictures);
  grid->setContentsMargins(0, 0, 0, 0);
  for (std::size_t i = 0; i < kMost; ++i) {
    const int column = static_cast<int>(i);
    m_titles[i] = new QLabel(pictures);
    m_titles[i]->setProperty("look", "title");
    m_titles[i]->setObjectName(i == 0 ? QStringLiteral("hitTitle") : QStringLiteral("otherHitTitle"));
    m_drawings[i] = new DrawingPreview(pictures);
    m_drawings[i]->setObjectName(i == 0 ? QStringLiteral("hitLevers") : QStringLiteral("otherHitDrawing"));
    m_elements[i] = new QLabel(pictures);
    m_elements[i]->setWordWrap(true);
    m_elements[i]->setTextFormat(Qt::RichText);
    grid->addWidget(m_titles[i], 0, column);
    grid->addWidget(m_drawings[i], 2, column);
    grid->addWidget(m_elements[i], 3, column, Qt::AlignTop);
    grid->setColumnStretch(column, 1);
  }
  grid->setRowStretch(2, 1);
  m_kinds = new QWidget(pictures);
  auto* row = new QHBoxLayout(m_kinds);
  row->setContentsMargins(0, 0, 0, 0);
  auto* group = new QButtonGroup(this);
  for (const bool isSchematic : {false, true}) {
    auto* chip = new QToolButton(m_kinds);
    chip->setText(isSchematic ? tr("Schematic") : tr("Levers"));
    chip->setObjectName(isSchematic ? QStringLiteral("compareSchematics") : QStringLiteral("compareLevers"));
    chip->setProperty("look", "chip");
    chip->setCheckable(true);
    chip->setChecked(!isSchematic);
    group->addButton(chip);
    row->addWidget(chip);
    connect(chip, &QToolButton::clicked, this, [this, isSchematic] {
      m_showsSchematics = isSchematic;
      updateDrawings();
    });
  }
  row->addStretch(1);
  grid->addWidget(m_kinds, 1, 0, 1, 2);
  return pictures;
}

const Gearbox& HitCard::gearboxAt(std::size_t position) const {
  const HitDetailPtr& detail = m_details[position];
  return detail ? *detail->gearbox : *m_hits[position].gearbox;
}

void HitCard::setHits(const GearboxWishPtr& wish, std::vector<NumberedHit> hits) {
  std::array<HitDetailPtr, kMost> details;
  for (std::size_t i = 0; i < hits.size(); ++i)
    for (const HitDetailPtr& known : m_details)
      if (known && known->asked == hits[i].gearbox) details[i] = known;
  m_wish = wish;
  m_hits = std::move(hits);
  m_details = std::move(details);
  for (std::size_t i = 0; i < kMost; ++i) {
    const bool isShown = i < m_hits.size();
    m_titles[i]->setText(isShown ? tr("No. %1").arg(m_hits[i].number) : QString());
    m_open[i]->setText(isShown ? tr("Open No. %1").arg(m_hits[i].number) : tr("Open"));
    m_open[i]->setVisible(isShown || i == 0);
    m_open[i]->setEnabled(isShown);
  }
  m_titles[0]->setText(m_hits.empty() ? tr("Choose a gearbox of the list.") : m_titles[0]->text());
  m_kinds->setVisible(m_hits.size() > 1);
  m_states->setVisible(!m_hits.empty());
  m_measures->setVisible(!m_hits.empty());
  m_variants->setVisible(m_hits.size() == 1);
  m_variants->setEnabled(!m_hits.empty() && std::any_of(m_hits.front().gearbox->variants.begin(),
                                                        m_hits.front().gearbox->variants.end(),
                                                        [](const auto& each) { return each.size() > 1; }));
  updateDrawings();
  updateWords();
}

void HitCard::setDetail(const HitDetailPtr& detail) {
  for (std::size_t i = 0; i < m_hits.size(); ++i) {
    if (m_hits[i].gearbox != detail->asked) continue;
    m_details[i] = detail;
    updateDrawings();
    updateWords();
  }
}

/// Of one gearbox levers and schematic, of two the same of both.
void HitCard::updateDrawings() {
  const bool isPair = m_hits.size() > 1;
  for (std::size_t i = 0; i < kMost; ++i) {
    const HitDetailPtr& detail = m_details[isPair ? i : 0];
    const bool isSchematic = isPair ? m_showsSchematics : i == 1;
    m_drawings[i]->setVisible(!m_hits.empty());
    m_drawings[i]->setAccessibleName(isSchematic ? tr("Schematic of the gearbox")
                                                 : tr("Lever diagram of the gearbox"));
    m_drawings[i]->setDrawing(!detail ? DisplayList() : isSchematic ? detail->schematic : detail->levers);
  }
}

void HitCard::updateWords() {
  for (std::size_t i = 0; i < kMost; ++i) m_elements[i]->setVisible(i < m_hits.size());
  if (m_hits.empty()) return m_words->clear();
  for (std::size_t i = 0; i < m_hits.size(); ++i) {
    const Gearbox& gearbox = gearboxAt(i);
    QStringList words;
    for (std::size_t element = 0; element < gearbox.elements.size(); ++element)
      words << QStringLiteral("<b>%1</b>&nbsp;%2")
                   .arg(elementLetter(static_cast<int>(element)),
                        elementText(*m_wish, gearbox, gearbox.elements[element])
                            .replace(' ', QStringLiteral("&nbsp;")));
    m_elements[i]->setText(words.join(QStringLiteral("&ensp; ")));
  }
  m_hits.size() > 1 ? fillTwoTable() : fillOneTable();
  fillMeasures();
  QStringList words;
  for (std::size_t i = 0; i < m_hits.size(); ++i) {
    const QString before =
        m_hits.size() > 1 ? tr("No. %1").arg(m_hits[i].number) + QStringLiteral(": ") : QString();
    words << before + linksOf(*m_wish, gearboxAt(i))
          << tr("Teeth, sun planet ring: %1").arg(teethOf(gearboxAt(i))) << sectionWords(gearboxAt(i));
  }
  m_words->setText(words.join('\n'));
}

QString HitCard::wantedOf(std::size_t gear) const {
  const auto text = [](const WantedRatio& ratio) {
    return QString::fromStdString(localizedNumber(ratio.text));
  };
  if (gear < m_wish->forward.size()) return text(m_wish->forward[gear]);
  return m_wish->reverseRatio ? withPrintedMinus('-' + text(*m_wish->reverseRatio)) : tr("any");
}

void HitCard::fillOneTable() {
  enum StateColumn { name, wanted, engaged, ratio, decimal, error, efficiency, circulating, stateColumns };
  const Gearbox& gearbox = gearboxAt(0);
  m_states->clear();
  m_states->setColumnCount(stateColumns);
  m_states->setRowCount(static_cast<int>(gearbox.gears.size()));
  m_states->setHorizontalHeaderLabels({tr("state"), tr("wanted"), tr("engaged"), tr("ratio"), tr("decimal"),
                                       tr("error"), QStringLiteral("η"), tr("circul.")});
  m_states->horizontalHeaderItem(circulating)
      ->setToolTip(tr("The largest circulating power, as a part of the power at the input"));
  for (const int column : {wanted, decimal}) m_states->setColumnHidden(column, false);
  m_states->setColumnHidden(efficiency, !gearbox.losses || !m_wish->efficiency);
  m_states->setColumnHidden(circulating, !gearbox.losses);
  for (std::size_t i = 0; i < gearbox.gears.size(); ++i) {
    const GearState& gear = gearbox.gears[i];
    const int row = static_cast<int>(i);
    m_states->setItem(row, name, hitCell(QString::fromStdString(gear.name), true));
    m_states->setItem(row, wanted, hitCell(wantedOf(i)));
    m_states->setItem(row, engaged, hitCell(engagedLetters(gear), true));
    m_states->setItem(row, ratio, boldCell(fractionOf(gear.ratio)));
    m_states->item(row, ratio)->setToolTip(decimalOf(gear.ratio));
    m_states->setItem(row, decimal, hitCell(decimalOf(gear.ratio)));
    m_states->setItem(row, error, hitCell(percentOf(gear.error)));
    if (!gearbox.losses) continue;
    const auto shown = [](const std::optional<Rational>& value) {
      return hitCell(value ? decimalOf(*value) : tr("none"));
    };
    m_states->setItem(row, efficiency, shown(gearbox.losses->efficiencies[i]));
    m_states->setItem(row, circulating, shown(gearbox.losses->circulating[i]));
  }
  fitTable(*m_states, {decimal, circulating, wanted});
}

void HitCard::fillTwoTable() {
  enum StateColumn { name, wanted, engaged, ratio, otherEngaged, otherRatio, stateColumns };
  m_states->clear();
  m_states->setColumnCount(stateColumns);
  for (int column = 0; column < stateColumns; ++column) m_states->setColumnHidden(column, false);
  m_states->setRowCount(static_cast<int>(gearboxAt(0).gears.size()));
  m_states->setHorizontalHeaderLabels(
      {tr("state"), tr("wanted"), m_titles[0]->text(), tr("ratio"), m_titles[1]->text(), tr("ratio")});
  for (std::size_t i = 0; i < gearboxAt(0).gears.size(); ++i) {
    const int row = static_cast<int>(i);
    m_states->setItem(row, name, hitCell(QString::fromStdString(gearboxAt(0).gears[i].name), true));
    m_states->setItem(row, wanted, hitCell(wantedOf(i)));
    for (std::size_t hit = 0; hit < kMost; ++hit) {
      const GearState& gear = gearboxAt(hit).gears[i];
      const int column = hit == 0 ? engaged : otherEngaged;
      m_states->setItem(row, column, hitCell(engagedLetters(gear), true));
      QTableWidgetItem* const found = boldCell(decimalOf(gear.ratio));
      found->setToolTip(fractionOf(gear.ratio));
      m_states->setItem(row, column + 1, found);
    }
  }
  fitTable(*m_states);
}

/// Of two the better one is green; what is doubtful has the colour of warnings, and its gear beside it.
void HitCard::fillMeasures() {
  const Theme theme = themeOf(palette());
  m_measures->clear();
  m_measures->setColumnCount(static_cast<int>(1 + m_hits.size()));
  m_measures->setRowCount(0);
  for (const HitMeasure measure : kHitMeasures) {
    const bool needsLosses = measure == HitMeasure::efficiency || measure == HitMeasure::circulating;
    if (needsLosses && !gearboxAt(0).losses) continue;
    if (measure == HitMeasure::efficiency && !m_wish->efficiency) continue;
    const int row = m_measures->rowCount();
    m_measures->setRowCount(row + 1);
    m_measures->setItem(row, 0, hitCell(measureName(measure), true));
    for (std::size_t i = 0; i < m_hits.size(); ++i) {
      const Gearbox& own = gearboxAt(i);
      const QString text = (measureText(measure, own) + ' ' + measureGear(measure, own)).trimmed();
      const bool wins = m_hits.size() > 1 && isBetter(measure, own, gearboxAt(1 - i));
      QTableWidgetItem* const item = wins ? boldCell(text) : hitCell(text);
      if (wins) item->setForeground(qColor(ColorRole::fine, theme));
      if (isWarning(measure, own)) item->setForeground(qColor(ColorRole::warning, theme));
      m_measures->setItem(row, static_cast<int>(i) + 1, item);
    }
  }
  fitTable(*m_measures);
}

void HitCard::fillVariants() {
  m_variantMenu->clear();
  const GearboxPtr gearbox = m_hits.front().gearbox;
  for (std::size_t i = 0; i < gearbox->elements.size(); ++i) {
    for (const ElementLinks& other : gearbox->variants[i]) {
      if (other == gearbox->elements[i]) continue;
      auto variant = withVariant(*m_wish, *gearbox, i, other);
      if (!variant) continue;
      const QString text = tr("%1: %2 instead of %3, largest torque %4, largest slip %5")
                               .arg(elementLetter(static_cast<int>(i)), elementText(*m_wish, *gearbox, other),
                                    elementText(*m_wish, *gearbox, gearbox->elements[i]),
                                    decimalOf(variant->measures.torque), decimalOf(variant->measures.slip));
      auto made = std::make_shared<const Gearbox>(*std::move(variant));
      m_variantMenu->addAction(text, this, [this, gearbox, made] { emit variantWanted(gearbox, made); });
    }
  }
  if (m_variantMenu->isEmpty())
    m_variantMenu->addAction(tr("None of them is within the limits of the wish."))->setEnabled(false);
}

}  // namespace geargraph

#include "moc_hit_card.cpp"
