#include "core/theory/statics/locking_limits.h"

#include <algorithm>

#include "core/machine/train/mesh_contact.h"

namespace geargraph {
namespace {

constexpr int kLockingPoints = 17;
const Rational kLeastEfficiency(1, 100);
constexpr double kLockingPrecision = 1e-6;

/// How all meshes lose more and more: 0 nothing, 1 the most that is tried.
struct LossPath {
  LockingScale scale = LockingScale::sameEfficiency;
  ByMesh<Rational> losses;  ///< 1 - eta_c at 1
  bool isExact = true;
  double mostStated = 0;  ///< the greatest stated loss, of the scale statedLosses

  [[nodiscard]] std::vector<MeshEfficiency> at(const Rational& place) const {
    std::vector<MeshEfficiency> efficiencies;
    for (const Rational& loss : losses) efficiencies.push_back({Rational(1) - place * loss, true, isExact});
    return efficiencies;
  }
  /// The value that is told: an efficiency, or a factor of the stated losses.
  [[nodiscard]] double valueAt(const Rational& place) const {
    const double most = (Rational(1) - kLeastEfficiency).toDouble();
    return scale == LockingScale::sameEfficiency ? 1 - place.toDouble() * most
                                                 : place.toDouble() * most / mostStated;
  }
};

/// Meshes that do not roll lose nothing, whatever they state.
LossPath pathOf(const std::vector<MeshEfficiency>& stated, const std::vector<char>& rolls) {
  LossPath path;
  Rational most = 0;
  Rational least = 1;
  for (std::size_t mesh = 0; mesh < stated.size(); ++mesh) {
    if (rolls[mesh] == 0) continue;
    const Rational loss = Rational(1) - stated[mesh].value;
    most = std::max(most, loss);
    least = std::min(least, loss);
  }
  const Rational range = Rational(1) - kLeastEfficiency;
  const bool areDifferent = least < most;
  if (areDifferent) path.scale = LockingScale::statedLosses;
  path.mostStated = most.toDouble();
  for (std::size_t mesh = 0; mesh < stated.size(); ++mesh) {
    const Rational loss = areDifferent ? (Rational(1) - stated[mesh].value) * range / most : range;
    path.losses.push_back(rolls[mesh] == 0 ? Rational(0) : loss);
    if (areDifferent) path.isExact = path.isExact && stated[mesh].isExact;
  }
  return path;
}

/// One sense of power: the loads as they are, or reversed.
struct LockingSense {
  StaticsSolution lossless;
  RadicalColumns loads;
};

class LockingSearch {
 public:
  LockingSearch(const KinematicModel& model, const Motion& motion, const LossPath& path,
                const CoefficientMatrix* stiffness, int mostCheap, const std::stop_token& stop)
      : m_model(model),
        m_motion(motion),
        m_path(path),
        m_stiffness(stiffness),
        m_mostCheap(mostCheap),
        m_stop(stop) {}

  /// False where `stop` was requested.
  bool run(const LockingSense& sense, std::optional<LockingBracket>& result) const {
    // Trying all patterns at every value is for few meshes. Else the iteration guides, and only what it
    // finds at the end is tried whole; where that differs, every value is.
    bool isWhole = lossyMeshes() <= m_mostCheap;
    const bool canBeWhole = lossyMeshes() <= kMaxPatternMeshes;
    for (;;) {
      Places places;
      if (!findPlaces(sense, isWhole, places)) return false;
      result.reset();
      if (!places.locks) return true;
      result = LockingBracket{m_path.valueAt(places.moves), m_path.valueAt(*places.locks), canBeWhole};
      if (isWhole || !canBeWhole) return true;
      const std::optional<bool> moves = movesAt(sense, *places.locks, true);
      if (!moves) return false;
      if (!*moves) return true;
      isWhole = true;
    }
  }

 private:
  struct Places {
    Rational moves = 0;
    std::optional<Rational> locks;
  };

