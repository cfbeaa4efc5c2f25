#include "ui/panels/number_field.h"

#include <QKeyEvent>
#include <QLocale>
#include <QPainter>
#include <QStyle>
#include <QWheelEvent>

#include "core/mechanism/model/length.h"
#include "ui/theme/application_theme.h"

namespace geargraph::inline panels {

NumberField::NumberField(QWidget* parent) : QLineEdit(parent) {
  setTextMargins(0, 0, 12, 0);
  connect(this, &QLineEdit::textEdited, this, &NumberField::onText);
}

void NumberField::setWhole(int least, int most) {
  m_least = least;
  m_most = most;
}

void NumberField::setLengthUnit(const std::string& unit) {
  m_unit = unit;
  if (!property("wrong").toBool()) setToolTip(hint());
}

QString NumberField::hint() const {
  if (!m_unit) return {};
  return tr("In %1; a length with another unit, such as 1/2 in or 2.5 cm, is converted.")
      .arg(QString::fromStdString(*m_unit).toHtmlEscaped());
}

std::optional<Number> NumberField::read(const QString& text) const {
  QString point = text.trimmed();
  if (QLocale().decimalPoint() == QLatin1String(",") && !point.contains(QLatin1Char('.')))
    point.replace(QLatin1Char(','), QLatin1Char('.'));
  const std::string typed = point.toStdString();
  return m_unit ? lengthFromText(typed, *m_unit) : Number::fromText(typed);
}

void NumberField::setNumber(const std::optional<Number>& number) {
  m_number = number;
  const auto typed = read(text());
  const bool beingTyped = hasFocus() && typed && number && typed->exact() == number->exact();
  if (beingTyped) return;
  if (hasFocus() && property("wrong").toBool()) return;
  setText(number ? QString::fromStdString(number->text()) : QString());
  setWrong({});
}

void NumberField::onText(const QString& typed) {
  const QString trimmed = typed.trimmed();
  if (trimmed.isEmpty() && m_optional) {
    setWrong({});
    m_number.reset();
    emit edited(std::nullopt);
    return;
  }
  const auto number = read(trimmed);
  if (!number) {
    return setWrong(m_unit ? tr("Type a number such as 12, 0.5 or 22/7, or a length such as 1/2 in.")
                           : tr("Type a number such as 12, 0.5 or 22/7."));
  }
  const bool whole = number->exact().isInteger();
  const bool outside =
      m_least && (!whole || number->exact() < Rational(*m_least) || number->exact() > Rational(*m_most));
  if (outside) return setWrong(tr("Type a whole number from %1 to %2.").arg(*m_least).arg(*m_most));
  setWrong({});
  m_number = number;
  emit edited(number);
}

void NumberField::reject(const QString& why) {
  setWrong(why);
}

void NumberField::setWrong(const QString& why) {
  setToolTip(why.isEmpty() ? hint() : why);
  if (property("wrong").toBool() == !why.isEmpty()) return;
  setProperty("wrong", !why.isEmpty());
  style()->unpolish(this);
  style()->polish(this);
  emit wrongChanged(why);
}

void NumberField::spin(int steps) {
  if (!isEnabled() || isReadOnly()) return;
  Rational value = m_number ? m_number->exact() : Rational(0);
  value += m_step * Rational(steps);
  if (m_least && value < Rational(*m_least)) value = Rational(*m_least);
  if (m_most && value > Rational(*m_most)) value = Rational(*m_most);
  if (m_number && value == m_number->exact()) return;
  m_number = Number(value);
  setWrong({});
  setText(QString::fromStdString(m_number->text()));
  emit edited(m_number);
}

QRect NumberField::spinRect() const {
  return {width() - 16, 2, 14, height() - 4};
}

void NumberField::paintEvent(QPaintEvent* event) {
  QLineEdit::paintEvent(event);
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  const bool ready = isEnabled() && (hasFocus() || underMouse());
  painter.setBrush(qColor(ready ? ColorRole::secondary : ColorRole::hairline, themeOf(palette())));
  const QPointF middle = QRectF(spinRect()).center();
  painter.drawPolygon(
      QPolygonF({middle + QPointF(-3, -2), middle + QPointF(3, -2), middle + QPointF(0, -6)}));
  painter.drawPolygon(QPolygonF({middle + QPointF(-3, 2), middle + QPointF(3, 2), middle + QPointF(0, 6)}));
}

void NumberField::keyPressEvent(QKeyEvent* event) {
  const int scale = event->modifiers().testFlag(Qt::ControlModifier) ? 10 : 1;
  if (event->key() == Qt::Key_Up) return spin(scale);
  if (event->key() == Qt::Key_Down) return spin(-scale);
  QLineEdit::keyPressEvent(event);
}

void NumberField::wheelEvent(QWheelEvent* event) {
  if (!hasFocus()) return event->ignore();  // the panel scrolls
  spin(event->angleDelta().y() > 0 ? 1 : -1);
  event->accept();
}

void NumberField::mousePressEvent(QMouseEvent* event) {
  m_selectOnRelease = !hasFocus() || m_selectOnRelease;
  if (spinRect().contains(event->pos())) {
    m_selectOnRelease = false;
    setFocus(Qt::MouseFocusReason);
    return spin(event->pos().y() < height() / 2 ? 1 : -1);
  }
  QLineEdit::mousePressEvent(event);
}

void NumberField::mouseReleaseEvent(QMouseEvent* event) {
  QLineEdit::mouseReleaseEvent(event);
  if (m_selectOnRelease && !hasSelectedText()) selectAll();
  m_selectOnRelease = false;
}

void NumberField::focusInEvent(QFocusEvent* event) {
  QLineEdit::focusInEvent(event);
  m_selectOnRelease = event->reason() == Qt::MouseFocusReason;
  emit editingStarted();
}

void NumberField::focusOutEvent(QFocusEvent* event) {
  QLineEdit::focusOutEvent(event);
  setText(m_number ? QString::fromStdString(m_number->text()) : QString());
  setWrong({});
}

}  // namespace geargraph::inline panels
