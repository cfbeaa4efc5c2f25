#include "ui/theme/looks.h"

#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QStyleOption>
#include <QVariant>
#include <utility>

#include "ui/theme/theme_colors.h"

namespace geargraph {
namespace {

constexpr std::pair<const char*, Look> kLooks[] = {
    {"hint", Look::hint},       {"title", Look::title},
    {"heading", Look::heading}, {"problem", Look::problem},
    {"empty", Look::empty},     {"card", Look::card},
    {"banner", Look::banner},   {"rule", Look::rule},
    {"verdict", Look::verdict}, {"note3d", Look::note3d},
    {"toast", Look::toast},     {"veil", Look::veil},
    {"chip", Look::chip},       {"symbol", Look::symbol},
    {"count", Look::count},     {"strongCount", Look::strongCount},
    {"flat", Look::flat},       {"control", Look::control},
    {"fix", Look::fix},         {"cell", Look::cell},
    {"entries", Look::entries}, {"cards", Look::cards},
};
// Most widgets have neither: the names are asked first, because a property is searched among all of its
// class.
constexpr const char* kLookProperty = "look";
constexpr const char* kInkProperty = "ink";
constexpr int kHeadingPixels = 17;

void applyInk(QLabel& label, ColorRole role) {
  QPalette inks;
  inks.setColor(QPalette::WindowText, qColor(role, themeOf(QApplication::palette())));
  label.setPalette(inks);
  label.setForegroundRole(QPalette::WindowText);  // on the sheet it would be that of texts
}

void setSize(QWidget& widget, int pixels) {
  QFont font;
  font.setPixelSize(pixels);
  widget.setFont(font);
}

void setWeight(QWidget& widget, int pixels = 0) {
  QFont font;
  font.setBold(true);
  if (pixels > 0) font.setPixelSize(pixels);
  widget.setFont(font);
}

void applyToLabel(QLabel& label, Look look) {
  const bool isSecondary = look == Look::hint || look == Look::empty || look == Look::veil;
  if (isSecondary) label.setForegroundRole(QPalette::PlaceholderText);
  switch (look) {
    case Look::hint:
      return label.setPalette(QPalette());  // which may have been a problem before
    case Look::title:
      return setWeight(label);
    case Look::heading:
      return setWeight(label, kHeadingPixels);
    case Look::problem:
      return applyInk(label, ColorRole::error);
    case Look::empty:
      return label.setMargin(24);  // a frame that is polished drops contents margins that leave no contents
    case Look::verdict:
      return label.setContentsMargins(13, 6, 13, 6);
    case Look::note3d:
      label.setContentsMargins(11, 6, 11, 6);
      return applyInk(label, ColorRole::warning);
    case Look::toast:
      label.setContentsMargins(18, 10, 18, 10);
      return applyInk(label, ColorRole::sheet);
    case Look::veil:
      return label.setContentsMargins(6, 2, 6, 2);
    default:
      return;
  }
}

/// A cell that shows what is given, and is not for typing, reads like one that has been typed.
void applyToCell(QLineEdit& cell) {
  QPalette inks;
  inks.setColor(QPalette::Disabled, QPalette::Text, QApplication::palette().color(QPalette::Text));
  cell.setPalette(inks);
}

}  // namespace

Look lookOf(const QWidget* widget) {
  if (widget == nullptr || !widget->dynamicPropertyNames().contains(kLookProperty)) return Look::none;
  const QString name = widget->property(kLookProperty).toString();
  for (const auto& [known, look] : kLooks) {
    if (name == QLatin1String(known)) return look;
  }
  return Look::none;
}

void applyLook(QWidget& widget) {
  if (widget.dynamicPropertyNames().contains(kInkProperty)) {
    const int ink = widget.property(kInkProperty).toInt();
    applyInk(static_cast<QLabel&>(widget), static_cast<ColorRole>(ink));
  }
  const Look look = lookOf(&widget);
  if (look == Look::none) return;
  if (look == Look::count || look == Look::strongCount) return setWeight(widget, smallPixels());
  if (look == Look::entries) return setSize(widget, bodyPixels() + 1);
  if (auto* label = qobject_cast<QLabel*>(&widget)) return applyToLabel(*label, look);
  auto* field = qobject_cast<QLineEdit*>(&widget);
  if (field != nullptr && look == Look::cell) applyToCell(*field);
}

void setInk(QLabel& label, ColorRole role) {
  label.setProperty(kInkProperty, static_cast<int>(role));
  applyInk(label, role);
}

void updateLooks(QWidget& root) {
  if (root.testAttribute(Qt::WA_WState_Polished)) applyLook(root);
  for (QWidget* widget : root.findChildren<QWidget*>()) {
    if (widget->testAttribute(Qt::WA_WState_Polished)) applyLook(*widget);
  }
}

QColor chosenColor(Theme theme) {
  const QColor sheet = qColor(ColorRole::sheet, theme);
  const QColor halo = qColor(ColorRole::halo, theme);
  const auto thinned = [](int sheetPart, int haloPart) { return (3 * sheetPart + haloPart) / 4; };
  return {thinned(sheet.red(), halo.red()), thinned(sheet.green(), halo.green()),
          thinned(sheet.blue(), halo.blue())};
}

/// At high contrast, the secondary colour is hardly darker than the ink.
QColor disabledColor(Theme theme) {
  return qColor(theme == Theme::highContrast ? ColorRole::hairline : ColorRole::secondary, theme);
}

bool hasState(const QStyleOption& option, QStyle::StateFlag flag) {
  return (option.state & flag) != 0;
}

void drawBox(QPainter& painter, const QRect& area, const StyleBox& box) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(box.filling.isValid() ? QBrush(box.filling) : QBrush(Qt::NoBrush));
  const bool hasEdge = box.edge.isValid();
  painter.setPen(hasEdge ? QPen(box.edge, box.edgeWidth) : QPen(Qt::NoPen));
  const double inset = hasEdge ? box.edgeWidth / 2 : 0;  // its middle is where it is drawn
  painter.drawRoundedRect(QRectF(area).adjusted(inset, inset, -inset, -inset), box.radius, box.radius);
  painter.restore();
}

void drawFrameOf(Look look, QPainter& painter, const QStyleOption& option) {
  const QRect& area = option.rect;
  const Theme theme = themeOf(option.palette);
  const auto color = [theme](ColorRole role) { return qColor(role, theme); };
  switch (look) {
    case Look::card:
      return drawBox(painter, area, {color(ColorRole::sheet), color(ColorRole::hairline), 6});
    case Look::banner:
      return drawBox(painter, area, {chosenColor(theme), color(ColorRole::hairline), 6});
    case Look::note3d:
      return drawBox(painter, area, {color(ColorRole::sheet), color(ColorRole::hairline), 5});
    case Look::verdict: {
      QColor ground = option.palette.color(QPalette::WindowText);
      QColor edge = ground;
      ground.setAlphaF(0.10F);
      edge.setAlphaF(0.45F);
      return drawBox(painter, area, {ground, edge, 5});
    }
    case Look::toast:
      return drawBox(painter, area, {color(ColorRole::ink), QColor(), 8});
    case Look::veil: {
      QColor veil = color(ColorRole::sheet);
      veil.setAlphaF(0.72F);  // type stays readable whatever turns behind it
      return drawBox(painter, area, {veil, QColor(), 5});
    }
    case Look::rule:
      return painter.fillRect(area, color(ColorRole::hairline));
    default:
      return;
  }
}

}  // namespace geargraph
