#include "ui/teeth_panel/choices_table.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>
#include <QStyledItemDelegate>
#include <algorithm>

#include "ui/theme/theme_colors.h"

namespace geargraph {
namespace {

using Kind = ChoicesModel::Kind;

constexpr int kCellMargin = 6;
constexpr int kScaleWidth = 70;  // of errors
constexpr int kShareWidth = 52;  // of efficiencies
constexpr int kTickWidth = 18;
constexpr int kMarkWidth = 10;  // of undercut
constexpr int kSortRoom = 10;
constexpr int kRowsMeasured = 100;

/// A line with its ends and its middle, and a dot where the ratio is.
void paintScale(QPainter& painter, const QRectF& area, double place, bool isExact, Theme theme) {
  const double y = area.center().y();
  painter.setPen(QPen(qColor(ColorRole::control, theme), 1));
  painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
  for (const double x : {area.left(), area.center().x(), area.right()})
    painter.drawLine(QPointF(x, y - 4), QPointF(x, y + 4));
  painter.setPen(Qt::NoPen);
  painter.setBrush(qColor(isExact ? ColorRole::fine : ColorRole::ink, theme));
  painter.drawEllipse(QPointF(area.center().x() + place * area.width() / 2, y), 3.5, 3.5);
}

void paintTicks(QPainter& painter, const QRectF& cell, const QVariantList& ticks, Theme theme) {
  double x = cell.right() - kCellMargin - kTickWidth * static_cast<double>(ticks.size());
  const double y = cell.center().y();
  for (const QVariant& tick : ticks) {
    const double middle = x + kTickWidth / 2.;
    if (tick.toBool()) {
      painter.setPen(QPen(qColor(ColorRole::fine, theme), 2));
      painter.setBrush(Qt::NoBrush);
      painter.drawPolyline(QPolygonF{{middle - 4, y}, {middle - 1, y + 3}, {middle + 5, y - 4}});
    } else {
      painter.setPen(Qt::NoPen);
      painter.setBrush(qColor(ColorRole::secondary, theme));
      painter.drawEllipse(QPointF(middle, y), 1.2, 1.2);
    }
    x += kTickWidth;
  }
}

void paintShare(QPainter& painter, const QRectF& area, double share, Theme theme) {
  const QRectF bar(area.left(), area.center().y() - 3, area.width(), 6);
  painter.setPen(Qt::NoPen);
  painter.setBrush(qColor(ColorRole::hairline, theme));
  painter.drawRoundedRect(bar, 3, 3);
  painter.setBrush(qColor(ColorRole::fine, theme));
  QRectF filled = bar;
  filled.setWidth(bar.width() * std::clamp(share, 0., 1.));
  painter.drawRoundedRect(filled, 3, 3);
}

class ChoicesDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const Theme theme = themeOf(option.palette);
    painter->save();
    painter->setLayoutDirection(Qt::LeftToRight);  // a minus sign stands before its number
    painter->setRenderHint(QPainter::Antialiasing);
    const bool isChosen = (option.state & QStyle::State_Selected) != 0;
    if (isChosen) {
      QColor band = qColor(ColorRole::halo, theme);
      band.setAlphaF(0.6F);
      painter->fillRect(option.rect, band);
    }
    QRectF cell(option.rect);
    QRectF text = cell.adjusted(0, 0, -kCellMargin, 0);
    const bool isFine = index.data(ChoicesModel::FineRole).toBool();
    if (const QVariant place = index.data(ChoicesModel::PlaceRole); place.isValid()) {
      const QRectF scale(cell.right() - kCellMargin - kScaleWidth, cell.top(), kScaleWidth - 4,
                         cell.height());
      paintScale(*painter, scale, place.toDouble(), isFine, theme);
      text.setRight(scale.left() - kCellMargin);
    }
    if (const QVariant share = index.data(ChoicesModel::ShareRole); share.isValid())
      paintShare(*painter, {cell.left() + 4, cell.top(), kShareWidth - 4., cell.height()}, share.toDouble(),
                 theme);
    if (const QVariant ticks = index.data(ChoicesModel::TicksRole); ticks.isValid())
      paintTicks(*painter, cell, ticks.toList(), theme);
    QFont font = option.font;
    font.setBold(index.data(ChoicesModel::StrongRole).toBool() || isFine ||
                 (isChosen && index.column() == 0));
    if (index.data(ChoicesModel::UndercutRole).toBool()) {
      QFont small = font;
      small.setPixelSize(smallPixels() - 1);
      painter->setFont(small);
      painter->setPen(qColor(ColorRole::warning, theme));
      painter->drawText(QRectF(text.right() - kMarkWidth + 2, cell.top(), kMarkWidth, cell.height() / 2 + 4),
                        Qt::AlignRight | Qt::AlignBottom, QStringLiteral("u"));
    }
    if (isWheel(index)) text.setRight(text.right() - kMarkWidth);
    painter->setFont(font);
    painter->setPen(qColor(isFine                ? ColorRole::fine
                           : index.column() == 0 ? (isChosen ? ColorRole::accent : ColorRole::secondary)
                                                 : ColorRole::ink,
                           theme));
    painter->drawText(text, Qt::AlignRight | Qt::AlignVCenter, index.data().toString());
    painter->restore();
  }

