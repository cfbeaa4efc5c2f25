#pragma once

#include <QAbstractListModel>

class QUndoStack;

namespace geargraph {

/// The steps of a history, the oldest first: row 0 is the document before the first, row i that after i
/// steps.
class HistoryModel : public QAbstractListModel {
  Q_OBJECT

 public:
  enum Role { DoneRole = Qt::UserRole };  ///< is the step done, not undone?

  explicit HistoryModel(const QUndoStack* stack, QObject* parent = nullptr);

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;

 private:
  void renew();
  [[nodiscard]] QString textOf(int row) const;

  const QUndoStack* m_stack;
  int m_rows;
};

}  // namespace geargraph
