#include "ui/document/history_model.h"

#include <QFont>
#include <QUndoStack>

namespace geargraph {

HistoryModel::HistoryModel(const QUndoStack* stack, QObject* parent)
    : QAbstractListModel(parent), m_stack(stack), m_rows(stack->count() + 1) {
  connect(stack, &QUndoStack::indexChanged, this, &HistoryModel::renew);
  connect(stack, &QUndoStack::cleanChanged, this, &HistoryModel::renew);
}

void HistoryModel::renew() {
  const int rows = m_stack->count() + 1;
  if (rows > m_rows) {
    beginInsertRows({}, m_rows, rows - 1);
    m_rows = rows;
    endInsertRows();
  } else if (rows < m_rows) {
    beginRemoveRows({}, rows, m_rows - 1);
    m_rows = rows;
    endRemoveRows();
  }
  emit dataChanged(index(0), index(m_rows - 1));
}

int HistoryModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : m_rows;
}

QString HistoryModel::textOf(int row) const {
  const QString text = row == 0 ? tr("Before the first step") : m_stack->text(row - 1);
  return row == m_stack->cleanIndex() ? tr("%1 (saved)").arg(text) : text;
}

QVariant HistoryModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || !checkIndex(index)) return {};
  const int row = index.row();
  const bool isNow = row == m_stack->index();
  switch (role) {
    case Qt::DisplayRole:
      return textOf(row);
    case Qt::AccessibleTextRole:
      return isNow                    ? tr("%1, shown now").arg(textOf(row))
             : row > m_stack->index() ? tr("%1, undone").arg(textOf(row))
                                      : textOf(row);
    case DoneRole:
      return row <= m_stack->index();
    case Qt::FontRole: {
      QFont font;
      font.setBold(isNow);
      font.setItalic(row > m_stack->index());
      return font;
    }
    default:
      return {};
  }
}

}  // namespace geargraph

#include "moc_history_model.cpp"
