#include "ui/designer/hits_table.h"

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QKeyEvent>
#include <QPainter>
#include <QScrollBar>
#include <algorithm>

#include "ui/theme/theme_colors.h"

namespace geargraph {

HitsTable::HitsTable(QWidget* parent) : QTableView(parent), m_shown(&m_hits) {
  setObjectName(QStringLiteral("hits"));
  setAccessibleName(tr("Gearboxes that were found"));
  setModel(&m_shown);
  setItemDelegate(new HitDelegate(&m_pictures, this));
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
  connect(&m_shown, &QAbstractItemModel::modelReset, this, &HitsTable::chosenChanged);
  connect(this, &QAbstractItemView::doubleClicked, this, &HitsTable::openWanted);
  connect(&m_pictures, &HitPictures::drawn, this, [this] {
    m_hits.repaintPictures();
    if (!m_pictures.isDrawing()) emit picturesDrawn();
  });
}

void HitsTable::startAnew(const GearboxWishPtr& wish) {
  m_pictures.startAnew(wish);
  m_hits.startAnew(wish);
  m_shown.startAnew();
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
  return current.isValid() ? m_shown.at(current) : nullptr;
}

void HitsTable::choose(const GearboxPtr& gearbox) {
  const int row = m_hits.rowOf(gearbox);
  if (row < 0) return;
  const QModelIndex index = m_shown.mapFromSource(m_hits.index(row, HitsModel::number));
  if (index.isValid()) setCurrentIndex(index);
}

/// Rows of one wish have nearly the same height: that of the most elements.
void HitsTable::fitRows() {
  int height = 0;
  for (int row = 0; row < std::min(m_shown.rowCount(), 50); ++row)
    height = std::max(height, sizeHintForIndex(m_shown.index(row, HitsModel::elements)).height());
  verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  verticalHeader()->setDefaultSectionSize(std::max(height, scaledPixels(84)));
  giveColumns();
}

/// Every column with what its cells need; in a narrow table the pictures of sections go first, then speeds
/// and torques, which the card has too.
void HitsTable::giveColumns() {
  const GearboxWishPtr& wish = m_hits.wish();
  setColumnHidden(HitsModel::efficiency, !wish || !wish->efficiency);
  constexpr std::array kGoFirst = {HitsModel::schematic, HitsModel::drawable, HitsModel::torque,
                                   HitsModel::speed};
  for (const int column : kGoFirst) setColumnHidden(column, false);
  resizeColumnsToContents();
  const auto missing = [this] {
    int width = 0;
    for (int column = 0; column < HitsModel::columns; ++column)
      width += isColumnHidden(column) ? 0 : columnWidth(column);
    return width - viewport()->width();
  };
  for (const int column : kGoFirst)
    if (missing() > 0) setColumnHidden(column, true);
  const int rest = -missing();
  if (rest > 0) setColumnWidth(HitsModel::elements, columnWidth(HitsModel::elements) + rest);
}

void HitsTable::resizeEvent(QResizeEvent* event) {
  QTableView::resizeEvent(event);
  if (m_shown.rowCount() > 0) fitRows();
}

/// The teeth of a gearbox run below its measures, over all their columns.
void HitsTable::paintEvent(QPaintEvent* event) {
  QTableView::paintEvent(event);
  QPainter painter(viewport());
  const Theme theme = themeOf(palette());
  QFont small = font();
  small.setPixelSize(smallPixels());
  painter.setFont(small);
  const int left = columnViewportPosition(HitsModel::error);
  int right = left;
  for (int column = HitsModel::error; column < HitsModel::drawable; ++column)
    right += isColumnHidden(column) ? 0 : columnWidth(column);
  constexpr int kMargin = 8;
  const int line = scaledPixels(22);
  const int first = std::max(rowAt(0), 0);
  for (int row = first; row < m_shown.rowCount(); ++row) {
    const int top = rowViewportPosition(row);
    if (top > viewport()->height()) break;
    const QRect room(left, top + rowHeight(row) - line, right - left - kMargin, line);
    const QString teeth = teethOf(*m_shown.at(m_shown.index(row, 0)));
    painter.setPen(qColor(ColorRole::secondary, theme));
    painter.drawText(room, Qt::AlignRight | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(teeth, Qt::ElideRight, room.width()));
    painter.setPen(qColor(ColorRole::hairline, theme));
    painter.drawLine(0, top + rowHeight(row) - 1, viewport()->width(), top + rowHeight(row) - 1);
  }
}

void HitsTable::copyRow() {
  QStringList cells;
  for (int column = 0; column < HitsModel::columns; ++column)
    if (!isColumnHidden(column)) cells << currentIndex().siblingAtColumn(column).data().toString();
  cells << teethOf(*chosen());
  QApplication::clipboard()->setText(cells.join('\t'));
}

void HitsTable::toggleTick(const QModelIndex& index) {
  const GearboxPtr hit = m_shown.at(index);
  m_hits.setTicked(hit, !m_hits.isTicked(hit));
}

/// The next row is chosen then.
void HitsTable::hideChosen() {
  const int row = currentIndex().row();
  m_shown.hideHit(chosen());
  if (m_shown.rowCount() > 0) selectRow(std::min(row, m_shown.rowCount() - 1));
}

void HitsTable::mousePressEvent(QMouseEvent* event) {
  const QModelIndex index = indexAt(event->pos());
  if (event->button() == Qt::LeftButton && index.isValid() && index.column() == HitsModel::number &&
      HitDelegate::tickBox(visualRect(index)).contains(event->pos()))
    return toggleTick(index);
  QTableView::mousePressEvent(event);
}

/// While something is hidden, Ctrl+Z brings it back, and not a document that the user does not see.
bool HitsTable::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const auto& key = static_cast<const QKeyEvent&>(*event);
    const bool isUndo = key.matches(QKeySequence::Undo) && m_shown.hiddenCount() > 0;
    const bool isLetter = key.key() == Qt::Key_H && key.modifiers() == Qt::NoModifier;
    if (isUndo || isLetter || key.matches(QKeySequence::Find)) {
      event->accept();
      return true;
    }
  }
  return QTableView::event(event);
}

void HitsTable::keyPressEvent(QKeyEvent* event) {
  if (event->matches(QKeySequence::Find)) return emit filterWanted();
  if (event->matches(QKeySequence::Undo) && m_shown.showLastHidden()) return;
  if (!currentIndex().isValid()) return QTableView::keyPressEvent(event);
  if (event->matches(QKeySequence::Copy)) return copyRow();
  switch (event->key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
      return emit openWanted();
    case Qt::Key_Space:
      return toggleTick(currentIndex());
    case Qt::Key_H:
    case Qt::Key_Delete:
      return hideChosen();
    default:
      QTableView::keyPressEvent(event);
  }
}

}  // namespace geargraph

#include "moc_hits_table.cpp"
