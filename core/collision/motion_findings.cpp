#include "core/collision/motion_findings.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <numbers>
#include <sstream>
#include <utility>

#include "core/base/wording.h"
#include "core/gears/train.h"
#include "core/matroid/exact_solution.h"
#include "core/pose/turning_lines.h"

namespace geargraph {
namespace {

/// Joints times inputs up to which rates are solved in fractions, which periods need.
constexpr std::size_t kMostExactGains = 20'000;

/// With one decimal and no -0.
std::string rounded(double value) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << std::round(value * 10) / 10 + 0.0;
  return text.str();
}

std::optional<JointRates> ratesOf(const AnalysisSnapshot& snapshot, const std::stop_token& stop) {
  const MatroidAnalysis* matroid = snapshot.matroid();
  if (matroid == nullptr || !matroid->solution) return std::nullopt;
  JointRates rates{
      *snapshot.tree, turningLines(snapshot.kinematics->placement), matroid->solution->rates, {}};
  if (rates.rates.size() * matroid->choice.joints.size() <= kMostExactGains) {
    auto exact = solveExact(*snapshot.kinematics->model, matroid->choice.joints, matroid->speeds, stop);
    if (!exact) return std::nullopt;
    rates.exact = std::move(exact->rates);
  }
  return rates;
}

/// Does a finding of the train say that these links overlap?
bool isKnown(const Diagnostics& known, const ElementId& one, const ElementId& other) {
  return std::any_of(known.begin(), known.end(), [&](const Diagnostic& diagnostic) {
    const auto names = [&](const ElementId& link) {
      return std::find(diagnostic.elements.begin(), diagnostic.elements.end(), link) !=
             diagnostic.elements.end();
    };
    const bool isOverlap = diagnostic.detail == Detail::bodiesOverlap ||
                           diagnostic.detail == Detail::wheelsOverlap ||
                           diagnostic.detail == Detail::planetsOverlap;
    return isOverlap && names(one) && names(other);
  });
}

class Wording {
 public:
  Wording(const AnalysisSnapshot& snapshot, const MotionCheck& check, bool isLimited)
      : m_snapshot(snapshot), m_check(check), m_isLimited(isLimited) {}

  [[nodiscard]] Diagnostic finding(const MotionCollision& collision) const {
    const Mechanism& mechanism = *m_snapshot.mechanism;
    const std::string links = "Links " + std::to_string(mechanism.linkLabel(collision.one)) + " and " +
                              std::to_string(mechanism.linkLabel(collision.other));
    Diagnostic diagnostic;
    diagnostic.code = Code::interference;
    diagnostic.detail = Detail::motionCollision;
    diagnostic.message = collision.time == 0
                             ? links + " overlap in the reference pose: leave more room between them."
                             : links + " collide " + when(collision.time) + ", with " +
                                   inputs(collision.time) +
                                   ". Leave more room between them, or give joints limits. " + checked();
    for (const int link : {collision.one, collision.other})
      diagnostic.elements.emplace_back(mechanism.links[static_cast<std::size_t>(link)].id);
    diagnostic.time = collision.time;
    return diagnostic;
  }

 private:
  static std::string when(double time) {
    if (time < 0) return "after " + rounded(-time) + " s of the motion backwards";
    return "after " + rounded(time) + " s of the motion";
  }

  [[nodiscard]] std::string inputs(double time) const {
    const MatroidAnalysis& matroid = *m_snapshot.matroid();
    std::vector<std::string> angles;
    for (const int joint : matroid.choice.joints) {
      const double angle = matroid.solution->rates[static_cast<std::size_t>(joint)] * time;
      angles.push_back(std::to_string(m_snapshot.graph->edgeLabel(joint)) + " at " +
                       rounded(angle * 180 / std::numbers::pi) + " deg");
    }
    return (angles.size() == 1 ? "joint " : "joints ") + listed(angles, kAllNames);
  }

  [[nodiscard]] std::string checked() const {
    const std::string until = rounded(m_check.to) + " s";
    if (m_isLimited)
      return "(Checked between the limits of the joints, from " + rounded(m_check.from) + " s to " + until +
             ".)";
    if (m_check.coversAll) return "(Checked until the motion repeats.)";
    return "(Checked for the first " + until + ": the motion does not repeat sooner.)";
  }

  const AnalysisSnapshot& m_snapshot;
  const MotionCheck& m_check;
  bool m_isLimited;
};

}  // namespace

std::optional<MotionReport> checkMotion(const AnalysisSnapshot& snapshot, const std::stop_token& stop,
                                        const MotionCheckOptions& options) {
  const Mechanism& mechanism = *snapshot.mechanism;
  if (mechanism.n() > kMostCheckedLinks || hasErrors(snapshot.diagnostics)) return std::nullopt;
  const auto rates = ratesOf(snapshot, stop);
  const auto turns = [](double rate) { return rate != 0; };
  if (!rates || std::none_of(rates->rates.begin(), rates->rates.end(), turns)) return std::nullopt;

  const GearTrain train = trainOf(mechanism, snapshot.kinematics->placement, stop);
  if (stop.stop_requested()) return std::nullopt;
  const std::vector<double> reference(rates->rates.size(), 0);
  const MotionRange range = motionRange(angleLimits(mechanism), reference, rates->rates);
  MotionReport report;
  report.check = motionCollisions(collisionParts(train), *rates, range, stop, options);
  if (stop.stop_requested()) return std::nullopt;
  const Wording wording(snapshot, report.check, range.isLimited());
  std::size_t unlisted = 0;
  for (const MotionCollision& collision : report.check.collisions) {
    Diagnostic found = wording.finding(collision);
    if (isKnown(train.diagnostics, found.elements[0], found.elements[1])) continue;
    if (report.diagnostics.size() < kMostMotionFindings) {
      report.diagnostics.push_back(std::move(found));
    } else {
      ++unlisted;
    }
  }
  if (unlisted > 0)
    report.diagnostics.back().message +=
        " (Later, " + std::to_string(unlisted) + " more pairs of links collide.)";
  return report;
}

}  // namespace geargraph
