#include "core/theory/statics/statics_diagnostics.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <numeric>
#include <set>
#include <unordered_map>

#include "core/foundations/base/locale.h"
#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"
#include "core/mechanism/model/load_edits.h"

namespace geargraph {
namespace {

constexpr std::size_t kMaxStaticsNames = 12;

Diagnostic makeDiagnostic(Code code, std::string message, std::vector<ElementId> elements = {}) {
  return {code, std::move(message), std::move(elements), {}, 0, 0};
}

std::string decimal(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.3g", value);
  return localizedNumber(buffer);
}

/// One of two texts that are marked by toTranslate(), by the number of names in the place %1: "joint 14",
/// "joints 13 and 14".
std::string countedLinks(const char* one, const char* many, const std::vector<std::string>& names) {
  return filled(translated(names.size() == 1 ? one : many), {listed(names, kMaxStaticsNames)});
}

/// With its first letter in upper case, where that is one of ASCII: German nouns have it already.
std::string capitalized(std::string sentence) {
  if (!sentence.empty())
    sentence.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(sentence.front())));
  return sentence;
}

std::string countedMeshes(const std::vector<std::string>& names) {
  return countedLinks(toTranslate("mesh %1"), toTranslate("meshes %1"), names);
}

std::vector<std::string> jointLabels(const Mechanism& mechanism, const std::vector<int>& joints) {
  std::vector<std::string> names;
  for (const JointOrdinal joint : joints) names.push_back(std::to_string(mechanism.jointLabel(joint)));
  return names;
}

std::vector<std::string> meshLabels(const Mechanism& mechanism, const std::vector<int>& meshes) {
  std::vector<std::string> names;
  for (const MeshOrdinal mesh : meshes) names.push_back(std::to_string(mechanism.meshLabel(mesh)));
  return names;
}

ElementId meshId(const Mechanism& mechanism, MeshOrdinal mesh) {
  return mechanism.gearMeshes[mesh].id;
}

/// What of the loads acts on the links and joints of a motion.
struct Drivers {
  std::vector<std::string> names;
  std::set<int> joints;
};

Drivers driversOf(const Mechanism& mechanism, const StaticsReport& report) {
  Drivers drivers;
  std::set<std::string> names;
  for (const LoadReport& load : report.loads) {
    if (const auto joint = jointOf(load.load)) {
      const auto at = std::find_if(mechanism.turningJoints.begin(), mechanism.turningJoints.end(),
                                   [&](const TurningJoint& each) { return each.id == *joint; });
      const int position = static_cast<int>(at - mechanism.turningJoints.begin());
      const auto& rates = report.lossless.unheld->rates;
      if (!rates.empty() && rates[position].isZero()) continue;
      drivers.joints.insert(position);
      if (names.insert("j" + joint->text()).second)
        drivers.names.push_back(translated("joint %1", {std::to_string(mechanism.jointLabel(position))}));
    } else if (names.insert("l" + linkOf(load.load)->text()).second) {
      drivers.names.push_back(translated("link %1", {labelOf(mechanism, *linkOf(load.load)).value_or("")}));
    }
  }
  return drivers;
}

/// "joint 14", "link 3".
std::string loadPlace(const Mechanism& mechanism, const Load& load) {
  if (const auto joint = jointOf(load))
    return translated("joint %1", {labelOf(mechanism, *joint).value_or(joint->text())});
  const LinkId link = *linkOf(load);
  return translated("link %1", {labelOf(mechanism, link).value_or(link.text())});
}

std::string placeName(const Mechanism& mechanism, const TorquePlace& place) {
  return place.inJoint() ? translated("joint %1", {std::to_string(mechanism.jointLabel(place.joint))})
                         : translated("link %1", {std::to_string(mechanism.linkLabel(place.link))});
}

/// "joint 6", "coupling A".
std::string heldName(const Mechanism& mechanism, const StaticsReport& report, const HeldPart& part) {
  if (part.coupling >= 0) return translated("coupling %1", {mechanism.couplings[part.coupling].id.text()});
  return placeName(mechanism, report.problem.balances[static_cast<std::size_t>(part.balance)]);
}

/// The range of each torque outside that depends on the shares.
std::string rangesOfShares(const Mechanism& mechanism, const StaticsReport& report) {
  std::vector<std::string> ranges;
  const std::size_t meshes = static_cast<std::size_t>(mechanism.c());
  for (std::size_t part = 0; part < report.ranges.size(); ++part) {
    const std::optional<SharedRange>& range = report.ranges[part];
    const HeldPart& held = report.held[part];
    if (!range || !held.isMain || !report.isAssumed(static_cast<int>(meshes + part))) continue;
    const std::string name = heldName(mechanism, report, held);
    const std::string least = decimal(range->least.number());
    const std::string most = decimal(range->most.number());
    ranges.push_back(least == most ? translated("%1: %2 N m", {name, least})
                                   : translated("%1: %2 to %3 N m", {name, least, most}));
  }
  if (ranges.empty()) return {};
  return ' ' + translated("For any sharing in which no mesh works against the others: %1.",
                          {listed(ranges, kMaxStaticsNames)});
}

