#pragma once

#include "core/teaching/derivation/named_results.h"

namespace geargraph::test {

/// A result that no program has: how many turning joints and gear meshes each link has. As long as this lives
/// the catalogue has it.
class ToyResult {
 public:
  [[nodiscard]] static const NamedResult& result() { return kResult; }

 private:
  /// A row for each link; columns: joints, meshes, parted between them.
  class Table final : public ResultTable {
   public:
    Table(const NamedResult& result, DigraphPtr graph)
        : ResultTable(result, EntryForm::fractions), m_graph(std::move(graph)) {}
    [[nodiscard]] int rows() const override { return m_graph->nodeCount(); }
    [[nodiscard]] int columns() const override { return 2; }
    [[nodiscard]] std::optional<int> partition() const override { return 1; }
    [[nodiscard]] Heading rowHeading(int row) const override {
      const int label = m_graph->nodeLabel(row);
      return {label, std::to_string(label), m_graph->nodeId(row)};
    }
    [[nodiscard]] Heading columnHeading(int column) const override {
      return {column + 1, column == 0 ? "J" : "M", {}};
    }
    [[nodiscard]] std::vector<ResultEntry> row(int row) const override {
      int counts[] = {0, 0};
      for (int edge = 0; edge < m_graph->edgeCount(); ++edge) {
        const auto [tail, head] = m_graph->edge(edge);
        if (tail == row || head == row) ++counts[edge < m_graph->t() ? 0 : 1];
      }
      std::vector<ResultEntry> entries;
      for (int column = 0; column < 2; ++column)
        if (counts[column] != 0) entries.push_back(fractionEntry(column, counts[column]));
      return entries;
    }

   private:
    DigraphPtr m_graph;
  };

  static std::vector<EntryForm> forms(const ResultSource& /*source*/) { return {EntryForm::fractions}; }
  static ResultTablePtr table(const NamedResult& self, const ResultSource& source, EntryForm /*form*/) {
    return std::make_shared<const Table>(self, source.snapshot->graph);
  }

  static constexpr std::string_view kName = "toy-degrees";
  static constexpr NamedResult kResult{.name = kName,
                                       .title = "Degrees of the links",
                                       .asciiName = "D",
                                       .of = ResultOf::graph,
                                       .needs = "nothing",
                                       .definition = "How many joints and meshes each link has.",
                                       .isWhole = true,
                                       .symbol = "D = [J | M]",
                                       .jsonName = "toyDegrees",
                                       .isPrinted = true,
                                       .reportFormula = "D",
                                       .reportText = "Each link has so many edges.",
                                       .forms = forms,
                                       .table = table};
  AddedResult m_added{kResult};
};

}  // namespace geargraph::test
