#include "core/theory/matroid/basis_sweep.h"

#include <algorithm>

namespace geargraph {
namespace {

using Residue = PrimeField::Residue;
using Row = std::vector<std::pair<int, Residue>>;

/// The value of a row at an element.
Residue valueAt(const Row& row, int element) {
  const auto place = std::lower_bound(row.begin(), row.end(), element,
                                      [](const auto& entry, int wanted) { return entry.first < wanted; });
  return place != row.end() && place->first == element ? place->second : 0;
}

/// row - factor * by
Row difference(const PrimeField& field, const Row& row, const Row& by, Residue factor) {
  Row result;
  result.reserve(row.size() + by.size());
  auto mine = row.begin();
  for (const auto& [element, value] : by) {
    for (; mine != row.end() && mine->first < element; ++mine) result.push_back(*mine);
    Residue left = 0;
    if (mine != row.end() && mine->first == element) left = (mine++)->second;
    left = field.subtract(left, field.multiply(factor, value));
    if (left != 0) result.emplace_back(element, left);
  }
  result.insert(result.end(), mine, row.end());
  return result;
}

void scaleToOne(const PrimeField& field, Row& row) {
  const Residue inverse = field.inverse(row.front().second);
  for (auto& [element, value] : row) value = field.multiply(value, inverse);
}

}  // namespace

/// The rows of the given vectors in reduced echelon form, numbered by their first elements.
bool FrontierBasisCounter::begin(long& steps) {
  std::vector<Row> rows(static_cast<std::size_t>(m_given.rank));
  std::vector<std::vector<int>> at(m_given.vectors.size());  // by element: rows that may have it
  for (std::size_t element = 0; element < at.size(); ++element) {
    for (const auto& [place, value] : m_given.vectors[element]) {
      rows[place].emplace_back(static_cast<int>(element), value);
      at[element].push_back(place);
    }
  }
  std::vector<char> placed(rows.size(), 0);
  std::vector<int> order;
  for (int element = 0; element < static_cast<int>(at.size()); ++element) {
    int pivot = -1;
    for (const int place : at[static_cast<std::size_t>(element)]) {
      if (placed[place] != 0 || valueAt(rows[place], element) == 0) continue;
      if (pivot < 0 || rows[place].size() < rows[pivot].size()) pivot = place;
    }
    if (pivot < 0) continue;
    placed[pivot] = 1;
    order.push_back(pivot);
    scaleToOne(m_field, rows[pivot]);
    for (const int place : std::vector<int>(at[static_cast<std::size_t>(element)])) {
      const Residue factor = valueAt(rows[place], element);
      if (place == pivot || factor == 0) continue;
      steps -= static_cast<long>(rows[place].size() + rows[pivot].size());
      if (steps <= 0) return false;
      for (const auto& [filled, value] : rows[pivot]) {
        if (valueAt(rows[place], filled) == 0) at[filled].push_back(place);
      }
      rows[place] = difference(m_field, rows[place], rows[pivot], factor);
    }
  }
  for (const int place : order) (void)numberOf(std::move(rows[place]));
  return true;
}

int FrontierBasisCounter::numberOf(Row row) {
  const auto [place, isNew] = m_numbers.try_emplace(std::move(row), static_cast<int>(m_rows.size()));
  if (isNew) m_rows.push_back(&place->first);
  return place->second;
}

std::optional<Rational> FrontierBasisCounter::count(long& steps, const std::stop_token& stop) {
  constexpr long kState = 16;  // what one costs beside its rows
  if (!begin(steps)) return std::nullopt;
  States states;
  states.emplace(State(), 1);
  const int elements = static_cast<int>(m_given.vectors.size());
  for (int element = 0; element < elements && !states.empty(); ++element) {
    States next;
    for (const auto& [state, weight] : states) {
      steps -= kState + static_cast<long>(state.changed.size());
      if (steps <= 0 || stop.stop_requested()) return std::nullopt;
      decide(state, element, weight, next, steps);
    }
    states = std::move(next);
  }
  for (const auto& [state, weight] : states) m_total += weight;  // of rank 0, behind the last element
  return m_total;
}

void FrontierBasisCounter::decide(const State& state, int element, const Rational& weight, States& next,
                                  long& steps) {
  if (rowsOf(state) <= 2) {
    m_total += weight * closedForm(state, element);
    return;
  }
  if (row(numberAt(state, 0)).front().first != element) {  // a loop: never in a basis
    next[state] += weight;
    return;
  }
  State contracted = state;
  dropFirst(contracted);
  fold(contracted);
  next[std::move(contracted)] += weight * m_given.weights[static_cast<std::size_t>(element)];
  if (auto without = deleted(state, steps)) next[std::move(*without)] += weight;
}

void FrontierBasisCounter::dropFirst(State& state) {
  if (state.changed.empty()) {
    ++state.next;
  } else {
    state.changed.erase(state.changed.begin());
  }
}

void FrontierBasisCounter::fold(State& state) {
  while (!state.changed.empty() && state.changed.back() == state.next - 1) {
    state.changed.pop_back();
    --state.next;
  }
}

/// The state without the first row's first element: that row finds a new place, the others stay reduced
/// against each other. Nothing where the row has no other element: then that one is in every basis.
std::optional<FrontierBasisCounter::State> FrontierBasisCounter::deleted(State state, long& steps) {
  const Row& first = row(numberAt(state, 0));
  if (first.size() == 1) return std::nullopt;
  Row left(first.begin() + 1, first.end());
  scaleToOne(m_field, left);
  const int leading = left.front().first;
  dropFirst(state);
  while (state.next < m_given.rank && row(state.next).front().first < leading) {
    state.changed.push_back(state.next++);
  }
  auto place = state.changed.begin();
  for (; place != state.changed.end() && row(*place).front().first < leading; ++place) {
    const Residue factor = valueAt(row(*place), leading);
    if (factor == 0) continue;
    steps -= static_cast<long>(row(*place).size() + left.size());
    *place = numberOf(difference(m_field, row(*place), left, factor));
  }
  state.changed.insert(place, numberOf(std::move(left)));
  fold(state);
  return state;
}

/// Rank 0: 1. Rank 1: the weights of all that are no loops. Rank 2: of all pairs that are not parallel.
Rational FrontierBasisCounter::closedForm(const State& state, int element) const {
  const int rows = rowsOf(state);
  if (rows == 0) return 1;
  const Row& first = row(numberAt(state, 0));
  const Row& second = rows == 2 ? row(numberAt(state, 1)) : first;
  Rational sum;
  std::map<Residue, Rational> byPoint;  // the second coordinate over the first; 0 in the first: apart
  Rational apart;
  for (int of = element; of < static_cast<int>(m_given.vectors.size()); ++of) {
    const Residue x = valueAt(first, of);
    const Residue y = valueAt(second, of);
    if (x == 0 && y == 0) continue;
    const Rational& weight = m_given.weights[static_cast<std::size_t>(of)];
    sum += weight;
    if (rows == 2) (x == 0 ? apart : byPoint[m_field.multiply(y, m_field.inverse(x))]) += weight;
  }
  if (rows == 1) return sum;
  Rational squares = apart * apart;
  for (const auto& [point, together] : byPoint) squares += together * together;
  return (sum * sum - squares) / Rational(2);
}

}  // namespace geargraph