/// What is known of the torques outside of self-stresses. `areMeshesOnly`: only meshes share.
std::string outsideOfShares(const Mechanism& mechanism, const StaticsReport& report, bool areMeshesOnly) {
  const bool dependOnThem = report.lacksLosses || (report.isShared && !report.losses().empty());
  if (!dependOnThem)
    return areMeshesOnly ? translated("Torques outside are determined.")
                         : translated("Torques that do not depend on them are determined.");
  if (report.isShared && !report.lacksLosses)
    return translated(
               "With losses, torques outside depend on it, too: they are given for equally stiff teeth, "
               "an assumption.") +
           rangesOfShares(mechanism, report);
  if (report.isShared || !areMeshesOnly)
    return translated("With losses, torques outside depend on it, too, and are not given.");
  return translated(
      "With losses, torques outside depend on it, too, and are not given: share by stiffness to "
      "find them.");
}

}  // namespace

Diagnostic noLoad() {
  return makeDiagnostic(Code::noLoad, translated("No load is given: all torques are 0."));
}

Diagnostic unitLoad(const Mechanism& mechanism, const ShiftState& state) {
  return makeDiagnostic(
      Code::unitLoad,
      translated("The drive of state %1, link %2, gets 1 N m, as no load acts on it or on the driven link.",
                 {state.name, labelOf(mechanism, *state.drive).value_or(state.drive->text())}),
      {*state.drive});
}

Diagnostic unknownUnit(const Mechanism& mechanism, bool leavesForcesOut) {
  return makeDiagnostic(
      Code::unknownUnit,
      leavesForcesOut
          ? translated(
                "The unit of length, \"%1\", has no known size: forces of teeth and bearings are left "
                "out, and so are loads that are forces. Units are nm, um, mm, cm, dm, m, mil, in and ft.",
                {mechanism.unit})
          : translated("The unit of length, \"%1\", has no known size: forces of teeth and bearings are left "
                       "out. Units are nm, um, mm, cm, dm, m, mil, in and ft.",
                       {mechanism.unit}));
}

Diagnostic noMotion(bool withoutLosses) {
  return makeDiagnostic(
      Code::noMotion,
      withoutLosses
          ? translated(
                "Speeds are not determined, so that nothing tells which gears drive: with losses, torques "
                "and "
                "powers are left out. Give inputs their speeds, or choose a state of one degree of freedom.")
          : translated("Speeds are not determined: powers and efficiencies are left out. Give inputs their "
                       "speeds, or "
                       "choose a state of one degree of freedom."));
}

Diagnostic noLossesAtRest() {
  return makeDiagnostic(Code::noMotion,
                        translated("All speeds are 0: at rest no power is lost, so that torques are those "
                                   "without losses. Give inputs their speeds."));
}

Diagnostic noEfficiency() {
  return makeDiagnostic(
      Code::noEfficiency,
      translated("No mesh has an efficiency: give `efficiency` or `friction` in the document, or "
                 "--eta."));
}

Diagnostic unbalancedLoads(const Mechanism& mechanism, const StaticsReport& report) {
  const FreeMotion& motion = *report.lossless.unheld;
  const Drivers drivers = driversOf(mechanism, report);
  std::vector<int> cures;
  for (const JointOrdinal joint : motion.joints)
    if (!drivers.joints.contains(joint)) cures.push_back(joint);
  if (cures.empty()) cures = motion.joints;
  const std::string turning = listed(jointLabels(mechanism, motion.joints), kMaxStaticsNames);
  const std::string loads = listed(drivers.names, kMaxStaticsNames);
  const std::string choices = listed(jointLabels(mechanism, cures), kMaxStaticsNames, toTranslate("or"));
  std::string message =
      motion.joints.size() == 1
          ? translated(
                "Nothing holds this motion: joint %1 turns freely under the load on %2. Add a balance at "
                "joint %3.",
                {turning, loads, choices})
          : translated(
                "Nothing holds this motion: joints %1 turn freely under the load on %2. Add a balance at "
                "joint %3.",
                {turning, loads, choices});
  std::vector<ElementId> elements;
  for (const JointOrdinal joint : motion.joints) elements.emplace_back(mechanism.turningJoints[joint].id);
  return makeDiagnostic(Code::unbalanced, std::move(message), std::move(elements));
}

