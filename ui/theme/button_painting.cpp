#include "ui/theme/button_painting.h"

#include <QPainter>
#include <QStyleOption>
#include <QToolBar>
#include <QToolButton>
#include <algorithm>

#include "ui/theme/theme_colors.h"

namespace geargraph {
namespace {

constexpr ButtonForm kToolBarForm = {{11, 6, 11, 6}, 0, 0, 5};
constexpr ButtonForm kChipForm = {{11, 4, 11, 4}, 0, 17, 11};
constexpr ButtonForm kSymbolForm = {{7, 4, 7, 4}, 18, 17, 11};
constexpr ButtonForm kCountForm = {{14, 3, 14, 3}, 0, 0, 10};
constexpr ButtonForm kFlatForm = {{6, 4, 6, 4}, 0, 0, 4};
constexpr ButtonForm kControlForm = {{8, 4, 8, 4}, 0, 0, 4};

bool isInToolBar(const QWidget& widget) {
  for (const QWidget* at = widget.parentWidget(); at != nullptr; at = at->parentWidget()) {
    if (qobject_cast<const QToolBar*>(at) != nullptr) return true;
    if (at->isWindow()) return false;
  }
  return false;
}

struct Inks {
  QColor filling, edge, ink;
};

Inks restingInks(Look look, Theme theme) {
  const auto color = [theme](ColorRole role) { return qColor(role, theme); };
  switch (look) {
    case Look::flat:
      return {QColor(), QColor(), color(ColorRole::secondary)};
    case Look::strongCount:
      return {chosenColor(theme), color(ColorRole::halo), color(ColorRole::accent)};
    case Look::none:  // in a tool bar
      return {QColor(), QColor(), color(ColorRole::ink)};
    default:
      return {color(ColorRole::sheet), color(ColorRole::hairline), color(ColorRole::ink)};
  }
}

void markHovered(Inks& inks, Look look, Theme theme) {
  switch (look) {
    case Look::none:
      inks.filling = qColor(ColorRole::panel, theme);
      inks.edge = qColor(ColorRole::hairline, theme);
      return;
    case Look::flat:
      inks.filling = qColor(ColorRole::panel, theme);
      inks.ink = qColor(ColorRole::ink, theme);
      return;
    default:
      inks.edge = qColor(ColorRole::accent, theme);
  }
}

void markChosen(Inks& inks, Look look, Theme theme) {
  inks.ink = qColor(ColorRole::accent, theme);
  if (look != Look::flat) inks.edge = inks.ink;
  if (look == Look::none || look == Look::chip || look == Look::symbol) inks.filling = chosenColor(theme);
}

bool isFocusShown(QStyle::State state) {
  return (state & QStyle::State_HasFocus) != 0 && (state & QStyle::State_KeyboardFocusChange) != 0;
}

Inks inksOf(Look look, QStyle::State state, Theme theme) {
  Inks inks = restingInks(look, theme);
  const bool isEnabled = (state & QStyle::State_Enabled) != 0;
  if (isEnabled && (state & QStyle::State_MouseOver) != 0) markHovered(inks, look, theme);
  if ((state & QStyle::State_On) != 0) markChosen(inks, look, theme);
  if (isFocusShown(state)) inks.edge = qColor(ColorRole::accent, theme);
  if (!isEnabled) inks.ink = disabledColor(theme);
  return inks;
}

/// A button whose text tells of its menu has no arrow.
bool hasArrow(const QStyleOptionToolButton& option, Look look) {
  return (option.features & QStyleOptionToolButton::HasMenu) != 0 && look != Look::flat &&
         look != Look::control;
}

/// Where Qt's own styles have it: in the corner, at the end of the line.
void drawMenuArrow(const QStyle& style, const QStyleOptionToolButton& option, QPainter& painter,
                   const QWidget& button) {
  const int extent = style.pixelMetric(QStyle::PM_MenuButtonIndicator, &option, &button);
  QStyleOption arrow = option;
  arrow.rect = QStyle::visualRect(
      option.direction, option.rect,
      QRect(option.rect.right() + 5 - extent, option.rect.bottom() + 5 - extent, extent - 6, extent - 6));
  style.drawPrimitive(QStyle::PE_IndicatorArrowDown, &arrow, &painter, &button);
}

}  // namespace

const ButtonForm* toolButtonForm(const QWidget* button) {
  if (qobject_cast<const QToolButton*>(button) == nullptr) return nullptr;
  switch (lookOf(button)) {
    case Look::chip:
      return &kChipForm;
    case Look::symbol:
      return &kSymbolForm;
    case Look::count:
    case Look::strongCount:
      return &kCountForm;
    case Look::flat:
      return &kFlatForm;
    case Look::control:
      return &kControlForm;
    default:
      return isInToolBar(*button) ? &kToolBarForm : nullptr;
  }
}

const ButtonForm& pushButtonForm(Look look) {
  static constexpr ButtonForm kForm = {{17, 5, 17, 5}, 0, 0, 4};
  static constexpr ButtonForm kFixForm = {{12, 2, 12, 2}, 0, 0, 11};
  return look == Look::fix ? kFixForm : kForm;
}

QSize roomFor(const ButtonForm& form, QSize content) {
  return content.expandedTo({form.leastWidth, form.leastHeight}).grownBy(form.padding);
}

void drawToolButton(const QStyle& style, const QStyleOptionToolButton& option, QPainter& painter,
                    const QWidget& button, const ButtonForm& form) {
  const Look look = lookOf(&button);
  const Theme theme = themeOf(option.palette);
  const Inks inks = inksOf(look, option.state, theme);
  const double most = option.rect.height() / 2.0;
  drawBox(painter, option.rect, {inks.filling, inks.edge, std::min(form.radius, most)});
  QStyleOptionToolButton label = option;
  label.rect = option.rect.marginsRemoved(form.padding);
  for (const auto role : {QPalette::ButtonText, QPalette::WindowText}) label.palette.setColor(role, inks.ink);
  style.drawControl(QStyle::CE_ToolButtonLabel, &label, &painter, &button);
  if (hasArrow(option, look)) drawMenuArrow(style, option, painter, button);
}

void drawPushButtonGround(const QStyle& style, const QStyleOptionButton& option, QPainter& painter,
                          Look look) {
  const Theme theme = themeOf(option.palette);
  const auto color = [theme](ColorRole role) { return qColor(role, theme); };
  const bool isDefault = (option.features & QStyleOptionButton::DefaultButton) != 0;
  StyleBox box{color(ColorRole::sheet), color(ColorRole::hairline), pushButtonForm(look).radius};
  if (!hasState(option, QStyle::State_Enabled)) {
    box.filling = color(ColorRole::panel);
  } else {
    const bool isMarked = hasState(option, QStyle::State_MouseOver) || isFocusShown(option.state);
    if (hasState(option, QStyle::State_Sunken) || hasState(option, QStyle::State_On) || isDefault)
      box.filling = chosenColor(theme);
    if (isMarked) box.edge = color(ColorRole::accent);
  }
  drawBox(painter, option.rect, box);
  if ((option.features & QStyleOptionButton::HasMenu) == 0) return;
  const int extent = style.pixelMetric(QStyle::PM_MenuButtonIndicator, &option);
  QStyleOption arrow = option;
  arrow.rect = QStyle::visualRect(
      option.direction, option.rect,
      QRect(option.rect.right() - extent - 2, option.rect.center().y() - extent / 2, extent, extent));
  style.drawPrimitive(QStyle::PE_IndicatorArrowDown, &arrow, &painter);
}

}  // namespace geargraph
