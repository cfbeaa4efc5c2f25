#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/foundations/base/translation.h"
#include "core/machine/solids/part_solids.h"
#include "core/machine/solids/wheel_form.h"
#include "core/machine/teeth/face_gear.h"

// A face gear: teeth on a plane ring, its body behind them.

namespace geargraph {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;

/// Thickness of the body below the roots, in modules.
constexpr double kFaceBody = 1.2;
/// From the roots to where the body's inner face begins.
constexpr double kFaceMargin = 0.15;

double outerOf(const GearSpec& s) {
  return faceInner(s) + s.faceWidth;
}

double rootHeight(const GearSpec& s) {
  return (s.dedendum - s.profileShift) * s.module;
}

double tipHeight(const GearSpec& s) {
  return -(s.addendum + s.profileShift) * s.module;
}

std::vector<ProfileVertex> faceBody(const GearSpec& s) {
  const double back = rootHeight(s) + kFaceBody * s.module, front = rootHeight(s) + kFaceMargin * s.module;
  return {{outerOf(s), back}, {s.bore / 2, back}, {s.bore / 2, front}, {faceInner(s), front}};
}

std::optional<WebWindows> faceWindows(const GearSpec& /*spec*/) {
  return std::nullopt;
}

std::vector<ProfileVertex> faceOutline(const GearSpec& spec) {
  std::vector<ProfileVertex> outline = faceBody(spec);
  outline.push_back({faceInner(spec), tipHeight(spec)});
  outline.push_back({outerOf(spec), tipHeight(spec)});
  return outline;
}

AxialSpan faceSpan(const GearSpec& spec) {
  return spanOf(faceOutline(spec));
}

double largestFaceBore(const GearSpec& spec) {
  return 2 * (faceInner(spec) - 0.5 * spec.module);
}

/// One cylinder of the teeth: half a tooth from the middle of the space to the middle of the tip.
struct FaceSection {
  std::vector<WallPoint> points;
  std::vector<char> isCorner;
};

class FaceTeeth {
 public:
  FaceTeeth(const GearSpec& spec, double tolerance)
      : m_spec(spec),
        m_cut(spec),
        m_flankSteps(static_cast<int>(std::ceil(kHeightSteps / std::sqrt(tolerance)))) {}

  [[nodiscard]] FaceSection at(double rho) const {
    FaceSection section;
    const double middle = pi / m_spec.teeth;
    const double root = m_cut.rootDepth(), tip = m_cut.tipDepth();
    const auto add = [&](double gam, double depth, const Vector3d& normal, bool isCorner) {
      const double z = depth - m_cut.axisHeight();
      section.points.push_back(
          {m_spec.module * Vector3d(rho * std::cos(gam), rho * std::sin(gam), z), normal});
      section.isCorner.push_back(isCorner ? 1 : 0);
    };
    const Vector3d up = -Vector3d::UnitZ();
    const double foot = m_cut.halfTooth(rho, root);
    add(middle, root, up, false);
    add(foot, root, up, false);
    for (int i = 0; i <= m_flankSteps; ++i) {
      const double depth =
          root + (tip - root) * std::pow(static_cast<double>(i) / m_flankSteps, kTowardsRoot);
      const double gam = m_cut.halfTooth(rho, depth);
      add(gam, depth, normalAt(rho, depth, gam), i == 0);
    }
    const double edge = m_cut.halfTooth(rho, tip);
    add(edge, tip, up, true);
    add(0, tip, up, false);
    return section;
  }

  static constexpr double kHeightSteps = 0.9;  ///< over the root of the tolerance: flanks bend so much
  static constexpr double kTowardsRoot = 1.5;  ///< and most of it near the roots

 private:
  /// Out of the tooth, of the half with gam >= 0: the gradient of gam - halfTooth().
  [[nodiscard]] Vector3d normalAt(double rho, double depth, double gam) const {
    constexpr double kStep = 1e-5;
    const double high = std::min(depth + kStep, m_cut.rootDepth()), low = high - 2 * kStep;
    const double byDepth = (m_cut.halfTooth(rho, high) - m_cut.halfTooth(rho, low)) / (high - low);
    const double byRadius =
        (m_cut.halfTooth(rho + kStep, depth) - m_cut.halfTooth(rho - kStep, depth)) / (2 * kStep);
    const double c = std::cos(gam), s = std::sin(gam);
    const Vector3d along(c, s, 0), across(-s, c, 0);
    return (across / rho - byRadius * along - byDepth * Vector3d::UnitZ()).normalized();
  }

  const GearSpec& m_spec;
  FaceCut m_cut;
  int m_flankSteps;
};

Solid faceSolid(const GearSpec& spec, double tolerance) {
  const FaceTeeth teeth(spec, tolerance);
  const double inner = faceInner(spec) / spec.module, outer = outerOf(spec) / spec.module;
  constexpr double kAlongSteps = 0.35;  // flanks bend less along the teeth
  const int layers =
      std::max(2, static_cast<int>(std::ceil(kAlongSteps * (outer - inner) / std::sqrt(tolerance))));
  GearBlank blank;
  blank.teeth = spec.teeth;
  blank.below = {faceBody(spec), std::nullopt, tolerance * spec.module};
  std::vector<char> corners;
  for (int i = 0; i <= layers; ++i) {
    FaceSection section = teeth.at(inner + (outer - inner) * i / layers);
    corners = std::move(section.isCorner);
    blank.sections.push_back(std::move(section.points));
  }
  for (std::size_t p = 0; p < corners.size(); ++p) {
    const WallPoint &bottom = blank.sections.front()[p], &top = blank.sections.back()[p];
    const Vector3d out(std::cos(std::atan2(top.position.y(), top.position.x())),
                       std::sin(std::atan2(top.position.y(), top.position.x())), 0);
    const Vector3d in(-std::cos(std::atan2(bottom.position.y(), bottom.position.x())),
                      -std::sin(std::atan2(bottom.position.y(), bottom.position.x())), 0);
    blank.half.push_back({bottom.position, top.position, top.normal, in, out, corners[p] != 0});
  }
  return meshed(blank);
}

Solid toothlessFace(const GearSpec& spec, double chord) {
  return revolved(faceOutline(spec), chord);
}

void checkFace(const GearSpec& spec, Diagnostics& found) {
  if (spec.mateTeeth < kMinGearTeeth || spec.mateTeeth >= spec.teeth) {
    found.push_back(specRejection(translated("A face gear has more teeth than its pinion.")));
  } else if (spec.faceWidth <= 0.2 * spec.module || spec.faceWidth > 1.001 * usualFaceGearFace(spec)) {
    found.push_back(specRejection(translated(
        "The face of %1 is wider than the teeth of a face gear are, or leaves none: make it at most "
        "%2.",
        {oneDecimal(spec.faceWidth), oneDecimal(usualFaceGearFace(spec))})));
  }
}

}  // namespace

constexpr WheelForm kFaceForm{.body = faceBody,
                              .windows = faceWindows,
                              .outline = faceOutline,
                              .span = faceSpan,
                              .largestBore = largestFaceBore,
                              .solid = faceSolid,
                              .toothless = toothlessFace,
                              .check = checkFace,
                              .checkBody = checkBore,
                              .tooFewTeeth = tooFewForRack};

}  // namespace geargraph
