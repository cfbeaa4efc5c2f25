#include "core/theory/states/engagement.h"

#include <algorithm>
#include <set>
#include <utility>

#include "core/foundations/base/position_index.h"
#include "core/theory/states/relative_speed.h"
#include "core/theory/states/state_diagnostics.h"

namespace geargraph {
namespace {

/// Where the reaction of the coupling is, and the link that it acts on.
std::pair<int, int> endsOf(const Mechanism& mechanism, ShiftElementOrdinal coupling) {
  const ShiftElement& element = mechanism.couplings[coupling];
  const PositionIndex<LinkTag> links(mechanism.links);
  return {element.kind == ShiftElementKind::brake ? 0 : links.at(element.links.back()),
          links.at(element.links.front())};
}

}  // namespace

std::vector<int> engagedCouplings(const Mechanism& mechanism) {
  std::vector<int> positions;
  if (mechanism.engaged.empty()) return positions;
  const PositionIndex<CouplingTag> couplings(mechanism.couplings);
  for (const ShiftElementId id : mechanism.engaged) positions.push_back(couplings.at(id));
  std::sort(positions.begin(), positions.end());
  return positions;
}

std::vector<KinematicModel::HeldRow> heldRows(const Mechanism& mechanism, const Placement& placement,
                                              ShiftElementOrdinal coupling) {
  const auto [from, to] = endsOf(mechanism, coupling);
  const std::vector<PathStep> path = treePath(*placement.tree->tree, from, to);
  std::vector<KinematicModel::HeldRow> rows;
  for (const RelativeSpeed::Part& part : RelativeSpeed::between(placement, from, to).parts) {
    KinematicModel::HeldRow& row = rows.emplace_back();
    row.coupling = coupling;
    row.from = from;
    row.to = to;
    row.axisGroup = part.axisGroup;
    for (const RelativeSpeed::Term& term : part.terms) row.links.push_back({term.link, term.factor});
    for (const PathStep& step : path) {
      const auto joint = static_cast<std::size_t>(step.joint);
      const int along = directionSign(placement, placement.classes->classOf[joint], part.axisGroup);
      if (along != 0)
        row.joints.push_back(
            {step.joint, along * step.direction * placement.classes->orientationSign[joint]});
    }
  }
  return rows;
}

int freewheelSense(const Mechanism& mechanism, const Placement& placement, ShiftElementOrdinal freewheel) {
  const auto rows = heldRows(mechanism, placement, freewheel);
  if (rows.size() != 1) return 0;
  const auto [second, first] = endsOf(mechanism, freewheel);
  const LinkOrdinal of = first != 0 ? first : second;
  const AxisGroupOrdinal own = placement.classes->classOfLink(of);
  return directionSign(placement, rows.front().axisGroup, own) *
         placement.classes->orientationSign[placement.tree->joint[of]];
}

Diagnostics freewheelDiagnostics(const Mechanism& mechanism, const Placement& placement,
                                 const ByJoint<Rational>& rates) {
  Diagnostics found;
  const std::vector<int> engaged = engagedCouplings(mechanism);
  for (ShiftElementOrdinal coupling = 0; coupling < static_cast<int>(mechanism.couplings.size());
       ++coupling) {
    if (mechanism.couplings[coupling].kind != ShiftElementKind::freewheel) continue;
    if (std::binary_search(engaged.begin(), engaged.end(), int{coupling})) continue;
    const int sense = freewheelSense(mechanism, placement, coupling);
    if (sense == 0) continue;
    const KinematicModel::HeldRow row = heldRows(mechanism, placement, coupling).front();
    Rational slip = 0;
    for (const KinematicModel::HeldRow::Term& term : row.joints)
      slip += Rational(sense * term.factor) * rates[term.of];
    if (slip.sign() > 0) found.push_back(freewheelDirection(mechanism, mechanism.couplings[coupling], slip));
  }
  return found;
}

Diagnostics clutchDiagnostics(const Mechanism& mechanism, const Placement& placement) {
  Diagnostics diagnostics;
  for (std::size_t position = 0; position < mechanism.couplings.size(); ++position) {
    const ShiftElement& coupling = mechanism.couplings[position];
    if (coupling.kind != ShiftElementKind::clutch) continue;
    const auto [from, to] = endsOf(mechanism, static_cast<int>(position));
    std::set<int> lines;
    for (const PathStep& step : treePath(*placement.tree->tree, from, to))
      lines.insert(placement.classes->classOf[step.joint]);
    if (lines.size() > 1) diagnostics.push_back(clutchAxes(mechanism, coupling));
  }
  return diagnostics;
}

bool closesWithoutLinkage(const Mechanism& mechanism, const Placement& placement,
                          ShiftElementOrdinal coupling) {
  const auto [from, to] = endsOf(mechanism, coupling);
  return RelativeSpeed::between(placement, from, to).closesWithoutLinkage();
}

Engagement engagementOf(const Mechanism& mechanism, const Placement& placement,
                        std::span<const int> couplings, const ShiftState* state) {
  Engagement result;
  for (const ShiftElementOrdinal coupling : couplings) {
    if (!closesWithoutLinkage(mechanism, placement, coupling))
      result.diagnostics.push_back(couplingLinkage(mechanism, mechanism.couplings[coupling], state));
    for (auto& row : heldRows(mechanism, placement, coupling)) result.rows.push_back(std::move(row));
  }
  if (!result.diagnostics.empty()) result.rows.clear();
  return result;
}

}  // namespace geargraph
