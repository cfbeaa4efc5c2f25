#include "ui/forces/linked_table.h"

#include <QEvent>
#include <QHeaderView>
#include <algorithm>

#include "ui/theme/frozen_column.h"
#include "ui/theme/theme_colors.h"

namespace geargraph {
namespace {

constexpr int kRowsMeasured = 40;  ///< for the widths of columns
constexpr int kRowHeight = 22;
constexpr int kGap = 8;  ///< between columns, beside what a cell has itself

}  // namespace

LinkedTable::LinkedTable(ValueTableModel* model, Selection* selection, QWidget* parent)
    : QTableView(parent), m_values(model), m_selection(selection) {
  setModel(model);
  setTabKeyNavigation(false);
  setSelectionBehavior(QAbstractItemView::SelectRows);
  setSelectionMode(QAbstractItemView::SingleSelection);
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  setShowGrid(false);
  setMouseTracking(true);
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  setWordWrap(false);
  verticalHeader()->hide();
  fitRows();
  horizontalHeader()->setHighlightSections(false);
  horizontalHeader()->setResizeContentsPrecision(kRowsMeasured);
  connect(selection, &Selection::selectionChanged, this, &LinkedTable::selectRowOfSelection);
  connect(this, &QTableView::clicked, this,
          [this](const QModelIndex& at) { m_selection->select(m_values->elementsAt(at.row())); });
  connect(this, &QTableView::entered, this,
          [this](const QModelIndex& at) { m_selection->hover(m_values->elementsAt(at.row())); });
  auto* first = new FrozenColumn(this);
  connect(first, &FrozenColumn::left, selection, &Selection::unhover);
}

void LinkedTable::fitRows() {
  verticalHeader()->setMinimumSectionSize(scaledPixels(kRowHeight));  // else Qt asks the style, for every row
  verticalHeader()->setDefaultSectionSize(scaledPixels(kRowHeight));
}

void LinkedTable::fitColumns(const std::function<bool(int column)>& isShown) {
  const int columns = m_values->columnCount();
  for (int column = 0; column < columns; ++column) {
    if (isColumnHidden(column) == isShown(column)) setColumnHidden(column, !isShown(column));
    if (!isShown(column)) continue;
    const int wanted =
        std::max(sizeHintForColumn(column), horizontalHeader()->sectionSizeHint(column)) + scaledPixels(kGap);
    if (columnWidth(column) != wanted) setColumnWidth(column, wanted);
  }
}

/// Larger type needs higher rows and wider columns.
void LinkedTable::changeEvent(QEvent* event) {
  QTableView::changeEvent(event);
  if (event->type() != QEvent::FontChange) return;
  fitRows();
  fitColumns([this](int column) { return !isColumnHidden(column); });
}

void LinkedTable::selectRowOfSelection() {
  const auto current = selectionModel()->selectedRows();
  if (!current.isEmpty() && m_values->elementsAt(current.front().row()) == m_selection->selected()) return;
  const int row = m_values->rowOf(m_selection->selected());
  row < 0 ? clearSelection() : selectRow(row);
}

bool LinkedTable::viewportEvent(QEvent* event) {
  if (event->type() == QEvent::Leave) m_selection->unhover();
  return QTableView::viewportEvent(event);
}

}  // namespace geargraph

#include "moc_linked_table.cpp"
