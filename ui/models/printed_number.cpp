#include "ui/models/printed_number.h"

#include "core/foundations/base/readable.h"
#include "core/foundations/base/spoken.h"

namespace geargraph::inline models {
QString withPrintedMinus(QString text) {
  return text.replace(QLatin1Char('-'), QStringLiteral("−"));
}

QString printedNumber(double value, int digits, char format) {
  return withPrintedMinus(
      QString::fromStdString(spokenNumber(QByteArray::number(value, format, digits).toStdString())));
}

QString printedFraction(const Rational& value) {
  return withPrintedMinus(QString::fromStdString(readableNumber(value)));
}

}  // namespace geargraph::inline models
