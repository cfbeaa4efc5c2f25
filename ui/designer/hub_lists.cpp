#include "ui/designer/hub_lists.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <algorithm>

#include "ui/designer/hit_words.h"
#include "ui/designer/hub_words.h"
#include "ui/theme/looks.h"
#include "ui/theme/theme_colors.h"

namespace geargraph {
namespace {

constexpr int kHubRowHeight = 24;  // px
constexpr std::size_t kMaxOthers = 200;

QTableWidgetItem* hubItem(const QString& text) {
  auto* item = new QTableWidgetItem(text);
  item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
  item->setTextAlignment(Qt::AlignCenter);
  return item;
}

void makeTable(QTableWidget& table) {
  table.verticalHeader()->setDefaultSectionSize(scaledPixels(kHubRowHeight));
  table.horizontalHeader()->setHighlightSections(false);
  table.verticalHeader()->setHighlightSections(false);
  table.setTabKeyNavigation(false);
  table.setFrameShape(QFrame::NoFrame);
  table.setWordWrap(false);
}

/// The speeds that a set alone can give, passed through first.
std::vector<Rational> ratiosOfSet(const HubSet& set) {
  std::vector<Rational> ratios{Rational(1)};
  for (std::size_t sun = 0; sun < set.suns.size(); ++sun) {
    if (set.suns[sun].reduction >= 0) ratios.push_back(set.reduction(sun));
    if (set.suns[sun].increase >= 0) ratios.push_back(set.reduction(sun).inverse());
  }
  return ratios;
}

}  // namespace

HubProducts::HubProducts(QWidget* parent) : QTableWidget(parent) {
  setObjectName(QStringLiteral("hubProducts"));
  setAccessibleName(tr("Products of the ratios of two sets"));
  setToolTip(tr("Rows: ratios of the first set. Columns: of the second. Gears are products of both."));
  makeTable(*this);
  setSelectionMode(QAbstractItemView::NoSelection);
  setFocusPolicy(Qt::NoFocus);
}

void HubProducts::setCandidate(const HubCandidate* candidate) {
  const bool isShown = candidate != nullptr && candidate->sets.size() == 2;
  setVisible(isShown);
  if (!isShown) return;
  const Theme theme = themeOf(palette());
  const std::vector<Rational> rows = ratiosOfSet(candidate->sets[0]);
  const std::vector<Rational> columns = ratiosOfSet(candidate->sets[1]);
  clear();
  setRowCount(static_cast<int>(rows.size()));
  setColumnCount(static_cast<int>(columns.size()));
  const auto headOf = [](const Rational& ratio) {
    return ratio == Rational(1) ? tr("through") : decimalOf(ratio);
  };
  for (std::size_t row = 0; row < rows.size(); ++row) {
    setVerticalHeaderItem(static_cast<int>(row), new QTableWidgetItem(headOf(rows[row])));
    for (std::size_t column = 0; column < columns.size(); ++column) {
      if (row == 0)
        setHorizontalHeaderItem(static_cast<int>(column), new QTableWidgetItem(headOf(columns[column])));
      const Rational product = rows[row] * columns[column];
      const auto gear = std::find(candidate->ratios.begin(), candidate->ratios.end(), product);
      const bool isUsed = gear != candidate->ratios.end();
      QTableWidgetItem* const item = hubItem(
          isUsed ? QStringLiteral("%1:  %2").arg(gear - candidate->ratios.begin() + 1).arg(decimalOf(product))
                 : tr("%1, not used").arg(decimalOf(product)));
      if (isUsed) item->setBackground(chosenColor(theme));
      item->setForeground(qColor(isUsed ? ColorRole::ink : ColorRole::secondary, theme));
      item->setToolTip(fractionOf(product));
      setItem(static_cast<int>(row), static_cast<int>(column), item);
    }
  }
  horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  setFixedHeight(horizontalHeader()->sizeHint().height() + rowCount() * scaledPixels(kHubRowHeight) + 4);
}

HubTable::HubTable(QWidget* parent) : QTableWidget(parent) {
  setObjectName(QStringLiteral("hubCandidates"));
  setAccessibleName(tr("Candidates"));
  makeTable(*this);
  verticalHeader()->hide();
  setShowGrid(false);
  setSelectionBehavior(QAbstractItemView::SelectRows);
  setSelectionMode(QAbstractItemView::SingleSelection);
  connect(this, &QTableWidget::currentCellChanged, this, [this](int row, int, int before) {
    if (row != before) emit chosenChanged();
  });
  connect(this, &QAbstractItemView::doubleClicked, this, &HubTable::openWanted);
}

void HubTable::setSearch(const HubSearchPtr& search) {
  m_search = nullptr;
  clear();
  setRowCount(0);
  setColumnCount(0);
  m_search = search;
  if (!search) return emit chosenChanged();
  const auto& shape = search->assembled.empty() ? search->others : search->assembled;
  QStringList heads{tr("No.")};
  if (!shape.empty()) {
    for (std::size_t set = 0; set < shape.front().sets.size(); ++set) {
      const QString number = QString::number(set + 1);
      for (std::size_t sun = 0; sun < shape.front().sets[set].suns.size(); ++sun)
        heads << tr("sun %1.%2").arg(number).arg(sun + 1);
      heads << tr("ring %1").arg(number) << tr("planets %1").arg(number);
    }
    for (std::size_t gear = 0; gear < shape.front().ratios.size(); ++gear)
      heads << tr("gear %1").arg(gear + 1);
  }
  setColumnCount(static_cast<int>(heads.size()));
  setHorizontalHeaderLabels(heads);
  for (const HubCandidate& each : search->assembled) addRow(each, false);
  for (std::size_t i = 0; i < std::min(search->others.size(), kMaxOthers); ++i)
    addRow(search->others[i], true);
  resizeColumnsToContents();
  if (rowCount() > 0) selectRow(0);
  emit chosenChanged();
}

/// Candidates of another structure may have other numbers of suns: what has no column is left out.
void HubTable::addRow(const HubCandidate& candidate, bool isDimmed) {
  const Theme theme = themeOf(palette());
  const int row = rowCount();
  setRowCount(row + 1);
  int column = 0;
  const auto put = [&](const QString& text, bool isWrong = false) {
    QTableWidgetItem* const item = hubItem(text);
    if (isDimmed) item->setForeground(qColor(isWrong ? ColorRole::warning : ColorRole::secondary, theme));
    if (column < columnCount()) setItem(row, column++, item);
    return item;
  };
  put(QString::number(row + 1));
  for (const HubSet& set : candidate.sets) {
    for (const HubSun& sun : set.suns) put(hubSunText(sun));
    put(QString::number(set.ring));
    put(hubPlanetsText(set), set.planets.empty())
        ->setToolTip(set.planets.empty() ? tr("No equal planets at equal distances can be assembled.")
                                         : QString());
  }
  for (const Rational& ratio : candidate.ratios) put(decimalOf(ratio))->setToolTip(fractionOf(ratio));
}

const HubCandidate* HubTable::chosen() const {
  if (!m_search || currentRow() < 0) return nullptr;
  const auto row = static_cast<std::size_t>(currentRow());
  const std::size_t assembled = m_search->assembled.size();
  return row < assembled ? &m_search->assembled[row] : &m_search->others[row - assembled];
}

void HubTable::keyPressEvent(QKeyEvent* event) {
  const bool isReturn = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (isReturn && chosen() != nullptr) return emit openWanted();
  QTableWidget::keyPressEvent(event);
}

}  // namespace geargraph

#include "moc_hub_lists.cpp"
