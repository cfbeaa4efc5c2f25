#include "core/theory/statics/statics_findings.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <numeric>
#include <set>
#include <unordered_map>

#include "core/foundations/base/wording.h"
#include "core/mechanism/model/load_edits.h"

namespace geargraph::inline statics {
namespace {

constexpr std::size_t kMostNames = 12;

Diagnostic finding(Code code, std::string message, std::vector<ElementId> elements = {}) {
  return {code, std::move(message), std::move(elements), {}, 0, 0};
}

std::string decimal(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.3g", value);
  return buffer;
}

/// "joint 14", "joints 13 and 14".
std::string counted(const char* one, const char* many, const std::vector<std::string>& names,
                    const char* last = "and") {
  return std::string(names.size() == 1 ? one : many) + ' ' + listed(names, kMostNames, last);
}

std::vector<std::string> jointLabels(const Mechanism& mechanism, const std::vector<int>& joints) {
  std::vector<std::string> names;
  for (const int joint : joints) names.push_back(std::to_string(mechanism.jointLabel(joint)));
  return names;
}

std::vector<std::string> meshLabels(const Mechanism& mechanism, const std::vector<int>& meshes) {
  std::vector<std::string> names;
  for (const int mesh : meshes) names.push_back(std::to_string(mechanism.meshLabel(mesh)));
  return names;
}

ElementId meshId(const Mechanism& mechanism, int mesh) {
  return mechanism.gearMeshes[static_cast<std::size_t>(mesh)].id;
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
      if (!rates.empty() && rates[static_cast<std::size_t>(position)].isZero()) continue;
      drivers.joints.insert(position);
      if (names.insert("j" + joint->text()).second)
        drivers.names.push_back("joint " + std::to_string(mechanism.jointLabel(position)));
    } else if (names.insert("l" + linkOf(load.load)->text()).second) {
      drivers.names.push_back("link " + labelOf(mechanism, *linkOf(load.load)).value_or(""));
    }
  }
  return drivers;
}

}  // namespace

Diagnostic noLoad() {
  return finding(Code::noLoad, "No load is given: all torques are 0.");
}

Diagnostic unitLoad(const Mechanism& mechanism, const ShiftState& state) {
  return finding(Code::unitLoad,
                 "The drive of state " + state.name + ", link " +
                     labelOf(mechanism, *state.drive).value_or(state.drive->text()) +
                     ", gets 1 N m, as no load acts on it or on the driven link.",
                 {*state.drive});
}

Diagnostic unknownUnit(const Mechanism& mechanism, bool leavesForcesOut) {
  return finding(Code::unknownUnit, "The unit of length, \"" + mechanism.unit +
                                        "\", has no known size: forces of teeth and bearings are left out" +
                                        (leavesForcesOut ? ", and so are loads that are forces" : "") +
                                        ". Units are nm, um, mm, cm, dm, m, mil, in and ft.");
}

Diagnostic noMotion() {
  return finding(
      Code::noMotion,
      "Speeds are not determined: powers and efficiencies are left out. Give inputs their speeds, or "
      "choose a state of one degree of freedom.");
}

Diagnostic noEfficiency() {
  return finding(Code::noEfficiency,
                 "No mesh has an efficiency: give `efficiency` or `friction` in the document, or --eta.");
}

Diagnostic unbalancedLoads(const Mechanism& mechanism, const StaticsReport& report) {
  const FreeMotion& motion = *report.lossless.unheld;
  const Drivers drivers = driversOf(mechanism, report);
  std::vector<int> cures;
  for (const int joint : motion.joints)
    if (!drivers.joints.contains(joint)) cures.push_back(joint);
  if (cures.empty()) cures = motion.joints;
  std::string message = "Nothing holds this motion: ";
  message += counted("joint", "joints", jointLabels(mechanism, motion.joints)) +
             (motion.joints.size() == 1 ? " turns" : " turn") + " freely under the load on ";
  message += listed(drivers.names, kMostNames) + ". Add a balance at " +
             counted("joint", "joint", jointLabels(mechanism, cures), "or") + '.';
  std::vector<ElementId> elements;
  for (const int joint : motion.joints)
    elements.emplace_back(mechanism.turningJoints[static_cast<std::size_t>(joint)].id);
  return finding(Code::unbalanced, std::move(message), std::move(elements));
}

