#include "core/design/collision/motion_diagnostics.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <numbers>
#include <sstream>
#include <utility>

#include "core/foundations/base/locale.h"
#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"
#include "core/machine/body_layout/derived_geometry.h"
#include "core/machine/train/train.h"
#include "core/theory/matroid/exact_solution.h"
#include "core/theory/pose/turning_lines.h"

namespace geargraph {
namespace {

/// Joints times inputs up to which rates are solved in fractions, which periods need.
constexpr std::size_t kMaxExactGains = 20'000;

/// Inputs whose angles a diagnostic gives.
constexpr std::size_t kMaxNamedInputs = 6;

/// With one decimal, below 1 with two digits that count, and no -0.
std::string rounded(double value) {
  const double size = std::abs(value);
  const int decimals = size >= 1 || size < 1e-12 ? 1 : 1 - static_cast<int>(std::floor(std::log10(size)));
  const double unit = std::pow(10, decimals);
  std::ostringstream text;
  text << std::fixed << std::setprecision(decimals) << std::round(value * unit) / unit + 0.0;
  return localizedNumber(text.str());
}

std::optional<JointRates> ratesOf(const AnalysisSnapshot& snapshot, const std::stop_token& stop) {
  const MatroidAnalysis* matroid = snapshot.matroid();
  if (matroid == nullptr || !matroid->solution || hasSlides(*snapshot.mechanism)) return std::nullopt;
  JointRates rates{
      *snapshot.tree, turningLines(snapshot.kinematics->placement()), matroid->solution->rates, {}};
  if (rates.rates.size() * matroid->choice.joints.size() <= kMaxExactGains) {
    auto exact = solveExact(*snapshot.kinematics->model, matroid->choice.joints, matroid->speeds, stop);
    if (!exact) return std::nullopt;
    rates.exact = std::move(exact->rates);
  }
  return rates;
}

/// Does a diagnostic of the train say that these links overlap?
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

  [[nodiscard]] Diagnostic diagnosticOf(const MotionCollision& collision) const {
    const Mechanism& mechanism = *m_snapshot.mechanism;
    const std::string one = std::to_string(mechanism.linkLabel(collision.one));
    const std::string other = std::to_string(mechanism.linkLabel(collision.other));
    Diagnostic diagnostic;
    diagnostic.code = Code::interference;
    diagnostic.detail = Detail::motionCollision;
    diagnostic.message =
        collision.time == 0
            ? translated("Links %1 and %2 overlap in the reference pose: give them clearance.", {one, other})
            : translated("Links %1 and %2 collide %3, with %4. Give them clearance, or limit joints.",
                         {one, other, when(collision.time), inputs(collision.time)}) +
                  ' ' + checked();
    for (const LinkOrdinal link : {collision.one, collision.other})
      diagnostic.elements.emplace_back(mechanism.links[link].id);
    diagnostic.time = collision.time;
    return diagnostic;
  }

 private:
  static std::string when(double time) {
    if (time < 0) return translated("after %1 of the motion backwards", {secondsText(-time)});
    return translated("after %1 of the motion", {secondsText(time)});
  }

  [[nodiscard]] std::string inputs(double time) const {
    const MatroidAnalysis& matroid = *m_snapshot.matroid();
    std::vector<std::string> angles;
    for (const JointOrdinal joint : matroid.choice.joints) {
      const double angle = matroid.solution->rates[joint] * time;
      angles.push_back(translated("%1 at %2 deg", {std::to_string(m_snapshot.graph->edgeLabel(joint)),
                                                   rounded(angle * 180 / std::numbers::pi)}));
    }
    const std::string all = listed(angles, kMaxNamedInputs);
    return angles.size() == 1 ? translated("joint %1", {all}) : translated("joints %1", {all});
  }

  [[nodiscard]] std::string checked() const {
    if (!m_check.isComplete) return translated("(Only part of the motion was checked.)");
    const std::string until = secondsText(m_check.to);
    if (!m_check.coversAll)
      return translated("(Checked for the first %1: the motion does not repeat sooner.)", {until});
    if (!m_isLimited) return translated("(Checked until the motion repeats.)");
    return translated("(Checked between the limits of the joints, from %1 to %2.)",
                      {secondsText(m_check.from), until});
  }

  const AnalysisSnapshot& m_snapshot;
  const MotionCheck& m_check;
  bool m_isLimited;
};

}  // namespace

std::optional<MotionReport> checkMotion(const AnalysisSnapshot& snapshot, const std::stop_token& stop,
                                        const MotionCheckOptions& options) {
  const Mechanism& mechanism = *snapshot.mechanism;
  if (mechanism.n() > kMaxCheckedLinks || hasErrors(snapshot.diagnostics)) return std::nullopt;
  const auto rates = ratesOf(snapshot, stop);
  const auto turns = [](double rate) { return rate != 0; };
  if (!rates || std::none_of(rates->rates.begin(), rates->rates.end(), turns)) return std::nullopt;

  const auto train = snapshot.geometry->train(stop);
  const auto known = snapshot.geometry->diagnostics(stop);
  if (!train || !known) return std::nullopt;
  const std::vector<double> reference(rates->rates.size(), 0);
  const MotionRange range = motionRange(angleLimits(mechanism), reference, rates->rates);
  MotionReport report;
  report.check = motionCollisions(collisionParts(*train, stop), *rates, range, stop, options);
  if (stop.stop_requested()) return std::nullopt;
  const Wording wording(snapshot, report.check, range.isLimited());
  std::size_t unlisted = 0;
  for (const MotionCollision& collision : report.check.collisions) {
    Diagnostic found = wording.diagnosticOf(collision);
    if (isKnown(*known, found.elements[0], found.elements[1])) continue;
    if (report.diagnostics.size() < kMaxMotionDiagnostics) {
      report.diagnostics.push_back(std::move(found));
    } else {
      ++unlisted;
    }
  }
  if (unlisted > 0)
    report.diagnostics.back().message +=
        ' ' + (unlisted == 1
                   ? translated("(1 more pair of links collides later.)")
                   : translated("(%1 more pairs of links collide later.)", {std::to_string(unlisted)}));
  return report;
}

std::string secondsText(double seconds) {
  return rounded(seconds) + " s";
}

std::string motionNote(const AnalysisSnapshot& snapshot, const MotionReport* report) {
  if (snapshot.mechanism->n() > kMaxCheckedLinks && !hasErrors(snapshot.diagnostics))
    return translated("The motion of more than %1 links is not checked for collisions.",
                      {std::to_string(kMaxCheckedLinks)});
  if (report == nullptr) return {};
  const MotionCheck& check = report->check;
  if (!check.isComplete)
    return translated(
        "Only part of the motion was checked for collisions: too many parts come close to each other.");
  if (check.coversAll) return {};
  return translated("The motion was checked for collisions for its first %1: it does not repeat sooner.",
                    {secondsText(check.to)});
}

}  // namespace geargraph
