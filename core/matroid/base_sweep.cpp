#include "core/matroid/base_sweep.h"

#include <algorithm>

namespace geargraph {
namespace {

using Residue = PrimeField::Residue;

Residue* rowAt(std::vector<Residue>& state, int row, int width) {
  return state.data() + static_cast<std::ptrdiff_t>(row) * width;
}
const Residue* rowAt(const std::vector<Residue>& state, int row, int width) {
  return state.data() + static_cast<std::ptrdiff_t>(row) * width;
}

/// row -= factor * by, from a column on.
void subtract(const PrimeField& field, Residue* row, const Residue* by, Residue factor, int from, int width) {
  for (int k = from; k < width; ++k) row[k] = field.subtract(row[k], field.multiply(factor, by[k]));
}

/// Reduced echelon form of a full-rank state, in place. Cost: O(rows^2 width).
void reduce(const PrimeField& field, std::vector<Residue>& state, int rows, int width) {
  int done = 0;
  for (int column = 0; column < width && done < rows; ++column) {
    int pivot = done;
    while (pivot < rows && rowAt(state, pivot, width)[column] == 0) ++pivot;
    if (pivot == rows) continue;
    if (pivot != done) {
      std::swap_ranges(rowAt(state, pivot, width), rowAt(state, pivot, width) + width,
                       rowAt(state, done, width));
    }
    Residue* by = rowAt(state, done, width);
    const Residue inverse = field.inverse(by[column]);
    for (int k = column; k < width; ++k) by[k] = field.multiply(by[k], inverse);
    for (int row = 0; row < rows; ++row) {
      Residue* other = rowAt(state, row, width);
      if (row != done && other[column] != 0) subtract(field, other, by, other[column], column, width);
    }
    ++done;
  }
}

}  // namespace

BaseSweep::BaseSweep(const PrimeField& field, const Representation& elements)
    : m_field(field),
      m_elements(static_cast<int>(elements.vectors.size())),
      m_weights(elements.weights),
      m_states(static_cast<std::size_t>(elements.rank) + 1) {
  State all(static_cast<std::size_t>(elements.rank) * elements.vectors.size());
  for (int row = 0; row < elements.rank; ++row) {
    for (int element = 0; element < m_elements; ++element) {
      rowAt(all, row, m_elements)[element] = elements.vectors[element][row];
    }
  }
  geargraph::reduce(field, all, elements.rank, m_elements);
  m_states[static_cast<std::size_t>(elements.rank)].emplace(std::move(all), 1);
}

std::optional<Rational> BaseSweep::count(long& steps, const std::stop_token& stop) {
  for (int element = 0; element < m_elements; ++element) {
    std::vector<States> next(m_states.size());
    for (std::size_t rows = 0; rows < m_states.size(); ++rows) {
      for (const auto& [state, weight] : m_states[rows]) {
        steps -= static_cast<long>(state.size()) + m_elements;
        if (steps <= 0 || stop.stop_requested()) return std::nullopt;
        decide(state, static_cast<int>(rows), element, weight, next);
      }
    }
    m_states = std::move(next);
  }
  return m_total;
}

void BaseSweep::decide(const State& state, int rows, int element, const Rational& weight,
                       std::vector<States>& next) {
  if (rows <= 2) {
    m_total += weight * closedForm(state, rows, element);
    return;
  }
  const int width = m_elements - element;
  const auto add = [&](State left, int rank, const Rational& by) {
    next[static_cast<std::size_t>(rank)][std::move(left)] += by;
  };
  if (state[0] == 0) {  // a loop: never in a basis
    add(deleted(state, rows, width), rows, weight);
    return;
  }
  add(contracted(state, rows, width), rows - 1, weight * m_weights[element]);
  const bool coloop = std::all_of(state.begin() + 1, state.begin() + width, [](Residue v) { return v == 0; });
  if (!coloop) add(deleted(state, rows, width), rows, weight);
}

/// The rows that are 0 at the first element: all but the first, in reduced form.
BaseSweep::State BaseSweep::contracted(const State& state, int rows, int width) const {
  State result;
  result.reserve(static_cast<std::size_t>(rows - 1) * static_cast<std::size_t>(width - 1));
  for (int row = 1; row < rows; ++row) {
    const Residue* from = rowAt(state, row, width);
    result.insert(result.end(), from + 1, from + width);
  }
  return result;
}

/// All rows without the first element: the first one finds a new place, the others stay reduced against each
/// other.
BaseSweep::State BaseSweep::deleted(const State& state, int rows, int width) const {
  const int left = width - 1;
  std::vector<Residue> first(state.begin() + 1, state.begin() + width);
  const bool isPivot = state[0] != 0;
  State result;
  result.reserve(static_cast<std::size_t>(rows) * static_cast<std::size_t>(left));
  if (!isPivot) {
    for (int row = 0; row < rows; ++row) {
      const Residue* from = rowAt(state, row, width);
      result.insert(result.end(), from + 1, from + width);
    }
    return result;
  }
  // It is reduced against the others already; only its own leading column has to go from theirs.
  const int leading = static_cast<int>(
      std::find_if(first.begin(), first.end(), [](Residue v) { return v != 0; }) - first.begin());
  const Residue inverse = m_field.inverse(first[leading]);
  for (Residue& value : first) value = m_field.multiply(value, inverse);
  bool placed = false;
  for (int row = 1; row < rows; ++row) {
    const Residue* from = rowAt(state, row, width) + 1;
    const auto start = std::find_if(from, from + left, [](Residue v) { return v != 0; }) - from;
    if (!placed && leading < start) {
      result.insert(result.end(), first.begin(), first.end());
      placed = true;
    }
    result.insert(result.end(), from, from + left);
    Residue* row0 = result.data() + result.size() - static_cast<std::size_t>(left);
    if (row0[leading] != 0) subtract(m_field, row0, first.data(), row0[leading], leading, left);
  }
  if (!placed) result.insert(result.end(), first.begin(), first.end());
  return result;
}

/// Rank 0: 1. Rank 1: the weights of all that are no loops. Rank 2: of all pairs that are not parallel.
Rational BaseSweep::closedForm(const State& state, int rows, int element) const {
  if (rows == 0) return 1;
  const int width = m_elements - element;
  Rational sum;
  Rational squares;
  std::map<Residue, Rational> byPoint;  // the second coordinate over the first; 0 in the first: apart
  Rational apart;
  for (int k = 0; k < width; ++k) {
    const Residue x = state[k];
    const Residue y = rows == 2 ? state[static_cast<std::size_t>(width) + k] : 0;
    if (x == 0 && y == 0) continue;
    const Rational& weight = m_weights[static_cast<std::size_t>(element) + k];
    sum += weight;
    if (rows == 1) continue;
    (x == 0 ? apart : byPoint[m_field.multiply(y, m_field.inverse(x))]) += weight;
  }
  if (rows == 1) return sum;
  squares = apart * apart;
  for (const auto& [point, weight] : byPoint) squares += weight * weight;
  return (sum * sum - squares) / Rational(2);
}

}  // namespace geargraph
