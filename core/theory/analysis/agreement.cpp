#include "core/theory/analysis/agreement.h"

#include <algorithm>
#include <iterator>
#include <set>

namespace geargraph {
namespace {

/// Counts what agrees and remembers what does not.
class Comparison {
 public:
  void compare(JointOrdinal joint, const Rational& a, const Rational& b) {
    ++m_result.compared;
    if (a == b) return;
    m_result.largestDifference = std::max(m_result.largestDifference, (a - b).abs());
    differ(joint);
  }
  void compare(JointOrdinal joint, const PiNumber& a, const PiNumber& b) {
    ++m_result.compared;
    if (a == b) return;
    const Rational difference = Rational::fromDouble((a - b).abs().toDouble());
    m_result.largestDifference = std::max(m_result.largestDifference, difference);
    differ(joint);
  }
  void differ(JointOrdinal joint) { m_joints.insert(joint); }
  [[nodiscard]] Agreement result(bool determined = true) {
    m_result.joints.assign(m_joints.begin(), m_joints.end());
    m_result.equal = determined && m_joints.empty();
    return std::move(m_result);
  }

 private:
  Agreement m_result;
  std::set<int> m_joints;
};

std::set<int> unshared(std::vector<int> a, std::vector<int> b) {
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  std::set<int> joints;
  std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::inserter(joints, joints.end()));
  return joints;
}

template <class Solution, class Value>
Agreement agreementOfMatrices(const Solution& matroid, const RateMatrix<Value>& ttGraph) {
  Comparison comparison;
  for (const JointOrdinal joint : unshared(matroid.inputs, ttGraph.inputs)) comparison.differ(joint);
  const auto columnOf = [&](int input) {
    return static_cast<std::size_t>(std::find(ttGraph.inputs.begin(), ttGraph.inputs.end(), input) -
                                    ttGraph.inputs.begin());
  };
  std::vector<std::size_t> columns;
  for (const int input : matroid.inputs) columns.push_back(columnOf(input));
  for (std::size_t row = 0; row < matroid.outputs.size(); ++row) {
    const JointOrdinal joint = matroid.outputs[row];
    const auto other = std::lower_bound(ttGraph.outputs.begin(), ttGraph.outputs.end(), joint);
    if (other == ttGraph.outputs.end() || *other != joint) {
      comparison.differ(joint);
      continue;
    }
    const auto& entries = ttGraph.entries[static_cast<std::size_t>(other - ttGraph.outputs.begin())];
    for (std::size_t k = 0; k < columns.size(); ++k) {
      if (columns[k] < entries.size()) {
        comparison.compare(joint, matroid.matrix[row * columns.size() + k], entries[columns[k]]);
      }
    }
  }
  return comparison.result(ttGraph.determined);
}

}  // namespace

Agreement agreementOf(const ExactSolution& matroid, const RateMatrix<Rational>& ttGraph) {
  return agreementOfMatrices(matroid, ttGraph);
}

Agreement agreementOf(const PiSolution& matroid, const RateMatrix<PiNumber>& ttGraph) {
  return agreementOfMatrices(matroid, ttGraph);
}

Agreement agreementOf(std::span<const Rational> matroid, std::span<const Rational> ttGraph) {
  Comparison comparison;
  const std::size_t shared = std::min(matroid.size(), ttGraph.size());
  for (std::size_t joint = 0; joint < shared; ++joint) {
    comparison.compare(static_cast<int>(joint), matroid[joint], ttGraph[joint]);
  }
  for (std::size_t joint = shared; joint < std::max(matroid.size(), ttGraph.size()); ++joint) {
    comparison.differ(static_cast<int>(joint));
  }
  return comparison.result();
}

std::optional<Agreement> agreementWith(const TtGraph& graph, const ExactSolution& matroid,
                                       std::span<const Rational> speeds, const std::stop_token& stop) {
  const SubstitutionPlan plan = substitutionPlan(graph, matroid.inputs);
  if (matroid.matrix.empty() && !matroid.inputs.empty() && !matroid.outputs.empty()) {
    const auto determination = ttDetermination(graph, plan, stop);
    const auto rates = ttRates(graph, plan, speeds, stop);
    if (!determination || !rates) return std::nullopt;
    Agreement agreement = agreementOf(matroid.rates, *rates);
    agreement.equal = agreement.equal && determination->valid();
    return agreement;
  }
  const auto solution = ttSolution(graph, plan, stop);
  if (!solution) return std::nullopt;
  return agreementOf(matroid, *solution);
}

}  // namespace geargraph
