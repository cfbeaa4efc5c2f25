#include "core/matroid/base_counter.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "core/matroid/base_sweep.h"

namespace geargraph {
namespace {

using Residue = PrimeField::Residue;

/// [I; A] with a weight for each element: the sum over all bases of the product of their elements' weights is
/// sought.
struct Weighted {
  int columns = 0;                         ///< elements of the basis that I stands for
  std::vector<std::vector<Residue>> rows;  ///< A, dense
  std::vector<Rational> rowWeights;
  std::vector<Rational> columnWeights;
  std::vector<int> rowOrder;
  std::vector<int> columnOrder;
};

/// The dual: transposed, weights inverted; its sum times the product of all weights is the sum.
Weighted dual(const Weighted& of, Rational& factor) {
  Weighted result;
  result.columns = static_cast<int>(of.rows.size());
  result.rows.assign(static_cast<std::size_t>(of.columns), std::vector<Residue>(of.rows.size()));
  for (std::size_t i = 0; i < of.rows.size(); ++i) {
    for (int j = 0; j < of.columns; ++j) result.rows[j][i] = of.rows[i][j];
  }
  const auto invert = [&](const std::vector<Rational>& weights) {
    std::vector<Rational> inverted;
    for (const Rational& weight : weights) {
      factor *= weight;
      inverted.push_back(weight.inverse());
    }
    return inverted;
  };
  result.columnWeights = invert(of.rowWeights);
  result.rowWeights = invert(of.columnWeights);
  result.columnOrder = of.rowOrder;
  result.rowOrder = of.columnOrder;
  return result;
}

class Counter {
 public:
  Counter(const PrimeField& field, const std::stop_token& stop) : m_field(field), m_stop(stop) {}

  /// Nothing once the work is over the budget.
  std::optional<Rational> count(Weighted matroid) {
    Rational product = 1;
    if (!reduce(matroid, product)) return std::nullopt;
    if (matroid.columns == 0) return product;
    for (Weighted& part : componentsOf(matroid)) {
      if (static_cast<int>(part.rows.size()) < part.columns) part = dual(part, product);
      const auto value = BaseSweep(m_field, representationOf(part)).count(m_steps, m_stop);
      if (!value) return std::nullopt;
      product *= *value;
    }
    return product;
  }

 private:
  /// True while there is budget.
  bool spend(const Weighted& matroid) {
    m_steps -= static_cast<long>(matroid.rows.size() + 1) * (matroid.columns + 1);
    return m_steps > 0 && !m_stop.stop_requested();
  }

  /// Merges parallel and series elements until there are none; loops and coloops go with them.
  bool reduce(Weighted& matroid, Rational& factor) {
    for (;;) {
      if (!spend(matroid)) return false;
      bool changed = mergeParallel(matroid);
      Rational dualFactor = 1;
      Weighted turned = dual(matroid, dualFactor);
      if (mergeParallel(turned)) {
        changed = true;
        factor *= dualFactor;
        matroid = dual(turned, factor);
      }
      if (!changed) return true;
    }
  }

  /// Drops zero rows, adds proportional rows and rows with one non-zero to their partners. True if any was.
  bool mergeParallel(Weighted& matroid) {
    std::map<std::vector<Residue>, std::size_t> known;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < matroid.rows.size(); ++i) {
      std::vector<Residue> row = std::move(matroid.rows[i]);
      const auto first = std::find_if(row.begin(), row.end(), [](Residue value) { return value != 0; });
      if (first == row.end()) continue;
      if (std::all_of(first + 1, row.end(), [](Residue value) { return value == 0; })) {
        matroid.columnWeights[static_cast<std::size_t>(first - row.begin())] += matroid.rowWeights[i];
        continue;
      }
      const Residue inverse = m_field.inverse(*first);
      for (Residue& value : row) value = m_field.multiply(value, inverse);
      const auto [place, isNew] = known.try_emplace(row, kept);
      if (!isNew) {
        matroid.rowWeights[place->second] += matroid.rowWeights[i];
        continue;
      }
      matroid.rowWeights[kept] = matroid.rowWeights[i];
      matroid.rowOrder[kept] = matroid.rowOrder[i];
      matroid.rows[kept++] = std::move(row);
    }
    const bool changed = kept != matroid.rows.size();
    matroid.rows.resize(kept);
    matroid.rowWeights.resize(kept);
    matroid.rowOrder.resize(kept);
    return changed;
  }

