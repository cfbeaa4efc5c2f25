#include "core/theory/matroid/basis_count.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>

#include "core/theory/matroid/basis_sweep.h"

namespace geargraph {
namespace {

using Residue = PrimeField::Residue;
using SparseRow = std::vector<std::pair<int, Residue>>;  // by ascending column

/// [I; A] with a weight for each element: the sum over all bases of the product of their elements' weights is
/// sought. A is sparse; merging elements only takes rows and columns away.
struct Weighted {
  int columns = 0;  ///< elements of the basis that I stands for
  std::vector<SparseRow> rows;
  std::vector<Rational> rowWeights;
  std::vector<Rational> columnWeights;
  std::vector<int> rowOrder;
  std::vector<int> columnOrder;
};

/// The dual: transposed, weights inverted; its sum times the product of all weights is the sum.
Weighted dual(const Weighted& of, Rational& factor) {
  Weighted result;
  result.columns = static_cast<int>(of.rows.size());
  result.rows.resize(static_cast<std::size_t>(of.columns));
  for (std::size_t i = 0; i < of.rows.size(); ++i) {
    for (const auto& [column, value] : of.rows[i])
      result.rows[column].emplace_back(static_cast<int>(i), value);
  }
  const auto invert = [&](const std::vector<Rational>& weights) {
    std::vector<Rational> inverted;
    inverted.reserve(weights.size());
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
  std::optional<Rational> count(const Weighted& matroid) {
    Rational product = 1;
    for (Weighted& part : componentsOf(matroid)) {
      if (!reduce(part, product)) return std::nullopt;
      if (part.columns == 0) continue;
      if (static_cast<int>(part.rows.size()) < part.columns) part = dual(part, product);
      const auto value = sweep(part);
      if (!value) return std::nullopt;
      product *= *value;
    }
    return product;
  }

 private:
  /// True while there is budget.
  bool spend(std::size_t steps) {
    m_steps -= static_cast<long>(steps);
    return m_steps > 0 && !m_stop.stop_requested();
  }

  /// Merges parallel and series elements until there are none; loops and coloops go with them.
  bool reduce(Weighted& matroid, Rational& factor) {
    for (;;) {
      std::size_t entries = matroid.rows.size() + static_cast<std::size_t>(matroid.columns);
      for (const SparseRow& row : matroid.rows) entries += row.size();
      if (!spend(8 * entries)) return false;
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
  bool mergeParallel(Weighted& matroid) const {
    std::map<SparseRow, std::size_t> known;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < matroid.rows.size(); ++i) {
      SparseRow row = std::move(matroid.rows[i]);
      if (row.empty()) continue;
      if (row.size() == 1) {
        matroid.columnWeights[row.front().first] += matroid.rowWeights[i];
        continue;
      }
      if (row.front().second != m_field.one()) {
        const Residue inverse = m_field.inverse(row.front().second);
        for (auto& [column, value] : row) value = m_field.multiply(value, inverse);
      }
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

  /// Parts that share no non-zero. Columns without any are coloops of weight 1 at the start: they drop out.
  static std::vector<Weighted> componentsOf(const Weighted& matroid) {
    std::vector<int> up(static_cast<std::size_t>(matroid.columns));
    std::iota(up.begin(), up.end(), 0);
    const auto root = [&](int column) {
      while (up[column] != column) column = up[column] = up[up[column]];
      return column;
    };
    for (const SparseRow& row : matroid.rows) {
      for (const auto& [column, value] : row) up[root(column)] = root(row.front().first);
    }
    std::vector<int> partOf(up.size(), -1);
    std::vector<int> place(up.size());
    std::vector<Weighted> parts;
    for (std::size_t i = 0; i < matroid.rows.size(); ++i) {
      if (matroid.rows[i].empty()) continue;
      int& part = partOf[static_cast<std::size_t>(root(matroid.rows[i].front().first))];
      if (part < 0) {
        part = static_cast<int>(parts.size());
        parts.emplace_back();
      }
      parts[part].rows.push_back(matroid.rows[i]);
      parts[part].rowWeights.push_back(matroid.rowWeights[i]);
      parts[part].rowOrder.push_back(matroid.rowOrder[i]);
    }
    for (int j = 0; j < matroid.columns; ++j) {
      const int part = partOf[root(j)];
      if (part < 0) continue;
      place[j] = parts[part].columns++;
      parts[part].columnWeights.push_back(matroid.columnWeights[j]);
      parts[part].columnOrder.push_back(matroid.columnOrder[j]);
    }
    for (Weighted& part : parts) {
      for (SparseRow& row : part.rows) {
        for (auto& [column, value] : row) column = place[column];
      }
    }
    return parts;
  }

  /// What is left once nothing merges may fall apart again; each piece is swept.
  std::optional<Rational> sweep(const Weighted& part) {
    Rational product = 1;
    for (const Weighted& piece : componentsOf(part)) {
      const auto value = sweepInSomeOrder(piece);
      if (!value) return std::nullopt;
      product *= *value;
    }
    return product;
  }

  /// Nobody knows beforehand which order keeps the states few, so both are tried with growing patience.
  std::optional<Rational> sweepInSomeOrder(const Weighted& piece) {
    constexpr long kFirstPatience = 1'000'000;
    const std::array orders{representationOf(piece, neighbourly(piece)),
                            representationOf(piece, labelled(piece))};
    for (long patience = kFirstPatience; patience < m_steps; patience *= 4) {
      for (const Representation& elements : orders) {
        long steps = patience;
        auto value = FrontierBasisCounter(m_field, elements).count(steps, m_stop);
        m_steps -= patience - steps;
        if (value) return value;
        if (m_stop.stop_requested()) return std::nullopt;
      }
    }
    return std::nullopt;
  }

  /// The elements of a piece, row i or column ~j, from neighbour to neighbour: breadth first over the
  /// non-zeros from an element with few, so that what is undecided at a time hangs together with few of the
  /// rest.
  static std::vector<int> neighbourly(const Weighted& piece) {
    const int rows = static_cast<int>(piece.rows.size());
    std::vector<std::vector<int>> around(
        static_cast<std::size_t>(rows + piece.columns));  // columns behind the rows
    for (int i = 0; i < rows; ++i) {
      for (const auto& [column, value] : piece.rows[i]) {
        around[i].push_back(rows + column);
        around[rows + column].push_back(i);
      }
    }
    const auto fewer = [&](int a, int b) { return around[a].size() < around[b].size(); };
    for (std::vector<int>& list : around) std::stable_sort(list.begin(), list.end(), fewer);
    std::vector<int> order;
    for (int round = 0; round < 2; ++round) {  // once to find an end, once from there
      const int start = order.empty() ? 0 : order.back();
      std::vector<char> seen(around.size(), 0);
      order.assign(1, start);
      seen[start] = 1;
      for (std::size_t at = 0; at < order.size(); ++at) {
        for (const int next : around[order[at]]) {
          if (seen[next] != 0) continue;
          seen[next] = 1;
          order.push_back(next);
        }
      }
    }
    for (int& element : order) {
      if (element >= rows) element = ~(element - rows);
    }
    return order;
  }

  /// The elements by their places in the common order.
  static std::vector<int> labelled(const Weighted& piece) {
    std::vector<std::pair<int, int>> elements;
    for (std::size_t i = 0; i < piece.rows.size(); ++i)
      elements.emplace_back(piece.rowOrder[i], static_cast<int>(i));
    for (int j = 0; j < piece.columns; ++j) elements.emplace_back(piece.columnOrder[j], ~j);
    std::sort(elements.begin(), elements.end());
    std::vector<int> order;
    for (const auto& [place, element] : elements) order.push_back(element);
    return order;
  }

  /// A vector per element, in this order.
  [[nodiscard]] Representation representationOf(const Weighted& piece, const std::vector<int>& order) const {
    Representation result;
    result.rank = piece.columns;
    for (const int element : order) {
      if (element >= 0) {
        result.vectors.push_back(piece.rows[element]);
        result.weights.push_back(piece.rowWeights[element]);
      } else {
        result.vectors.push_back({{~element, m_field.one()}});
        result.weights.push_back(piece.columnWeights[static_cast<std::size_t>(~element)]);
      }
    }
    return result;
  }

  const PrimeField& m_field;
  std::stop_token m_stop;
  long m_steps = 150'000'000;  ///< that are left
};

}  // namespace

std::optional<Rational> countBases(const PrimeField& field, const std::vector<int>& unitOrder,
                                   const std::vector<SparseRow>& rows, const std::vector<int>& rowOrder,
                                   const std::stop_token& stop) {
  Weighted matroid;
  matroid.columns = static_cast<int>(unitOrder.size());
  matroid.rows = rows;
  matroid.rowWeights.assign(rows.size(), 1);
  matroid.columnWeights.assign(unitOrder.size(), 1);
  matroid.rowOrder = rowOrder;
  matroid.columnOrder = unitOrder;
  return Counter(field, stop).count(matroid);
}

}  // namespace geargraph
