#include "ui/reading/page_preview.h"

#include <QKeyEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>

#include "ui/theme/application_theme.h"

namespace geargraph {

PagePreview::PagePreview(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("pagePreview"));
  setFocusPolicy(Qt::StrongFocus);
  tell();
}

void PagePreview::setPages(const PrintedPagesPtr& pages, const QString& why) {
  m_pages = pages;
  m_why = why;
  m_page = std::clamp(m_page, 0, std::max(0, (pages ? pages->count() : 0) - 1));
  tell();
  emit pageChanged(m_page);
}

void PagePreview::setPage(int page) {
  if (!m_pages || page == m_page || page < 0 || page >= m_pages->count()) return;
  m_page = page;
  tell();
  emit pageChanged(page);
}

void PagePreview::tell() {
  const bool isThere = m_pages && m_pages->count() > 0;
  setAccessibleName(tr("Print preview"));
  setAccessibleDescription(
      isThere ? tr("Page %1 of %2: %3").arg(m_page + 1).arg(m_pages->count()).arg(m_pages->describe(m_page))
              : m_why);
  update();
}

void PagePreview::paintEvent(QPaintEvent*) {
  constexpr double kMargin = 14;
  QPainter painter(this);
  const Theme theme = themeOf(palette());
  painter.fillRect(rect(), qColor(ColorRole::panel, theme));
  if (hasFocus()) {
    painter.setPen(QPen(qColor(ColorRole::accent, theme), 2));
    painter.drawRect(rect().adjusted(1, 1, -1, -1));
  }
  if (!m_pages || m_pages->count() == 0) {
    painter.setPen(qColor(ColorRole::secondary, theme));
    painter.drawText(rect().adjusted(20, 20, -20, -20), Qt::AlignCenter | Qt::TextWordWrap, m_why);
    return;
  }
  const QSizeF paper = m_pages->paper();
  const double scale =
      std::min((width() - 2 * kMargin) / paper.width(), (height() - 2 * kMargin) / paper.height());
  const QSizeF shown = paper * scale;
  painter.translate((width() - shown.width()) / 2, (height() - shown.height()) / 2);
  painter.fillRect(QRectF({0, 0}, shown), Qt::white);
  painter.setPen(qColor(ColorRole::hairline, theme));
  painter.drawRect(QRectF({0, 0}, shown));
  painter.setClipRect(QRectF({0, 0}, shown));
  m_pages->paint(painter, m_page, scale, m_painter);
}

void PagePreview::keyPressEvent(QKeyEvent* event) {
  const int last = m_pages ? m_pages->count() - 1 : 0;
  switch (event->key()) {
    case Qt::Key_PageUp:
    case Qt::Key_Left:
    case Qt::Key_Up:
      return setPage(m_page - 1);
    case Qt::Key_PageDown:
    case Qt::Key_Right:
    case Qt::Key_Down:
      return setPage(m_page + 1);
    case Qt::Key_Home:
      return setPage(0);
    case Qt::Key_End:
      return setPage(last);
    default:
      QWidget::keyPressEvent(event);
  }
}

void PagePreview::wheelEvent(QWheelEvent* event) {
  setPage(m_page + (event->angleDelta().y() < 0 ? 1 : -1));
  event->accept();
}

}  // namespace geargraph

#include "moc_page_preview.cpp"
