#include "ui/panels/teeth_slider.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QSignalBlocker>
#include <QStyle>
#include <QWheelEvent>
#include <algorithm>

#include "ui/theme/field_painting.h"

namespace geargraph {
namespace {

constexpr int kMin = 6;  // below, gears can hardly be made
constexpr int kMany = 120;

}  // namespace

TeethSlider::TeethSlider(QWidget* parent) : QSlider(Qt::Horizontal, parent) {
  setRange(kMin, kMany);
  setPageStep(5);
  setMinimumWidth(70);
  setFocusPolicy(Qt::StrongFocus);
  setToolTip(tr("Slide to change the teeth; Esc puts back"));
  connect(this, &QSlider::valueChanged, this, [this](int teeth) {
    if (!isSliderDown()) emit started();  // a key, the wheel, or a screen reader: each step is one
    emit slid(teeth);
  });
}

void TeethSlider::showTeeth(const std::optional<int>& teeth) {
  const QSignalBlocker quiet(this);
  setEnabled(teeth.has_value());
  if (!teeth) return;
  if (!isSliderDown()) setRange(std::min(kMin, *teeth), std::max(kMany, 2 * *teeth));
  setValue(*teeth);
}

/// To where the mouse is, wherever it was pressed.
void TeethSlider::follow(int x) {
  if (m_isGivenUp) return;
  setSliderPosition(QStyle::sliderValueFromPosition(minimum(), maximum(), x - kSliderHandle / 2,
                                                    width() - kSliderHandle,
                                                    layoutDirection() == Qt::RightToLeft));
}

void TeethSlider::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  m_isGivenUp = false;
  emit started();
  setSliderDown(true);
  follow(event->pos().x());
}

void TeethSlider::mouseMoveEvent(QMouseEvent* event) {
  if (isSliderDown()) follow(event->pos().x());
}

void TeethSlider::mouseReleaseEvent(QMouseEvent*) {
  setSliderDown(false);
}

void TeethSlider::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Escape || !isSliderDown()) return QSlider::keyPressEvent(event);
  m_isGivenUp = true;
  emit putBack();
}

/// A wheel over a panel scrolls it, unless the slider has the focus.
void TeethSlider::wheelEvent(QWheelEvent* event) {
  if (!hasFocus()) return event->ignore();
  QSlider::wheelEvent(event);
}

}  // namespace geargraph

#include "moc_teeth_slider.cpp"
