#include "core/teaching/grading/conditions.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

using Fields = std::vector<const ReadField*>;
using Row = std::vector<std::string>;

Fields fieldsOf(const Condition& condition, const ReadAnswer& answer) {
  Fields fields;
  for (const int field : condition.fields) fields.push_back(&answer[static_cast<std::size_t>(field)]);
  if (condition.fields.empty()) {
    for (const ReadField& field : answer) fields.push_back(&field);
  }
  return fields;
}

bool isReadable(const Fields& fields) {
  return std::all_of(fields.begin(), fields.end(),
                     [](const ReadField* field) { return field->fault == AnswerFault::none; });
}

bool isNumeric(const Fields& fields) {
  return std::all_of(fields.begin(), fields.end(), [](const ReadField* field) {
    return field->fault == AnswerFault::none && !field->isEmpty &&
           (field->kind == FieldKind::integer || field->kind == FieldKind::number);
  });
}

bool readLike(const Fields& fields, const Row& row) {
  GEARGRAPH_REQUIRE(row.size() == fields.size());
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (!fields[i]->readsLike(row[i])) return false;
  }
  return true;
}

bool readLikeOne(const Fields& fields, const std::vector<Row>& rows) {
  return std::any_of(rows.begin(), rows.end(), [&](const Row& row) { return readLike(fields, row); });
}

Rational numberOf(const std::string& text) {
  return *Rational::fromText(text);
}

std::vector<Rational> numbersOf(std::span<const std::string> texts) {
  std::vector<Rational> numbers;
  for (const std::string& text : texts) numbers.push_back(numberOf(text));
  return numbers;
}

bool isMultiple(const Fields& fields, const Row& row) {
  const std::vector<Rational> expected = numbersOf(row);
  const auto pivot =
      std::find_if(expected.begin(), expected.end(), [](const Rational& v) { return !v.isZero(); });
  if (!isNumeric(fields) || pivot == expected.end()) return false;
  const Rational factor = fields[static_cast<std::size_t>(pivot - expected.begin())]->number.value / *pivot;
  if (factor.isZero()) return false;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (!fields[i]->number.agreesWith(factor * expected[i])) return false;
  }
  return true;
}

bool areRows(const Fields& fields, const std::vector<Row>& rows) {
  if (!isNumeric(fields) || rows.empty()) return false;
  const std::size_t width = rows.front().size();
  std::vector<char> used(rows.size(), 0);
  for (std::size_t first = 0; first < fields.size(); first += width) {
    const auto isRow = [&](const Row& row, int sign) {
      for (std::size_t i = 0; i < width; ++i) {
        if (fields[first + i]->number.value != Rational(sign) * numberOf(row[i])) return false;
      }
      return true;
    };
    std::size_t found = rows.size();
    for (std::size_t i = 0; i < rows.size() && found == rows.size(); ++i) {
      if (used[i] == 0 && (isRow(rows[i], 1) || isRow(rows[i], -1))) found = i;
    }
    if (found == rows.size()) return false;
    used[found] = 1;
  }
  return fields.size() == width * rows.size();
}

bool contains(const Row& row, const std::string& text) {
  return std::find(row.begin(), row.end(), text) != row.end();
}

/// How many edges of the set join parts that others of the set do not; and the nodes of the graph.
struct Joined {
  std::size_t joining = 0;
  std::size_t nodes = 0;
};

Joined joinedBy(const Row& set, const std::vector<Row>& edges) {
  std::map<std::string, int> nodes;
  for (const Row& edge : edges) {
    nodes.try_emplace(edge[1], static_cast<int>(nodes.size()));
    nodes.try_emplace(edge[2], static_cast<int>(nodes.size()));
  }
  std::vector<int> above(nodes.size());
  std::iota(above.begin(), above.end(), 0);
  const auto rootOf = [&](const std::string& node) {
    int at = nodes.at(node);
    while (above[static_cast<std::size_t>(at)] != at) at = above[static_cast<std::size_t>(at)];
    return at;
  };
  Joined joined{0, nodes.size()};
  for (const Row& edge : edges) {
    const int tail = rootOf(edge[1]);
    const int head = rootOf(edge[2]);
    if (!contains(set, edge[0]) || tail == head) continue;
    above[static_cast<std::size_t>(tail)] = head;
    ++joined.joining;
  }
  return joined;
}

