#include "core/theory/statics/efficiency_curve.h"

#include <algorithm>

#include "core/machine/train/mesh_contact.h"
#include "core/theory/matroid/exact_solution.h"

namespace geargraph {
namespace {

RadicalColumns negatedLoads(const RadicalColumns& columns) {
  RadicalColumns reversed;
  for (const RadicalColumns::Column& column : columns.columns())
    for (const auto& [link, value] : column.entries) reversed.add(link, -value, column.square);
  return reversed;
}

RadicalColumns totalOf(const std::vector<RadicalColumns>& loads) {
  RadicalColumns sum;
  for (const RadicalColumns& load : loads)
    for (const RadicalColumns::Column& column : load.columns())
      for (const auto& [link, value] : column.entries) sum.add(link, value, column.square);
  return sum;
}

/// One sense of power: the loads as they are, or reversed.
struct Sense {
  std::vector<RadicalColumns> loads;
  RadicalColumns sum;
  StaticsSolution lossless;
};

class Follower {
 public:
  Follower(const Mechanism& mechanism, const KinematicModel& model, const StaticsReport& report,
           const std::stop_token& stop)
      : m_mechanism(mechanism), m_model(model), m_report(report), m_stop(stop) {}

  /// False where `stop` was requested.
  bool prepare() {
    for (const LoadReport& load : m_report.loads) {
      m_forward.loads.push_back(load.power);
      m_backward.loads.push_back(negatedLoads(load.power));
    }
    m_forward.sum = totalOf(m_forward.loads);
    m_backward.sum = totalOf(m_backward.loads);
    m_forward.lossless = m_report.lossless;
    auto reversed = solveStatics(m_model, m_report.held, m_backward.sum, {}, m_stop);
    if (!reversed) return false;
    m_backward.lossless = std::move(*reversed);
    return true;
  }

  [[nodiscard]] std::vector<int> knownBalances() const {
    std::vector<int> known;
    for (std::size_t part = 0; part < m_report.held.size(); ++part)
      if (m_report.held[part].balance >= 0 &&
          m_report.lossless.isDetermined(m_mechanism.c() + static_cast<int>(part)))
        known.push_back(static_cast<int>(part));
    return known;
  }

  /// None where `stop` was requested.
  std::optional<EfficiencyPoint> pointAt(const Rational& at, const Motion& motion,
                                         const std::vector<MeshEfficiency>& efficiencies,
                                         const std::vector<int>& held) {
    EfficiencyPoint point;
    point.at = at;
    const auto forward =
        solveWithLosses(m_model, m_forward.lossless, m_forward.sum, motion, efficiencies, nullptr, m_stop);
    const auto backward =
        solveWithLosses(m_model, m_backward.lossless, m_backward.sum, motion, efficiencies, nullptr, m_stop);
    if (!forward || !backward) return std::nullopt;
    point.isLocked = forward->outcome == LossySolution::Outcome::selfLocking;
    point.isLockedBackward = backward->outcome == LossySolution::Outcome::selfLocking;
    point.forward = efficiencyOf(*forward, m_forward, motion);
    point.backward = efficiencyOf(*backward, m_backward, motion);
    if (forward->outcome != LossySolution::Outcome::solved) return point;
    for (const int part : held)
      point.torques.push_back(
          forward->statics.values[static_cast<std::size_t>(m_mechanism.c() + part)].number());
    return point;
  }

 private:
  std::optional<double> efficiencyOf(const LossySolution& solution, const Sense& sense,
                                     const Motion& motion) const {
    if (solution.outcome != LossySolution::Outcome::solved) return std::nullopt;
    const auto value = powerSums(m_model, solution, sense.loads, motion).efficiency();
    return value ? std::optional(value->number()) : std::nullopt;
  }

