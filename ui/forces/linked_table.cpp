#include "ui/forces/linked_table.h"

#include <QEvent>
#include <QHeaderView>

#include "ui/theme/theme_colors.h"

namespace geargraph {
namespace {

constexpr int kRowsMeasured = 40;  ///< for the widths of columns

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
  verticalHeader()->setMinimumSectionSize(scaledPixels(22));  // else Qt asks the style, for every row
  verticalHeader()->setDefaultSectionSize(scaledPixels(22));
  horizontalHeader()->setHighlightSections(false);
  horizontalHeader()->setResizeContentsPrecision(kRowsMeasured);
  connect(selection, &Selection::selectionChanged, this, &LinkedTable::selectRowOfSelection);
  connect(this, &QTableView::clicked, this,
          [this](const QModelIndex& at) { m_selection->select(m_values->elementsAt(at.row())); });
  connect(this, &QTableView::entered, this,
          [this](const QModelIndex& at) { m_selection->hover(m_values->elementsAt(at.row())); });
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
