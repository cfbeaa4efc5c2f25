#include "ui/panels/results_delegate.h"

#include <QFontMetricsF>
#include <QMouseEvent>
#include <QPainter>
#include <QtMath>

#include "ui/models/link_speeds_model.h"
#include "ui/models/results_model.h"
#include "ui/panels/rate_label.h"
#include "ui/panels/ratio_text.h"
#include "ui/theme/application_theme.h"

namespace geargraph {
namespace {

constexpr int kMargin = 16;   // at the left and right edge of the table
constexpr int kDotRoom = 22;  // of the link's disc
constexpr int kGap = 18;      // between columns

double baseLine(const QRectF& rect, const QFont& font) {
  const QFontMetricsF metrics(font);
  return rect.center().y() + (metrics.ascent() - metrics.descent()) / 2;
}

}  // namespace

void paintLinkDot(QPainter& painter, const QPointF& centre, int colorNumber) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(qColor(linkColor(colorNumber)));
  painter.drawEllipse(centre, 5, 5);
  painter.restore();
}

QPixmap linkDot(int colorNumber, qreal pixelRatio) {
  constexpr int kSize = 12;
  QPixmap pixmap(qRound(kSize * pixelRatio), qRound(kSize * pixelRatio));
  pixmap.setDevicePixelRatio(pixelRatio);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  paintLinkDot(painter, {kSize / 2.0, kSize / 2.0}, colorNumber);
  return pixmap;
}

namespace {

/// The text of a row's first cell in this many px: the name of the link is shortened, then left out.
QString rowTextIn(double room, const QModelIndex& index, const QFontMetricsF& metrics) {
  QString text = index.data().toString();
  if (metrics.horizontalAdvance(text) <= room) return text;
  const auto* model = static_cast<const ResultsModel*>(index.model());
  const QString name = model->rowName(index.row());
  constexpr qsizetype kFewest = 3;  // letters of a name that tell anything
  for (qsizetype letters = name.size() - 1; letters >= kFewest; --letters) {
    text = model->rowText(index.row(), name.left(letters).trimmed() + QStringLiteral("…"));
    if (metrics.horizontalAdvance(text) <= room) return text;
  }
  return metrics.elidedText(model->rowText(index.row(), {}), Qt::ElideRight, room + 1);
}

}  // namespace

ResultsDelegate::ResultsDelegate(Selection* selection, QObject* parent)
    : QStyledItemDelegate(parent), m_selection(selection) {}

void ResultsDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                            const QModelIndex& index) const {
  painter->setLayoutDirection(Qt::LeftToRight);  // a minus sign stands before its number
  const auto* model = static_cast<const ResultsModel*>(index.model());
  const Theme theme = themeOf(option.palette);
  const ElementId joint = model->outputAt(index.row());
  painter->save();
  if (m_selection->hovered().contains(joint) || m_selection->isSelected(joint)) {
    QColor band = qColor(ColorRole::halo, theme);
    band.setAlphaF(0.35F);
    painter->fillRect(option.rect, band);
  }
  painter->setPen(qColor(ColorRole::ink, theme));
  const QRectF cell(option.rect);
  const double base = baseLine(cell, option.font);
  const QString text = index.data().toString();
  if (index.column() == 0) {
    paintLinkDot(*painter, {cell.left() + kMargin + 5, cell.center().y()},
                 index.data(ResultsModel::LinkColorRole).toInt());
    const double left = cell.left() + kMargin + kDotRoom;
    const QString label = index.data(ResultsModel::JointLabelRole).toString();
    const double advance = paintRate(painter, option.font, {left, base}, label);
    painter->setFont(option.font);
    const QFontMetricsF metrics(option.font);
    const double from = left + advance + metrics.horizontalAdvance(QLatin1Char(' '));
    painter->drawText(QPointF(from, base), rowTextIn(cell.right() - from - kGap / 2.0, index, metrics));
  } else if (index.column() == model->columnCount() - 1) {
    QFont bold = option.font;
    bold.setBold(true);
    painter->setFont(bold);
    painter->drawText(cell.adjusted(0, 0, -kMargin, 0), Qt::AlignRight | Qt::AlignVCenter, text);
  } else if (index.data(ResultsModel::ZeroRole).toBool()) {
    painter->setPen(qColor(ColorRole::secondary, theme));
    painter->drawText(cell, Qt::AlignCenter, QStringLiteral("·"));
  } else if (index.data(ResultsModel::SymbolRole).toBool()) {
    const double advance = paintRatios(nullptr, option.font, {}, text);
    const double left = qMax(cell.left() + 2, cell.center().x() - advance / 2);
    painter->setClipRect(option.rect);
    paintRatios(painter, option.font, {left, base}, text);
  } else {
    painter->drawText(cell, Qt::AlignCenter, text);
  }
  painter->restore();
}

int ResultsDelegate::widthOf(const QModelIndex& index, const QFont& font) const {
  constexpr int kMaxKept = 4096;
  if (font != m_font || m_widths.size() > kMaxKept) m_widths.clear();
  m_font = font;
  const QString text = index.data().toString();
  const bool last = index.column() == index.model()->columnCount() - 1;
  // What is not the text itself that decides how it is painted.
  QString key = index.column() == 0 ? index.data(ResultsModel::JointLabelRole).toString()
                : last              ? QStringLiteral("bold")
                                    : index.data(ResultsModel::SymbolRole).toString();
  key += QLatin1Char('\n') + text;
  const auto known = m_widths.constFind(key);
  return known != m_widths.constEnd() ? *known : *m_widths.insert(key, measured(index, text));
}