  const Mechanism& m_mechanism;
  const KinematicModel& m_model;
  const StaticsReport& m_report;
  std::stop_token m_stop;
  Sense m_forward;
  Sense m_backward;
};

/// The motion for a ratio of the two inputs' speeds: the first keeps its own, or turns at 1.
class TwoInputs {
 public:
  /// None where `stop` was requested.
  static std::optional<TwoInputs> of(const KinematicModel& model, const MatroidAnalysis& analysis,
                                     const std::stop_token& stop) {
    const Rational own = analysis.speeds.front();
    const Rational speed = own.isZero() ? Rational(1) : own;
    auto first = solveExact(model, analysis.choice.joints, std::vector{speed, Rational(0)}, stop);
    auto second = solveExact(model, analysis.choice.joints, std::vector{Rational(0), speed}, stop);
    if (!first || !second) return std::nullopt;
    return TwoInputs(std::move(first->rates), std::move(second->rates));
  }
  [[nodiscard]] Motion at(const Rational& ratio) const {
    Motion motion = m_first;
    for (std::size_t joint = 0; joint < motion.size(); ++joint) motion[joint] += ratio * m_second[joint];
    return motion;
  }

 private:
  TwoInputs(Motion first, Motion second) : m_first(std::move(first)), m_second(std::move(second)) {}
  Motion m_first;
  Motion m_second;
};

std::vector<Rational> placesOn(const CurveRange& range) {
  std::vector<Rational> places;
  for (int i = 0; i < range.points; ++i)
    places.push_back(range.from + (range.to - range.from) * Rational(i, range.points - 1));
  return places;
}

}  // namespace

std::vector<CurveAxis> curveAxes(const MatroidAnalysis& analysis, const StaticsReport& report,
                                 const StaticsOptions& options) {
  const bool hasCurve = report.isSolved && report.motion && !report.loads.empty() &&
                        report.lossless.isBalanced() && report.lossless.isDeterminate() && !report.isShared;
  if (!hasCurve) return {};
  std::vector<CurveAxis> axes;
  const bool hasLosses = report.lossy && report.lossy->outcome != LossySolution::Outcome::undecided;
  if (options.state < 0 && analysis.choice.joints.size() == 2 && hasLosses)
    axes.push_back(CurveAxis::speedRatio);
  axes.push_back(CurveAxis::meshEfficiency);
  return axes;
}

CurveRange usualRange(CurveAxis axis) {
  if (axis == CurveAxis::speedRatio) return {Rational(-2), Rational(2), 81};
  return {Rational(1, 2), Rational(1), 51};
}

std::optional<EfficiencyCurve> efficiencyCurve(const Mechanism& mechanism, const KinematicModel& model,
                                               const Placement& placement, const MatroidAnalysis& analysis,
                                               const StaticsReport& report, const StaticsOptions& options,
                                               CurveAxis axis, const CurveRange& range,
                                               const std::stop_token& stop) {
  Follower follower(mechanism, model, report, stop);
  if (!follower.prepare()) return std::nullopt;
  EfficiencyCurve curve{axis, analysis.choice.joints, follower.knownBalances(), {}};
  std::optional<TwoInputs> inputs;
  std::vector<MeshEfficiency> efficiencies(static_cast<std::size_t>(mechanism.c()));
  if (axis == CurveAxis::speedRatio) {
    inputs = TwoInputs::of(model, analysis, stop);
    if (!inputs) return std::nullopt;
    std::vector<std::optional<MeshContact>> contacts;
    if (hasFriction(mechanism)) contacts = meshContacts(mechanism, placement, stop);
    if (stop.stop_requested()) return std::nullopt;
    efficiencies = efficienciesOf(mechanism, placement, contacts, options.efficiency);
  }
  for (const Rational& at : placesOn(range)) {
    if (axis == CurveAxis::meshEfficiency)
      std::fill(efficiencies.begin(), efficiencies.end(), MeshEfficiency{at, true, true});
    auto point = follower.pointAt(at, inputs ? inputs->at(at) : *report.motion, efficiencies, curve.held);
    if (!point) return std::nullopt;
    curve.points.push_back(std::move(*point));
  }
  return curve;
}

}  // namespace geargraph