Diagnostic loadsOnBalances(const Mechanism& mechanism, const StaticsReport& report,
                           const std::vector<std::size_t>& loads) {
  std::vector<std::string> names;
  std::vector<std::string> places;
  std::vector<ElementId> elements;
  const auto addOnce = [](std::vector<std::string>& list, const std::string& name) {
    if (std::find(list.begin(), list.end(), name) == list.end()) list.push_back(name);
  };
  for (const std::size_t i : loads) {
    const LoadReport& load = report.loads[i];
    const HeldPart& part = report.held[static_cast<std::size_t>(load.heldBy)];
    addOnce(names, loadPlace(mechanism, load.load));
    addOnce(places, placeName(mechanism, report.problem.balances[static_cast<std::size_t>(part.balance)]));
    if (const auto joint = jointOf(load.load)) {
      elements.emplace_back(*joint);
    } else {
      elements.emplace_back(*linkOf(load.load));
    }
  }
  const std::string on = listed(names, kMaxStaticsNames);
  const std::string held = listed(places, kMaxStaticsNames);
  return makeDiagnostic(
      Code::loadOnBalance,
      translated("The load on %1 acts where the balance at %2 holds, which cancels it: no mesh passes any of "
                 "it, and it counts for no efficiency. To find what it drives, put the balance elsewhere.",
                 {on, held}),
      std::move(elements));
}

Diagnostic sharedLoads(const Mechanism& mechanism, const KinematicModel& model, const StaticsReport& report) {
  const StaticsSolution& solution = report.lossless;
  std::vector<char> isMember(static_cast<std::size_t>(solution.unknowns), 0);
  for (const auto& members : solution.selfStresses)
    for (const auto& [unknown, weight] : members) isMember[static_cast<std::size_t>(unknown)] = 1;
  std::vector<int> meshes;
  std::vector<std::string> couplings;
  bool balances = false;
  std::vector<ElementId> elements;
  for (int unknown = 0; unknown < solution.unknowns; ++unknown) {
    if (isMember[static_cast<std::size_t>(unknown)] == 0) continue;
    if (unknown < model.c()) {
      meshes.push_back(unknown);
      elements.push_back(meshId(mechanism, unknown));
      continue;
    }
    const HeldPart& part = solution.held[static_cast<std::size_t>(unknown - model.c())];
    if (part.balance >= 0) balances = true;
    if (part.coupling < 0) continue;
    const ShiftElementId id = mechanism.couplings[part.coupling].id;
    if (std::find(couplings.begin(), couplings.end(), id.text()) == couplings.end())
      couplings.push_back(id.text());
    elements.emplace_back(id);
  }
  std::vector<std::string> groups;
  if (!meshes.empty()) groups.push_back(countedMeshes(meshLabels(mechanism, meshes)));
  if (!couplings.empty())
    groups.push_back(countedLinks(toTranslate("coupling %1"), toTranslate("couplings %1"), couplings));
  if (balances) groups.push_back(translated("balances"));
  const std::string sharing = capitalized(listed(groups, kMaxStaticsNames));
  const int count = solution.indeterminate();
  std::string message = count == 1
                            ? translated(
                                  "%1 share the load in proportions that stiffness and clearance decide (1 "
                                  "self-stress).",
                                  {sharing})
                            : translated(
                                  "%1 share the load in proportions that stiffness and clearance decide (%2 "
                                  "self-stresses).",
                                  {sharing, std::to_string(count)});
  message += ' ';
  message += outsideOfShares(mechanism, report, couplings.empty() && !balances);
  return makeDiagnostic(Code::staticallyIndeterminate, std::move(message), std::move(elements));
}

Diagnostic deadLoad(const Mechanism& mechanism, JointOrdinal joint, const std::vector<int>& meshes) {
  const JointId id = mechanism.turningJoints[joint].id;
  std::vector<ElementId> elements{id};
  for (const MeshOrdinal mesh : meshes) elements.push_back(meshId(mechanism, mesh));
  const std::string label = std::to_string(mechanism.jointLabel(joint));
  const std::string carrying = listed(meshLabels(mechanism, meshes), kMaxStaticsNames);
  std::string message;
  if (meshes.empty()) {
    message = translated("Joint %1 cannot turn: its load needs no balance.", {label});
  } else if (meshes.size() == 1) {
    message = translated("Joint %1 cannot turn: its load is carried by mesh %2.", {label, carrying});
  } else {
    message = translated("Joint %1 cannot turn: its load is carried by meshes %2.", {label, carrying});
  }
  return makeDiagnostic(Code::deadLoad, std::move(message), std::move(elements));
}

