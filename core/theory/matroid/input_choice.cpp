#include "core/theory/matroid/input_choice.h"

#include <algorithm>

#include "core/foundations/exact/sparse_expansion.h"

namespace geargraph {
namespace {

/// Rows of K = the rates over the free phi, taken while they are independent.
class IndependentRates {
 public:
  IndependentRates(const KinematicModel& model, const ModularDoubleField& field, const Structure& structure,
                   const std::vector<SparseVector<ModularDouble>>& phi)
      : m_model(model),
        m_field(field),
        m_structure(structure),
        m_phi(phi),
        m_sum(field, model.n()),
        m_rowOfPivot(static_cast<std::size_t>(model.n()), -1),
        m_taken(static_cast<std::size_t>(model.t()), 0) {}

  /// True where the joint's rate does not follow from those taken before; then it is taken.
  bool take(JointOrdinal joint) {
    if (m_taken[joint] != 0 || m_structure.dead[joint] != 0) return false;
    if (m_structure.idle[joint] == 0 && !extend(rate(joint))) return false;
    m_taken[joint] = 1;
    return true;
  }

 private:
  SparseVector<ModularDouble> rate(JointOrdinal joint) {
    const auto& of = m_model.jointRate(joint);
    m_sum.subtract(m_field.fromInteger(-of.sign), m_phi[static_cast<std::size_t>(of.child) - 1]);
    if (of.parent != 0)
      m_sum.subtract(m_field.fromInteger(of.sign), m_phi[static_cast<std::size_t>(of.parent) - 1]);
    return m_sum.take(m_field.one());
  }

  /// Reduces by the rows taken; what is left, if anything, becomes one of them.
  bool extend(SparseVector<ModularDouble> row) {
    for (std::size_t i = 0; i < row.size();) {
      const int known = m_rowOfPivot[row[i].first];
      if (known < 0) {
        ++i;
        continue;
      }
      const ModularDouble factor = row[i].second;
      const int pivot = row[i].first;
      for (const auto& [place, value] : row) m_sum.at(place) = value;
      m_sum.subtract(factor, m_rows[known]);
      row = m_sum.take(m_field.one());
      i = 0;
      while (i < row.size() && row[i].first < pivot) ++i;
    }
    if (row.empty()) return false;
    const ModularDouble leading = row.front().second;
    for (auto& [place, value] : row) value = m_field.quotient(value, leading);
    m_rowOfPivot[row.front().first] = static_cast<int>(m_rows.size());
    m_rows.push_back(std::move(row));
    return true;
  }

  const KinematicModel& m_model;
  const ModularDoubleField& m_field;
  const Structure& m_structure;
  const std::vector<SparseVector<ModularDouble>>& m_phi;
  SparseSum<ModularDoubleField> m_sum;
  std::vector<int> m_rowOfPivot;
  std::vector<SparseVector<ModularDouble>> m_rows;
  std::vector<char> m_taken;
};

}  // namespace

bool isValidAsEngaged(const InputChoice& choice, std::span<const int> wanted) {
  const auto isTwice = [&](JointOrdinal joint) {
    return std::count(wanted.begin(), wanted.end(), joint) > 1;
  };
  return choice.added.empty() && std::none_of(wanted.begin(), wanted.end(), isTwice);
}

std::optional<InputChoice> chooseInputs(const KinematicModel& model, const ModularDoubleField& field,
                                        const Structure& structure, std::span<const int> wanted,
                                        const std::stop_token& stop) {
  constexpr std::size_t kMaxEntries = 20'000'000;
  const auto phi = expandSparse(field, structure.system, kMaxEntries, stop);
  if (!phi) return std::nullopt;
  IndependentRates rates(model, field, structure, *phi);
  InputChoice choice;
  for (const JointOrdinal joint : wanted)
    (rates.take(joint) ? choice.joints : choice.rejected).push_back(joint);
  for (JointOrdinal joint = 0; joint < model.t() && static_cast<int>(choice.joints.size()) < structure.dof;
       ++joint) {
    if (stop.stop_requested()) return std::nullopt;
    if (!rates.take(joint)) continue;
    choice.joints.push_back(joint);
    choice.added.push_back(joint);
  }
  return choice;
}

}  // namespace geargraph
