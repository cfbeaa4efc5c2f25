#include "ui/forces/value_table_model.h"

#include <QFont>
#include <algorithm>

#include "ui/models/printed_number.h"
#include "ui/models/term_tips.h"

namespace geargraph {
namespace {

QVariant alignmentOf(const ForceColumn& column) {
  return QVariant::fromValue(Qt::AlignVCenter | (column.isNumber ? Qt::AlignRight : Qt::AlignLeft));
}

}  // namespace

void ValueTableModel::showTable(std::shared_ptr<const ValueTable> table, bool isOther) {
  const bool isSameShape = !isOther && m_table && table && table->rows.size() == m_table->rows.size() &&
                           table->columns.size() == m_table->columns.size();
  if (!isSameShape) beginResetModel();
  m_table = std::move(table);
  if (!isSameShape) return endResetModel();
  const int rows = rowCount();
  const int columns = columnCount();
  if (rows > 0 && columns > 0) emit dataChanged(index(0, 0), index(rows - 1, columns - 1));
}

std::set<ElementId> ValueTableModel::elementsAt(int row) const {
  if (row < 0 || row >= rowCount()) return {};
  const std::vector<ElementId>& elements = m_table->rows[static_cast<std::size_t>(row)].elements;
  return {elements.begin(), elements.end()};
}

int ValueTableModel::rowOf(const std::set<ElementId>& elements) const {
  if (!m_table) return -1;
  const auto row = std::find_if(m_table->rows.begin(), m_table->rows.end(), [&](const ForceRow& each) {
    return !each.elements.empty() && elements.contains(each.elements.front());
  });
  return row == m_table->rows.end() ? -1 : static_cast<int>(row - m_table->rows.begin());
}

int ValueTableModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() || !m_table ? 0 : static_cast<int>(m_table->rows.size());
}

int ValueTableModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() || !m_table ? 0 : static_cast<int>(m_table->columns.size());
}

QVariant ValueTableModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || !m_table) return {};
  const ForceColumn& column = m_table->columns[static_cast<std::size_t>(index.column())];
  const ForceCell& cell =
      m_table->rows[static_cast<std::size_t>(index.row())].cells[static_cast<std::size_t>(index.column())];
  switch (role) {
    case Qt::DisplayRole:
      return column.isNumber ? withPrintedMinus(shownText(cell.text)) : shownText(cell.text);
    case Qt::AccessibleTextRole:  // screen readers say nothing of an empty cell
      return cell.text.empty() ? QVariant(tr("none")) : QVariant();
    case Qt::ToolTipRole:
      return shownText(column.meaning);
    case Qt::TextAlignmentRole:
      return alignmentOf(column);
    case Qt::FontRole: {
      if (!column.isFraction) return {};
      QFont bold;
      bold.setBold(true);
      return bold;
    }
    default:
      return {};
  }
}

QVariant ValueTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || !m_table || section < 0 || section >= columnCount()) return {};
  const ForceColumn& column = m_table->columns[static_cast<std::size_t>(section)];
  if (role == Qt::DisplayRole) {
    const QString head = shownText(column.head);
    return column.unit.empty() ? head : head + QStringLiteral(", ") + shownText(column.unit);
  }
  if (role == Qt::ToolTipRole) return shownText(column.meaning);
  if (role == Qt::TextAlignmentRole) return alignmentOf(column);
  return {};
}

}  // namespace geargraph

#include "moc_value_table_model.cpp"
