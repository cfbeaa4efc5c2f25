#pragma once

#include "core/teaching/work_check/table_check.h"
#include "core/teaching/work_check/table_mistakes.h"

namespace geargraph {

/// A comparison of a written matrix with one kind: first call isRight(), then, if false, explain().
class TableTrial {
 public:
  /// All arguments outlive it.
  TableTrial(const Vocabulary& vocabulary, const WrittenTable& table, const WrittenAmounts& amounts,
             PaperMatrix kind, const std::stop_token& stop);

  [[nodiscard]] bool isDefined() const { return m_right.has_value(); }
  [[nodiscard]] const DerivedTable& right() const { return *m_right; }
  [[nodiscard]] bool hasSize() const { return fits(*m_right); }

  /// The first label that this matrix does not have, if the size is right; else null.
  [[nodiscard]] const WrittenCell* unknownLabel() const;

  /// Is it right in the order of the labels, for another tree, or without labels in another order?
  bool isRight();

  /// Finds the mistakes of a matrix that is not right.
  void explain();

  /// The number of differing entries, or kNotComparable.
  [[nodiscard]] std::size_t cost() const;
  static constexpr std::size_t kNotComparable = 1'000'000;

  [[nodiscard]] MatrixVerdict& verdict() { return m_verdict; }

 private:
  [[nodiscard]] bool fits(const DerivedTable& table) const;
  [[nodiscard]] std::optional<LabelPositions> labelsOf(const DerivedTable& table) const;
  [[nodiscard]] std::optional<Alignment> aligned(const DerivedTable& table, FreeOrder order) const;
  bool accept(const DerivedTable& table, FreeOrder order);
  void addNotes(const DerivedTable& table, const Alignment& alignment);
  void acceptTree(const std::vector<int>& tree);

  /// Finds a mistake made throughout.
  void acceptOrderOfFormulas();
  bool findMistake(FreeOrder order);
  [[nodiscard]] Alignment naturalAlignment() const;
  [[nodiscard]] std::vector<WorkDifference> naturalDifferences() const;
  [[nodiscard]] std::size_t disagreements(std::size_t written, int derived,
                                          const std::vector<int>& columns) const;

  /// The natural order; without labels the order of rows in which the fewest entries differ.
  [[nodiscard]] Alignment bestAlignment() const;
  void fillEntries(const DerivedTable& table, const Alignment& alignment);

  const Vocabulary& m_vocabulary;
  const WrittenTable& m_table;
  const WrittenAmounts& m_amounts;
  std::stop_token m_stop;
  std::optional<DerivedTable> m_right;
  std::vector<MistakenTable> m_mistaken;
  std::optional<WorkDifference> m_mistake;
  MatrixVerdict m_verdict;
};

}  // namespace geargraph
