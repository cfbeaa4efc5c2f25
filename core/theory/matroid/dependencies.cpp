#include "core/theory/matroid/dependencies.h"

#include <map>

#include "core/foundations/exact/sparse_expansion.h"

namespace geargraph {
namespace {

/// The equations transposed: a row per phi, an unknown multiplier per equation.
SparseRows<ModularDouble> multiplierRows(const KinematicModel& model, const ModularDoubleField& field) {
  const SparseRows<ModularDouble> rows = equationRows(model, field, model.equations());
  std::vector<std::vector<std::pair<int, ModularDouble>>> columns(static_cast<std::size_t>(model.n()));
  for (int equation = 0; equation < rows.rows(); ++equation) {
    for (int entry = rows.begin(equation); entry < rows.end(equation); ++entry) {
      columns[rows.column(entry)].emplace_back(equation, rows.value(entry));
    }
  }
  SparseRows<ModularDouble> transposed;
  for (const auto& column : columns) {
    for (const auto& [equation, value] : column) transposed.add(equation, value);
    transposed.endRow();
  }
  return transposed;
}

/// Multipliers that are not 0, by equation.
using Vector = std::map<int, ModularDouble>;

void subtractMultiple(const ModularDoubleField& field, Vector& from, const Vector& what, int pivot) {
  const ModularDouble factor = field.quotient(from.at(pivot), what.at(pivot));
  for (const auto& [equation, value] : what) {
    ModularDouble& target = from[equation];
    field.subtractProduct(target, factor, value);
    if (field.isZero(target)) from.erase(equation);
  }
}

/// Vectors of multipliers in echelon form, each led by its latest equation and free of the others' leaders.
class Echelon {
 public:
  explicit Echelon(const ModularDoubleField& field) : m_field(field) {}

  void add(Vector vector) {
    while (!vector.empty()) {
      const int leader = vector.rbegin()->first;
      const auto known = m_byLeader.find(leader);
      if (known == m_byLeader.end()) {
        m_byLeader.emplace(leader, std::move(vector));
        return;
      }
      subtractMultiple(m_field, vector, known->second, leader);
    }
  }

  /// From the earliest leader up, so that every vector is reduced by finished ones.
  std::map<int, Vector> reduced() && {
    for (auto& [leader, vector] : m_byLeader) {
      std::vector<int> others;
      for (const auto& [equation, value] : vector) {
        if (equation != leader && m_byLeader.contains(equation)) others.push_back(equation);
      }
      for (const int other : others) {
        if (vector.contains(other)) subtractMultiple(m_field, vector, m_byLeader.at(other), other);
      }
    }
    return std::move(m_byLeader);
  }

 private:
  const ModularDoubleField& m_field;
  std::map<int, Vector> m_byLeader;
};

}  // namespace

std::optional<std::vector<Redundancy>> redundanciesOf(const KinematicModel& model,
                                                      const ModularDoubleField& field,
                                                      const std::stop_token& stop) {
  const auto system =
      eliminate(field, multiplierRows(model, field), model.equations(), model.equations(), stop);
  if (!system) return std::nullopt;
  constexpr std::size_t kMaxEntries = 20'000'000;
  const auto multipliers = expandSparse(field, *system, kMaxEntries, stop);
  if (!multipliers) return std::nullopt;
  std::map<int, Vector> vectors;  // by free multiplier
  for (int equation = 0; equation < model.equations(); ++equation) {
    for (const auto& [column, value] : (*multipliers)[equation]) vectors[column].emplace(equation, value);
  }
  Echelon echelon(field);
  for (auto& [column, vector] : vectors) echelon.add(std::move(vector));
  std::vector<Redundancy> result;
  for (const auto& [leader, vector] : std::move(echelon).reduced()) {
    Redundancy redundancy{leader, {}};
    for (const auto& [equation, value] : vector) {
      if (equation != leader) redundancy.dependsOn.push_back(equation);
    }
    result.push_back(std::move(redundancy));
  }
  return result;
}

}  // namespace geargraph
