#pragma once

#include <span>

#include "core/presentation/report/report.h"
#include "core/teaching/derivation/named_results.h"

namespace geargraph {

// Functions for sentences and formulas of a report.

/// "The inputs are joints $8$ and $9$." with formulas between dollar signs becomes words and formulas.
/// @pre an even number of dollar signs; it contains no text of the user's
[[nodiscard]] ReportWords reportWords(std::string_view sentence);
/// A text of the user's, without formulas.
[[nodiscard]] ReportWords plainWords(std::string text);

/// The words for TeX or Markdown: formulas between dollar signs, other words through `escaped`.
[[nodiscard]] std::string dollarWords(const ReportWords& words, std::string (*escaped)(std::string_view));

/// Columns and rows of the largest matrix that is printed; for others the report says where they are
/// available.
constexpr int kMaxReportColumns = 40;
constexpr int kMaxReportRows = 80;

/// A column vector of names in parentheses.
[[nodiscard]] std::string texColumn(const std::vector<std::string>& names);
/// "(\dot{\theta}_8, ...)" as a column.
[[nodiscard]] std::string rateColumn(const Digraph& graph, std::span<const int> joints);
/// "\dot{\theta}_{8}"
[[nodiscard]] std::string rateName(const Digraph& graph, JointOrdinal joint);
/// A matrix of TeX entries in brackets; with a bar before the column `partition`.
[[nodiscard]] std::string texMatrix(const std::vector<std::vector<std::string>>& rows,
                                    std::optional<int> partition = std::nullopt);
/// The entries of a table without its headings.
[[nodiscard]] std::string texMatrix(const ResultTable& table);
/// Lines aligned at their first "=".
[[nodiscard]] std::string texLines(const std::vector<std::string>& lines);
/// The sides of "= ... =", each on a line.
[[nodiscard]] std::string texStages(const std::vector<std::string>& stages);
/// The sentence that a matrix is too large to print, with the command that writes it.
[[nodiscard]] std::string tooManyEntries(int rows, int columns, std::string_view commandName);
/// "(35), (28) and (39)"
[[nodiscard]] std::string citedEquations(const std::vector<int>& numbers);

}  // namespace geargraph
