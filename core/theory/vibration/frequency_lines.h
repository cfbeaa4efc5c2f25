#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/foundations/base/rational.h"
#include "core/mechanism/model/mechanism.h"
#include "core/mechanism/placement/placement.h"
#include "core/theory/matroid/kinematic_model.h"

namespace geargraph {

/// What repeats at a frequency. P. D. McFadden, J. D. Smith, Proc. IMechE 199 C1, 1985, 65-70 (planetary
/// sets); R. B. Randall, Vibration-based Condition Monitoring, 2011 (hunting tooth).
enum class FrequencyKind : std::uint8_t {
  shaft,          ///< turns of a link against the ground
  joint,          ///< turns of a link against the moving link that bears it: a planet on its pin
  planetPass,     ///< planets that pass one tooth of a gear: their number times carrier against gear
  toothMesh,      ///< teeth that enter a mesh, and multiples of it (harmonics)
  sideband,       ///< a harmonic of a mesh, plus or minus turns of a wheel or passes of planets
  assemblyPhase,  ///< tooth mesh over gcd(N_i, N_j): wear repeats with it
  huntingTooth,   ///< the same two teeth meet again: tooth mesh over lcm(N_i, N_j)
};

/// "shaft", "joint", "planet-pass", "tooth-mesh", "sideband", "assembly-phase", "hunting-tooth".
[[nodiscard]] std::string_view frequencyKindName(FrequencyKind kind);

/// A line of the spectrum.
struct FrequencyLine {
  FrequencyKind kind = FrequencyKind::shaft;
  std::optional<LinkOrdinal> link = {};    ///< shaft; the gear that is passed; the wheel that modulates
  std::optional<JointOrdinal> joint = {};  ///< of FrequencyKind::joint
  std::optional<MeshOrdinal> mesh = {};    ///< of the four kinds of meshes
  int harmonic = 1;                        ///< multiple of the tooth mesh; 1 but for toothMesh and sideband
  int sideband = 0;                        ///< -2, -1, 1, 2: how many of what modulates are added
  int planets = 0;                         ///< planets that pass, of planetPass and of sidebands by them
  /// The frequency over that of the reference shaft, above 0: cycles a turn of it. Exact.
  Rational ratio = {};
};

struct FrequencyOptions {
  int harmonics = 1;  ///< of each mesh, 1 to kMaxHarmonics
  int sidebands = 1;  ///< on each side of each harmonic, 0 to kMaxSidebands
  /// How many equally spaced planets a planet stands for that is drawn alone, 1 to kMaxPlanets.
  int planets = 1;

  static constexpr int kMaxHarmonics = 20;
  static constexpr int kMaxSidebands = 20;
  static constexpr int kMaxPlanets = 100;
};

/// The rates of all joints in a motion (rad/s, or for a drive at 1).
struct FrequencyMotion {
  std::span<const Rational> rates;
  /// A motion of links that turn freely beside `rates` (StateSolution::idleRates); empty: none. What turns in
  /// it has no frequency.
  std::span<const Rational> idle = {};
};

/// The speed of a link against the ground about its one direction, without its sign: std::nullopt where it
/// turns about several directions at once or freely. @pre the placement has a tree; a rate for every joint
[[nodiscard]] std::optional<Rational> shaftSpeed(const Placement& placement, const FrequencyMotion& motion,
                                                 LinkOrdinal link);

/// All lines of a motion: shafts, joints, planets, then for each mesh its harmonics, each with its sidebands,
/// assembly phase and hunting tooth. What is at rest has none; nor has what turns freely, and no shaft that
/// turns about several directions at once.
///
/// Identity  N_i |w_i - w_k| = N_j |w_j - w_k| for every mesh, k its carrier.
/// Cost      O(n + c log c), times harmonics and sidebands; with a joint's path to the ground a link.
/// @pre model and placement are the mechanism's; the rates fulfil its meshes; reference > 0, the speed of the
/// reference shaft in the unit of the rates
[[nodiscard]] std::vector<FrequencyLine> frequencyLines(
    const Mechanism& mechanism, const Placement& placement, const KinematicModel& model,
    const FrequencyMotion& motion, const Rational& reference, const FrequencyOptions& options = {});

}  // namespace geargraph
