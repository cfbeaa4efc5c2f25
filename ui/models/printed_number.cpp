#include "ui/models/printed_number.h"

#include "core/foundations/base/spoken.h"

namespace geargraph::inline models {
namespace {

constexpr int kLongestFraction = 9;  // characters; longer ones are told in digits

}  // namespace

QString withPrintedMinus(QString text) {
  return text.replace(QLatin1Char('-'), QStringLiteral("−"));
}

QString printedNumber(double value, int digits, char format) {
  return withPrintedMinus(
      QString::fromStdString(spokenNumber(QByteArray::number(value, format, digits).toStdString())));
}

QString printedFraction(const Rational& value) {
  const std::string text = value.toString();
  if (static_cast<int>(text.size()) > kLongestFraction) return printedNumber(value.toDouble());
  return withPrintedMinus(QString::fromStdString(text));
}

}  // namespace geargraph::inline models
