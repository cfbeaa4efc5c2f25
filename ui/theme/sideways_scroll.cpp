#include "ui/theme/sideways_scroll.h"

#include <QScrollBar>
#include <QToolButton>
#include <QWheelEvent>

#include "ui/theme/control_button.h"
#include "ui/theme/theme_colors.h"

namespace geargraph {

constexpr int kLeastWidth = 160;
constexpr int kArrowWidth = 24;

SidewaysScroll::SidewaysScroll(QWidget* strip, QWidget* parent)
    : QScrollArea(parent),
      m_left(makeArrow(-1, tr("There is more on the left"))),
      m_right(makeArrow(1, tr("There is more on the right"))) {
  setWidget(strip);
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  connect(horizontalScrollBar(), &QScrollBar::rangeChanged, this, &SidewaysScroll::placeArrows);
  connect(horizontalScrollBar(), &QScrollBar::valueChanged, this, &SidewaysScroll::placeArrows);
  placeArrows();
}

/// `way`: -1 scrolls to the left, 1 to the right, by most of what is seen.
QToolButton* SidewaysScroll::makeArrow(int way, const QString& tip) {
  QToolButton* arrow = controlButton(way < 0 ? QStringLiteral("moreLeft") : QStringLiteral("moreRight"),
                                     way < 0 ? QStringLiteral("‹") : QStringLiteral("›"), tip, this);
  arrow->setAccessibleName(tip);
  connect(arrow, &QToolButton::clicked, this, [this, way] {
    const int step = way * viewport()->width() * 2 / 3;
    QScrollBar* bar = horizontalScrollBar();
    bar->setValue(bar->value() + (isRightToLeft() ? -step : step));
  });
  return arrow;
}

void SidewaysScroll::placeArrows() {
  const QScrollBar* bar = horizontalScrollBar();
  const bool isBefore = bar->value() > bar->minimum();
  const bool isAfter = bar->value() < bar->maximum();
  const int width = scaledPixels(kArrowWidth);
  m_left->setGeometry(0, 0, width, height());
  m_right->setGeometry(this->width() - width, 0, width, height());
  m_left->setVisible(isRightToLeft() ? isAfter : isBefore);
  m_right->setVisible(isRightToLeft() ? isBefore : isAfter);
  m_left->raise();
  m_right->raise();
}

/// A strip whose contents change changes its height.
bool SidewaysScroll::eventFilter(QObject* watched, QEvent* event) {
  if (watched == widget() && event->type() == QEvent::LayoutRequest) updateGeometry();
  return QScrollArea::eventFilter(watched, event);
}

void SidewaysScroll::resizeEvent(QResizeEvent* event) {
  QScrollArea::resizeEvent(event);
  placeArrows();
}

void SidewaysScroll::wheelEvent(QWheelEvent* event) {
  QScrollBar* bar = horizontalScrollBar();
  const QPoint turned = event->angleDelta();
  const int delta = turned.x() != 0 ? turned.x() : turned.y();
  if (bar->maximum() == 0 || delta == 0) return event->ignore();
  bar->setValue(bar->value() - (isRightToLeft() ? -delta : delta) / 2);
  event->accept();
}

QSize SidewaysScroll::sizeHint() const {
  return {widget()->sizeHint().width(), widget()->minimumSizeHint().height()};
}

QSize SidewaysScroll::minimumSizeHint() const {
  return {kLeastWidth, widget()->minimumSizeHint().height()};
}

}  // namespace geargraph

#include "moc_sideways_scroll.cpp"
