#include "ui/forces/force_table_model.h"

#include <QFont>

#include "ui/models/term_tips.h"

namespace geargraph::inline forces {

void ForceTableModel::show(const ForcesPtr& forces, ForceTableKind kind) {
  const ForceTable* const before = table();
  const int rows = rowCount();
  const int columns = columnCount();
  const ForcesPtr kept = m_forces;  // `before` is part of it
  const ForceTable* const now = forces ? forces->table(kind) : nullptr;
  const bool isSameShape = before != nullptr && now != nullptr && m_kind == kind &&
                           static_cast<int>(now->rows.size()) == rows &&
                           static_cast<int>(now->columns.size()) == columns;
  if (!isSameShape) beginResetModel();
  m_forces = forces;
  m_kind = kind;
  if (!isSameShape) return endResetModel();
  // The selection and the scroll position stay while numbers change.
  if (rows > 0 && columns > 0) emit dataChanged(index(0, 0), index(rows - 1, columns - 1));
}

std::set<ElementId> ForceTableModel::elementsAt(int row) const {
  const ForceTable* const shown = table();
  if (shown == nullptr || row < 0 || row >= rowCount()) return {};
  const std::vector<ElementId>& elements = shown->rows[static_cast<std::size_t>(row)].elements;
  return {elements.begin(), elements.end()};
}

int ForceTableModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() || table() == nullptr ? 0 : static_cast<int>(table()->rows.size());
}

int ForceTableModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() || table() == nullptr ? 0 : static_cast<int>(table()->columns.size());
}

QVariant ForceTableModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || table() == nullptr) return {};
  const ForceColumn& column = table()->columns[static_cast<std::size_t>(index.column())];
  const ForceCell& cell =
      table()->rows[static_cast<std::size_t>(index.row())].cells[static_cast<std::size_t>(index.column())];
  switch (role) {
    case Qt::DisplayRole:
      return shownText(cell.text);
    case Qt::ToolTipRole:
      return shownText(column.meaning);
    case Qt::TextAlignmentRole:
      return QVariant::fromValue(Qt::AlignVCenter | (column.isNumber ? Qt::AlignRight : Qt::AlignLeft));
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

QVariant ForceTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || table() == nullptr || section < 0 || section >= columnCount())
    return {};
  const ForceColumn& column = table()->columns[static_cast<std::size_t>(section)];
  if (role == Qt::DisplayRole) {
    const QString head = shownText(column.head);
    return column.unit.empty() ? head : head + QStringLiteral(", ") + shownText(column.unit);
  }
  if (role == Qt::ToolTipRole) return shownText(column.meaning);
  if (role == Qt::TextAlignmentRole)
    return QVariant::fromValue(Qt::AlignVCenter | (column.isNumber ? Qt::AlignRight : Qt::AlignLeft));
  return {};
}

}  // namespace geargraph::inline forces