 private:
  static bool isWheel(const QModelIndex& index) {
    return static_cast<const ChoicesModel*>(index.model())->columnAt(index.column()).kind == Kind::wheel;
  }
};

}  // namespace

ChoicesTable::ChoicesTable(ChoicesModel* model, QWidget* parent) : QTableView(parent), m_choices(model) {
  setModel(model);
  setItemDelegate(new ChoicesDelegate(this));
  setTabKeyNavigation(false);
  setSelectionBehavior(QAbstractItemView::SelectRows);
  setSelectionMode(QAbstractItemView::SingleSelection);
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  setShowGrid(false);
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  setWordWrap(false);
  verticalHeader()->hide();
  verticalHeader()->setMinimumSectionSize(scaledPixels(21));
  verticalHeader()->setDefaultSectionSize(scaledPixels(21));
  horizontalHeader()->setHighlightSections(false);
  horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  horizontalHeader()->setSortIndicator(0, Qt::AscendingOrder);
  setSortingEnabled(true);
  connect(model, &QAbstractItemModel::modelReset, this, [this] {
    horizontalHeader()->setSortIndicator(0, Qt::AscendingOrder);
    fitColumns();
  });
}

int ChoicesTable::widthOf(int column) const {
  const Kind kind = m_choices->columnAt(column).kind;
  QFont bold = font();
  bold.setBold(true);
  const QFontMetrics metrics(bold);
  int width =
      QFontMetrics(font()).horizontalAdvance(m_choices->headerData(column, Qt::Horizontal).toString()) +
      kSortRoom;
  int extra = 0;
  if (kind == Kind::error && m_choices->rowCount() > 0 &&
      m_choices->index(0, column).data(ChoicesModel::PlaceRole).isValid())
    extra = kScaleWidth + kCellMargin;
  if (kind == Kind::efficiency) extra = kShareWidth;
  if (kind == Kind::wheel) extra = kMarkWidth;
  for (int row = 0; row < std::min(m_choices->rowCount(), kRowsMeasured); ++row) {
    const QModelIndex at = m_choices->index(row, column);
    width = std::max(width, metrics.horizontalAdvance(at.data().toString()) + extra);
    width = std::max(width, kTickWidth * static_cast<int>(at.data(ChoicesModel::TicksRole).toList().size()));
  }
  return width + 2 * kCellMargin;
}

void ChoicesTable::fitColumns() {
  int total = 0;
  std::vector<int> widths;
  for (int column = 0; column < m_choices->columnCount(); ++column) {
    widths.push_back(widthOf(column));
    total += widths.back();
  }
  std::vector<bool> hides(widths.size());
  for (const Kind least : {Kind::backward, Kind::decimal, Kind::planets}) {
    for (std::size_t column = 0; column < widths.size() && total > viewport()->width(); ++column) {
      if (m_choices->columnAt(static_cast<int>(column)).kind != least) continue;
      hides[column] = true;
      total -= widths[column];
    }
  }
  for (std::size_t at = 0; at < widths.size(); ++at) {
    const int column = static_cast<int>(at);
    if (isColumnHidden(column) != hides[at]) setColumnHidden(column, hides[at]);
    if (!hides[at] && horizontalHeader()->sectionSize(column) != widths[at])
      horizontalHeader()->resizeSection(column, widths[at]);
  }
}

int ChoicesTable::chosenRow() const {
  const QModelIndexList rows = selectionModel()->selectedRows();
  return rows.isEmpty() ? -1 : rows.front().row();
}

void ChoicesTable::keyPressEvent(QKeyEvent* event) {
  if (event->matches(QKeySequence::Copy)) return emit copyWanted();
  const bool isReturn = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  const bool isArrow = event->key() == Qt::Key_Down || event->key() == Qt::Key_Up;
  if (isReturn && chosenRow() >= 0) return emit taken(chosenRow());
  if (event->key() == Qt::Key_Escape && chosenRow() >= 0) return emit putBack();
  if (isArrow && chosenRow() < 0 && m_choices->rowCount() > 0) return selectRow(0);
  QTableView::keyPressEvent(event);
}

void ChoicesTable::mouseDoubleClickEvent(QMouseEvent* event) {
  if (const QModelIndex at = indexAt(event->pos()); at.isValid()) emit taken(at.row());
}

void ChoicesTable::resizeEvent(QResizeEvent* event) {
  QTableView::resizeEvent(event);
  fitColumns();
}

}  // namespace geargraph

#include "moc_choices_table.cpp"
