#include "core/theory/statics/statics_agreement.h"

#include <cmath>

namespace geargraph {
namespace {

/// Rounded numbers of both agree to the digits that a few hundred operations leave.
bool agree(const Real& a, const Real& b) {
  constexpr double kRounding = 1e-9;
  if (a.isExact() && b.isExact()) return a == b;
  const double size = std::abs(a.number()) + std::abs(b.number());
  return std::abs(a.number() - b.number()) <= kRounding * size;
}

}  // namespace

StaticsAgreement staticsAgreement(const KinematicModel& model, const StaticsSolution& matroid,
                                  const TtTorques& ttGraph) {
  StaticsAgreement result;
  result.equal = matroid.isBalanced() == ttGraph.isBalanced;
  const bool valued = matroid.isBalanced() && ttGraph.isBalanced;
  const auto compare = [&](const Real& a, const Real& b) {
    ++result.compared;
    if (agree(a, b)) return true;
    const Real difference = (a - b).abs();
    if (difference.number() > result.largestDifference.number()) result.largestDifference = difference;
    return false;
  };
  for (MeshOrdinal mesh = 0; mesh < model.c(); ++mesh) {
    const auto at = static_cast<std::size_t>(mesh);
    bool same = matroid.determined[at] == ttGraph.meshDetermined[at];
    if (same && valued && matroid.determined[at] != 0) {
      const KinematicModel::MeshRow& row = model.meshRow(mesh);
      const Real& mu = matroid.values[at];
      same = compare(Real(-row.tailTeeth) * mu, ttGraph.tailPorts[at]) &&
             compare(Real(row.sign * row.headTeeth) * mu, ttGraph.headPorts[at]);
    }
    if (!same) result.meshes.push_back(mesh);
  }
  for (std::size_t part = 0; part < matroid.held.size(); ++part) {
    const std::size_t at = static_cast<std::size_t>(model.c()) + part;
    bool same = matroid.determined[at] == ttGraph.chordDetermined[part];
    if (same && valued && matroid.determined[at] != 0)
      same = compare(matroid.values[at], ttGraph.chords[part]);
    if (!same) result.held.push_back(static_cast<int>(part));
  }
  result.equal = result.equal && result.meshes.empty() && result.held.empty();
  return result;
}

std::vector<TtChord> chordsOf(std::span<const HeldPart> held) {
  std::vector<TtChord> chords;
  for (const HeldPart& part : held) chords.push_back(part.byJoint);
  return chords;
}

}  // namespace geargraph