  [[nodiscard]] int lossyMeshes() const {
    return static_cast<int>(std::count_if(m_path.losses.begin(), m_path.losses.end(),
                                          [](const Rational& loss) { return !loss.isZero(); }));
  }

  std::optional<bool> movesAt(const LockingSense& sense, const Rational& place, bool isWhole) const {
    const auto solution = solveWithLosses(m_model, sense.lossless, sense.loads, m_motion, m_path.at(place),
                                          m_stiffness, m_stop, isWhole ? kMaxPatternMeshes : 0);
    if (!solution) return std::nullopt;
    return solution->outcome == LossySolution::Outcome::solved;
  }

  /// The first of evenly spaced places where it locks, and closer and closer.
  bool findPlaces(const LockingSense& sense, bool isWhole, Places& places) const {
    Rational from = 0;
    Rational to = 1;
    do {
      const Rational step = (to - from) / Rational(kLockingPoints - 1);
      const bool hasLocked = places.locks.has_value();  // at the last of them
      std::optional<Rational> locks = places.locks;
      for (int i = 1; i < kLockingPoints - (hasLocked ? 1 : 0); ++i) {
        const Rational place = from + Rational(i) * step;
        const std::optional<bool> moves = movesAt(sense, place, isWhole);
        if (!moves) return false;
        if (!*moves) {
          locks = place;
          break;
        }
        places.moves = place;
      }
      if (!locks) return true;
      places.locks = locks;
      from = places.moves;
      to = *locks;
    } while ((to - from).toDouble() > kLockingPrecision);
    return true;
  }

  const KinematicModel& m_model;
  const Motion& m_motion;
  const LossPath& m_path;
  const CoefficientMatrix* m_stiffness;
  int m_mostCheap;
  std::stop_token m_stop;
};

RadicalColumns sumOfLoads(const std::vector<LoadReport>& loads, bool isReversed) {
  RadicalColumns sum;
  for (const LoadReport& load : loads)
    for (const RadicalColumns::Column& column : load.power.columns())
      for (const auto& [link, value] : column.entries)
        sum.add(link, isReversed ? -value : value, column.square);
  return sum;
}

}  // namespace

bool hasLockingLimits(const StaticsReport& report) {
  return report.isSolved && report.motion && !report.loads.empty() && report.lossless.isBalanced() &&
         report.lossless.isDeterminate();
}

std::optional<LockingLimits> lockingLimits(const Mechanism& mechanism, const KinematicModel& model,
                                           const Placement& placement, const StaticsReport& report,
                                           const StaticsOptions& options, const std::stop_token& stop,
                                           int mostCheap) {
  std::vector<std::optional<MeshContact>> contacts;
  if (hasFriction(mechanism)) contacts = meshContacts(mechanism, placement, stop);
  if (stop.stop_requested()) return std::nullopt;
  const LossPath path = pathOf(efficienciesOf(mechanism, placement, contacts, options.efficiency),
                               powersOf(model, report.lossless, *report.motion).rolls);
  std::optional<CoefficientMatrix> matrix;
  if (report.isShared) matrix.emplace(mechanism, model, placement);
  const CoefficientMatrix* const stiffness = matrix ? &*matrix : nullptr;

  const LockingSense forward{report.lossless, sumOfLoads(report.loads, false)};
  LockingSense backward{{}, sumOfLoads(report.loads, true)};
  auto reversed = solveStatics(model, report.held, backward.loads, {}, stop);
  if (!reversed) return std::nullopt;
  backward.lossless = std::move(*reversed);
  if (stiffness != nullptr && !shareByStiffness(model, *stiffness, backward.lossless, stop))
    return std::nullopt;

  LockingLimits limits;
  limits.scale = path.scale;
  limits.leastEfficiency = kLeastEfficiency.toDouble();
  const LockingSearch search(model, *report.motion, path, stiffness, mostCheap, stop);
  if (!search.run(forward, limits.forward) || !search.run(backward, limits.backward)) return std::nullopt;
  return limits;
}

}  // namespace geargraph
