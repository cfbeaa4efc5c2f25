#include "core/teaching/derivation/result_tables.h"

namespace geargraph {
namespace {

/// A matrix of the digraph.
class MatrixTable final : public ResultTable {
 public:
  MatrixTable(const NamedResult& result, const AnalysisSnapshot& snapshot, MatrixKind kind)
      : ResultTable(result, EntryForm::fractions),
        m_graph(snapshot.graph),
        m_tree(snapshot.tree),
        m_matrix(snapshot.matrix(kind)) {}

  [[nodiscard]] int rows() const override { return m_matrix->rows(); }
  [[nodiscard]] int columns() const override { return m_matrix->columns(); }
  [[nodiscard]] std::optional<int> partition() const override { return m_matrix->partition(); }
  [[nodiscard]] Heading rowHeading(int row) const override { return m_matrix->rowHeading(row); }
  [[nodiscard]] Heading columnHeading(int column) const override { return m_matrix->columnHeading(column); }
  [[nodiscard]] IntegerMatrixPtr integers() const override { return m_matrix; }

  [[nodiscard]] std::vector<ResultEntry> row(int row) const override {
    std::vector<MatrixEntry> numbers;
    m_matrix->rowEntries(row, numbers);
    std::vector<ResultEntry> entries;
    entries.reserve(numbers.size());
    for (const auto& [column, value] : numbers) {
      const std::string text = std::to_string(value);
      entries.push_back({column, text, text, static_cast<double>(value), false});
    }
    return entries;
  }
  [[nodiscard]] std::set<ElementId> elementsOfRow(int row) const override {
    return geargraph::elementsOfRow(m_matrix->kind(), *m_graph, m_tree.get(), row);
  }
  /// A row of T, C and Q is a cycle or a cutset, which a column is part of.
  [[nodiscard]] std::set<ElementId> elementsOfCell(int row, int column) const override {
    std::set<ElementId> elements = elementsOfRow(row);
    const MatrixKind kind = m_matrix->kind();
    if (kind == MatrixKind::incidence || kind == MatrixKind::reducedIncidence || kind == MatrixKind::path)
      elements.insert(columnHeading(column).element);
    return elements;
  }
  [[nodiscard]] CellExplanation explanation(int row, int column) const override {
    return explainCell(m_matrix->kind(), *m_graph, m_tree.get(), row, column);
  }

 private:
  DigraphPtr m_graph;
  SpanningTreePtr m_tree;
  IntegerMatrixPtr m_matrix;
};

}  // namespace

ResultTablePtr matrixTable(const NamedResult& result, const SnapshotPtr& snapshot, MatrixKind kind) {
  return std::make_shared<const MatrixTable>(result, *snapshot, kind);
}

}  // namespace geargraph
