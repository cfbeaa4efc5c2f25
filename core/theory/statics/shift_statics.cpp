#include "core/theory/statics/shift_statics.h"

#include <algorithm>
#include <map>

#include "core/mechanism/model/load_edits.h"

namespace geargraph {
namespace {

/// The link that a torque acts on from the ground, about the direction of the link's first axis on the way
/// there: a torque on the link, or in the joint that ties it to the ground.
std::optional<std::pair<LinkId, Rational>> torqueFromGround(const Mechanism& mechanism, const Load& load) {
  if (const auto* torque = std::get_if<LinkTorque>(&load.action))
    return std::pair(torque->link, torque->torque.exact());
  const auto* inJoint = std::get_if<JointTorque>(&load.action);
  if (inJoint == nullptr) return std::nullopt;
  const TurningJoint& joint = *mechanism.find(inJoint->joint);
  const LinkId ground = mechanism.links.front().id;
  if (joint.tail == ground) return std::pair(joint.head, inJoint->torque.exact());
  if (joint.head == ground) return std::pair(joint.tail, -inJoint->torque.exact());
  return std::nullopt;
}

}  // namespace

std::optional<Rational> driveTorqueOf(const Mechanism& mechanism, int state) {
  if (mechanism.driveTorque) return mechanism.driveTorque->exact();
  const ShiftState& own = mechanism.states[static_cast<std::size_t>(state)];
  std::map<LinkId, Rational> atDrives;
  bool isDrivenLoaded = false;
  for (const Load& load : mechanism.loads) {
    const auto torque = torqueFromGround(mechanism, load);
    if (!torque) continue;
    const auto& [link, size] = *torque;
    isDrivenLoaded = isDrivenLoaded || own.driven == link;
    const bool drives = std::any_of(mechanism.states.begin(), mechanism.states.end(),
                                    [&](const ShiftState& each) { return each.drive == link; });
    if (drives) atDrives[link] += size;
  }
  std::erase_if(atDrives, [](const auto& each) { return each.second.isZero(); });
  if (atDrives.size() == 1) return atDrives.begin()->second;
  if (atDrives.empty() && isDrivenLoaded) return std::nullopt;
  return Rational(1);
}

std::optional<EndTorques> endTorques(const Mechanism& mechanism, const StaticsReport& report) {
  if (report.state < 0) return std::nullopt;
  const ShiftState& state = mechanism.states[static_cast<std::size_t>(report.state)];
  if (!state.drive || !state.driven) return std::nullopt;
  const StaticsSolution& solution = report.solution();
  const auto meshes = static_cast<std::size_t>(solution.unknowns) - report.held.size();
  std::optional<Real> found;
  std::optional<LinkId> holder;
  for (std::size_t part = 0; part < report.held.size(); ++part) {
    const int balance = report.held[part].balance;
    if (balance < 0 || solution.determined[meshes + part] == 0) continue;
    const TorquePlace& place = report.problem.balances[static_cast<std::size_t>(balance)];
    if (place.inJoint()) continue;
    found = solution.values[meshes + part];
    holder = mechanism.links[place.link].id;
  }
  if (!found || (holder != state.drive && holder != state.driven)) return std::nullopt;
  const LinkId& loaded = holder == state.drive ? *state.driven : *state.drive;
  Real given;
  std::vector<Load> others;
  for (const LoadReport& load : report.loads) {
    const auto torque = torqueFromGround(mechanism, load.load);
    if (torque && torque->first == loaded) {
      given += Real(torque->second);
    } else {
      others.push_back(load.load);
    }
  }
  const bool isDriveFound = holder == state.drive;
  return EndTorques{isDriveFound ? *found : given, isDriveFound ? given : *found, std::move(others)};
}

std::optional<StateForces> solveShiftState(const Mechanism& mechanism, const KinematicModel& model,
                                           const Placement& placement, const TtGraph& ttGraph,
                                           const MatroidAnalysis& analysis, int state, StaticsOptions options,
                                           const std::stop_token& stop) {
  const auto solved = [&] {
    return analyzeStatics(mechanism, model, placement, ttGraph, analysis, options, stop);
  };
  StateForces result{state, {}, {}};
  options.state = state;
  if (!options.driveTorque) options.driveTorque = driveTorqueOf(mechanism, state);
  result.report = solved();
  if (!result.report) return std::nullopt;
  const std::optional<Rational>& torque = options.driveTorque;
  const bool isAlone = !torque || (result.report->loads.size() == 1 && torque->sign() > 0);
  if (isAlone) return result;
  options.documentLoads = false;
  options.loads.clear();
  options.driveTorque = Rational(1);
  result.alone = solved();
  return result.alone ? std::optional(std::move(result)) : std::nullopt;
}

}  // namespace geargraph