/// The rank of the rows {name, numbers ...} that the set names.
std::size_t rankOf(const Row& set, const std::vector<Row>& named) {
  std::vector<std::vector<Rational>> rows;
  for (const Row& row : named) {
    if (contains(set, row.front())) rows.push_back(numbersOf(std::span(row).subspan(1)));
  }
  std::size_t rank = 0;
  const std::size_t width = named.empty() ? 0 : named.front().size() - 1;
  for (std::size_t column = 0; column < width && rank < rows.size(); ++column) {
    std::size_t pivot = rank;
    while (pivot < rows.size() && rows[pivot][column].isZero()) ++pivot;
    if (pivot == rows.size()) continue;
    std::swap(rows[rank], rows[pivot]);
    for (std::size_t below = rank + 1; below < rows.size(); ++below) {
      const Rational factor = rows[below][column] / rows[rank][column];
      if (factor.isZero()) continue;
      for (std::size_t i = column; i < width; ++i) rows[below][i] -= factor * rows[rank][i];
    }
    ++rank;
  }
  return rank;
}

bool holdsOfSet(const Condition& condition, const Row& set) {
  const auto count = [&] { return numberOf(condition.values.front().front()); };
  const Rational size(static_cast<std::int64_t>(set.size()));
  const auto isIn = [&](const std::string& element) { return contains(set, element); };
  const auto only = [&]() -> const Row& { return condition.values.front(); };
  switch (condition.test) {
    case Test::spanningTree: {
      const Joined joined = joinedBy(set, condition.values);
      return joined.joining == set.size() && set.size() + 1 == joined.nodes;
    }
    case Test::hasLoop:
      return joinedBy(set, condition.values).joining < set.size();
    case Test::basis:
      return set.size() + 1 == condition.values.front().size() && rankOf(set, condition.values) == set.size();
    case Test::dependent:
      return rankOf(set, condition.values) < set.size();
    case Test::fewer:
      return size < count();
    case Test::more:
      return size > count();
    case Test::includes:
      return std::all_of(only().begin(), only().end(), isIn);
    case Test::lacks:
      return !std::all_of(only().begin(), only().end(), isIn);
    case Test::touches:
      return std::any_of(only().begin(), only().end(), isIn);
    default:
      return false;
  }
}

bool areWithin(const Fields& fields, const Row& bounds) {
  return std::all_of(fields.begin(), fields.end(), [&](const ReadField* field) {
    const Rational& value = field->number.value;
    return value.isInteger() && value >= numberOf(bounds[0]) && value <= numberOf(bounds[1]);
  });
}

}  // namespace

bool holds(const Condition& condition, const ReadAnswer& answer) {
  const Fields fields = fieldsOf(condition, answer);
  if (!isReadable(fields)) return false;
  switch (condition.test) {
    case Test::values:
      return readLikeOne(fields, condition.values);
    case Test::differs:
      return !readLikeOne(fields, condition.values);
    case Test::multiple:
      return isMultiple(fields, condition.values.front());
    case Test::rows:
      return areRows(fields, condition.values);
    case Test::quotient:
      return isNumeric(fields) && !fields[1]->number.value.isZero() &&
             fields[0]->number.value / fields[1]->number.value == numberOf(condition.values.front().front());
    case Test::within:
      return isNumeric(fields) && areWithin(fields, condition.values.front());
    case Test::outside:
      return isNumeric(fields) && !areWithin(fields, condition.values.front());
    default:
      return fields.size() == 1 && fields.front()->kind == FieldKind::set &&
             holdsOfSet(condition, fields.front()->elements);
  }
}

bool allHold(std::span<const Condition> conditions, const ReadAnswer& answer) {
  return std::all_of(conditions.begin(), conditions.end(),
                     [&](const Condition& condition) { return holds(condition, answer); });
}

}  // namespace geargraph
