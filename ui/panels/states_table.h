#pragma once

#include <QHash>
#include <QHeaderView>
#include <QStyledItemDelegate>
#include <QTableView>

#include "ui/models/states_model.h"

namespace geargraph {

/// Paints the cells of the shift table: dots of engaged couplings, names, ratios.
class StatesDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

/// The column headings: a coupling's name above its constraint; names are edited in place.
class StatesHeader : public QHeaderView {
  Q_OBJECT

 public:
  explicit StatesHeader(QWidget* parent);
  void rename(int section);
  /// As high as the type needs.
  void fitHeight();

 signals:
  void renamed(int section, const QString& name);

 protected:
  void paintSection(QPainter* painter, const QRect& rect, int section) const override;
};

/// The shift table of a StatesModel, with columns fitted to their contents. Where there is no room for all of
/// them it scrolls beneath the names of the states.
class StatesTable : public QTableView {
  Q_OBJECT

 public:
  explicit StatesTable(StatesModel* model, QWidget* parent = nullptr);
  [[nodiscard]] StatesHeader& heads() { return *m_heads; }
  void fitColumns();
  /// The row of the state that is looked at in another view is marked; -1: none.
  void setLookedAt(int row);
  [[nodiscard]] int lookedAt() const { return m_lookedAt; }

 signals:
  void left();  ///< the mouse has left the table

 protected:
  void leaveEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  /// The font of a text: the table's, its bold or its small variant.
  enum class Face { plain, bold, small };

  void fitHeights();
  [[nodiscard]] int widthOf(int column) const;
  [[nodiscard]] std::vector<int> widthsNow() const;
  /// The width of a text in a face, in pixels; cached.
  [[nodiscard]] int advance(Face face, const QString& text) const;

  StatesModel* m_model;
  StatesHeader* m_heads;
  StatesHeader* m_firstHead;  ///< of the column that stays
  QTableView* m_first;
  int m_lookedAt = -1;
  mutable QHash<QPair<int, QString>, int> m_advances;
  mutable QFont m_measured;  ///< the font of m_advances
};

}  // namespace geargraph
