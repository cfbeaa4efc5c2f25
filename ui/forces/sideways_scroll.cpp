#include "ui/forces/sideways_scroll.h"

#include <QScrollBar>

namespace geargraph::inline forces {

constexpr int kLeastWidth = 160;

SidewaysScroll::SidewaysScroll(QWidget* strip, QWidget* parent) : QScrollArea(parent) {
  setWidget(strip);
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  connect(horizontalScrollBar(), &QScrollBar::rangeChanged, this, &QWidget::updateGeometry);
}

/// The bar needs room of its own where there is one.
int SidewaysScroll::wantedHeight() const {
  const bool scrolls = horizontalScrollBar()->maximum() > 0;
  return widget()->minimumSizeHint().height() + (scrolls ? horizontalScrollBar()->sizeHint().height() : 0);
}

QSize SidewaysScroll::sizeHint() const {
  return {widget()->sizeHint().width(), wantedHeight()};
}

QSize SidewaysScroll::minimumSizeHint() const {
  return {kLeastWidth, wantedHeight()};
}

}  // namespace geargraph::inline forces
