#include "core/foundations/exact/pi_number.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

/// "pi", "pi^2". @pre power is above 0
std::string powerText(int power) {
  return power == 1 ? "pi" : "pi^" + std::to_string(power);
}

std::string termText(const Rational& factor, int power) {
  if (power < 0) return factor.toString() + "/" + powerText(-power);
  if (power == 0) return factor.toString();
  if (factor == Rational(1)) return powerText(power);
  if (factor == Rational(-1)) return "-" + powerText(power);
  return factor.toString() + "*" + powerText(power);
}

}  // namespace

PiNumber::PiNumber(const Rational& value, int power) {
  if (!value.isZero()) m_terms.push_back({power, value});
}

bool PiNumber::isRational() const {
  return m_terms.empty() || (m_terms.size() == 1 && m_terms.front().power == 0);
}

Rational PiNumber::rational() const {
  GEARGRAPH_REQUIRE(isRational());
  return m_terms.empty() ? Rational(0) : m_terms.front().factor;
}

double PiNumber::toDouble() const {
  if (isRational()) return m_terms.empty() ? 0 : m_terms.front().factor.toDouble();
  double sum = 0;
  for (const Term& term : m_terms) sum += term.factor.toDouble() * std::pow(std::numbers::pi, term.power);
  return sum;
}

std::string PiNumber::toString() const {
  std::string text;
  for (const Term& term : m_terms) {
    const bool isNegative = term.factor.sign() < 0;
    if (text.empty()) {
      text = termText(term.factor, term.power);
    } else {
      text += (isNegative ? " - " : " + ") + termText(term.factor.abs(), term.power);
    }
  }
  return text.empty() ? "0" : text;
}

PiNumber& PiNumber::operator+=(const PiNumber& other) {
  for (const Term& term : other.m_terms) {
    const auto at = std::lower_bound(m_terms.begin(), m_terms.end(), term.power,
                                     [](const Term& each, int power) { return each.power > power; });
    if (at == m_terms.end() || at->power != term.power) {
      m_terms.insert(at, term);
      continue;
    }
    at->factor += term.factor;
    if (at->factor.isZero()) m_terms.erase(at);
  }
  return *this;
}

PiNumber& PiNumber::operator*=(const PiNumber& other) {
  PiNumber product;
  for (const Term& a : m_terms) {
    for (const Term& b : other.m_terms) product += PiNumber(a.factor * b.factor, a.power + b.power);
  }
  return *this = std::move(product);
}

bool operator<(const PiNumber& a, const PiNumber& b) {
  if (a.isRational() && b.isRational()) return a.rational() < b.rational();
  return a.toDouble() < b.toDouble();
}

}  // namespace geargraph
