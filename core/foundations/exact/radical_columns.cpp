#include "core/foundations/exact/radical_columns.h"

#include <cmath>

#include "core/foundations/base/contract.h"

namespace geargraph {

void RadicalColumns::add(int place, const Rational& coefficient, const Rational& square) {
  if (coefficient.isZero()) return;
  Column* to = nullptr;
  Rational factor = coefficient;
  for (Column& column : m_columns) {
    const auto root = (square / column.square).squareRoot();
    if (!root) continue;
    to = &column;
    factor *= *root;
    break;
  }
  if (to == nullptr) to = &m_columns.emplace_back(Column{square, {}});
  Rational& entry = to->entries[place];
  entry += factor;
  if (entry.isZero()) to->entries.erase(place);
}

Real RadicalColumns::sumOf(std::span<const Rational> parts) const {
  GEARGRAPH_REQUIRE(parts.size() == m_columns.size());
  Real sum = parts[0];
  for (std::size_t k = 1; k < parts.size(); ++k) {
    if (parts[k].isZero()) continue;
    sum += Real::inexact(parts[k].toDouble() * std::sqrt(m_columns[k].square.toDouble()));
  }
  return sum;
}

Real RadicalColumns::at(int place) const {
  std::vector<Rational> parts;
  for (const Column& column : m_columns) {
    const auto found = column.entries.find(place);
    parts.push_back(found == column.entries.end() ? Rational(0) : found->second);
  }
  return sumOf(parts);
}

}  // namespace geargraph
