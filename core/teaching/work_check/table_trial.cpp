#include "core/teaching/work_check/table_trial.h"

#include <algorithm>

#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"

namespace geargraph {
namespace {

constexpr std::size_t kMaxListedTrials = 12;

/// The place of each label among the headings; nothing where one is not among them or named twice.
std::optional<std::vector<int>> placesOf(const Vocabulary& vocabulary, const std::vector<WrittenCell>& labels,
                                         const std::vector<Heading>& headings) {
  std::vector<int> places;
  std::vector<char> isTaken(headings.size(), 0);
  for (const WrittenCell& label : labels) {
    const auto number = labelNumber(vocabulary, label.text);
    const auto found = std::find_if(headings.begin(), headings.end(),
                                    [&](const Heading& heading) { return number == heading.label; });
    if (found == headings.end()) return std::nullopt;
    const auto place = static_cast<std::size_t>(found - headings.begin());
    if (isTaken[place] != 0) return std::nullopt;
    isTaken[place] = 1;
    places.push_back(static_cast<int>(place));
  }
  return places;
}

}  // namespace

TableTrial::TableTrial(const Vocabulary& vocabulary, const WrittenTable& table, const WrittenAmounts& amounts,
                       PaperMatrix kind, const std::stop_token& stop)
    : m_vocabulary(vocabulary),
      m_table(table),
      m_amounts(amounts),
      m_stop(stop),
      m_right(derivedTable(vocabulary, kind)) {
  m_verdict.kind = kind;
}

const WrittenCell* TableTrial::unknownLabel() const {
  if (!hasSize() || labelsOf(*m_right)) return nullptr;
  for (const auto* side : {&m_table.rowLabels, &m_table.columnLabels}) {
    const auto& headings = side == &m_table.rowLabels ? m_right->rows : m_right->columns;
    for (std::size_t i = 0; i < side->size(); ++i) {
      const std::vector<WrittenCell> upToHere(side->begin(),
                                              side->begin() + static_cast<std::ptrdiff_t>(i) + 1);
      if (!placesOf(m_vocabulary, upToHere, headings)) return &(*side)[i];
    }
  }
  return nullptr;
}

bool TableTrial::isRight() {
  if (hasSize() && labelsOf(*m_right)) {
    if (accept(*m_right, FreeOrder::none)) {
      if (!m_verdict.differences.empty()) acceptOrderOfFormulas();
      return true;
    }
  }
  if (const auto tree = otherTree(m_vocabulary, m_verdict.kind, m_table, m_amounts)) {
    acceptTree(*tree);
    return true;
  }
  if (!hasSize() || !labelsOf(*m_right)) return false;
  const bool isMistaken = findMistake(FreeOrder::none);
  const auto natural = naturalDifferences();
  for (const FreeOrder order : {FreeOrder::rows, FreeOrder::columns, FreeOrder::both}) {
    if (!accept(*m_right, order)) continue;
    const bool isOneEntry = natural.size() == 1 && natural.front().entries.size() == 1;
    if (!isMistaken && !isOneEntry) return true;
    m_verdict.outcome = WorkOutcome::ambiguous;
    m_verdict.differences = isMistaken ? std::vector{*m_mistake} : natural;
    m_verdict.notes.push_back(
        translated("Without labels it may be either: write the labels of rows and columns."));
    return true;
  }
  return false;
}

/// The numbers are right as they stand, and some formulas are not: maybe they are in another order.
void TableTrial::acceptOrderOfFormulas() {
  const MatrixVerdict natural = m_verdict;
  for (const FreeOrder order : {FreeOrder::rows, FreeOrder::columns, FreeOrder::both}) {
    if (accept(*m_right, order) && m_verdict.differences.empty()) return;
  }
  m_verdict = natural;
}

void TableTrial::explain() {
  m_verdict.outcome = WorkOutcome::wrong;
  m_verdict.notes.clear();
  for (const FreeOrder order : {FreeOrder::none, FreeOrder::rows, FreeOrder::columns, FreeOrder::both}) {
    if (!findMistake(order)) continue;
    m_verdict.differences = {*m_mistake};
    if (hasSize() && labelsOf(*m_right)) fillEntries(*m_right, bestAlignment());
    return;
  }
  if (!hasSize() || !labelsOf(*m_right)) return;
  const Alignment alignment = bestAlignment();
  m_verdict.differences = tableDifferences(m_vocabulary, *m_right, m_amounts, alignment);
  fillEntries(*m_right, alignment);
}

std::size_t TableTrial::cost() const {
  std::size_t count = 0;
  for (const auto& row : m_verdict.entries)
    count += static_cast<std::size_t>(
        std::count_if(row.begin(), row.end(), [](const ComparedEntry& e) { return e.differs; }));
  const bool isExplained = m_verdict.differences.size() == 1 && m_verdict.differences.front().entries.empty();
  if (isExplained) return 1;
  return m_verdict.entries.empty() ? kNotComparable : count;
}

bool TableTrial::fits(const DerivedTable& table) const {
  return table.height() == m_table.rows() && table.width() == m_table.columns();
}

std::optional<LabelPositions> TableTrial::labelsOf(const DerivedTable& table) const {
  LabelPositions places;
  if (!m_table.rowLabels.empty()) {
    places.rows = placesOf(m_vocabulary, m_table.rowLabels, table.rows);
    if (!places.rows) return std::nullopt;
  }
  if (!m_table.columnLabels.empty()) {
    places.columns = placesOf(m_vocabulary, m_table.columnLabels, table.columns);
    if (!places.columns) return std::nullopt;
  }
  return places;
}

std::optional<Alignment> TableTrial::aligned(const DerivedTable& table, FreeOrder order) const {
  if (!fits(table)) return std::nullopt;
  const auto labels = labelsOf(table);
  if (!labels) return std::nullopt;
  return alignmentOf(m_vocabulary, m_amounts, table, rowFreedom(table.kind), *labels, order, m_stop);
}

bool TableTrial::accept(const DerivedTable& table, FreeOrder order) {
  const auto alignment = aligned(table, order);
  if (!alignment) return false;
  m_verdict.outcome = WorkOutcome::right;
  m_verdict.differences = tableDifferences(m_vocabulary, table, m_amounts, *alignment);
  if (!m_verdict.differences.empty()) m_verdict.outcome = WorkOutcome::wrong;
  fillEntries(table, *alignment);
  addNotes(table, *alignment);
  return true;
}

void TableTrial::addNotes(const DerivedTable& table, const Alignment& alignment) {
  m_verdict.notes.clear();
  const auto note = [&](const char* sentence, const std::vector<int>& order,
                        const std::vector<Heading>& headings) {
    if (std::is_sorted(order.begin(), order.end())) return;
    std::vector<std::string> names;
    for (const int place : order) names.push_back(headings[static_cast<std::size_t>(place)].text);
    m_verdict.notes.push_back(filled(translated(sentence), {listed(names, kMaxListedTrials)}));
  };
  note(toTranslate("Your rows are in another order: %1."), alignment.rows, table.rows);
  note(toTranslate("Your columns are in another order: %1."), alignment.columns, table.columns);
  std::vector<std::string> turned;
  for (std::size_t i = 0; i < alignment.turned.size(); ++i) {
    if (alignment.turned[i] != 0 && rowFreedom(table.kind) == RowFreedom::sign)
      turned.push_back(table.rows[static_cast<std::size_t>(alignment.rows[i])].text);
  }
  if (turned.empty()) return;
  m_verdict.notes.push_back(
      translated("You walk %1 the other way, which is as good: all signs of the row change.",
                 {listed(turned, kMaxListedTrials)}));
}

void TableTrial::acceptTree(const std::vector<int>& tree) {
  m_verdict.outcome = WorkOutcome::right;
  std::vector<std::string> names;
  for (const int label : tree) names.push_back(std::to_string(label));
  m_verdict.notes = {
      translated("You take another spanning tree, of the edges %1: for it the matrix is right.",
                 {listed(names, kAllNames)})};
}

bool TableTrial::findMistake(FreeOrder order) {
  if (m_mistake) return true;
  if (m_mistaken.empty()) m_mistaken = mistakenTables(m_vocabulary, *m_right);
  for (const MistakenTable& mistaken : m_mistaken) {
    if (!aligned(mistaken.table, order)) continue;
    m_mistake = WorkDifference{mistaken.name, {}, {}, mistaken.reason};
    return true;
  }
  return false;
}

Alignment TableTrial::naturalAlignment() const {
  const auto labels = labelsOf(*m_right);
  Alignment alignment;
  const auto orderOf = [](const std::optional<std::vector<int>>& places, int count) {
    std::vector<int> order;
    for (int i = 0; i < count; ++i) order.push_back(i);
    return places ? *places : order;
  };
  alignment.rows = orderOf(labels->rows, m_right->height());
  alignment.columns = orderOf(labels->columns, m_right->width());
  return alignment;
}

std::vector<WorkDifference> TableTrial::naturalDifferences() const {
  return tableDifferences(m_vocabulary, *m_right, m_amounts, naturalAlignment());
}

std::size_t TableTrial::disagreements(std::size_t written, int derived,
                                      const std::vector<int>& columns) const {
  const auto row =
      scaledRow(m_vocabulary, m_amounts[written], m_right->entries[static_cast<std::size_t>(derived)],
                rowFreedom(m_right->kind), columns);
  std::size_t count = 0;
  for (std::size_t k = 0; k < row.size(); ++k) {
    if (agreementOf(m_vocabulary, m_amounts[written][k], row[k]) == TableAgreement::none) ++count;
  }
  return count;
}

Alignment TableTrial::bestAlignment() const {
  Alignment alignment = naturalAlignment();
  if (!m_table.rowLabels.empty()) return alignment;
  const std::size_t height = m_amounts.size();
  std::vector<std::vector<std::size_t>> costs(height);
  std::size_t own = 0;
  for (std::size_t i = 0; i < height; ++i) {
    for (std::size_t j = 0; j < height; ++j)
      costs[i].push_back(disagreements(i, static_cast<int>(j), alignment.columns));
    own += costs[i][i];
  }
  std::vector<int> rows(height, -1);
  std::vector<char> isTaken(height, 0);
  std::size_t sum = 0;
  for (std::size_t round = 0; round < height; ++round) {
    std::size_t bestRow = height;
    std::size_t best = 0;
    for (std::size_t i = 0; i < height; ++i) {
      for (std::size_t j = 0; j < height && rows[i] < 0; ++j) {
        if (isTaken[j] != 0) continue;
        const bool isBetter = bestRow == height || costs[i][j] < costs[bestRow][best] ||
                              (costs[i][j] == costs[bestRow][best] && i == j && bestRow != best);
        if (!isBetter) continue;
        bestRow = i;
        best = j;
      }
    }
    rows[bestRow] = static_cast<int>(best);
    isTaken[best] = 1;
    sum += costs[bestRow][best];
  }
  if (sum < own) alignment.rows = rows;
  return alignment;
}

void TableTrial::fillEntries(const DerivedTable& table, const Alignment& alignment) {
  m_verdict.rows.clear();
  m_verdict.columns.clear();
  m_verdict.entries.clear();
  for (const int row : alignment.rows) m_verdict.rows.push_back(table.rows[static_cast<std::size_t>(row)]);
  for (const int column : alignment.columns)
    m_verdict.columns.push_back(table.columns[static_cast<std::size_t>(column)]);
  for (std::size_t i = 0; i < m_amounts.size(); ++i) {
    const auto expected =
        scaledRow(m_vocabulary, m_amounts[i], table.entries[static_cast<std::size_t>(alignment.rows[i])],
                  rowFreedom(table.kind), alignment.columns);
    auto& entries = m_verdict.entries.emplace_back();
    for (std::size_t k = 0; k < expected.size(); ++k) {
      entries.push_back({m_table.cells[i][k], entryText(expected[k]),
                         agreementOf(m_vocabulary, m_amounts[i][k], expected[k]) != TableAgreement::full,
                         elementsOf(table, alignment.rows[i], alignment.columns[k])});
    }
  }
}

}  // namespace geargraph
