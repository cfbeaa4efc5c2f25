#include "core/theory/statics/live_statics.h"

#include <cmath>

#include "core/foundations/exact/elimination.h"
#include "core/theory/statics/statics_system.h"

namespace geargraph {

std::optional<LiveStatics> solveStaticsLive(const KinematicModel& model, const ModularDoubleField& field,
                                            std::span<const HeldPart> held, const RadicalColumns& loads,
                                            const std::stop_token& stop) {
  const auto weight = [&](MeshOrdinal mesh, bool tail) {
    const KinematicModel::MeshRow& row = model.meshRow(mesh);
    return field.fromInteger(tail ? row.tailTeeth : row.headTeeth);
  };
  const auto fused = [&](const Rational& factor) -> ModularDouble {
    // A denominator that the prime divides: any residue but 0 keeps the double alive.
    return {factor.toDouble(), field.prime().fromRational(factor).value_or(field.prime().one())};
  };
  const int unknowns = model.c() + static_cast<int>(held.size());
  const auto system = eliminate(field, staticsRows(model, field, held, loads, weight, fused), unknowns,
                                unknowns + loads.count(), stop);
  if (!system) return std::nullopt;
  LiveStatics result;
  result.rank = system->rank();
  result.indeterminate = static_cast<int>(system->freeColumns.size());
  result.determined.assign(static_cast<std::size_t>(unknowns), 1);
  result.values.assign(static_cast<std::size_t>(unknowns), 0);
  std::vector<ModularDouble> x(static_cast<std::size_t>(system->columns));
  if (result.indeterminate > 0) {
    // A sum of self-stresses at random: what is 0 in it is 0 in all of them.
    ResidueStream random(field.prime(), 0x737472657373U);
    for (const int column : system->freeColumns) x[static_cast<std::size_t>(column)] = {0, random.next()};
    substitute(field, *system, x);
    for (int unknown = 0; unknown < unknowns; ++unknown) {
      if (x[static_cast<std::size_t>(unknown)].residue != 0)
        result.determined[static_cast<std::size_t>(unknown)] = 0;
    }
  }
  for (int k = 0; k < loads.count(); ++k) {
    const RadicalColumns::Column& part = loads.columns()[static_cast<std::size_t>(k)];
    if (part.entries.empty()) continue;
    std::fill(x.begin(), x.end(), ModularDouble());
    x[static_cast<std::size_t>(unknowns + k)] = field.one();
    substitute(field, *system, x);
    for (const auto& check : system->checks)
      result.isBalanced = result.isBalanced && field.isZero(checkValue(field, *system, check, x));
    const double root = k == 0 ? 1 : std::sqrt(part.square.toDouble());
    for (int unknown = 0; unknown < unknowns; ++unknown)
      result.values[static_cast<std::size_t>(unknown)] += root * x[static_cast<std::size_t>(unknown)].number;
  }
  if (!result.isBalanced) result.values.clear();
  return result;
}

}  // namespace geargraph
