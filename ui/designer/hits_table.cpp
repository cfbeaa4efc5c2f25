#include "ui/designer/hits_table.h"

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QKeyEvent>
#include <QPainter>
#include <QScrollBar>
#include <algorithm>

#include "ui/designer/hit_words.h"
#include "ui/theme/looks.h"
#include "ui/theme/theme_colors.h"

namespace geargraph::inline designer {
namespace {

constexpr int kGearStep = 14;  // px at the usual size of type
constexpr int kElementStep = 11;
constexpr int kDotsMargin = 8;

/// The gearbox in a row of the sorted table.
const GearboxPtr& hitAt(const QModelIndex& index) {
  const auto* order = static_cast<const QSortFilterProxyModel*>(index.model());
  const auto* hits = static_cast<const HitsModel*>(order->sourceModel());
  return hits->at(order->mapToSource(index).row());
}

}  // namespace

void EngagedDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                            const QModelIndex& index) const {
  if (index.column() != HitsModel::elements) return QStyledItemDelegate::paint(painter, option, index);
  const Gearbox& hit = *hitAt(index);
  const Theme theme = themeOf(option.palette);
  const int gearStep = scaledPixels(kGearStep);
  const int elementStep = scaledPixels(kElementStep);
  painter->save();
  painter->setLayoutDirection(Qt::LeftToRight);
  if (option.state & QStyle::State_Selected) painter->fillRect(option.rect, chosenColor(theme));
  painter->setRenderHint(QPainter::Antialiasing);
  QFont small = option.font;
  small.setPixelSize(smallPixels() - 2);
  painter->setFont(small);
  const int left = option.rect.left() + kDotsMargin;
  const int top = option.rect.top() + kDotsMargin / 2;
  const auto elements = static_cast<int>(hit.elements.size());
  for (std::size_t g = 0; g < hit.gears.size(); ++g) {
    const GearState& gear = hit.gears[g];
    const int x = left + static_cast<int>(g) * gearStep;
    painter->setPen(qColor(ColorRole::secondary, theme));
    painter->drawText(QRect(x, top, gearStep, elementStep), Qt::AlignCenter,
                      QString::fromStdString(gear.name));
    painter->setPen(Qt::NoPen);
    for (int element = 0; element < elements; ++element) {
      const bool isEngaged =
          std::find(gear.engaged.begin(), gear.engaged.end(), element) != gear.engaged.end();
      const QPointF center(x + gearStep / 2.0, top + (element + 1.5) * elementStep);
      const double radius = isEngaged ? elementStep * 0.36 : elementStep * 0.1;
      painter->setBrush(qColor(isEngaged ? ColorRole::ink : ColorRole::secondary, theme));
      painter->drawEllipse(center, radius, radius);
    }
  }
  painter->setPen(qColor(ColorRole::secondary, theme));
  const int letters = left + static_cast<int>(hit.gears.size()) * gearStep + 3;
  for (int element = 0; element < elements; ++element) {
    painter->drawText(QRect(letters, top + (element + 1) * elementStep, gearStep, elementStep),
                      Qt::AlignCenter, elementLetter(element));
  }
  painter->restore();
}

QSize EngagedDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
  if (index.column() != HitsModel::elements) return QStyledItemDelegate::sizeHint(option, index);
  const Gearbox& hit = *hitAt(index);
  return {2 * kDotsMargin + (static_cast<int>(hit.gears.size()) + 1) * scaledPixels(kGearStep),
          kDotsMargin + (static_cast<int>(hit.elements.size()) + 1) * scaledPixels(kElementStep) + 4};
}

/// The chosen row has the same ground in all cells.
void EngagedDelegate::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const {
  QStyledItemDelegate::initStyleOption(option, index);
  const Theme theme = themeOf(option->palette);
  option->palette.setColor(QPalette::Highlight, chosenColor(theme));
  option->palette.setColor(QPalette::HighlightedText, qColor(ColorRole::ink, theme));
}

HitsTable::HitsTable(QWidget* parent) : QTableView(parent) {
  setObjectName(QStringLiteral("hits"));
  setAccessibleName(tr("Gearboxes that were found"));
  m_order.setSourceModel(&m_hits);
  m_order.setSortRole(HitsModel::SortRole);
  setModel(&m_order);
  setItemDelegate(new EngagedDelegate(this));
  setSelectionBehavior(QAbstractItemView::SelectRows);
  setSelectionMode(QAbstractItemView::SingleSelection);
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  setShowGrid(false);
  setWordWrap(false);
  setTabKeyNavigation(false);
  setFrameShape(QFrame::NoFrame);
  verticalHeader()->hide();
  horizontalHeader()->setHighlightSections(false);
  horizontalHeader()->setSortIndicator(HitsModel::number, Qt::AscendingOrder);
  setSortingEnabled(true);
  connect(selectionModel(), &QItemSelectionModel::currentRowChanged, this, &HitsTable::chosenChanged);
  connect(&m_order, &QAbstractItemModel::modelReset, this, &HitsTable::chosenChanged);
  connect(this, &QAbstractItemView::doubleClicked, this, &HitsTable::openWanted);
}

void HitsTable::startAnew(GearboxWishPtr wish) {
  setColumnHidden(HitsModel::efficiency, !wish || !wish->efficiency);
  m_hits.startAnew(std::move(wish));
}

void HitsTable::add(const std::vector<GearboxPtr>& found) {
  if (found.empty()) return;
  const QModelIndex current = currentIndex();
  const int before = current.isValid() ? visualRect(current).top() : 0;
  m_hits.add(found);
  fitRows();
  if (!current.isValid()) return selectRow(0);
  executeDelayedItemsLayout();
  verticalScrollBar()->setValue(verticalScrollBar()->value() + visualRect(currentIndex()).top() - before);
}

GearboxPtr HitsTable::chosen() const {
  const QModelIndex current = currentIndex();
  return current.isValid() ? hitAt(current) : nullptr;
}

/// Rows of one wish have nearly the same height: that of the most elements.
void HitsTable::fitRows() {
  int height = 0;
  for (int row = 0; row < std::min(m_order.rowCount(), 50); ++row)
    height = std::max(height, sizeHintForIndex(m_order.index(row, HitsModel::elements)).height());
  verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  verticalHeader()->setDefaultSectionSize(std::max(height, scaledPixels(28)));
  resizeColumnsToContents();
  int rest = viewport()->width();
  for (int column = 0; column < HitsModel::columns; ++column)
    rest -= isColumnHidden(column) ? 0 : columnWidth(column);
  if (rest > 0) setColumnWidth(HitsModel::teeth, columnWidth(HitsModel::teeth) + rest);
}

void HitsTable::resizeEvent(QResizeEvent* event) {
  QTableView::resizeEvent(event);
  if (m_order.rowCount() > 0) fitRows();
}

void HitsTable::copyRow() {
  QStringList cells;
  for (int column = 0; column < HitsModel::columns; ++column)
    if (!isColumnHidden(column)) cells << currentIndex().siblingAtColumn(column).data().toString();
  QApplication::clipboard()->setText(cells.join('\t'));
}

void HitsTable::keyPressEvent(QKeyEvent* event) {
  if (event->matches(QKeySequence::Copy) && currentIndex().isValid()) return copyRow();
  if ((event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) && currentIndex().isValid()) {
    emit openWanted();
    return;
  }
  QTableView::keyPressEvent(event);
}

}  // namespace geargraph::inline designer

#include "moc_hits_table.cpp"
