#include "ui/models/printed_number.h"

#include "core/foundations/base/spoken.h"

namespace geargraph::inline models {
namespace {

constexpr int kLongestFraction = 9;  // characters; longer ones are told in digits

QString withPrintedMinus(QString text) {
  return text.replace(QLatin1Char('-'), QStringLiteral("−"));
}

}  // namespace

QString printedNumber(double value) {
  return withPrintedMinus(
      QString::fromStdString(spokenNumber(QByteArray::number(value, 'g', 6).toStdString())));
}

QString printedFraction(const Rational& value) {
  const std::string text = value.toString();
  if (static_cast<int>(text.size()) > kLongestFraction) return printedNumber(value.toDouble());
  return withPrintedMinus(QString::fromStdString(text));
}

}  // namespace geargraph::inline models
