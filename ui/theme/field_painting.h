#pragma once

#include <QMargins>
#include <QRect>
#include <QStyle>

class QPainter;
class QStyleOptionComboBox;
class QStyleOptionFrame;
class QStyleOptionSlider;
class QStyleOptionSpinBox;
class QWidget;

namespace geargraph {

/// Edge and padding of fields, those of spin boxes and combo boxes with their buttons.
[[nodiscard]] QMargins lineEditMargins(const QWidget* field);
constexpr QMargins kSpinBoxMargins = {7, 4, 17, 4};
constexpr QMargins kComboBoxMargins = {7, 4, 21, 4};
constexpr int kScrollBarWidth = 10;
constexpr int kLeastScrollHandle = 24;
constexpr int kSliderHandle = 16;

/// A line edit that does not stand in a spin box or a combo box, whose ground is theirs.
void drawLineEdit(const QStyleOptionFrame& option, QPainter& painter, const QWidget* field);

[[nodiscard]] QRect spinBoxPart(const QStyleOptionSpinBox& option, QStyle::SubControl part);
void drawSpinBox(const QStyle& style, const QStyleOptionSpinBox& option, QPainter& painter,
                 const QWidget* field);

[[nodiscard]] QRect comboBoxPart(const QStyleOptionComboBox& option, QStyle::SubControl part);
void drawComboBox(const QStyleOptionComboBox& option, QPainter& painter);

/// Scroll bars have no buttons at their ends.
[[nodiscard]] QRect scrollBarPart(const QStyleOptionSlider& option, QStyle::SubControl part);
void drawScrollBar(const QStyleOptionSlider& option, QPainter& painter, const QWidget* bar);

/// The parts of a horizontal slider.
[[nodiscard]] QRect sliderPart(const QStyleOptionSlider& option, QStyle::SubControl part);
void drawSlider(const QStyleOptionSlider& option, QPainter& painter);

}  // namespace geargraph
