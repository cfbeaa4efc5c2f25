#include "core/theory/matroid/matroid_diagnostics.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>

#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"
#include "core/mechanism/placement/planet_groups.h"
#include "core/theory/matroid/exact_solution.h"
#include "core/theory/matroid/symbolic_solution.h"

namespace geargraph {
namespace {

constexpr std::size_t kMaxMatroidNames = 12;

std::string countedMeshes(std::size_t count, const std::string& names) {
  return count == 1 ? translated("mesh %1", {names}) : translated("meshes %1", {names});
}

/// Speaks of elements by their labels and collects them as culprits.
class Speaker {
 public:
  Speaker(const Mechanism& mechanism, Code code, Detail detail = Detail::none) : m_mechanism(mechanism) {
    m_diagnostic.code = code;
    m_diagnostic.detail = detail;
  }

  std::string meshes(std::span<const int> positions) {
    return names(
        positions, [&](int m) { m_diagnostic.elements.emplace_back(m_mechanism.gearMeshes[m].id); },
        [&](int m) { return m_mechanism.meshLabel(m); });
  }
  std::string joints(std::span<const int> positions) {
    return names(
        positions, [&](int j) { m_diagnostic.elements.emplace_back(m_mechanism.turningJoints[j].id); },
        [&](int j) { return m_mechanism.jointLabel(j); });
  }
  std::string links(std::span<const int> positions) {
    return names(
        positions, [&](int l) { m_diagnostic.elements.emplace_back(m_mechanism.links[l].id); },
        [&](int l) { return l; });
  }
  /// "mesh 15", "meshes 15 and 16", "brake A", "meshes 15 and 16, brake A and clutch E".
  std::string equations(const KinematicModel& model, std::span<const int> positions) {
    std::vector<int> ofMeshes;
    std::vector<int> ofCouplings;
    for (const int equation : positions) {
      if (equation < model.c()) {
        ofMeshes.push_back(equation);
      } else if (const ShiftElementOrdinal coupling = model.heldRow(equation).coupling;
                 std::find(ofCouplings.begin(), ofCouplings.end(), coupling) == ofCouplings.end()) {
        ofCouplings.push_back(coupling);
      }
    }
    std::string text = ofMeshes.empty() ? std::string() : countedMeshes(ofMeshes.size(), meshes(ofMeshes));
    if (!text.empty() && !ofCouplings.empty())
      text += ofCouplings.size() == 1 ? ' ' + translated("and") + ' ' : ", ";
    return text + couplings(ofCouplings);
  }
  std::string couplings(std::span<const int> positions) {
    std::vector<std::string> texts;
    for (const int position : positions) {
      const ShiftElement& coupling = m_mechanism.couplings[position];
      m_diagnostic.elements.emplace_back(coupling.id);
      texts.push_back(couplingName(coupling.kind, coupling.id.text()));
    }
    return texts.empty() ? std::string() : listed(texts, kMaxMatroidNames);
  }
  Diagnostic say(std::string message) {
    m_diagnostic.message = std::move(message);
    return std::move(m_diagnostic);
  }

 private:
  template <class Collect, class Label>
  std::string names(std::span<const int> positions, const Collect& collect, const Label& label) {
    std::vector<std::string> texts;
    for (const int position : positions) {
      collect(position);
      texts.push_back(std::to_string(label(position)));
    }
    return listed(texts, kMaxMatroidNames);
  }

