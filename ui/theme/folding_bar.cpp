#include "ui/theme/folding_bar.h"

#include <QBoxLayout>
#include <QEvent>
#include <algorithm>

namespace geargraph {

FoldingBar::FoldingBar(QWidget* first, QWidget* second, QWidget* parent)
    : QWidget(parent),
      m_first(first),
      m_second(second),
      m_layout(new QBoxLayout(QBoxLayout::LeftToRight, this)) {
  m_layout->setContentsMargins(12, 6, 10, 2);
  m_layout->setSpacing(4);
  m_layout->addWidget(first);
  m_layout->addWidget(second, 1);
}

bool FoldingBar::isFolded() const {
  return m_layout->direction() == QBoxLayout::TopToBottom;
}

// It is that of their size hints: a control may be told to be narrower than what is in it needs.
QSize FoldingBar::minimumSizeHint() const {
  const QMargins margins = m_layout->contentsMargins();
  const int wider = std::max(m_first->sizeHint().width(), m_second->sizeHint().width());
  return {wider + margins.left() + margins.right(), m_layout->minimumSize().height()};
}

void FoldingBar::fold() {
  const QMargins margins = m_layout->contentsMargins();
  const int both = m_first->sizeHint().width() + m_layout->spacing() + m_second->sizeHint().width();
  const bool isWideEnough = margins.left() + both + margins.right() <= width();
  m_layout->setDirection(isWideEnough ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
}

void FoldingBar::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fold();
}

/// A control that gets another text, or another font, needs other room.
bool FoldingBar::event(QEvent* event) {
  if (event->type() == QEvent::LayoutRequest) fold();
  return QWidget::event(event);
}

}  // namespace geargraph

#include "moc_folding_bar.cpp"
