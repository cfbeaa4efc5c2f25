#include "core/theory/matroid/input_roles.h"

#include <algorithm>
#include <map>
#include <unordered_set>

#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

std::size_t placeOf(const std::vector<int>& joints, JointOrdinal joint) {
  const auto found = std::find(joints.begin(), joints.end(), joint);
  GEARGRAPH_REQUIRE(found != joints.end());
  return static_cast<std::size_t>(found - joints.begin());
}

}  // namespace

std::vector<int> commandedBy(const LiveSolution& solution, int input) {
  const std::size_t columns = solution.inputs.size();
  const std::size_t column = placeOf(solution.inputs, input);
  std::vector<int> commanded;
  for (std::size_t row = 0; row < solution.outputs.size(); ++row) {
    if (solution.matrix[row * columns + column] != 0) commanded.push_back(solution.outputs[row]);
  }
  return commanded;
}

std::vector<int> commandersOf(const LiveSolution& solution, int output) {
  const std::size_t columns = solution.inputs.size();
  const std::size_t row = placeOf(solution.outputs, output);
  std::vector<int> commanders;
  for (std::size_t column = 0; column < columns; ++column) {
    if (solution.matrix[row * columns + column] != 0) commanders.push_back(solution.inputs[column]);
  }
  return commanders;
}

std::vector<std::vector<int>> tiedJoints(const ExactSolution& solution) {
  const std::size_t columns = solution.inputs.size();
  // By row over its first entry that is not 0; of a row the entries that are not 0.
  std::map<std::vector<std::pair<std::size_t, std::string>>, std::vector<int>> groups;
  const auto add = [&](JointOrdinal joint, std::span<const Rational> row) {
    const auto leading = std::find_if(row.begin(), row.end(), [](const Rational& r) { return !r.isZero(); });
    if (leading == row.end()) return;
    std::vector<std::pair<std::size_t, std::string>> key;
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (!row[i].isZero()) key.emplace_back(i, (row[i] / *leading).toString());
    }
    groups[std::move(key)].push_back(joint);
  };
  for (std::size_t i = 0; i < columns; ++i) {
    std::vector<Rational> row(columns);
    row[i] = 1;
    add(solution.inputs[i], row);
  }
  for (std::size_t i = 0; i < solution.outputs.size(); ++i)
    add(solution.outputs[i], std::span(solution.matrix).subspan(i * columns, columns));
  std::vector<std::vector<int>> tied;
  for (auto& [key, joints] : groups) {
    if (joints.size() < 2) continue;
    std::sort(joints.begin(), joints.end());
    tied.push_back(std::move(joints));
  }
  std::sort(tied.begin(), tied.end());
  return tied;
}

InputCompletion::InputCompletion(const KinematicModel& model)
    : m_model(model), m_structure(*structureOf(model, m_field)) {}

std::optional<std::vector<int>> InputCompletion::with(std::span<const int> wanted,
                                                      std::span<const int> present) const {
  std::vector<int> joints(wanted.begin(), wanted.end());
  const std::unordered_set<int> known(wanted.begin(), wanted.end());
  for (const JointOrdinal joint : present) {
    if (!known.contains(joint)) joints.push_back(joint);
  }
  const auto choice = chooseInputs(m_model, m_field, m_structure, joints);
  if (!choice || choice->joints.size() < wanted.size()) return std::nullopt;
  if (!std::equal(wanted.begin(), wanted.end(), choice->joints.begin())) return std::nullopt;
  return choice->joints;
}

std::vector<int> chainTo(const SpanningTree& tree, LinkOrdinal link) {
  std::vector<int> chain;
  for (LinkOrdinal node = link; node != 0; node = tree.parent(node))
    chain.push_back(tree.jointToParent(node));
  std::reverse(chain.begin(), chain.end());
  return chain;
}

}  // namespace geargraph