  const Mechanism& m_mechanism;
  Diagnostic m_diagnostic;
};

std::vector<int> marked(const std::vector<char>& marks) {
  std::vector<int> places;
  for (std::size_t i = 0; i < marks.size(); ++i) {
    if (marks[i] != 0) places.push_back(static_cast<int>(i));
  }
  return places;
}

Diagnostic redundantMesh(const Mechanism& mechanism, const Redundancy& redundancy) {
  Speaker speaker(mechanism, Code::redundantMesh);
  const std::vector<int> mesh{redundancy.equation};
  const std::string name = speaker.meshes(mesh);
  const std::string others = speaker.meshes(redundancy.dependsOn);
  return speaker.say(translated(
      "Mesh %1 follows from %2: it constrains nothing more. Harmless for the motion; the load is shared.",
      {name, countedMeshes(redundancy.dependsOn.size(), others)}));
}

/// Redundant meshes that follow from equal planets: wanted, because the planets share the load.
class SharedLoads {
 public:
  SharedLoads(const Mechanism& mechanism, const Placement& placement)
      : m_mechanism(mechanism), m_sets(equalPlanets(mechanism, placement, PlanetScope::all)) {
    for (std::size_t set = 0; set < m_sets.size(); ++set) {
      for (std::size_t group = 0; group < m_sets[set].size(); ++group) {
        for (const MeshOrdinal mesh : m_sets[set][group].meshes) m_placeOf[mesh] = {set, group};
      }
    }
    m_redundant.resize(m_sets.size());
    m_others.resize(m_sets.size());
  }

  /// True where the mesh and those that it follows from belong to several planets of one set.
  bool take(const Redundancy& redundancy) {
    const auto own = m_placeOf.find(redundancy.equation);
    if (own == m_placeOf.end()) return false;
    const auto [set, group] = own->second;
    bool isOfOthers = false;
    for (const int mesh : redundancy.dependsOn) {
      const auto place = m_placeOf.find(mesh);
      if (place == m_placeOf.end() || place->second.first != set) return false;
      isOfOthers = isOfOthers || place->second.second != group;
    }
    if (!isOfOthers) return false;
    m_redundant[set].push_back(redundancy.equation);
    m_others[set].insert(m_others[set].end(), redundancy.dependsOn.begin(), redundancy.dependsOn.end());
    return true;
  }

  /// One note per set.
  [[nodiscard]] Diagnostics notes() const {
    Diagnostics notes;
    for (std::size_t set = 0; set < m_sets.size(); ++set) {
      if (m_redundant[set].empty()) continue;
      std::vector<int> others = m_others[set];
      std::sort(others.begin(), others.end());
      others.erase(std::unique(others.begin(), others.end()), others.end());
      std::erase_if(others, [&](int mesh) {
        return std::find(m_redundant[set].begin(), m_redundant[set].end(), mesh) != m_redundant[set].end();
      });
      Speaker speaker(m_mechanism, Code::redundantMesh, Detail::equalPlanets);
      const std::string meshes = countedMeshes(m_redundant[set].size(), speaker.meshes(m_redundant[set]));
      speaker.meshes(others);
      notes.push_back(speaker.say(translated(
          "Links %1 are equal planets, which share the load: the motion would be the same without %2.",
          {planets(m_sets[set]), meshes})));
    }
    return notes;
  }

 private:
  [[nodiscard]] std::string planets(const std::vector<PlanetGroup>& groups) const {
    std::vector<std::string> names;
    for (const PlanetGroup& group : groups) {
      for (const LinkOrdinal link : group.links) names.push_back(std::to_string(m_mechanism.linkLabel(link)));
    }
    return listed(names, kMaxMatroidNames);
  }

