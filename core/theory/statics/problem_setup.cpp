#include "core/theory/statics/problem_setup.h"

#include <algorithm>

#include "core/foundations/base/position_index.h"
#include "core/mechanism/model/load_edits.h"
#include "core/theory/statics/statics_diagnostics.h"

namespace geargraph {
namespace {

class ProblemSetup {
 public:
  ProblemSetup(const Mechanism& mechanism, const KinematicModel& model, const Placement& placement,
               const MatroidAnalysis& analysis, const StaticsOptions& options, StaticsReport& report)
      : m_mechanism(mechanism),
        m_model(model),
        m_placement(placement),
        m_analysis(analysis),
        m_options(options),
        m_report(report) {}

  void takeLoads() {
    const ShiftState* const of = state();
    const bool hasOwnTorque = isDriven() && m_options.driveTorque;
    std::vector<Load> loads;
    if (m_options.documentLoads) loads = m_mechanism.loads;
    loads.insert(loads.end(), m_options.loads.begin(), m_options.loads.end());
    for (Load& load : loads) {
      LoadReport measured = measuredLoad(std::move(load));
      if (hasOwnTorque && isReplaced(measured)) {
        m_report.leftOut.push_back(std::move(measured.load));
      } else {
        take(std::move(measured));
      }
    }
    if (hasOwnTorque) {
      take(measuredLoad({{}, LinkTorque{*of->drive, {}, Number(*m_options.driveTorque)}}));
    } else if (isDriven() && !isLoaded(of->drive) && !isLoaded(of->driven)) {
      take(measuredLoad({{}, LinkTorque{*of->drive, {}, Number(1)}}));
      add(unitLoad(m_mechanism, *of));
    } else if (m_report.loads.empty()) {
      add(noLoad());
    }
    if (!metresPerUnit(m_mechanism)) add(unknownUnit(m_mechanism, !m_report.problem.forces.empty()));
  }

  void takeBalances() {
    m_report.problem.balances = balances();
    m_report.held = heldParts(m_mechanism, m_model, m_placement, m_report.problem);
    std::vector<std::size_t> heldAlone;
    for (std::size_t i = 0; i < m_report.loads.size(); ++i) {
      LoadReport& load = m_report.loads[i];
      const auto part = std::find_if(m_report.held.begin(), m_report.held.end(), [&](const HeldPart& each) {
        return each.balance >= 0 && each.isExact && each.holds(load.power);
      });
      if (part == m_report.held.end()) continue;
      load.heldBy = static_cast<int>(part - m_report.held.begin());
      heldAlone.push_back(i);
    }
    if (!heldAlone.empty()) add(loadsOnBalances(m_mechanism, m_report, heldAlone));
  }

 private:
  [[nodiscard]] const ShiftState* state() const {
    return m_options.state < 0 ? nullptr : &m_mechanism.states[static_cast<std::size_t>(m_options.state)];
  }
  /// Has the state a moving link as its drive?
  [[nodiscard]] bool isDriven() const {
    return state() != nullptr && state()->drive && *state()->drive != m_mechanism.links.front().id;
  }
  void add(Diagnostic diagnostic) { m_report.diagnostics.push_back(std::move(diagnostic)); }

  /// With its power.
  [[nodiscard]] LoadReport measuredLoad(Load load) const {
    LoadReport report{std::move(load), {}, {}};
    report.power = LoadPower::of(m_mechanism, m_model, m_placement, problemOf(report.load)).byLink;
    if (m_report.motion) report.watts = powerOf(m_model, report.power, *m_report.motion);
    return report;
  }
  [[nodiscard]] StaticsProblem problemOf(const Load& load) const {
    StaticsProblem only;
    addLoads(m_mechanism, m_placement, std::span(&load, 1), only);
    return only;
  }
  void take(LoadReport load) {
    const StaticsProblem only = problemOf(load.load);
    auto& problem = m_report.problem;
    problem.torques.insert(problem.torques.end(), only.torques.begin(), only.torques.end());
    problem.forces.insert(problem.forces.end(), only.forces.begin(), only.forces.end());
    m_report.loads.push_back(std::move(load));
  }

  /// Is it a torque on the link, or does it do what one about the link's own axis does?
  [[nodiscard]] bool isOn(const LoadReport& load, const LinkId& id) const {
    const auto* torque = std::get_if<LinkTorque>(&load.load.action);
    if (torque != nullptr && torque->link == id) return true;
    const LinkOrdinal link = PositionIndex<LinkTag>(m_mechanism.links).at(id);
    if (link == 0) return false;
    StaticsProblem problem;
    problem.balances = {onLink(m_mechanism, m_placement, link, std::nullopt)};
    return heldParts(m_mechanism, m_model, m_placement, problem).front().holds(load.power);
  }
  [[nodiscard]] bool isLoaded(const std::optional<LinkId>& link) const {
    return link && std::any_of(m_report.loads.begin(), m_report.loads.end(), [&](const LoadReport& each) {
             return linkOf(each.load) == *link || isOn(each, *link);
           });
  }
  /// Does the torque at the drive take its place: is it where a state is driven, or where this one drives?
  [[nodiscard]] bool isReplaced(const LoadReport& load) const {
    const std::optional<LinkId>& driven = state()->driven;
    return (driven && isOn(load, *driven)) ||
           std::any_of(m_mechanism.states.begin(), m_mechanism.states.end(),
                       [&](const ShiftState& each) { return each.drive && isOn(load, *each.drive); });
  }

  [[nodiscard]] std::vector<TorquePlace> balances() const {
    if (!m_options.balances.empty()) return placesOf(m_mechanism, m_placement, m_options.balances);
    const ShiftState* const of = state();
    const bool hasOwnTorque = isDriven() && m_options.driveTorque;
    if (m_mechanism.balances && !hasOwnTorque)
      return placesOf(m_mechanism, m_placement, *m_mechanism.balances);
    std::vector<TorquePlace> places;
    if (of == nullptr) {
      for (const JointOrdinal joint : m_analysis.choice.joints) {
        const auto& torques = m_report.problem.torques;
        const bool loaded = std::any_of(torques.begin(), torques.end(),
                                        [&](const AppliedTorque& each) { return each.place.joint == joint; });
        if (!loaded) places.push_back(TorquePlace{joint});
      }
      return places;
    }
    if (!of->drive || !of->driven || isLoaded(of->drive) == isLoaded(of->driven)) return places;
    const LinkOrdinal free =
        PositionIndex<LinkTag>(m_mechanism.links).at(isLoaded(of->drive) ? *of->driven : *of->drive);
    if (free != 0) places.push_back(onLink(m_mechanism, m_placement, free, std::nullopt));
    return places;
  }

  const Mechanism& m_mechanism;
  const KinematicModel& m_model;
  const Placement& m_placement;
  const MatroidAnalysis& m_analysis;
  const StaticsOptions& m_options;
  StaticsReport& m_report;
};

}  // namespace

void setUpProblem(const Mechanism& mechanism, const KinematicModel& model, const Placement& placement,
                  const MatroidAnalysis& analysis, const StaticsOptions& options, StaticsReport& report) {
  ProblemSetup setup(mechanism, model, placement, analysis, options, report);
  setup.takeLoads();
  setup.takeBalances();
}

}  // namespace geargraph
