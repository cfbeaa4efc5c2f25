#include "core/presentation/meshfile/train_files.h"

#include <cmath>
#include <numbers>

#include "core/foundations/base/contract.h"
#include "core/machine/teeth/half_tooth.h"
#include "core/machine/teeth/wheel_kind.h"
#include "core/theory/pose/turning_lines.h"

namespace geargraph {
namespace {

/// Rate of a gear against its carrier about the line of their axis class.
Rational relativeRate(const PlacedTrain& placed, std::span<const Rational> rates, LinkOrdinal carrier,
                      int gear) {
  Rational sum;
  for (const PathStep& step : treePath(placed.tree, carrier, gear)) {
    const auto joint = static_cast<std::size_t>(step.joint);
    const int sense = step.direction * placed.placement.classes->orientationSign[joint];
    sum += Rational(sense) * rates[joint];
  }
  return sum;
}

/// The circles where they are not what module, teeth, shift, addendum and dedendum say.
void setCircles(AssemblyGear& gear, const GearSpec& spec) {
  if (isConical(spec) || isFaceGear(spec) || !isToothed(spec)) return;
  const HalfTooth tooth = toothOf(spec, kScreenTolerance);
  const double pitch = 0.5 * spec.teeth;
  const double outward = isRing(spec) ? -1 : 1;
  const double tip = pitch + outward * spec.addendum + spec.profileShift;
  const double root = pitch - outward * spec.dedendum + spec.profileShift;
  constexpr double kSame = 1e-9;
  if (std::abs(tooth.tipRad - tip) > kSame) gear.tipCircle = tooth.tipRad * spec.module;
  if (std::abs(tooth.rootRad - root) > kSame) gear.rootCircle = tooth.rootRad * spec.module;
}

AssemblyGear assemblyGear(const TrainGear& source, const GearSpec& spec, std::shared_ptr<const Solid> solid) {
  AssemblyGear gear;
  gear.name = source.name;
  gear.kind = spec.kind;
  gear.teeth = spec.teeth;
  gear.module = spec.module;
  gear.pressureAngle = spec.pressureAngle;
  gear.profileShift = spec.profileShift;
  gear.width = spec.faceWidth;
  gear.bore = spec.bore;
  gear.coneAngle = spec.coneAngle;
  gear.helixAngle = spec.helixAngle;
  gear.herringbone = spec.herringbone;
  gear.backlashAllowance = spec.backlashAllowance * spec.module;
  gear.addendum = spec.addendum;
  gear.dedendum = spec.dedendum;
  gear.rootRadius = spec.rootRadius;
  setCircles(gear, spec);
  gear.solid = std::move(solid);
  gear.pose = source.pose;
  return gear;
}

/// The motion that moves most meshes, and by how many pitches.
struct ChosenMotion {
  const std::vector<Rational>* rates = nullptr;
  std::vector<double> pitches;
};

ChosenMotion chosen(const PlacedTrain& placed, std::span<const std::vector<Rational>> motions) {
  GEARGRAPH_REQUIRE(!motions.empty());
  ChosenMotion best;
  std::ptrdiff_t mostMoving = -1;
  for (const std::vector<Rational>& rates : motions) {
    std::vector<double> pitches = pitchRates(placed, rates);
    const auto moving = std::count_if(pitches.begin(), pitches.end(), [](double p) { return p != 0; });
    if (moving > mostMoving) {
      mostMoving = moving;
      best = {&rates, std::move(pitches)};
    }
  }
  return best;
}

}  // namespace

PlacedTrain::PlacedTrain(const Mechanism& aMechanism, const SpanningTree& aTree, const Placement& aPlacement,
                         const GearTrain& aTrain)
    : mechanism(aMechanism),
      tree(aTree),
      placement(aPlacement),
      train(aTrain),
      kinematics(aTree, turningLines(aPlacement)) {}

double expectedTriangles(const GearTrain& train, double tolerance) {
  constexpr double kTrianglesPerTooth = 130;  // at export tolerance, spur gears and bevels alike
  double triangles = 0;
  for (const TrainGear& gear : train.gears) triangles += kTrianglesPerTooth * gear.spec.teeth;
  return triangles *
         std::sqrt(kExportTolerance / tolerance);  // arcs: chords go with the root of the tolerance
}

std::vector<Rational> genericSpeeds(std::size_t count) {
  std::vector<Rational> speeds;
  for (std::size_t k = 0; k < count; ++k) {
    const auto i = static_cast<std::int64_t>(k);
    speeds.emplace_back(1000 + 97 * i * i + 31 * i, 1000);
  }
  return speeds;
}

std::vector<double> pitchRates(const PlacedTrain& placed, std::span<const Rational> rates) {
  std::vector<double> pitches;
  for (const TrainMesh& mesh : placed.train.meshes) {
    const TrainGear& tail = placed.train.gears[static_cast<std::size_t>(mesh.tailGear)];
    const auto& geometry = placed.placement.meshes[mesh.mesh];
    GEARGRAPH_REQUIRE(geometry.has_value());
    const Rational rate = relativeRate(placed, rates, geometry->carrier, tail.link);
    pitches.push_back((Rational(tail.spec.teeth) * rate).toDouble() / (2 * std::numbers::pi));
  }
  return pitches;
}

Expected<Assembly> assemblyOf(const PlacedTrain& placed, GearCache& cache, double tolerance,
                              std::span<const std::vector<Rational>> motions, std::size_t frames) {
  GEARGRAPH_REQUIRE(frames >= kMinFrames);
  Assembly assembly;
  assembly.unit = placed.mechanism.unit;
  Diagnostics failures;
  for (const TrainGear& gear : placed.train.gears) {
    GearSpec spec = gear.spec;
    spec.body = GearBody::plain;
    auto solid = cache.solid(spec, tolerance);
    if (solid) {
      assembly.gears.push_back(assemblyGear(gear, spec, *std::move(solid)));
    } else {
      failures.insert(failures.end(), solid.error().begin(), solid.error().end());
    }
  }
  if (!failures.empty()) return failures;
  for (const TrainMesh& mesh : placed.train.meshes) {
    assembly.meshes.push_back(
        {static_cast<std::size_t>(mesh.tailGear), static_cast<std::size_t>(mesh.headGear)});
  }
  const ChosenMotion motion = chosen(placed, motions);
  for (const double time : frameTimes(motion.pitches, frames)) {
    std::vector<double> angles;
    for (const Rational& rate : *motion.rates) angles.push_back(rate.toDouble() * time);
    const std::vector<Eigen::Isometry3d> links = placed.kinematics.poses(angles);
    auto& frame = assembly.frames.emplace_back();
    for (const TrainGear& gear : placed.train.gears) {
      frame.push_back(links[static_cast<std::size_t>(gear.link)] * gear.pose);
    }
  }
  return assembly;
}

}  // namespace geargraph