  const Mechanism& m_mechanism;
  std::vector<std::vector<PlanetGroup>> m_sets;
  std::map<int, std::pair<std::size_t, std::size_t>> m_placeOf;  ///< by mesh: set and group
  std::vector<std::vector<int>> m_redundant;                     ///< meshes, by set
  std::vector<std::vector<int>> m_others;                        ///< from which they follow
};

/// The engaged couplings that add nothing, and from which equations they follow. A coupling over axes of
/// several directions has several rows, of which one that counts is enough.
struct IdleCoupling {
  ShiftElementOrdinal coupling = 0;
  std::vector<int> dependsOn;
};

std::vector<IdleCoupling> idleCouplings(const Mechanism& mechanism, const KinematicModel& model,
                                        const MatroidAnalysis& analysis) {
  std::vector<IdleCoupling> idle;
  for (const ShiftElementId id : mechanism.engaged) {
    const auto found = std::find_if(mechanism.couplings.begin(), mechanism.couplings.end(),
                                    [&](const ShiftElement& each) { return each.id == id; });
    IdleCoupling entry{static_cast<int>(found - mechanism.couplings.begin()), {}};
    const auto isItsRow = [&](int equation) { return model.heldRow(equation).coupling == entry.coupling; };
    if (std::any_of(analysis.independentHeld.begin(), analysis.independentHeld.end(), isItsRow)) continue;
    for (const Redundancy& redundancy : analysis.redundancies) {
      if (redundancy.equation < model.c() || !isItsRow(redundancy.equation)) continue;
      entry.dependsOn.insert(entry.dependsOn.end(), redundancy.dependsOn.begin(), redundancy.dependsOn.end());
    }
    std::sort(entry.dependsOn.begin(), entry.dependsOn.end());
    entry.dependsOn.erase(std::unique(entry.dependsOn.begin(), entry.dependsOn.end()), entry.dependsOn.end());
    idle.push_back(std::move(entry));
  }
  return idle;
}

Diagnostic redundantCoupling(const Mechanism& mechanism, const KinematicModel& model,
                             const IdleCoupling& idle) {
  Speaker speaker(mechanism, Code::redundantCoupling);
  speaker.couplings(std::vector<int>{idle.coupling});
  const ShiftElement& coupling = mechanism.couplings[idle.coupling];
  const std::string& name = coupling.id.text();
  const std::string others = speaker.equations(model, idle.dependsOn);
  if (coupling.kind == ShiftElementKind::brake) {
    return speaker.say(
        others.empty()
            ? translated("Brake %1 is engaged and holds nothing that could move.", {name})
            : translated("Brake %1 is engaged and holds nothing that could move: that follows from %2.",
                         {name, others}));
  }
  return speaker.say(
      others.empty()
          ? translated("Clutch %1 is engaged and holds nothing that could move.", {name})
          : translated("Clutch %1 is engaged and holds nothing that could move: that follows from %2.",
                       {name, others}));
}

/// The loops that meshes alone close: what couplings hold is held on purpose.
std::vector<LockedLoop> loopsOfMeshes(const KinematicModel& model, const std::vector<LockedLoop>& loops) {
  std::vector<LockedLoop> result;
  std::copy_if(loops.begin(), loops.end(), std::back_inserter(result),
               [&](const LockedLoop& loop) { return loop.equations.back() < model.c(); });
  return result;
}

std::string loopText(Speaker& speaker, const std::vector<LockedLoop>& loops) {
  std::string text;
  for (std::size_t i = 0; i < loops.size() && i < 3; ++i) {
    text += (i == 0 ? "" : "; ") + speaker.meshes(loops[i].equations);
  }
  return countedMeshes(loops.front().equations.size(), text);
}

Diagnostic locked(const Mechanism& mechanism, const std::vector<LockedLoop>& loops) {
  Speaker speaker(mechanism, Code::locked);
  return speaker.say(
      translated("Nothing can move: the loop of %1 locks it. Change a tooth count so that the ratios round "
                 "the loop agree, or delete a mesh.",
                 {loopText(speaker, loops)}));
}

Diagnostic lockedAsEngaged(const Mechanism& mechanism, const KinematicModel& model,
                           const MatroidAnalysis& analysis) {
  Speaker speaker(mechanism, Code::locked);
  const std::vector<int>& held =
      analysis.independentHeld.empty() ? analysis.lockedLoops.front().equations : analysis.independentHeld;
  const std::string names = speaker.equations(model, held);
  return speaker.say(held.size() == 1
                         ? translated("Nothing can move: %1 holds everything. Release a coupling.", {names})
                         : translated("Nothing can move: %1 hold everything. Release a coupling.", {names}));
}

Diagnostic deadJoints(const Mechanism& mechanism, const std::vector<int>& joints,
                      const std::vector<LockedLoop>& loops, const std::vector<std::vector<int>>& blocks) {
  Speaker speaker(mechanism, Code::deadJoint);
  const std::string names = speaker.joints(joints);
  const std::string meshes = loopText(speaker, loops);
  std::string message = joints.size() == 1
                            ? translated("Joint %1 can never turn, locked by %2.", {names, meshes})
                            : translated("Joints %1 can never turn, locked by %2.", {names, meshes});
  for (std::size_t i = 0; i < blocks.size() && i < 3; ++i) {
    message += ' ' + translated("Links %1 form a rigid block.", {speaker.links(blocks[i])});
  }
  return speaker.say(std::move(message));
}

/// locked or dead-joint, of the train as engaged.
void addLocked(const Mechanism& mechanism, const KinematicModel& model, const MatroidAnalysis& analysis,
               Diagnostics& diagnostics) {
  if (model.held().empty()) {
    if (analysis.dof == 0 && model.t() > 0) {
      diagnostics.push_back(locked(mechanism, analysis.lockedLoops));
    } else if (!analysis.lockedLoops.empty()) {
      diagnostics.push_back(
          deadJoints(mechanism, marked(analysis.dead), analysis.lockedLoops, analysis.rigidBlocks));
    }
    return;
  }
  const std::vector<LockedLoop> loops = loopsOfMeshes(model, analysis.lockedLoops);
  if (analysis.dof == 0) {
    diagnostics.push_back(analysis.independentHeld.empty() && !loops.empty()
                              ? locked(mechanism, loops)
                              : lockedAsEngaged(mechanism, model, analysis));
  } else if (!loops.empty()) {
    std::vector<int> joints;
    for (const LockedLoop& loop : loops) joints.insert(joints.end(), loop.joints.begin(), loop.joints.end());
    std::sort(joints.begin(), joints.end());
    diagnostics.push_back(deadJoints(mechanism, joints, loops, {}));
  }
}

Diagnostic idle(const Mechanism& mechanism, const MatroidAnalysis& analysis) {
  Speaker speaker(mechanism, Code::idleJoint);
  const std::vector<int> joints = marked(analysis.idle);
  const std::string names = speaker.joints(joints);
  return speaker.say(joints.size() == 1
                         ? translated("No mesh constrains joint %1: it has to be driven.", {names})
                         : translated("No mesh constrains joints %1: they have to be driven.", {names}));
}

/// What the joint's rate comes to over the inputs of the choice, with short factors in front of the q.
std::string relationText(const Mechanism& mechanism, JointOrdinal joint, const std::vector<int>& inputs,
                         const std::vector<std::string>& factors) {
  const auto name = [&](int of) { return "q" + std::to_string(mechanism.jointLabel(of)); };
  std::string sum;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    std::string factor = factors[i];
    if (factor == "0") continue;
    const bool isSum = factor.find(' ') != std::string::npos && factor.find('/') == std::string::npos;
    const bool negative = !isSum && factor[0] == '-';
    if (negative) factor.erase(0, 1);
    if (isSum) factor = "(" + factor + ")";
    sum += sum.empty() ? (negative ? "-" : "") : (negative ? " - " : " + ");
    sum += (factor == "1" ? "" : factor + " ") + name(inputs[i]);
  }
  return name(joint) + " = " + (sum.empty() ? "0" : sum);
}

Diagnostic invalidInputs(const Mechanism& mechanism, const KinematicModel& model, const Placement& placement,
                         const MatroidAnalysis& analysis, std::span<const int> wanted,
                         const std::stop_token& stop) {
  constexpr std::size_t kMaxRelations = 4;
  Speaker speaker(mechanism, Code::invalidInputs);
  const InputChoice& choice = analysis.choice;
  const std::string dof = std::to_string(analysis.dof);
  const std::string inputs = std::to_string(wanted.size());
  const bool isOneInput = wanted.size() == 1;
  std::string message =
      analysis.dof == 1
          ? (isOneInput
                 ? translated("The mechanism has 1 degree of freedom, and 1 input is chosen.")
                 : translated("The mechanism has 1 degree of freedom, and %1 inputs are chosen.", {inputs}))
          : (isOneInput ? translated("The mechanism has %1 degrees of freedom, and 1 input is chosen.", {dof})
                        : translated("The mechanism has %1 degrees of freedom, and %2 inputs are chosen.",
                                     {dof, inputs}));
  for (std::size_t i = 0; i < choice.rejected.size() && i < kMaxRelations; ++i) {
    const std::vector<int> joint{choice.rejected[i]};
    const std::string name = speaker.joints(joint);
    const auto twice = std::count(wanted.begin(), wanted.end(), joint[0]) > 1;
    message += ' ';
    message +=
        twice ? translated("Joint %1 is chosen twice.", {name})
              : translated("Joint %1 is no free choice: %2.",
                           {name, forcedRelation(mechanism, model, placement, analysis, joint[0], stop)});
  }
  if (!choice.added.empty()) {
    message += ' ' + translated("Still free: choose %1 too.", {speaker.joints(choice.added)});
  }
  const std::string valid = speaker.joints(choice.joints);
  message += ' ';
  message += choice.joints.empty() ? translated("The only valid set is the empty one.")
                                   : translated("A valid set is %1.", {valid});
  return speaker.say(std::move(message));
}

}  // namespace

