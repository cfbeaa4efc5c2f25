#include "ui/models/printed_number.h"

#include "core/foundations/base/locale.h"
#include "core/foundations/base/readable.h"

namespace geargraph {
QString withPrintedMinus(QString text) {
  return text.replace(QLatin1Char('-'), QStringLiteral("−"));
}

QString printedNumber(double value, int digits, char format) {
  return withPrintedMinus(
      QString::fromStdString(localizedNumber(QByteArray::number(value, format, digits).toStdString())));
}

QString printedFraction(const Rational& value) {
  return withPrintedMinus(QString::fromStdString(readableNumber(value)));
}

QString printedExact(const PiNumber& value) {
  if (value.isRational()) return printedFraction(value.rational());
  QString text = QString::fromStdString(value.toString());
  text.replace(QStringLiteral("pi"), QStringLiteral("π")).replace(QLatin1Char('*'), QStringLiteral("·"));
  return withPrintedMinus(text);
}

}  // namespace geargraph
