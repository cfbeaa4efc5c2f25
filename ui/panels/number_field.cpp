#include "ui/panels/number_field.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QLocale>
#include <QPainter>
#include <QRegularExpression>
#include <QStyle>
#include <QStyleOptionSpinBox>
#include <QWheelEvent>
#include <cctype>
#include <string_view>
#include <utility>

#include "core/foundations/base/locale.h"
#include "core/mechanism/model/length.h"
#include "ui/document/typed_length.h"
#include "ui/theme/application_theme.h"

namespace geargraph {

NumberField::NumberField(QWidget* parent) : QAbstractSpinBox(parent) {
  setProperty("look", "number");
  setFocusPolicy(Qt::StrongFocus);  // not by the wheel, which scrolls the panel
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAttribute(Qt::WA_Hover);
  lineEdit()->setMaxLength(kMaxTyped);
  connect(lineEdit(), &QLineEdit::textEdited, this, &NumberField::onText);
  lineEdit()->installEventFilter(this);
  m_pause.setSingleShot(true);
  m_pause.setInterval(kPause);
  connect(&m_pause, &QTimer::timeout, this, &NumberField::commit);
}

/// With the decimal sign that is typed here; a minus stays a hyphen, as one types it.
QString NumberField::textOf(const Number& number) {
  return QString::fromStdString(localizedNumber(number.text()));
}

void NumberField::setWhole(int least, int most) {
  m_least = least;
  m_most = most;
}

void NumberField::setLengthUnit(const std::optional<std::string>& unit) {
  m_unit = unit;
  m_isRate = false;
  if (!property("wrong").toBool()) setToolTip(hint());
}

void NumberField::setLengthRate(const std::string& unit) {
  setLengthUnit(unit);
  m_isRate = true;
  if (!property("wrong").toBool()) setToolTip(hint());
}

void NumberField::setQuantity(Quantity quantity, const Rational& shownIn) {
  m_quantity = quantity;
  m_shownIn = shownIn;
}

void NumberField::setEmptyText(const QString& text) {
  lineEdit()->setPlaceholderText(text);
}

QString NumberField::hint() const {
  if (!m_unit) return {};
  if (m_isRate) {
    return tr("In %1/s; a speed with another unit, such as 2 m/s or 30 in/min, is converted.")
        .arg(QString::fromStdString(*m_unit).toHtmlEscaped());
  }
  return tr("In %1; a length with another unit, such as 1/2 in or 2.5 cm, is converted.")
      .arg(QString::fromStdString(*m_unit).toHtmlEscaped());
}

/// A length with or without "/s" or "/min" behind it.
std::optional<Number> NumberField::readRate(const std::string& typed) const {
  for (const auto& [ending, seconds] : {std::pair("/s", 1), std::pair("/min", 60)}) {
    const std::string_view end(ending);
    if (!typed.ends_with(end)) continue;
    const std::string length = typed.substr(0, typed.size() - end.size());
    if (length.empty() || !std::isalpha(static_cast<unsigned char>(length.back()))) continue;
    const auto number = lengthFromText(length, *m_unit);
    return number && seconds != 1 ? Number(number->exact() / Rational(seconds)) : number;
  }
  return lengthFromText(typed, *m_unit);
}

std::optional<Number> NumberField::read(const QString& text) const {
  QString point = text.trimmed();
  // Where a comma may group thousands, "1,000" could mean either.
  static const QRegularExpression kGrouped(QStringLiteral("^[-+]?[1-9][0-9]{0,2},[0-9]{3}$"));
  const bool isDecimal = QLocale().decimalPoint() == QLatin1String(",") || !kGrouped.match(point).hasMatch();
  if (isDecimal && !point.contains(QLatin1Char('.'))) point.replace(QLatin1Char(','), QLatin1Char('.'));
  const std::string typed = point.toStdString();
  if (m_unit) return m_isRate ? readRate(typed) : lengthFromText(typed, *m_unit);
  if (auto number = typedNumber(typed)) return number;
  const auto quantity = withUnitFromText(typed, m_quantity);
  return quantity && m_shownIn != Rational(1) ? Number(quantity->exact() / m_shownIn) : quantity;
}

void NumberField::setNumber(const std::optional<Number>& number) {
  m_number = number;
  const auto typed = read(text());
  const bool beingTyped = hasFocus() && typed && number && typed->exact() == number->exact();
  if (beingTyped || (hasFocus() && m_isPending)) return;
  if (hasFocus() && property("wrong").toBool()) return;
  showNumber();
  setWrong({});
}

void NumberField::showNumber() {
  lineEdit()->setText(m_number ? textOf(*m_number) : QString());
}

QVariant NumberField::value() const {
  return m_number ? QVariant(m_number->value()) : QVariant();
}

void NumberField::setValue(const QVariant& value) {
  if (isReadOnly()) return;
  lineEdit()->setText(QString::number(value.toDouble(), 'g', QLocale::FloatingPointShortest));
  onText(text());
  commit();
}

QString NumberField::objectionTo(const std::optional<Number>& number) const {
  if (m_least) {
    const bool fits = number && number->exact().isInteger() && number->exact() >= Rational(*m_least) &&
                      number->exact() <= Rational(*m_most);
    return fits ? QString() : tr("Type a whole number from %1 to %2.").arg(*m_least).arg(*m_most);
  }
  if (number) return {};
  if (m_isRate) return tr("Type a speed such as 12, 2*3, 2 m/s or 30 in/min.");
  if (m_unit) return tr("Type a number such as 12, 0.5, 22/7 or 2*3, or a length such as 1/2 in.");
  switch (m_quantity) {
    case Quantity::number:
      break;
    case Quantity::angle:
      return tr("Type an angle such as 30, 2*15, 0.5 rad or 1/4 turns.");
    case Quantity::speed:
      return tr("Type a speed such as 12, 2*3, 90 deg/s or 1500 rpm.");
    case Quantity::torque:
      return tr("Type a torque such as 12, 2*3, 5 N cm, 3 lbf ft or 2 kW @ 1500 rpm.");
    case Quantity::force:
      return tr("Type a force such as 12, 2*3 or 5 kN.");
  }
  return tr("Type a number such as 12, 0.5, 22/7 or 2*3.");
}

/// What is being typed need not be a number yet: only what is right again changes the field's style.
void NumberField::onText(const QString& typed) {
  m_isPending = true;
  m_pause.start();
  if (objectionTo(read(typed)).isEmpty()) setWrong({});
}

void NumberField::commit() {
  m_pause.stop();
  if (!std::exchange(m_isPending, false)) return;
  const bool isEmpty = text().trimmed().isEmpty() && m_optional;
  const std::optional<Number> number = isEmpty ? std::nullopt : read(text());
  const QString objection = isEmpty ? QString() : objectionTo(number);
  setWrong(objection);
  const bool isSame =
      number.has_value() == m_number.has_value() && (!number || number->exact() == m_number->exact());
  if (objection.isEmpty() && !isSame) tellOf(number);
}

void NumberField::tellOf(const std::optional<Number>& number) {
  m_before = std::exchange(m_number, number);
  m_isCommitting = true;
  emit edited(number);
  m_isCommitting = false;
}

/// Back to the document's number.
void NumberField::drop() {
  m_pause.stop();
  m_isPending = false;
  showNumber();
  setWrong({});
}

void NumberField::reject(const QString& why) {
  if (m_isCommitting) m_number = m_before;
  setWrong(why);
}

void NumberField::setWrong(const QString& why) {
  setToolTip(why.isEmpty() ? hint() : why);
  if (property("wrong").toBool() == !why.isEmpty()) return;
  markWrong(!why.isEmpty());
  emit wrongChanged(why);
}

void NumberField::markWrong(bool isWrong) {
  setProperty("wrong", isWrong);
  update();
}

void NumberField::stepBy(int steps) {
  if (!isEnabled() || isReadOnly()) return;
  commit();
  Rational value = m_number ? m_number->exact() : Rational(0);
  value += m_step * Rational(steps);
  if (m_least && value < Rational(*m_least)) value = Rational(*m_least);
  if (m_most && value > Rational(*m_most)) value = Rational(*m_most);
  if (m_number && value == m_number->exact()) return;
  setWrong({});
  lineEdit()->setText(textOf(Number(value)));
  tellOf(Number(value));
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

/// Of undo and redo the line of text takes only what is not committed yet; all else is the document's.
bool NumberField::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && !m_isPending) {
    auto* key = static_cast<QKeyEvent*>(event);
    if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
      event->ignore();
      return false;
    }
  }
  return QAbstractSpinBox::event(event);
}

void NumberField::keyPressEvent(QKeyEvent* event) {
  const bool isReturn = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  const bool isHistory = event->matches(QKeySequence::Undo) || event->matches(QKeySequence::Redo);
  if (isHistory && !m_isPending) return event->ignore();
  if (event->key() == Qt::Key_Escape && (m_isPending || property("wrong").toBool())) return drop();
  if (isReturn) commit();
  QAbstractSpinBox::keyPressEvent(event);
  if (isReturn) emit editingStarted();  // what is typed next is another step of the history
}

void NumberField::focusInEvent(QFocusEvent* event) {
  QAbstractSpinBox::focusInEvent(event);
  m_selectOnRelease = event->reason() == Qt::MouseFocusReason;
  emit editingStarted();
}

void NumberField::focusOutEvent(QFocusEvent* event) {
  QAbstractSpinBox::focusOutEvent(event);
  const bool wasPending = m_isPending;
  commit();
  showNumber();
  if (!wasPending) return setWrong({});
  // Why the number was not taken stays to be read beside the field, which shows the document's again.
  if (property("wrong").toBool()) markWrong(false);
}

}  // namespace geargraph

#include "moc_number_field.cpp"