std::string forcedRelation(const Mechanism& mechanism, const KinematicModel& model,
                           const Placement& placement, const MatroidAnalysis& analysis, JointOrdinal joint,
                           const std::stop_token& stop) {
  constexpr int kMaxSymbolicJoints = 200;
  constexpr int kShort = 12;
  const std::vector<int>& inputs = analysis.choice.joints;
  if (analysis.dead[joint] != 0) return relationText(mechanism, joint, {}, {});
  const std::vector<int> outputs = outputsOf(model, inputs);
  const auto row =
      static_cast<std::size_t>(std::find(outputs.begin(), outputs.end(), joint) - outputs.begin());
  const std::size_t columns = inputs.size();
  std::vector<std::string> factors;
  if (model.t() <= kMaxSymbolicJoints) {
    const CoefficientMatrix matrix(mechanism, model, placement);
    const auto symbolic =
        solveSymbolic(mechanism, model, matrix, analysis.independentEquations(), inputs, stop, {kShort});
    for (std::size_t i = 0; symbolic && i < columns; ++i) {
      const auto& entry = symbolic->matrix[row * columns + i];
      if (entry) factors.push_back(entry->toText());
    }
  }
  if (factors.size() != columns) {
    const auto exact = solveExact(model, inputs, analysis.speeds, stop);
    if (!exact || exact->matrix.empty()) return relationText(mechanism, joint, {joint}, {"..."});
    factors.clear();
    for (std::size_t i = 0; i < columns; ++i) factors.push_back(exact->matrix[row * columns + i].toString());
  }
  return relationText(mechanism, joint, inputs, factors);
}

