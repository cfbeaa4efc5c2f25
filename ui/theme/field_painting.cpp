#include "ui/theme/field_painting.h"

#include <QPainter>
#include <QStyleOption>
#include <QVariant>
#include <QWidget>
#include <algorithm>

#include "ui/theme/icons.h"
#include "ui/theme/looks.h"
#include "ui/theme/theme_colors.h"

namespace geargraph {
namespace {

constexpr int kStepperWidth = 16;
constexpr int kDropDownWidth = 20;

/// The ground of a field that has a value.
StyleBox fieldBox(const QStyleOption& option) {
  const Theme theme = themeOf(option.palette);
  const bool isEnabled = hasState(option, QStyle::State_Enabled);
  const bool isFocused = isEnabled && hasState(option, QStyle::State_HasFocus);
  return {qColor(isEnabled ? ColorRole::sheet : ColorRole::panel, theme),
          qColor(isFocused ? ColorRole::accent : ColorRole::control, theme)};
}

void drawChevron(QPainter& painter, const QRect& area, Theme theme, double devicePixelRatio) {
  constexpr int kExtent = 10;
  const QRect place(area.center() - QPoint(kExtent / 2 - 1, kExtent / 2 - 1), QSize(kExtent, kExtent));
  painter.drawPixmap(
      place, iconPixmap(QStringLiteral("chevron"), ColorRole::secondary, theme, kExtent, devicePixelRatio));
}

}  // namespace

QMargins lineEditMargins(const QWidget* field) {
  return lookOf(field) == Look::cell ? QMargins(1, 4, 1, 4) : QMargins(7, 4, 7, 4);
}

void drawLineEdit(const QStyleOptionFrame& option, QPainter& painter, const QWidget* field) {
  if (option.lineWidth <= 0) return painter.fillRect(option.rect, option.palette.color(QPalette::Base));
  const Theme theme = themeOf(option.palette);
  StyleBox box = fieldBox(option);
  const QString mark = field != nullptr ? field->property("mark").toString() : QString();
  if (mark == QLatin1String("wrong")) {
    box.edge = qColor(ColorRole::error, theme);
    box.edgeWidth = 2;
  } else if (mark == QLatin1String("right")) {
    box.edge = qColor(ColorRole::fine, theme);
  }
  drawBox(painter, option.rect, box);
}

QRect spinBoxPart(const QStyleOptionSpinBox& option, QStyle::SubControl part) {
  const QRect& all = option.rect;
  const int stepper = all.right() + 1 - kStepperWidth;
  QRect place;
  switch (part) {
    case QStyle::SC_SpinBoxUp:
      place = QRect(stepper, all.top(), kStepperWidth, all.height() / 2);
      break;
    case QStyle::SC_SpinBoxDown:
      place = QRect(stepper, all.top() + all.height() / 2, kStepperWidth, all.height() - all.height() / 2);
      break;
    case QStyle::SC_SpinBoxEditField:
      place = all.marginsRemoved(kSpinBoxMargins);
      break;
    default:
      return all;
  }
  return QStyle::visualRect(option.direction, all, place);
}

void drawSpinBox(const QStyle& style, const QStyleOptionSpinBox& option, QPainter& painter,
                 const QWidget* field) {
  StyleBox box = fieldBox(option);
  if (field != nullptr && field->property("wrong").toBool())
    box.edge = qColor(ColorRole::error, themeOf(option.palette));
  drawBox(painter, option.rect, box);
  if (field != nullptr && field->property("look").isValid()) return;  // a number draws its steppers itself
  for (const bool isUp : {true, false}) {
    QStyleOption arrow = option;
    arrow.rect =
        spinBoxPart(option, isUp ? QStyle::SC_SpinBoxUp : QStyle::SC_SpinBoxDown).adjusted(3, 3, -3, -3);
    const auto allowed = isUp ? QAbstractSpinBox::StepUpEnabled : QAbstractSpinBox::StepDownEnabled;
    arrow.state.setFlag(QStyle::State_Enabled,
                        hasState(option, QStyle::State_Enabled) && option.stepEnabled.testFlag(allowed));
    style.drawPrimitive(isUp ? QStyle::PE_IndicatorArrowUp : QStyle::PE_IndicatorArrowDown, &arrow, &painter,
                        field);
  }
}

QRect comboBoxPart(const QStyleOptionComboBox& option, QStyle::SubControl part) {
  const QRect& all = option.rect;
  switch (part) {
    case QStyle::SC_ComboBoxArrow:
      return QStyle::visualRect(option.direction, all,
                                QRect(all.right() - kDropDownWidth, all.top(), kDropDownWidth, all.height()));
    case QStyle::SC_ComboBoxEditField:
      return QStyle::visualRect(option.direction, all, all.marginsRemoved(kComboBoxMargins));
    default:
      return all;
  }
}

void drawComboBox(const QStyleOptionComboBox& option, QPainter& painter) {
  drawBox(painter, option.rect, fieldBox(option));
  drawChevron(painter, comboBoxPart(option, QStyle::SC_ComboBoxArrow), themeOf(option.palette),
              painter.device()->devicePixelRatio());
}

QRect scrollBarPart(const QStyleOptionSlider& option, QStyle::SubControl part) {
  const bool isHorizontal = option.orientation == Qt::Horizontal;
  const QRect& all = option.rect;
  const int length = isHorizontal ? all.width() : all.height();
  // As wide a part of the bar as what is seen is of the whole.
  const qint64 range = qint64(option.maximum) - option.minimum;
  const qint64 whole = range + std::max(option.pageStep, 1);
  const int least = std::min(kLeastScrollHandle, length);
  const int handle =
      range == 0 ? length
                 : std::clamp(static_cast<int>(qint64(option.pageStep) * length / whole), least, length);
  const int start = QStyle::sliderPositionFromValue(option.minimum, option.maximum, option.sliderPosition,
                                                    length - handle, option.upsideDown);
  const auto along = [&](int from, int extent) {
    const QRect place = isHorizontal ? QRect(all.left() + from, all.top(), extent, all.height())
                                     : QRect(all.left(), all.top() + from, all.width(), extent);
    return QStyle::visualRect(option.direction, all, place);
  };
  switch (part) {
    case QStyle::SC_ScrollBarSlider:
      return along(start, handle);
    case QStyle::SC_ScrollBarSubPage:
      return along(0, start);
    case QStyle::SC_ScrollBarAddPage:
      return along(start + handle, length - start - handle);
    case QStyle::SC_ScrollBarGroove:
      return all;
    default:
      return {};
  }
}

void drawScrollBar(const QStyleOptionSlider& option, QPainter& painter, const QWidget* bar) {
  const Theme theme = themeOf(option.palette);
  const QWidget* area = bar;
  while (area != nullptr && lookOf(area) == Look::none) area = area->parentWidget();
  if (lookOf(area) != Look::cards) painter.fillRect(option.rect, qColor(ColorRole::sheet, theme));
  const bool isMarked =
      (option.activeSubControls & QStyle::SC_ScrollBarSlider) != 0 || hasState(option, QStyle::State_Sunken);
  const QRect handle = scrollBarPart(option, QStyle::SC_ScrollBarSlider).adjusted(1, 1, -1, -1);
  drawBox(painter, handle, {qColor(isMarked ? ColorRole::secondary : ColorRole::control, theme), QColor()});
}

QRect sliderPart(const QStyleOptionSlider& option, QStyle::SubControl part) {
  const QRect& all = option.rect;
  constexpr int kGroove = 4;
  switch (part) {
    case QStyle::SC_SliderGroove:
      return {all.left(), all.center().y() + 1 - kGroove / 2, all.width(), kGroove};
    case QStyle::SC_SliderHandle: {
      const int at = QStyle::sliderPositionFromValue(option.minimum, option.maximum, option.sliderPosition,
                                                     all.width() - kSliderHandle, option.upsideDown);
      return {all.left() + at, all.center().y() + 1 - kSliderHandle / 2, kSliderHandle, kSliderHandle};
    }
    default:
      return all;
  }
}

void drawSlider(const QStyleOptionSlider& option, QPainter& painter) {
  const Theme theme = themeOf(option.palette);
  const bool isEnabled = hasState(option, QStyle::State_Enabled);
  const QRect groove = sliderPart(option, QStyle::SC_SliderGroove);
  const QRect handle = sliderPart(option, QStyle::SC_SliderHandle);
  drawBox(painter, groove, {qColor(ColorRole::control, theme), QColor(), 2});
  QRect passed = groove;
  if (option.upsideDown) {
    passed.setLeft(handle.center().x());
  } else {
    passed.setRight(handle.center().x());
  }
  if (isEnabled) drawBox(painter, passed, {qColor(ColorRole::accent, theme), QColor(), 2});
  const bool isMarked =
      (option.activeSubControls & QStyle::SC_SliderHandle) != 0 || hasState(option, QStyle::State_HasFocus);
  const QColor edge = qColor(isEnabled ? ColorRole::accent : ColorRole::control, theme);
  const QColor filling = isEnabled && isMarked ? edge : qColor(ColorRole::sheet, theme);
  drawBox(painter, handle, {filling, edge, kSliderHandle / 2.0 - 1, 2});
}

}  // namespace geargraph
