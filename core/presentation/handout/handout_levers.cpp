#include "core/presentation/handout/handout_levers.h"

#include "core/presentation/drawing/svg_writer.h"
#include "core/theory/levers/lever_motion.h"
#include "core/theory/states/state_solution.h"

namespace geargraph {
namespace {

class LeversWriter {
 public:
  LeversWriter(JsonWriter& json, const AnalysisSnapshot& snapshot, const HandoutLevers& levers)
      : m_json(json), m_mechanism(*snapshot.mechanism), m_levers(levers) {
    const Placement& placement = snapshot.kinematics->placement();
    for (JointOrdinal joint = 0; joint < m_mechanism.t(); ++joint) {
      if (placement.classes->classOf[joint] != levers.plan.mainAxis) continue;
      std::vector<Rational> alone(static_cast<std::size_t>(m_mechanism.t()));
      alone[static_cast<std::size_t>(static_cast<int>(joint))] = 1;
      m_perJoint.emplace_back(joint, leverSpeeds(levers.plan, placement, alone));
    }
  }

  void writeLevers() {
    m_json.key("levers");
    m_json.beginArray();
    int bar = -1;
    for (const LeverSpot& spot : m_levers.levers.spots) {
      if (spot.bar != bar && bar >= 0) m_json.endArray();
      if (spot.bar != bar) m_json.beginArray();
      bar = spot.bar;
      writeSpot(spot);
    }
    if (bar >= 0) m_json.endArray();
    m_json.endArray();
  }

  void writeNomogram() {
    m_json.key("nomogram");
    m_json.beginObject();
    m_json.key("lines");
    m_json.beginArray();
    for (const NomogramSheet::Line& line : m_levers.nomogram.lines) {
      m_json.beginArray(Row::row);
      m_json.number(static_cast<std::int64_t>(line.state));
      for (const double each : {line.from.x, line.from.y, line.to.x, line.to.y}) m_json.number(each);
      m_json.endArray();
    }
    m_json.endArray();
    m_json.key("tags");
    m_json.beginArray();
    for (const NomogramSheet::Tag& tag : m_levers.nomogram.tags) {
      m_json.beginObject(Row::row);
      m_json.key("states");
      m_json.beginArray(Row::row);
      for (const int state : tag.states) m_json.number(static_cast<std::int64_t>(state));
      m_json.endArray();
      m_json.key("box");
      m_json.beginArray(Row::row);
      for (const double each : {tag.box.left(), tag.box.top(), 2 * tag.box.halfWidth, 2 * tag.box.halfHeight})
        m_json.number(each);
      m_json.endArray();
      m_json.endObject();
    }
    m_json.endArray();
    m_json.endObject();
  }

 private:
  using Row = JsonWriter::Layout;

  void writeSpot(const LeverSpot& spot) {
    const LinkOrdinal link = m_levers.plan.levers[static_cast<std::size_t>(spot.lever)]
                                 .points[static_cast<std::size_t>(spot.point)]
                                 .links.front();
    const Tint tint = Tint::ofLink(m_mechanism.linkLabel(link), m_mechanism.colorNumber(link));
    m_json.beginObject(Row::row);
    m_json.member("element",
                  std::string(listName(ElementKind::link)) + "/" + m_mechanism.links[link].id.text());
    m_json.member("colour", hexOf(colorOf(tint, Theme::light)));
    m_json.member("x", spot.at.x);
    m_json.member("y", spot.at.y);
    m_json.key("terms");
    m_json.beginArray(Row::row);
    const auto at = static_cast<std::size_t>(m_levers.plan.positionOf(link));
    for (const auto& [joint, speeds] : m_perJoint) {
      if (speeds[at].isZero()) continue;
      m_json.beginArray(Row::row);
      m_json.number(static_cast<std::int64_t>(joint));
      m_json.number(static_cast<std::int64_t>(speeds[at].sign()));
      m_json.endArray();
    }
    m_json.endArray();
    m_json.endObject();
  }

  JsonWriter& m_json;
  const Mechanism& m_mechanism;
  const HandoutLevers& m_levers;
  /// By joint of the main axis: the speeds of the plan's links when it alone turns, at 1 rad/s: -1, 0 or 1.
  std::vector<std::pair<JointOrdinal, std::vector<Rational>>> m_perJoint;
};

}  // namespace

HandoutLevers handoutLevers(const AnalysisSnapshot& snapshot, const std::stop_token& stop) {
  HandoutLevers drawn;
  if (!snapshot.kinematics || !snapshot.kinematics->model) return drawn;
  const Mechanism& mechanism = *snapshot.mechanism;
  const Placement& placement = snapshot.kinematics->placement();
  auto plan = leverPlanOf(*snapshot.kinematics->model, placement, {}, stop);
  if (!plan || plan->levers.empty()) return drawn;
  drawn.plan = *std::move(plan);
  LeverPicture picture;
  picture.plan = drawn.plan;
  drawn.levers = leverSheet(mechanism, picture, leverLayout(mechanism, drawn.plan), {},
                            {.speeds = false, .torques = false});
  drawn.leversSvg = svgOf(drawn.levers.drawing, SheetStyle());
  if (mechanism.states.empty()) return drawn;
  KinematicModel model = *snapshot.kinematics->model;
  model.hold({});  // states engage their own couplings
  const auto states = solveStates(mechanism, model, placement, false, stop);
  if (!states) return drawn;
  drawn.nomogram = nomogramSheet(mechanism, drawn.plan, placement, *states, {}, {});
  if (drawn.nomogram.missing.empty()) drawn.nomogramSvg = svgOf(drawn.nomogram.drawing, SheetStyle());
  return drawn;
}

void writeHandoutLevers(JsonWriter& json, const AnalysisSnapshot& snapshot, const HandoutLevers& levers) {
  if (levers.leversSvg.empty()) return;
  LeversWriter writer(json, snapshot, levers);
  writer.writeLevers();
  if (!levers.nomogramSvg.empty()) writer.writeNomogram();
}

}  // namespace geargraph
