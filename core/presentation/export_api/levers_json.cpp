#include "core/presentation/export_api/levers_json.h"

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "core/foundations/files/json_writer.h"
#include "core/mechanism/model/shift_edits.h"
#include "core/theory/matroid/exact_solution.h"
#include "core/theory/states/engagement.h"
#include "core/theory/statics/shift_statics.h"

namespace geargraph {
namespace {

using Row = JsonWriter::Layout;

std::string_view absenceName(LeverAbsence absence) {
  switch (absence) {
    case LeverAbsence::none:
      return {};
    case LeverAbsence::unsolvable:
      return "unfinished";
    case LeverAbsence::noMesh:
      return "no-mesh";
    case LeverAbsence::locked:
      return "locked";
    case LeverAbsence::directions:
      return "directions";
    case LeverAbsence::tooLarge:
      return "too-large";
  }
  return {};
}

/// The lever diagram as JSON: links by id.
class LeversJson {
 public:
  LeversJson(JsonWriter& json, const Mechanism& mechanism, const LeverPicture& picture)
      : m_json(json), m_mechanism(mechanism), m_picture(picture), m_plan(picture.plan) {}

  void write() {
    m_json.key("freedom");
    m_plan.absence == LeverAbsence::unsolvable ? m_json.null()
                                               : m_json.number(static_cast<std::int64_t>(m_plan.freedom));
    m_json.key("points");
    m_json.beginObject();
    for (std::size_t i = 0; i < m_plan.points.size(); ++i) {
      m_json.key(idOf(m_plan.links[i]));
      m_json.beginArray(Row::row);
      for (const Rational& each : m_plan.points[i]) m_json.string(each.toString());
      m_json.endArray();
    }
    m_json.endObject();
    m_json.key("levers");
    m_json.beginArray();
    for (std::size_t i = 0; i < m_plan.levers.size(); ++i) writeLever(i);
    m_json.endArray();
    m_json.key("reason");
    m_plan.absence == LeverAbsence::none ? m_json.null() : m_json.string(absenceName(m_plan.absence));
    writeSpeeds();
  }

 private:
  [[nodiscard]] std::string idOf(LinkOrdinal link) const { return m_mechanism.links[link].id.text(); }

  void writeLever(std::size_t position) {
    const Lever& lever = m_plan.levers[position];
    m_json.beginObject();
    m_json.key("points");
    m_json.beginArray();
    for (const LeverPoint& point : lever.points) {
      m_json.beginObject(Row::row);
      m_json.key("links");
      m_json.beginArray(Row::row);
      for (const LinkOrdinal link : point.links) m_json.string(idOf(link));
      m_json.endArray();
      m_json.member("at", point.at.toString());
      m_json.member("byMeshes", point.isByMeshes && point.isOneByMeshes);
      m_json.endObject();
    }
    m_json.endArray();
    m_json.key("meshes");
    m_json.beginArray(Row::row);
    for (const int group : lever.groups) {
      for (const MeshOrdinal mesh : m_plan.groups[static_cast<std::size_t>(group)].meshes)
        m_json.string(m_mechanism.gearMeshes[mesh].id.text());
    }
    m_json.endArray();
    m_json.member("byMeshes", lever.isByMeshes);
    writeTorques(position);
    m_json.endObject();
  }

  /// In the order of the points; null where there are no loads, or they leave the torques open.
  void writeTorques(std::size_t position) {
    m_json.key("torques");
    if (position >= m_picture.torques.size() || m_picture.torques[position].empty()) return m_json.null();
    m_json.beginArray(Row::row);
    for (const Rational& torque : m_picture.torques[position]) m_json.string(torque.toString());
    m_json.endArray();
  }

  void writeSpeeds() {
    m_json.key("engaged");
    m_json.beginArray(Row::row);
    for (const ShiftElementOrdinal coupling : m_picture.engaged)
      m_json.string(m_mechanism.couplings[coupling].id.text());
    m_json.endArray();
    m_json.key("speeds");
    if (m_picture.speeds.empty()) return m_json.null();
    m_json.beginObject(Row::row);
    for (std::size_t i = 0; i < m_plan.links.size(); ++i)
      m_json.member(idOf(m_plan.links[i]), m_picture.speeds[i].toString());
    m_json.endObject();
  }

