#include "core/presentation/result_json/lost_motion_report.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "core/foundations/base/translation.h"
#include "core/foundations/files/json_writer.h"
#include "core/teaching/force_tables/spoken_cell.h"
#include "core/theory/matroid/joint_coupling.h"
#include "core/theory/states/state_edits.h"

namespace geargraph {
namespace {

using Row = JsonWriter::Layout;

constexpr double kArcMinutes = 60 * 180 / std::numbers::pi;  // of a radian

/// In minutes of arc; empty beyond the range of doubles.
ForceCell angleCell(const std::optional<double>& radians) {
  if (!radians || !std::isfinite(*radians)) return {};
  const double minutes = *radians * kArcMinutes;
  return {shownNumber(minutes), minutes, {}};
}
ForceCell angleCell(const std::optional<Rational>& radians) {
  return angleCell(radians ? std::optional(radians->toDouble()) : std::nullopt);
}

class LostMotionJson {
 public:
  LostMotionJson(JsonWriter& json, const Mechanism& mechanism) : m_json(json), m_mechanism(mechanism) {}

  void write(const LostMotionCase& of) {
    m_json.beginObject();
    m_json.key("state");
    of.state ? m_json.string(m_mechanism.states[static_cast<std::size_t>(*of.state)].name) : m_json.null();
    m_json.key("held");
    m_json.beginArray(Row::row);
    if (of.motions) {
      for (const JointOrdinal input : of.motions->held) m_json.string(idOf(input));
    }
    m_json.endArray();
    m_json.key("shared");
    of.motions ? m_json.boolean(of.motions->isShared) : m_json.null();
    m_json.key("plays");
    m_json.beginObject(Row::row);
    if (of.motions) {
      for (const MeshOrdinal mesh : of.motions->plays.ordinals())
        m_json.member(idOf(mesh), of.motions->plays[mesh].toString());
    }
    m_json.endObject();
    m_json.key("outputs");
    if (of.motions) {
      m_json.beginArray();
      for (std::size_t output = 0; output < of.motions->outputs.size(); ++output) writeOutput(of, output);
      m_json.endArray();
    } else {
      m_json.null();
    }
    m_json.endObject();
  }

 private:
  [[nodiscard]] std::string idOf(JointOrdinal joint) const {
    return m_mechanism.turningJoints[joint].id.text();
  }
  [[nodiscard]] std::string idOf(MeshOrdinal mesh) const { return m_mechanism.gearMeshes[mesh].id.text(); }

  void exact(std::string_view name, const std::optional<Rational>& value) {
    m_json.key(name);
    value ? m_json.string(value->toString()) : m_json.null();
  }

  void writeOutput(const LostMotionCase& of, std::size_t output) {
    const LostMotion& motion = of.motions->outputs[output];
    m_json.beginObject();
    m_json.member("joint", idOf(motion.joint));
    exact("worst", motion.worst);
    m_json.key("worstDegrees");
    motion.worst ? m_json.numberOrNull(motion.worst->toDouble() * 180 / std::numbers::pi) : m_json.null();
    m_json.key("rootOfSquares");
    motion.rootOfSquares ? m_json.numberOrNull(*motion.rootOfSquares) : m_json.null();
    m_json.key("most");
    const auto most = motion.mostOf();
    most ? m_json.string(idOf(*most)) : m_json.null();
    m_json.key("parts");
    m_json.beginObject(Row::row);
    for (const MeshOrdinal mesh : motion.parts.ordinals())
      m_json.member(idOf(mesh), motion.parts[mesh].toString());
    m_json.endObject();
    m_json.key("weights");
    if (of.motions->isShared) {
      m_json.null();
    } else {
      m_json.beginObject(Row::row);
      for (const MeshOrdinal mesh : motion.weights.ordinals())
        m_json.member(idOf(mesh), motion.weights[mesh].toString());
      m_json.endObject();
    }
    m_json.key("atInputs");
    m_json.beginObject(Row::row);
    for (std::size_t input = 0; input < of.motions->held.size(); ++input)
      exact(idOf(of.motions->held[input]), of.atInput(output, input));
    m_json.endObject();
    m_json.endObject();
  }