Diagnostic sharedLoads(const Mechanism& mechanism, const KinematicModel& model,
                       const StaticsSolution& solution) {
  std::vector<int> meshes;
  std::vector<std::string> couplings;
  bool balances = false;
  std::vector<ElementId> elements;
  for (int unknown = 0; unknown < solution.unknowns; ++unknown) {
    if (solution.isDetermined(unknown)) continue;
    if (unknown < model.c()) {
      meshes.push_back(unknown);
      elements.push_back(meshId(mechanism, unknown));
      continue;
    }
    const HeldPart& part = solution.held[static_cast<std::size_t>(unknown - model.c())];
    if (part.balance >= 0) balances = true;
    if (part.coupling < 0) continue;
    const CouplingId id = mechanism.couplings[static_cast<std::size_t>(part.coupling)].id;
    if (std::find(couplings.begin(), couplings.end(), id.text()) == couplings.end())
      couplings.push_back(id.text());
    elements.emplace_back(id);
  }
  std::vector<std::string> groups;
  if (!meshes.empty()) groups.push_back(counted("mesh", "meshes", meshLabels(mechanism, meshes)));
  if (!couplings.empty()) groups.push_back(counted("coupling", "couplings", couplings));
  if (balances) groups.emplace_back("balances");
  std::string message = listed(groups, kMostNames);
  if (!message.empty()) message[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(message[0])));
  const int count = solution.indeterminate();
  message += " share the load in proportions that stiffness and clearance decide (" + std::to_string(count) +
             (count == 1 ? " self-stress). " : " self-stresses). ");
  message += couplings.empty() && !balances ? "Torques outside are determined."
                                            : "Torques that do not depend on them are determined.";
  return finding(Code::staticallyIndeterminate, std::move(message), std::move(elements));
}

Diagnostic deadLoad(const Mechanism& mechanism, int joint, const std::vector<int>& meshes) {
  const JointId id = mechanism.turningJoints[static_cast<std::size_t>(joint)].id;
  std::vector<ElementId> elements{id};
  for (const int mesh : meshes) elements.push_back(meshId(mechanism, mesh));
  const std::string carried =
      meshes.empty() ? "."
                     : " is carried by " + counted("mesh", "meshes", meshLabels(mechanism, meshes)) + '.';
  return finding(Code::deadLoad,
                 "Joint " + std::to_string(mechanism.jointLabel(joint)) + " cannot turn: its load" +
                     (meshes.empty() ? " needs no balance." : carried),
                 std::move(elements));
}

Diagnostic selfLocking(const Mechanism& mechanism, const StaticsReport& report,
                       const std::vector<MeshEfficiency>& efficiencies, const std::optional<double>& part) {
  std::vector<std::string> names;
  std::vector<ElementId> elements;
  for (const TorquePlace& place : report.problem.balances) {
    if (place.inJoint()) {
      names.push_back("joint " + std::to_string(mechanism.jointLabel(place.joint)));
      elements.emplace_back(mechanism.turningJoints[static_cast<std::size_t>(place.joint)].id);
    } else {
      names.push_back("link " + std::to_string(mechanism.linkLabel(place.link)));
      elements.emplace_back(mechanism.links[static_cast<std::size_t>(place.link)].id);
    }
  }
  std::string message = "No torque at " + listed(names, kMostNames) +
                        " moves this load: the train is self-locking in this direction";
  if (part) {
    std::set<std::string> values;
    double efficiency = 1;
    for (const MeshEfficiency& each : efficiencies) {
      if (each.value == Rational(1)) continue;
      values.insert(each.value.toString());
      efficiency = 1 - *part * (1 - each.value.toDouble());
    }
    message += values.size() == 1 ? " (it begins below eta = " + decimal(efficiency) + ")"
                                  : " (it begins at " + decimal(100 * *part) + " % of these losses)";
  }
  return finding(Code::selfLocking, message + '.', std::move(elements));
}

Diagnostic patternLimit(const Mechanism& mechanism, const std::vector<int>& meshes) {
  std::vector<ElementId> elements;
  for (const int mesh : meshes) elements.push_back(meshId(mechanism, mesh));
  return finding(Code::patternLimit,
                 "Which gears drive was not decided: the rounds of guesses do not settle, and " +
                     counted("mesh", "meshes", meshLabels(mechanism, meshes)) +
                     " leave too many patterns to try all of them. Powers are those without losses.",
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
  Diagnostics findings;
  for (const auto& [leader, meshes] : groups) {
    double most = 0;
    std::vector<ElementId> elements;
    for (const int mesh : meshes) {
      most = std::max(most, times[static_cast<std::size_t>(mesh)]);
      elements.push_back(meshId(mechanism, mesh));
    }
    const bool isOne = meshes.size() == 1;
    std::string message = counted("mesh", "meshes", meshLabels(mechanism, meshes));
    message[0] = 'M';
    message += (isOne ? " passes " : " pass up to ") + decimal(most) + " times the power fed, seen from " +
               (isOne ? "its carrier." : "their carriers.");
    findings.push_back(finding(Code::recirculation, std::move(message), std::move(elements)));
  }
  return findings;
}

Diagnostic circulatingPower(const Mechanism& mechanism, const Circulation& circulation, double part) {
  std::vector<std::string> links;
  std::vector<ElementId> elements;
  for (const int link : circulation.links) {
    links.push_back(std::to_string(mechanism.linkLabel(link)));
    elements.emplace_back(mechanism.links[static_cast<std::size_t>(link)].id);
  }
  for (const int mesh : circulation.meshes) elements.push_back(meshId(mechanism, mesh));
  return finding(Code::recirculation,
                 decimal(part) + " W of each W fed circulate through " + counted("link", "links", links) +
                     " and " + counted("mesh", "meshes", meshLabels(mechanism, circulation.meshes)) + '.',
                 std::move(elements));
}

}  // namespace geargraph::inline statics