  static std::vector<Weighted> componentsOf(const Weighted& matroid) {
    std::vector<int> up(static_cast<std::size_t>(matroid.columns));
    std::iota(up.begin(), up.end(), 0);
    const auto root = [&](int column) {
      while (up[column] != column) column = up[column] = up[up[column]];
      return column;
    };
    const auto firstOf = [](const std::vector<Residue>& row) {
      return static_cast<int>(std::find_if(row.begin(), row.end(), [](Residue v) { return v != 0; }) -
                              row.begin());
    };
    for (const auto& row : matroid.rows) {
      const int first = firstOf(row);
      for (int j = first + 1; j < matroid.columns; ++j) {
        if (row[j] != 0) up[root(j)] = root(first);
      }
    }
    std::map<int, std::size_t> partOf;
    std::vector<Weighted> parts;
    std::vector<int> place(static_cast<std::size_t>(matroid.columns));
    for (int j = 0; j < matroid.columns; ++j) {
      const auto [part, isNew] = partOf.try_emplace(root(j), parts.size());
      if (isNew) parts.emplace_back();
      Weighted& of = parts[part->second];
      place[j] = of.columns++;
      of.columnWeights.push_back(matroid.columnWeights[j]);
      of.columnOrder.push_back(matroid.columnOrder[j]);
    }
    for (std::size_t i = 0; i < matroid.rows.size(); ++i) {
      Weighted& of = parts[partOf.at(root(firstOf(matroid.rows[i])))];
      std::vector<Residue> row(static_cast<std::size_t>(of.columns), 0);
      for (int j = 0; j < matroid.columns; ++j) {
        if (matroid.rows[i][j] != 0) row[place[j]] = matroid.rows[i][j];
      }
      of.rows.push_back(std::move(row));
      of.rowWeights.push_back(matroid.rowWeights[i]);
      of.rowOrder.push_back(matroid.rowOrder[i]);
    }
    return parts;
  }

  /// A vector per element, in the common order.
  Representation representationOf(const Weighted& part) const {
    std::vector<std::pair<int, int>> elements;  // order, and row i or column ~j
    for (std::size_t i = 0; i < part.rows.size(); ++i)
      elements.emplace_back(part.rowOrder[i], static_cast<int>(i));
    for (int j = 0; j < part.columns; ++j) elements.emplace_back(part.columnOrder[j], ~j);
    std::sort(elements.begin(), elements.end());
    Representation result;
    result.rank = part.columns;
    for (const auto& [order, element] : elements) {
      if (element >= 0) {
        result.vectors.push_back(part.rows[element]);
        result.weights.push_back(part.rowWeights[element]);
      } else {
        std::vector<Residue> unit(static_cast<std::size_t>(part.columns), 0);
        unit[static_cast<std::size_t>(~element)] = m_field.one();
        result.vectors.push_back(std::move(unit));
        result.weights.push_back(part.columnWeights[static_cast<std::size_t>(~element)]);
      }
    }
    return result;
  }

  const PrimeField& m_field;
  std::stop_token m_stop;
  long m_steps = 40'000'000;  ///< that are left
};

/// Splits sparse rows into dense matroids of connected columns.
std::vector<Weighted> denseParts(const std::vector<int>& unitOrder,
                                 const std::vector<std::vector<std::pair<int, Residue>>>& rows,
                                 const std::vector<int>& rowOrder) {
  const int rank = static_cast<int>(unitOrder.size());
  std::vector<int> up(static_cast<std::size_t>(rank));
  std::iota(up.begin(), up.end(), 0);
  const auto root = [&](int column) {
    while (up[column] != column) column = up[column] = up[up[column]];
    return column;
  };
  for (const auto& row : rows) {
    for (const auto& entry : row) up[root(entry.first)] = root(row.front().first);
  }
  std::vector<int> partOf(static_cast<std::size_t>(rank), -1);
  std::vector<int> place(static_cast<std::size_t>(rank));
  std::vector<Weighted> parts;
  for (int j = 0; j < rank; ++j) {
    int& part = partOf[root(j)];
    if (part < 0) {
      part = static_cast<int>(parts.size());
      parts.emplace_back();
    }
    place[j] = parts[part].columns++;
    parts[part].columnWeights.emplace_back(1);
    parts[part].columnOrder.push_back(unitOrder[j]);
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto& row = rows[i];
    Weighted& of = parts[partOf[root(row.front().first)]];
    std::vector<Residue> dense(static_cast<std::size_t>(of.columns), 0);
    for (const auto& [column, value] : row) dense[place[column]] = value;
    of.rows.push_back(std::move(dense));
    of.rowWeights.emplace_back(1);
    of.rowOrder.push_back(rowOrder[i]);
  }
  return parts;
}

}  // namespace

std::optional<Rational> countBases(const PrimeField& field, const std::vector<int>& unitOrder,
                                   const std::vector<std::vector<std::pair<int, Residue>>>& rows,
                                   const std::vector<int>& rowOrder, const std::stop_token& stop) {
  Counter counter(field, stop);
  Rational total = 1;
  for (Weighted& part : denseParts(unitOrder, rows, rowOrder)) {
    if (part.rows.empty()) continue;  // an idle joint: in every set
    const auto count = counter.count(std::move(part));
    if (!count) return std::nullopt;
    total *= *count;
  }
  return total;
}

}  // namespace geargraph