  JsonWriter& m_json;
  const Mechanism& m_mechanism;
};

}  // namespace

std::optional<Rational> LostMotionCase::atInput(std::size_t output, std::size_t input) const {
  const std::optional<Rational>& worst = motions->outputs[output].worst;
  const Rational& gain = gains[output * motions->held.size() + input];
  if (!worst || gain.isZero()) return std::nullopt;
  return *worst / gain.abs();
}

std::optional<LostMotionCase> lostMotionCase(const AnalysisSnapshot& snapshot, const std::stop_token& stop) {
  LostMotionCase made;
  const MatroidAnalysis* const matroid = snapshot.matroid();
  if (matroid == nullptr || !matroid->solution || hasSlides(*snapshot.mechanism)) return made;
  const KinematicModel& model = *snapshot.kinematics->model;
  std::optional<ExactSolution> own;
  if (!snapshot.solved || !snapshot.solved->exact) {
    own = solveExact(model, matroid->choice.joints, matroid->speeds, stop);
    if (!own) return std::nullopt;
  }
  const ExactSolution& exact = own ? *own : *snapshot.solved->exact;
  made.motions = lostMotions(*snapshot.mechanism, model, matroid->choice.joints, stop);
  if (stop.stop_requested()) return std::nullopt;
  if (exact.matrix.empty() && !exact.inputs.empty() && !exact.outputs.empty()) made.motions.reset();
  if (!made.motions) return made;
  for (const LostMotion& output : made.motions->outputs) {
    const std::vector<Rational> gains = gainsOf(exact, output.joint);
    made.gains.insert(made.gains.end(), gains.begin(), gains.end());
  }
  return made;
}

std::optional<std::vector<LostMotionCase>> lostMotionCases(const Mechanism& mechanism,
                                                           const std::stop_token& stop) {
  std::vector<LostMotionCase> cases;
  for (int state = 0; state < static_cast<int>(mechanism.states.size()); ++state) {
    LostMotionCase made;
    if (auto engaged = withStateEngaged(mechanism, state)) {
      const SnapshotPtr snapshot =
          analyzeLive(std::make_shared<const Mechanism>(*std::move(engaged)), 0, stop);
      auto found = snapshot ? lostMotionCase(*snapshot, stop) : std::nullopt;
      if (!found) return std::nullopt;
      made = *std::move(found);
    }
    made.state = state;
    cases.push_back(std::move(made));
  }
  return cases;
}

ValueTable lostMotionTable(const Mechanism& mechanism, const std::vector<LostMotionCase>& cases) {
  ValueTable table;
  const bool hasStates = std::any_of(cases.begin(), cases.end(),
                                     [](const LostMotionCase& each) { return each.state.has_value(); });
  const auto add = [&](const char* head, const char* unit, const char* meaning, bool isNumber) {
    table.columns.push_back(wordedColumn(head, unit, meaning, isNumber));
  };
  if (hasStates) add(toTranslate("state"), "", toTranslate("The state whose couplings are engaged."), false);
  add(toTranslate("output"), "", toTranslate("The joint that turns while the inputs are held, by label."),
      false);
  add(toTranslate("input"), "", toTranslate("The input that it is carried back to, by label."), false);
  add(toTranslate("worst"), "rad", toTranslate("From stop to stop at the output, every mesh at its worst."),
      true);
  add(toTranslate("worst"), "arcmin", toTranslate("The same in minutes of arc."), true);
  add(toTranslate("likely"), "arcmin",
      toTranslate("The root of the sum of squares of the parts of all meshes."), true);
  add(toTranslate("at the input"), "arcmin",
      toTranslate("How far the input turns from stop to stop while the output is held."), true);
  add(toTranslate("mesh"), "", toTranslate("The mesh that contributes most, by label."), false);
  add(toTranslate("its part"), "arcmin",
      toTranslate("What is lost of the worst case if that mesh has no play."), true);
  for (const LostMotionCase& of : cases) {
    if (!of.motions) continue;
    for (std::size_t output = 0; output < of.motions->outputs.size(); ++output) {
      const LostMotion& motion = of.motions->outputs[output];
      const auto most = motion.mostOf();
      for (std::size_t input = 0; input < of.motions->held.size(); ++input) {
        const JointOrdinal held = of.motions->held[input];
        ForceRow& row = table.rows.emplace_back();
        row.elements = {mechanism.turningJoints[motion.joint].id, mechanism.turningJoints[held].id};
        if (most) row.elements.emplace_back(mechanism.gearMeshes[*most].id);
        if (hasStates)
          row.cells.push_back(
              {of.state ? mechanism.states[static_cast<std::size_t>(*of.state)].name : "", {}, {}});
        row.cells.push_back({std::to_string(mechanism.jointLabel(motion.joint)), {}, {}});
        row.cells.push_back({std::to_string(mechanism.jointLabel(held)), {}, {}});
        row.cells.push_back({motion.worst ? motion.worst->toString() : "", {}, {}});
        row.cells.push_back(angleCell(motion.worst));
        row.cells.push_back(angleCell(motion.rootOfSquares));
        row.cells.push_back(angleCell(of.atInput(output, input)));
        row.cells.push_back({most ? std::to_string(mechanism.meshLabel(*most)) : "", {}, {}});
        row.cells.push_back(angleCell(most ? std::optional(motion.parts[*most]) : std::nullopt));
      }
    }
  }
  return table;
}

std::string lostMotionJson(const Mechanism* mechanism, const std::vector<LostMotionCase>& cases) {
  TextSink sink;
  {
    JsonWriter json(sink);
    json.beginObject();
    json.member("format", "geargraph-backlash");
    json.member("version", 1);
    json.key("cases");
    json.beginArray();
    if (mechanism != nullptr) {
      for (const LostMotionCase& of : cases) LostMotionJson(json, *mechanism).write(of);
    }
    json.endArray();
    json.endObject();
  }
  return sink.take();
}

}  // namespace geargraph