Diagnostics matroidDiagnostics(const Mechanism& mechanism, const KinematicModel& model,
                               const Placement& placement, const MatroidAnalysis& analysis,
                               std::span<const int> wanted, const std::stop_token& stop) {
  Diagnostics diagnostics;
  std::optional<SharedLoads> shared;
  for (const Redundancy& redundancy : analysis.redundancies) {
    if (redundancy.equation >= model.c()) continue;
    if (!shared) shared.emplace(mechanism, placement);
    if (!shared->take(redundancy)) diagnostics.push_back(redundantMesh(mechanism, redundancy));
  }
  for (const IdleCoupling& idle : idleCouplings(mechanism, model, analysis))
    diagnostics.push_back(redundantCoupling(mechanism, model, idle));
  addLocked(mechanism, model, analysis, diagnostics);
  if (model.equations() == 0 && model.t() > 0) {
    Diagnostic none;
    none.code = Code::noMeshes;
    none.message = translated("There are no gear meshes yet: every joint is free.");
    diagnostics.push_back(std::move(none));
  } else if (std::find(analysis.idle.begin(), analysis.idle.end(), 1) != analysis.idle.end()) {
    diagnostics.push_back(idle(mechanism, analysis));
  }
  const bool valid =
      model.held().empty() ? analysis.choice.wantedIsValid() : isValidAsEngaged(analysis.choice, wanted);
  if (analysis.inputsGiven && !valid) {
    diagnostics.push_back(invalidInputs(mechanism, model, placement, analysis, wanted, stop));
  }
  if (shared) append(diagnostics, shared->notes());
  return diagnostics;
}

}  // namespace geargraph
