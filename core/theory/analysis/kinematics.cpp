#include "core/theory/analysis/kinematics.h"

#include "core/foundations/base/contract.h"
#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"
#include "core/theory/states/engagement.h"

namespace geargraph {
namespace {

Diagnostic skipped(std::string message) {
  return {Code::symbolicSkipped, std::move(message), {}, {}, 0, 0};
}

/// `equation` closes a loop of rows with pi and rows without it.
Diagnostic piMixed(const Mechanism& mechanism, const KinematicModel& model, int equation) {
  constexpr std::size_t kMostNames = 8;
  Diagnostic diagnostic;
  diagnostic.code = Code::piMixed;
  std::vector<std::string> names;
  for (MeshOrdinal mesh = 0; mesh < model.c(); ++mesh) {
    if (model.meshRow(mesh).pi == 0) continue;
    names.push_back(std::to_string(mechanism.meshLabel(mesh)));
    diagnostic.elements.emplace_back(mechanism.gearMeshes[mesh].id);
  }
  if (equation < model.c()) diagnostic.elements.emplace_back(mechanism.gearMeshes[equation].id);
  diagnostic.message = translated(
      "A length is tied to an angle by pi (meshes %1) and, round a loop, by a whole number of modules too: "
      "their "
      "rates would be sums of different powers of pi, for which there are no exact numbers here. State the "
      "racks "
      "of the loop all by their module or all by their pitch.",
      {listed(names, kMostNames)});
  return diagnostic;
}

/// Fills the symbolic parts of a solution.
class SymbolicPass {
 public:
  SymbolicPass(const Mechanism& mechanism, const LiveKinematics& live, SolvedKinematics& result,
               const std::stop_token& stop)
      : m_mechanism(mechanism), m_live(live), m_result(result), m_stop(stop) {}

  /// False where `stop` was requested.
  bool run() {
    const std::size_t entries = m_result.inputs().size() * m_result.outputs().size();
    if (entries > SolvedKinematics::kMaxSymbolicEntries) {
      m_result.diagnostics.push_back(skipped(
          translated("The symbolic solution has %1 entries; it was left out.", {std::to_string(entries)})));
      return true;
    }
    return byMatroid() && byTtGraph();
  }

 private:
  bool byMatroid() {
    const CoefficientMatrix coefficients(m_mechanism, *m_live.model, m_live.placement());
    m_result.symbolic = solveSymbolic(m_mechanism, *m_live.model, coefficients,
                                      m_live.matroid->independentEquations(), m_result.inputs(), m_stop);
    if (m_stop.stop_requested()) return false;
    if (!m_result.symbolic) {
      m_result.diagnostics.push_back(skipped(translated(
          "The equations of this mechanism are so coupled that the symbolic solution would fill pages; "
          "it was left out.")));
    } else if (m_result.symbolic->skipped > 0) {
      m_result.diagnostics.push_back(skipped(translated(
          "%1 entries of the symbolic solution are left as a chain of substitutions: expanded, one "
          "has over %2 terms, or all together over %3 factors.",
          {std::to_string(m_result.symbolic->skipped), std::to_string(kExpansionBudget),
           std::to_string(kSolutionBudget)})));
    }
    return true;
  }

  bool byTtGraph() {
    if (!m_result.symbolic) return true;
    const TtGraph& graph = *m_live.ttGraph;
    m_result.ttSymbolic =
        ttSymbolicSolution(ttRatioRing(graph, RatioNaming::matroid), graph, m_result.ttPlan, m_stop);
    const RatioRingPtr names = ttRatioRing(graph, RatioNaming::ttGraph);
    if (const auto inOwnNames = ttSymbolicSolution(names, graph, m_result.ttPlan, m_stop)) {
      m_result.ttSteps = substitutionSteps(names, graph, m_result.ttPlan, *inOwnNames, m_stop);
    }
    return !m_stop.stop_requested();
  }

  const Mechanism& m_mechanism;
  const LiveKinematics& m_live;
  SolvedKinematics& m_result;
  const std::stop_token& m_stop;
};

}  // namespace

LiveKinematicsPtr liveKinematics(const PlacedMechanism& placed, const std::stop_token& stop) {
  const Placement& placement = placed.placement();
  const DigraphPtr& graph = placement.tree->graph;
  const SpanningTreePtr& tree = placement.tree->tree;
  auto live = std::make_shared<LiveKinematics>(LiveKinematics{placed, nullptr, {}, {}, {}});
  live->ttGraph = std::make_shared<const TtGraph>(placed, graph, tree, ReferenceLines(placement));
  if (stop.stop_requested()) return nullptr;
  live->model = KinematicModel::of(graph, tree, placement);
  if (live->model && !placed.mechanism().engaged.empty()) {
    Engagement engagement = engagementOf(placed, placement, engagedCouplings(placed));
    live->model->hold(std::move(engagement.rows));
    live->engagement = std::move(engagement.diagnostics);
  }
  if (live->model && live->engagement.empty()) {
    if (const auto mixed = live->model->mixedEquation())
      live->engagement.push_back(piMixed(placed, *live->model, *mixed));
  }
  if (live->model && live->engagement.empty()) {
    live->matroid = analyzeMatroid(placed, *live->model, placement, stop);
    if (!live->matroid) return nullptr;
  }
  return live;
}

SolvedKinematicsPtr solvedKinematics(const Mechanism& mechanism, const LiveKinematics& live,
                                     const SolveOptions& options, const std::stop_token& stop) {
  GEARGRAPH_REQUIRE(live.matroid.has_value());
  auto solved = std::make_shared<SolvedKinematics>();
  const std::vector<int>& inputs = live.matroid->choice.joints;
  const std::vector<Rational>& speeds = live.matroid->speeds;
  if (live.model->hasPi()) {
    solved->pi = solvePi(*live.model, inputs, speeds, stop);
  } else {
    solved->exact = solveExact(*live.model, inputs, speeds, stop);
  }
  if (!solved->exact && !solved->pi) return nullptr;

  if (live.ttGraph->isComplete()) {
    solved->ttPlan = substitutionPlan(*live.ttGraph, inputs);
    if (solved->pi) {
      if (!solved->pi->matrix.empty() && (solved->ttPi = ttPiSolution(*live.ttGraph, solved->ttPlan, stop)))
        solved->agreement = agreementOf(*solved->pi, *solved->ttPi);
    } else if (solved->exact->matrix.empty()) {  // too large to hold: the rates are compared instead
      solved->agreement = agreementWith(*live.ttGraph, *solved->exact, speeds, stop);
    } else if ((solved->ttExact = ttSolution(*live.ttGraph, solved->ttPlan, stop))) {
      solved->agreement = agreementOf(*solved->exact, *solved->ttExact);
    }
    if (stop.stop_requested()) return nullptr;
  }
  if (options.symbolic && live.ttGraph->isComplete() && !SymbolicPass(mechanism, live, *solved, stop).run()) {
    return nullptr;
  }
  return solved;
}

}  // namespace geargraph