  JsonWriter& m_json;
  const Mechanism& m_mechanism;
  const LeverPicture& m_picture;
  const LeverPlan& m_plan;
};

/// Do errors leave torques unknown? In a state, which drives its own link, the document's inputs do not
/// count.
bool leavesTorquesOpen(const AnalysisSnapshot& snapshot, bool inState) {
  if (snapshot.matroid() == nullptr) return true;
  return std::any_of(snapshot.diagnostics.begin(), snapshot.diagnostics.end(), [&](const Diagnostic& each) {
    return each.severity() == Severity::error && !(inState && each.code == Code::invalidInputs);
  });
}

/// The statics without losses: of the engaged state as in the shift table, else under the document's loads.
/// None without loads, and where nothing holds them; `stop` tells whether it was stopped.
std::optional<StaticsReport> lossless(const AnalysisSnapshot& snapshot, const std::stop_token& stop) {
  const Mechanism& mechanism = *snapshot.mechanism;
  StaticsOptions options;
  options.symbolic = false;
  const auto state = shownState(mechanism);
  if (state && mechanism.states[static_cast<std::size_t>(*state)].driven) {
    // States engage their own couplings.
    auto released = std::make_shared<Mechanism>(mechanism);
    released->engaged.clear();
    const SnapshotPtr open = analyzeLive(std::move(released), 0, stop);
    if (!open || leavesTorquesOpen(*open, true)) return std::nullopt;
    const LiveKinematics& kinematics = *open->kinematics;
    auto forces = solveShiftState(*open->mechanism, *kinematics.model, kinematics.placement(),
                                  *kinematics.ttGraph, *kinematics.matroid, *state, options, stop);
    return forces ? std::move(forces->report) : std::nullopt;
  }
  if (mechanism.loads.empty() || leavesTorquesOpen(snapshot, false)) return std::nullopt;
  const LiveKinematics& kinematics = *snapshot.kinematics;
  return analyzeStatics(mechanism, *kinematics.model, kinematics.placement(), *kinematics.ttGraph,
                        *kinematics.matroid, options, stop);
}

/// The rows of all engaged couplings but one.
std::vector<KinematicModel::HeldRow> heldWithout(const Mechanism& mechanism, const Placement& placement,
                                                 std::optional<ShiftElementOrdinal> left) {
  std::vector<KinematicModel::HeldRow> held;
  for (const ShiftElementOrdinal coupling : mechanism.couplings.ordinals()) {
    const auto& engaged = mechanism.engaged;
    if (coupling == left ||
        std::find(engaged.begin(), engaged.end(), mechanism.couplings[coupling].id) == engaged.end())
      continue;
    if (!closesWithoutLinkage(mechanism, placement, coupling)) continue;
    for (auto& row : heldRows(mechanism, placement, coupling)) held.push_back(std::move(row));
  }
  return held;
}

/// The rates of all joints with the speeds of the inputs; empty where these do not determine them.
/// std::nullopt if `stop` was requested.
std::optional<std::vector<Rational>> exactRates(const AnalysisSnapshot& snapshot,
                                                const std::stop_token& stop) {
  const MatroidAnalysis* const matroid = snapshot.matroid();
  if (matroid == nullptr || !matroid->solution) return std::vector<Rational>();
  auto exact = solveExact(*snapshot.kinematics->model, matroid->choice.joints, matroid->speeds, stop);
  if (!exact) return std::nullopt;
  return std::move(exact->rates);
}

}  // namespace

std::optional<LeverPicture> leverPictureOf(const AnalysisSnapshot& snapshot, const std::stop_token& stop) {
  const LiveKinematics* const kinematics = snapshot.kinematics.get();
  if (kinematics == nullptr || !kinematics->model || hasSlides(*snapshot.mechanism)) return LeverPicture{};
  const Placement& placement = kinematics->placement();
  auto plan = leverPlanOf(*kinematics->model, placement, {}, stop);
  if (!plan) return std::nullopt;
  const auto rates = exactRates(snapshot, stop);
  if (!rates) return std::nullopt;
  const MatroidAnalysis* const matroid = snapshot.matroid();
  const std::vector<int> inputs = rates->empty() ? std::vector<int>() : matroid->choice.joints;
  LeverPicture picture = leverPicture(*snapshot.mechanism, placement, *std::move(plan), inputs, *rates);
  if (picture.plan.levers.empty()) return picture;
  const auto report = lossless(snapshot, stop);
  if (stop.stop_requested()) return std::nullopt;
  if (report && report->isAnswered())
    picture.torques = leverTorques(picture.plan, *kinematics->model, *report);
  return picture;
}

std::optional<LeverPlan> pointPlanOf(const AnalysisSnapshot& snapshot, const std::stop_token& stop) {
  const LiveKinematics* const kinematics = snapshot.kinematics.get();
  if (kinematics == nullptr || !kinematics->model || hasSlides(*snapshot.mechanism)) return LeverPlan{};
  const Mechanism& mechanism = *snapshot.mechanism;
  std::optional<ShiftElementOrdinal> last;
  for (const ShiftElementOrdinal coupling : mechanism.couplings.ordinals()) {
    if (!mechanism.engaged.empty() && mechanism.couplings[coupling].id == mechanism.engaged.back())
      last = coupling;
  }
  return leverPlanOf(*kinematics->model, kinematics->placement(),
                     heldWithout(mechanism, kinematics->placement(), last), stop);
}

std::optional<SpeedPlan> speedPlanFor(const AnalysisSnapshot& snapshot, const std::stop_token& stop) {
  const LiveKinematics* const kinematics = snapshot.kinematics.get();
  if (kinematics == nullptr || !kinematics->model) return SpeedPlan{};
  const auto rates = exactRates(snapshot, stop);
  if (!rates) return std::nullopt;
  return speedPlanOf(kinematics->placement(), *rates);
}

std::optional<int> freedomWithout(const AnalysisSnapshot& snapshot, ShiftElementOrdinal coupling,
                                  const std::stop_token& stop) {
  const LiveKinematics* const kinematics = snapshot.kinematics.get();
  if (kinematics == nullptr || !kinematics->model) return std::nullopt;
  const Placement& placement = kinematics->placement();
  const auto plan =
      leverPlanOf(*kinematics->model, placement, heldWithout(*snapshot.mechanism, placement, coupling), stop);
  if (!plan || plan->absence == LeverAbsence::unsolvable || plan->absence == LeverAbsence::tooLarge)
    return std::nullopt;
  return plan->freedom;
}

std::optional<StatesOnLevers> statesOnLevers(const AnalysisSnapshot& snapshot, const std::stop_token& stop) {
  const LiveKinematics* const kinematics = snapshot.kinematics.get();
  if (kinematics == nullptr || !kinematics->model) return StatesOnLevers{};
  // The states engage their own couplings, whatever the document engages.
  KinematicModel model = *kinematics->model;
  model.hold({});
  auto plan = leverPlanOf(model, kinematics->placement(), {}, stop);
  if (!plan) return std::nullopt;
  StatesOnLevers found{*std::move(plan), {}, shownState(*snapshot.mechanism)};
  if (snapshot.states) {
    found.states = *snapshot.states;
    return found;
  }
  auto states = solveStates(*snapshot.mechanism, model, kinematics->placement(), false, stop);
  if (!states) return std::nullopt;
  found.states = *std::move(states);
  return found;
}

std::optional<int> shownState(const Mechanism& mechanism) {
  const int state = mechanism.engaged.empty() ? -1 : engagedState(mechanism);
  return state < 0 ? std::nullopt : std::optional(state);
}

std::string leversJson(const AnalysisSnapshot* snapshot, const LeverPicture* picture) {
  TextSink sink;
  {
    JsonWriter json(sink);
    json.beginObject();
    json.member("format", "geargraph-levers");
    json.member("version", 1);
    const Mechanism none = emptyMechanism();
    const LeverPicture empty;
    LeversJson(json, snapshot != nullptr ? *snapshot->mechanism : none, picture != nullptr ? *picture : empty)
        .write();
    json.endObject();
  }
  return sink.take();
}

}  // namespace geargraph
