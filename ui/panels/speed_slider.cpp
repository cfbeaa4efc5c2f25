#include "ui/panels/speed_slider.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

#include "ui/theme/application_theme.h"

namespace geargraph {
namespace {
constexpr double kHandle = 6.5;  // radius
}

SpeedSlider::SpeedSlider(QWidget* parent) : QAbstractSlider(parent) {
  setOrientation(Qt::Horizontal);
  setRange(-kSteps, kSteps);
  setSingleStep(kSteps / 20);
  setPageStep(kSteps / 4);
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

double SpeedSlider::xOf(int steps) const {
  const double half = width() / 2.0;
  return half + (half - kHandle - 2) * steps / kSteps;
}

void SpeedSlider::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const Theme theme = themeOf(palette());
  const double y = height() / 2.0;
  painter.setPen(QPen(qColor(ColorRole::hairline, theme), 4, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(QPointF(xOf(-kSteps), y), QPointF(xOf(kSteps), y));
  const QColor drive = isEnabled() ? qColor(ColorRole::input, theme) : qColor(ColorRole::secondary, theme);
  painter.setPen(QPen(drive, 4, Qt::SolidLine, Qt::RoundCap));
  if (value() != 0) painter.drawLine(QPointF(xOf(0), y), QPointF(xOf(value()), y));
  painter.setPen(QPen(drive, hasFocus() ? 2.6 : 2));
  painter.setBrush(qColor(ColorRole::sheet, theme));
  painter.drawEllipse(QPointF(xOf(value()), y), kHandle, kHandle);
}

void SpeedSlider::follow(double x) {
  const double half = width() / 2.0;
  int steps = static_cast<int>(kSteps * (x - half) / (half - kHandle - 2));
  steps = std::clamp(steps / 5 * 5, -kSteps, kSteps);
  if (std::abs(steps) < 8) steps = 0;  // zero is easy to hit
  setSliderPosition(steps);
}

void SpeedSlider::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  setSliderDown(true);
  follow(event->position().x());
}

void SpeedSlider::mouseMoveEvent(QMouseEvent* event) {
  if (isSliderDown()) follow(event->position().x());
}

void SpeedSlider::mouseReleaseEvent(QMouseEvent*) {
  setSliderDown(false);
}

void SpeedSlider::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Home) return setValue(0);
  QAbstractSlider::keyPressEvent(event);
}

}  // namespace geargraph

#include "moc_speed_slider.cpp"
