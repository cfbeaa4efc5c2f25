#pragma once

#include <QHeaderView>
#include <QStyledItemDelegate>

#include "ui/selection/selection.h"

namespace geargraph {

/// Paints the cells of the results: rates, formulas in the gear ratios, numbers.
class ResultsDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  ResultsDelegate(Selection* selection, QObject* parent);

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  /// The pixels that the cell wants.
  [[nodiscard]] int widthOf(const QModelIndex& index, const QFont& font) const;

 private:
  Selection* m_selection;
};

/// The heads of the columns: the rates of the inputs.
class ResultsHeader : public QHeaderView {
  Q_OBJECT

 public:
  explicit ResultsHeader(QWidget* parent);

 protected:
  void paintSection(QPainter* painter, const QRect& rect, int section) const override;
};

/// A disc in the colour that the link has in every view.
void paintLinkDot(QPainter& painter, const QPointF& centre, int linkLabel);

}  // namespace geargraph
