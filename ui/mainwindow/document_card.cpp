#include "ui/mainwindow/document_card.h"

#include <QApplication>
#include <QPainter>
#include <QPixmapCache>
#include <QTextLayout>

#include "ui/mainwindow/thumbnails.h"
#include "ui/theme/application_theme.h"

namespace geargraph {
namespace {

constexpr int kGap = 8;       ///< between a card and the next
constexpr int kPadding = 10;  ///< between a card's edge and what is in it
constexpr int kCorner = 6;
constexpr QSize kRowPicture{88, 55};
constexpr int kNoteLines = 2;

/// Lines of a text that has so much room, the last one with an ellipsis where more would follow.
void drawLines(QPainter& painter, const QRect& room, const QString& text, int most) {
  QTextLayout layout(text, painter.font());
  layout.beginLayout();
  int y = room.top();
  const QFontMetrics metrics(painter.font());
  for (int i = 0; i < most; ++i) {
    QTextLine line = layout.createLine();
    if (!line.isValid()) break;
    line.setLineWidth(room.width());
    QString shown = text.mid(line.textStart(), line.textLength());
    if (i + 1 == most) {
      shown = metrics.elidedText(text.mid(line.textStart()), Qt::ElideRight, room.width());
    }
    painter.drawText(QRect(room.left(), y, room.width(), metrics.height()), Qt::AlignLeft | Qt::AlignVCenter,
                     shown.trimmed());
    y += metrics.height();
  }
  layout.endLayout();
}

/// Kept, as scaling takes some ms: a page of cards is painted whenever its window is.
QPixmap scaledPicture(const QImage& image, QSize size) {
  const QString key =
      QStringLiteral("card %1 %2x%3").arg(image.cacheKey()).arg(size.width()).arg(size.height());
  QPixmap picture;
  if (QPixmapCache::find(key, &picture)) return picture;
  picture = QPixmap::fromImage(image.scaled(size, Qt::KeepAspectRatio, Qt::SmoothTransformation));
  QPixmapCache::insert(key, picture);
  return picture;
}

QFont smallFont(const QFont& font) {
  QFont small = font;
  small.setPixelSize(smallPixels());
  return small;
}

}  // namespace

QSize DocumentCard::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
  Q_UNUSED(index)
  if (m_form == Form::row) return {200, kRowPicture.height() + 2 * kPadding};
  const int name = QFontMetrics(option.font).height();
  const int note = kNoteLines * QFontMetrics(smallFont(option.font)).height();
  return {Thumbnails::kSize.width() + 2 * kPadding + kGap,
          Thumbnails::kSize.height() + name + note + 2 * kPadding + 8 + kGap};
}

void DocumentCard::paint(QPainter* painter, const QStyleOptionViewItem& option,
                         const QModelIndex& index) const {
  const Theme theme = themeOf(QApplication::palette());
  const bool upright = m_form == Form::upright;
  const bool hovered = (option.state & QStyle::State_MouseOver) != 0;
  const bool focused = (option.state & QStyle::State_HasFocus) != 0;
  const QRect card = upright ? option.rect.adjusted(0, 0, -kGap, -kGap) : option.rect.adjusted(0, 1, 0, -1);
  painter->save();
  painter->setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
  if (upright || hovered || focused) {
    painter->setPen(qColor(hovered || focused ? ColorRole::accent : ColorRole::hairline, theme));
    painter->setBrush(qColor(ColorRole::sheet, theme));
    painter->drawRoundedRect(QRectF(card).adjusted(0.5, 0.5, -0.5, -0.5), kCorner, kCorner);
  }

  const QRect inside = card.adjusted(kPadding, kPadding, -kPadding, -kPadding);
  const QSize size = upright ? Thumbnails::kSize : kRowPicture;
  const QRect picture(inside.topLeft(), size);
  const auto image = index.data(kPictureRole).value<QImage>();
  if (!image.isNull()) {
    const QSize pixels = size * painter->device()->devicePixelRatioF();
    painter->drawPixmap(picture, scaledPicture(image, pixels));
  }

  QRect words = upright ? inside.adjusted(0, size.height() + 8, 0, 0)
                        : inside.adjusted(size.width() + kPadding, 0, 0, 0);
  const QString note = index.data(kNoteRole).toString();
  QFont bold = option.font;
  bold.setWeight(QFont::DemiBold);
  const int nameHeight = QFontMetrics(bold).height();
  if (!upright) words.setTop(inside.center().y() - nameHeight);
  painter->setPen(qColor(ColorRole::ink, theme));
  painter->setFont(bold);
  drawLines(*painter, words, index.data().toString(), 1);
  painter->setPen(qColor(ColorRole::secondary, theme));
  painter->setFont(smallFont(option.font));
  drawLines(*painter, words.adjusted(0, nameHeight, 0, 0), note, upright ? kNoteLines : 1);
  painter->restore();
}

}  // namespace geargraph

#include "moc_document_card.cpp"
