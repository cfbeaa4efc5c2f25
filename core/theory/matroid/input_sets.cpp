#include "core/theory/matroid/input_sets.h"

#include <algorithm>

#include "core/foundations/exact/sparse_expansion.h"
#include "core/theory/matroid/basis_count.h"
#include "core/theory/matroid/basis_enumeration.h"
#include "core/theory/matroid/live_solution.h"

namespace geargraph {
namespace {

constexpr std::size_t kMaxInputSetEntries = 20'000'000;
constexpr std::size_t kMaxListedSets = 2'000'000;

}  // namespace

std::optional<InputSets> InputSets::of(const KinematicModel& model, const ModularDoubleField& field,
                                       std::span<const int> inputs, const std::stop_token& stop) {
  const int columns = model.n() + static_cast<int>(inputs.size());
  const auto system =
      eliminate(field, inputRows(model, field, allEquations(model), inputs), model.n(), columns, stop);
  if (!system) return std::nullopt;
  GEARGRAPH_REQUIRE(system->freeColumns.empty());
  const auto phi = expandSparse(field, *system, kMaxInputSetEntries, stop);
  if (!phi) return std::nullopt;

  InputSets sets(field.prime());
  sets.m_inputs.assign(inputs.begin(), inputs.end());
  SparseSum<ModularDoubleField> sum(field, columns);
  for (JointOrdinal joint = 0; joint < model.t(); ++joint) {
    const auto& rate = model.jointRate(joint);
    sum.subtract(field.fromInteger(-rate.sign), (*phi)[static_cast<std::size_t>(rate.child) - 1]);
    if (rate.parent != 0) {
      sum.subtract(field.fromInteger(rate.sign), (*phi)[static_cast<std::size_t>(rate.parent) - 1]);
    }
    auto& row = sets.m_rates.emplace_back();
    for (const auto& [column, value] : sum.take(field.one()))
      row.emplace_back(column - model.n(), value.residue);
  }
  return sets;
}

bool InputSets::canReplace(int x, int y) const {
  const auto place = std::find(m_inputs.begin(), m_inputs.end(), x) - m_inputs.begin();
  const auto& row = m_rates[static_cast<std::size_t>(y)];
  return std::any_of(row.begin(), row.end(), [&](const auto& entry) { return entry.first == place; });
}

std::vector<int> InputSets::replacementsFor(int x) const {
  std::vector<int> joints;
  for (int y = 0; y < static_cast<int>(m_rates.size()); ++y) {
    if (y != x && canReplace(x, y)) joints.push_back(y);
  }
  return joints;
}

std::optional<Rational> InputSets::count(const std::stop_token& stop) const {
  std::vector<char> isInput(m_rates.size(), 0);
  for (const JointOrdinal joint : m_inputs) isInput[joint] = 1;
  std::vector<std::vector<std::pair<int, PrimeField::Residue>>> others;
  std::vector<int> order;
  for (std::size_t joint = 0; joint < m_rates.size(); ++joint) {
    if (isInput[joint] != 0 || m_rates[joint].empty()) continue;
    others.push_back(m_rates[joint]);
    order.push_back(static_cast<int>(joint));
  }
  return countBases(m_field, m_inputs, others, order, stop);
}

std::vector<std::vector<int>> InputSets::list(std::size_t limit, const std::stop_token& stop) const {
  if (limit == 0) return {};
  if (m_rates.size() * m_inputs.size() > kMaxListedSets) return neighbours(limit);
  auto sets = enumerateBases(m_field, static_cast<int>(m_inputs.size()), m_rates, limit, stop);
  return sets ? std::move(*sets) : neighbours(limit);
}

std::vector<std::vector<int>> InputSets::neighbours(std::size_t limit) const {
  std::vector<std::vector<int>> sets;
  const auto add = [&](std::vector<int> set) {
    std::sort(set.begin(), set.end());
    sets.push_back(std::move(set));
  };
  add(m_inputs);
  std::vector<char> isInput(m_rates.size(), 0);
  for (const JointOrdinal joint : m_inputs) isInput[joint] = 1;
  for (std::size_t joint = 0; joint < m_rates.size(); ++joint) {
    if (isInput[joint] != 0) continue;
    for (const auto& [place, value] : m_rates[joint]) {
      if (sets.size() >= limit) return sets;
      std::vector<int> set = m_inputs;
      set[place] = static_cast<int>(joint);
      add(std::move(set));
    }
  }
  return sets;
}

}  // namespace geargraph
