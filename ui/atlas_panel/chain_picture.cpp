#include "ui/atlas_panel/chain_picture.h"

#include <QPainter>

#include "ui/canvas/mark_painter.h"
#include "ui/theme/theme_colors.h"

namespace geargraph {
namespace {

constexpr double kLargestPictureScale = 1.1;
constexpr double kPictureMargin = 4;  ///< px

}  // namespace

void paintChain(QPainter& painter, const DisplayList& drawing, const QRectF& area, Theme theme) {
  if (drawing.marks.empty()) return;
  painter.save();
  painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
  const QRectF room = area.adjusted(kPictureMargin, kPictureMargin, -kPictureMargin, -kPictureMargin);
  paintFitted(painter, drawing, room, theme, kLargestPictureScale);
  painter.restore();
}

ChainPicture::ChainPicture(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("chainPicture"));
  setMinimumHeight(120);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Expanding);
}

void ChainPicture::setDrawing(DisplayList drawing, const QString& description) {
  m_drawing = std::move(drawing);
  m_image = {};
  setAccessibleName(description);
  update();
}

void ChainPicture::setImage(QImage image, const QString& description) {
  m_drawing = {};
  m_image = std::move(image);
  setAccessibleName(description);
  update();
}

void ChainPicture::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  if (!m_image.isNull()) {
    const QSize size = m_image.size().scaled(this->size(), Qt::KeepAspectRatio);
    const QPoint corner((width() - size.width()) / 2, (height() - size.height()) / 2);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(QRect(corner, size), m_image);
    return;
  }
  paintChain(painter, m_drawing, rect(), themeOf(palette()));
}

}  // namespace geargraph

#include "moc_chain_picture.cpp"