int ResultsDelegate::leastWidthOf(const QModelIndex& index, const QFont& font) {
  const auto* model = static_cast<const ResultsModel*>(index.model());
  const QString label = index.data(ResultsModel::JointLabelRole).toString();
  return kMargin + kDotRoom + kGap +
         qCeil(paintRate(nullptr, font, {}, label) +
               QFontMetricsF(font).horizontalAdvance(QLatin1Char(' ') + model->rowText(index.row(), {})));
}

int ResultsDelegate::measured(const QModelIndex& index, const QString& text) const {
  const QFontMetricsF metrics(m_font);
  if (index.column() == 0) {
    const QString label = index.data(ResultsModel::JointLabelRole).toString();
    return kMargin + kDotRoom + kGap +
           qCeil(paintRate(nullptr, m_font, {}, label) + metrics.horizontalAdvance(QLatin1Char(' ') + text));
  }
  if (index.column() == index.model()->columnCount() - 1) {
    QFont bold = m_font;
    bold.setBold(true);
    return kGap + kMargin + qCeil(QFontMetricsF(bold).horizontalAdvance(text));
  }
  if (index.data(ResultsModel::SymbolRole).toBool()) {
    return kGap + qCeil(paintRatios(nullptr, m_font, {}, text));
  }
  return kGap + qCeil(metrics.horizontalAdvance(text));
}

LinkSpeedsDelegate::LinkSpeedsDelegate(Selection* selection, QObject* parent)
    : QStyledItemDelegate(parent), m_selection(selection) {}

void LinkSpeedsDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                               const QModelIndex& index) const {
  painter->setLayoutDirection(Qt::LeftToRight);  // a minus sign stands before its number
  const auto* model = static_cast<const LinkSpeedsModel*>(index.model());
  const Theme theme = themeOf(option.palette);
  const ElementId link = model->linkAt(index.row());
  const QRectF cell(option.rect);
  painter->save();
  if (m_selection->isHovered(link) || m_selection->isSelected(link)) {
    QColor band = qColor(ColorRole::halo, theme);
    band.setAlphaF(0.35F);
    painter->fillRect(option.rect, band);
  }
  QFont font = option.font;
  font.setBold(index.column() == LinkSpeedsModel::aboutColumn);
  painter->setFont(font);
  painter->setPen(
      qColor(index.column() > LinkSpeedsModel::aboutColumn ? ColorRole::secondary : ColorRole::ink, theme));
  const int left = index.column() == LinkSpeedsModel::linkColumn ? kMargin + kDotRoom : kGap / 2;
  if (index.column() == LinkSpeedsModel::linkColumn) {
    paintLinkDot(*painter, {cell.left() + kMargin + 5, cell.center().y()},
                 index.data(LinkSpeedsModel::LinkColorRole).toInt());
  }
  painter->drawText(cell.adjusted(left, 0, -kGap / 2, 0), index.data(Qt::TextAlignmentRole).toInt(),
                    index.data().toString());
  painter->restore();
}

QSize LinkSpeedsDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
  QFont bold = option.font;
  bold.setBold(true);
  const int room = index.column() == LinkSpeedsModel::linkColumn ? kMargin + kDotRoom + kGap : kGap;
  return {room + QFontMetrics(bold).horizontalAdvance(index.data().toString()), scaledPixels(23)};
}

ResultsHeader::ResultsHeader(QWidget* parent) : QHeaderView(Qt::Horizontal, parent) {
  setSectionResizeMode(QHeaderView::Fixed);
  setHighlightSections(false);
  setMinimumHeight(24);
  setMouseTracking(true);
}

void ResultsHeader::mouseMoveEvent(QMouseEvent* event) {
  QHeaderView::mouseMoveEvent(event);
  emit sectionHovered(logicalIndexAt(event->pos()));
}

void ResultsHeader::leaveEvent(QEvent* event) {
  QHeaderView::leaveEvent(event);
  emit sectionHovered(-1);
}

void ResultsHeader::paintSection(QPainter* painter, const QRect& rect, int section) const {
  const Theme theme = themeOf(palette());
  painter->save();
  painter->setPen(qColor(ColorRole::secondary, theme));
  const QString text = model()->headerData(section, Qt::Horizontal).toString();
  const int last = model()->columnCount() - 1;
  if (section == 0) {
    painter->drawText(rect.adjusted(kMargin + kDotRoom, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter, text);
  } else if (section == last) {
    painter->drawText(rect.adjusted(0, 0, -kMargin, 0), Qt::AlignRight | Qt::AlignVCenter, text);
  } else {
    const double advance = paintRate(nullptr, font(), {}, text);
    painter->setPen(qColor(ColorRole::ink, theme));
    const QRectF cell(rect);
    paintRate(painter, font(), {cell.center().x() - advance / 2, baseLine(cell, font())}, text);
  }
  painter->restore();
}

}  // namespace geargraph

#include "moc_results_delegate.cpp"
