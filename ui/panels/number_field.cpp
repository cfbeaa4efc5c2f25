#include "ui/panels/number_field.h"

#include <QLineEdit>
#include <QLocale>
#include <QPainter>
#include <QStyle>
#include <QStyleOptionSpinBox>
#include <QWheelEvent>

#include "core/mechanism/model/length.h"
#include "ui/theme/application_theme.h"

namespace geargraph::inline panels {

NumberField::NumberField(QWidget* parent) : QAbstractSpinBox(parent) {
  setProperty("look", "number");
  setFocusPolicy(Qt::StrongFocus);  // not by the wheel, which scrolls the panel
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAttribute(Qt::WA_Hover);
  connect(lineEdit(), &QLineEdit::textEdited, this, &NumberField::onText);
  lineEdit()->installEventFilter(this);
}

void NumberField::setWhole(int least, int most) {
  m_least = least;
  m_most = most;
}

void NumberField::setLengthUnit(const std::string& unit) {
  m_unit = unit;
  if (!property("wrong").toBool()) setToolTip(hint());
}

void NumberField::setEmptyText(const QString& text) {
  lineEdit()->setPlaceholderText(text);
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
  showNumber();
  setWrong({});
}

void NumberField::showNumber() {
  lineEdit()->setText(m_number ? QString::fromStdString(m_number->text()) : QString());
}

QVariant NumberField::value() const {
  return m_number ? QVariant(m_number->value()) : QVariant();
}

void NumberField::setValue(const QVariant& value) {
  if (isReadOnly()) return;
  lineEdit()->setText(QString::number(value.toDouble(), 'g', QLocale::FloatingPointShortest));
  onText(text());
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

void NumberField::stepBy(int steps) {
  if (!isEnabled() || isReadOnly()) return;
  Rational value = m_number ? m_number->exact() : Rational(0);
  value += m_step * Rational(steps);
  if (m_least && value < Rational(*m_least)) value = Rational(*m_least);
  if (m_most && value > Rational(*m_most)) value = Rational(*m_most);
  if (m_number && value == m_number->exact()) return;
  m_number = Number(value);
  setWrong({});
  showNumber();
  emit edited(m_number);
}

QAbstractSpinBox::StepEnabled NumberField::stepEnabled() const {
  if (isReadOnly()) return StepNone;
  StepEnabled enabled = StepNone;
  if (!m_number || !m_most || m_number->exact() < Rational(*m_most)) enabled |= StepUpEnabled;
  if (!m_number || !m_least || m_number->exact() > Rational(*m_least)) enabled |= StepDownEnabled;
  return enabled;
}

/// A line of text is as wide as a QLineEdit's; QAbstractSpinBox would make room for the text of its minimum,
/// which it does not know.
QSize NumberField::sizeAround(const QSize& text) const {
  QStyleOptionSpinBox option;
  initStyleOption(&option);
  return style()->sizeFromContents(QStyle::CT_SpinBox, &option, text, this);
}

QSize NumberField::sizeHint() const {
  return sizeAround(lineEdit()->sizeHint());
}

QSize NumberField::minimumSizeHint() const {
  return sizeAround(lineEdit()->minimumSizeHint());
}

void NumberField::paintEvent(QPaintEvent* event) {
  QAbstractSpinBox::paintEvent(event);
  QStyleOptionSpinBox option;
  initStyleOption(&option);
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  const bool ready = isEnabled() && (hasFocus() || underMouse());
  painter.setBrush(qColor(ready ? ColorRole::secondary : ColorRole::hairline, themeOf(palette())));
  const QRectF up = style()->subControlRect(QStyle::CC_SpinBox, &option, QStyle::SC_SpinBoxUp, this);
  const QRectF down = style()->subControlRect(QStyle::CC_SpinBox, &option, QStyle::SC_SpinBoxDown, this);
  const QPointF middle = up.united(down).center();
  painter.drawPolygon(
      QPolygonF({middle + QPointF(-3, -2), middle + QPointF(3, -2), middle + QPointF(0, -6)}));
  painter.drawPolygon(QPolygonF({middle + QPointF(-3, 2), middle + QPointF(3, 2), middle + QPointF(0, 6)}));
}

void NumberField::wheelEvent(QWheelEvent* event) {
  if (!hasFocus()) return event->ignore();  // the panel scrolls
  QAbstractSpinBox::wheelEvent(event);
}

void NumberField::mousePressEvent(QMouseEvent* event) {
  m_selectOnRelease = false;  // on an arrow
  QAbstractSpinBox::mousePressEvent(event);
}

/// A click into the text that brings the focus selects all of it.
bool NumberField::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::MouseButtonRelease) {
    if (m_selectOnRelease && !lineEdit()->hasSelectedText()) selectAll();
    m_selectOnRelease = false;
  }
  return QAbstractSpinBox::eventFilter(watched, event);
}

void NumberField::focusInEvent(QFocusEvent* event) {
  QAbstractSpinBox::focusInEvent(event);
  m_selectOnRelease = event->reason() == Qt::MouseFocusReason;
  emit editingStarted();
}

void NumberField::focusOutEvent(QFocusEvent* event) {
  QAbstractSpinBox::focusOutEvent(event);
  showNumber();
  setWrong({});
}

}  // namespace geargraph::inline panels
