#include "core/foundations/exact/expansion.h"

namespace geargraph {
namespace {

using Line = Elimination<RationalFunction>::Line;

/// One line; std::nullopt where it needs an entry that is over the budget, or goes over it.
std::optional<RationalFunction> expandLine(const RationalFunctionField& field,
                                           const Elimination<RationalFunction>& system, const Line& line,
                                           const std::vector<std::optional<RationalFunction>>& x,
                                           ExpansionBudget& budget) {
  constexpr int kRoomToCancel = 4;
  const auto& rows = system.matrixOf(line.core);
  RationalFunction sum;
  for (int entry = rows.begin(line.row); entry < rows.end(line.row); ++entry) {
    const int column = rows.column(entry);
    if (column == line.column) continue;
    if (!x[column]) return std::nullopt;
    if (x[column]->isZero()) continue;
    field.subtractProduct(sum, rows.value(entry), *x[column]);
    budget.total -= sum.size();
    if (budget.total < 0 || sum.termCount() > kRoomToCancel * budget.terms) return std::nullopt;
  }
  const RationalFunction& pivot = pivotOf(rows, line.row, line.column);
  if (!sum.isZero() && !pivot.isOne()) {
    sum /= pivot;
    budget.total -= sum.size();
  }
  if (budget.total < 0 || sum.termCount() > budget.terms) return std::nullopt;
  return sum;
}

}  // namespace

bool expand(const RationalFunctionField& field, const Elimination<RationalFunction>& system,
            const std::vector<char>& vanishing, std::vector<std::optional<RationalFunction>>& x,
            ExpansionBudget& budget, const std::stop_token& stop) {
  for (const Line& line : system.lines) {
    if (stop.stop_requested()) return false;
    if (vanishing[line.column] != 0) continue;
    x[line.column] = budget.total < 0 ? std::nullopt : expandLine(field, system, line, x, budget);
  }
  return true;
}

}  // namespace geargraph