Diagnostic selfLocking(const Mechanism& mechanism, const StaticsReport& report,
                       const std::vector<MeshEfficiency>& efficiencies, const std::optional<double>& part) {
  std::vector<std::string> names;
  std::vector<ElementId> elements;
  for (const TorquePlace& place : report.problem.balances) {
    names.push_back(placeName(mechanism, place));
    if (place.inJoint()) {
      elements.emplace_back(mechanism.turningJoints[place.joint].id);
    } else {
      elements.emplace_back(mechanism.links[place.link].id);
    }
  }
  const std::string places = listed(names, kMaxStaticsNames);
  std::string message =
      translated("No torque at %1 moves this load: the train is self-locking in this direction.", {places});
  if (part) {
    std::set<std::string> values;
    double efficiency = 1;
    for (const MeshEfficiency& each : efficiencies) {
      if (each.value == Rational(1)) continue;
      values.insert(each.value.toString());
      efficiency = 1 - *part * (1 - each.value.toDouble());
    }
    message = values.size() == 1
                  ? translated(
                        "No torque at %1 moves this load: the train is self-locking in this direction (it "
                        "begins below eta = %2).",
                        {places, decimal(efficiency)})
                  : translated(
                        "No torque at %1 moves this load: the train is self-locking in this direction (it "
                        "begins at %2 % of these losses).",
                        {places, decimal(100 * *part)});
  }
  return makeDiagnostic(Code::selfLocking, std::move(message), std::move(elements));
}

Diagnostic patternLimit(const Mechanism& mechanism, const std::vector<int>& meshes) {
  std::vector<ElementId> elements;
  for (const MeshOrdinal mesh : meshes) elements.push_back(meshId(mechanism, mesh));
  return makeDiagnostic(
      Code::patternLimit,
      translated("Which gears drive was not decided: the rounds of guesses do not settle, and %1 leave "
                 "too many patterns to try all of them. Torques and powers are left out.",
                 {countedMeshes(meshLabels(mechanism, meshes))}),
      std::move(elements));
}

Diagnostics recirculations(const Mechanism& mechanism, const std::vector<double>& times) {
  const LinkId ground = mechanism.links.front().id;
  std::vector<std::size_t> leaders(times.size());
  std::iota(leaders.begin(), leaders.end(), std::size_t{0});
  const auto leaderOf = [&](std::size_t mesh) {
    while (leaders[mesh] != mesh) mesh = leaders[mesh] = leaders[leaders[mesh]];
    return mesh;
  };
  std::unordered_map<LinkId, std::size_t> meshOf;  // by gear, the first one there
  for (std::size_t mesh = 0; mesh < times.size(); ++mesh) {
    if (times[mesh] <= 0) continue;
    for (const LinkId gear : {mechanism.gearMeshes[mesh].tail, mechanism.gearMeshes[mesh].head})
      if (gear != ground) leaders[leaderOf(mesh)] = leaderOf(meshOf.try_emplace(gear, mesh).first->second);
  }
  std::map<std::size_t, std::vector<int>> groups;
  for (std::size_t mesh = 0; mesh < times.size(); ++mesh)
    if (times[mesh] > 0) groups[leaderOf(mesh)].push_back(static_cast<int>(mesh));
  Diagnostics diagnostics;
  for (const auto& [leader, meshes] : groups) {
    double most = 0;
    std::vector<ElementId> elements;
    for (const MeshOrdinal mesh : meshes) {
      most = std::max(most, times[static_cast<std::size_t>(mesh)]);
      elements.push_back(meshId(mechanism, mesh));
    }
    const std::string labels = listed(meshLabels(mechanism, meshes), kMaxStaticsNames);
    std::string message =
        meshes.size() == 1
            ? translated("Mesh %1 passes %2 times the power fed, seen from its carrier.",
                         {labels, decimal(most)})
            : translated("Meshes %1 pass up to %2 times the power fed, seen from their carriers.",
                         {labels, decimal(most)});
    diagnostics.push_back(makeDiagnostic(Code::recirculation, std::move(message), std::move(elements)));
  }
  return diagnostics;
}

Diagnostic circulatingPower(const Mechanism& mechanism, const Circulation& circulation, double part) {
  std::vector<std::string> links;
  std::vector<ElementId> elements;
  for (const LinkOrdinal link : circulation.links) {
    links.push_back(std::to_string(mechanism.linkLabel(link)));
    elements.emplace_back(mechanism.links[link].id);
  }
  for (const MeshOrdinal mesh : circulation.meshes) elements.push_back(meshId(mechanism, mesh));
  return makeDiagnostic(
      Code::recirculation,
      translated("%1 W of each W fed circulate through %2 and %3.",
                 {decimal(part), countedLinks(toTranslate("link %1"), toTranslate("links %1"), links),
                  countedMeshes(meshLabels(mechanism, circulation.meshes))}),
      std::move(elements));
}

}  // namespace geargraph
