#include "core/presentation/result_json/vibration_report.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/foundations/base/readable.h"
#include "core/foundations/base/translation.h"
#include "core/foundations/files/json_writer.h"
#include "core/teaching/force_tables/spoken_cell.h"
#include "core/theory/matroid/exact_solution.h"

namespace geargraph {
namespace {

using Row = JsonWriter::Layout;

/// The speed of the reference shaft, or why there is none.
std::variant<Rational, FrequencyAbsence> speedOf(const Placement& placement, const FrequencyMotion& motion,
                                                 const ReferenceShaft& reference) {
  Rational speed;
  if (const auto* joint = std::get_if<JointOrdinal>(&reference)) {
    const auto at = static_cast<std::size_t>(int{*joint});
    if (!motion.idle.empty() && !motion.idle[at].isZero()) return FrequencyAbsence::free;
    speed = motion.rates[at].abs();
  } else {
    const auto known = shaftSpeed(placement, motion, std::get<LinkOrdinal>(reference));
    if (!known) return FrequencyAbsence::free;
    speed = *known;
  }
  if (speed.isZero()) return FrequencyAbsence::atRest;
  return speed;
}

void fillCase(FrequencyCase& into, const AnalysisSnapshot& snapshot, const FrequencyMotion& motion,
              const FrequencyOptions& options) {
  const LiveKinematics& kinematics = *snapshot.kinematics;
  if (!into.reference) {
    into.absence = FrequencyAbsence::atRest;
    return;
  }
  const auto speed = speedOf(kinematics.placement(), motion, *into.reference);
  if (const auto* absence = std::get_if<FrequencyAbsence>(&speed)) {
    into.absence = *absence;
    return;
  }
  into.absence = FrequencyAbsence::none;
  into.lines = frequencyLines(*snapshot.mechanism, kinematics.placement(), *kinematics.model, motion,
                              std::get<Rational>(speed), options);
}

std::optional<ReferenceShaft> driveOf(const Mechanism& mechanism, const ShiftState& state) {
  if (!state.drive) return std::nullopt;
  for (const LinkOrdinal link : mechanism.links.ordinals()) {
    if (mechanism.links[link].id == *state.drive) return link;
  }
  return std::nullopt;
}

std::string labelText(const Mechanism& mechanism, LinkOrdinal link) {
  return std::to_string(mechanism.linkLabel(link));
}
std::string labelText(const Mechanism& mechanism, MeshOrdinal mesh) {
  return std::to_string(mechanism.meshLabel(mesh));
}

void writeLine(JsonWriter& json, const Mechanism& mechanism, const FrequencyLine& line,
               std::optional<double> rpm) {
  json.beginObject(Row::row);
  json.member("kind", frequencyKindName(line.kind));
  if (line.mesh) json.member("mesh", mechanism.gearMeshes[*line.mesh].id.text());
  if (line.link) json.member("link", mechanism.links[*line.link].id.text());
  if (line.joint) json.member("joint", mechanism.turningJoints[*line.joint].id.text());
  if (line.planets > 0) json.member("planets", line.planets);
  if (line.kind == FrequencyKind::toothMesh || line.kind == FrequencyKind::sideband)
    json.member("harmonic", line.harmonic);
  if (line.kind == FrequencyKind::sideband) json.member("sideband", line.sideband);
  json.member("ratio", line.ratio.toString());
  json.key("orders");
  json.numberOrNull(line.ratio.toDouble());
  json.key("hertz");
  rpm ? json.numberOrNull(hertzOf(line, *rpm)) : json.null();
  json.endObject();
}

std::string_view absenceName(FrequencyAbsence absence) {
  switch (absence) {
    case FrequencyAbsence::none:
      return {};
    case FrequencyAbsence::unfinished:
      return "unfinished";
    case FrequencyAbsence::atRest:
      return "at-rest";
    case FrequencyAbsence::free:
      return "free";
  }
  return {};
}

void writeCase(JsonWriter& json, const Mechanism& mechanism, const FrequencyCase& of,
               std::optional<double> rpm) {
  json.beginObject();
  json.key("state");
  of.state ? json.string(mechanism.states[static_cast<std::size_t>(*of.state)].name) : json.null();
  json.key("reference");
  if (of.reference) {
    json.beginObject(Row::row);
    if (const auto* joint = std::get_if<JointOrdinal>(&*of.reference)) {
      json.member("joint", mechanism.turningJoints[*joint].id.text());
    } else {
      json.member("link", mechanism.links[std::get<LinkOrdinal>(*of.reference)].id.text());
    }
    json.endObject();
  } else {
    json.null();
  }
  json.key("reason");
  of.absence == FrequencyAbsence::none ? json.null() : json.string(absenceName(of.absence));
  json.key("lines");
  json.beginArray();
  for (const FrequencyLine& line : of.lines) writeLine(json, mechanism, line, rpm);
  json.endArray();
  json.endObject();
}

/// Beyond the range of doubles there is no number.
ForceCell decimalCell(double value) {
  if (!std::isfinite(value)) return {};
  return {shownNumber(value), value, {}};
}

ForceCell wholeCell(bool isThere, int value) {
  if (!isThere) return {};
  return {std::to_string(value), static_cast<double>(value), {}};
}

std::vector<ElementId> elementsOf(const Mechanism& mechanism, const FrequencyLine& line) {
  std::vector<ElementId> elements;
  if (line.mesh) elements.emplace_back(mechanism.gearMeshes[*line.mesh].id);
  if (line.link) elements.emplace_back(mechanism.links[*line.link].id);
  if (line.joint) elements.emplace_back(mechanism.turningJoints[*line.joint].id);
  return elements;
}

}  // namespace

std::optional<FrequencyCase> frequenciesAsEngaged(const AnalysisSnapshot& snapshot,
                                                  const VibrationOptions& options,
                                                  const std::stop_token& stop) {
  FrequencyCase made;
  made.reference = options.reference;
  const MatroidAnalysis* const matroid = snapshot.matroid();
  if (matroid == nullptr || !matroid->solution || hasSlides(*snapshot.mechanism)) return made;
  ByJoint<Rational> rates;
  if (snapshot.solved && snapshot.solved->exact) {
    rates = snapshot.solved->exact->rates;
  } else {
    auto exact = solveExact(*snapshot.kinematics->model, matroid->choice.joints, matroid->speeds, stop);
    if (!exact) return std::nullopt;
    rates = std::move(exact->rates);
  }
  if (!made.reference) {
    for (const int joint : matroid->choice.joints) {
      if (made.reference || rates[JointOrdinal(joint)].isZero()) continue;
      made.reference = JointOrdinal(joint);
    }
  }
  fillCase(made, snapshot, {rates}, options.lines);
  return made;
}

std::optional<std::vector<FrequencyCase>> frequencyCases(const AnalysisSnapshot& snapshot,
                                                         const VibrationOptions& options,
                                                         const std::stop_token& stop) {
  const Mechanism& mechanism = *snapshot.mechanism;
  if (mechanism.states.empty() || !mechanism.engaged.empty()) {
    auto one = frequenciesAsEngaged(snapshot, options, stop);
    if (!one) return std::nullopt;
    return std::vector<FrequencyCase>{*std::move(one)};
  }
  std::vector<FrequencyCase> cases(mechanism.states.size());
  for (std::size_t i = 0; i < cases.size(); ++i) {
    cases[i].state = static_cast<int>(i);
    cases[i].reference = options.reference ? options.reference : driveOf(mechanism, mechanism.states[i]);
  }
  const LiveKinematics* const kinematics = snapshot.kinematics.get();
  if (kinematics == nullptr || !kinematics->model) return cases;
  std::optional<std::vector<StateSolution>> solved;
  if (!snapshot.states) {
    solved = solveStates(mechanism, *kinematics->model, kinematics->placement(), false, stop);
    if (!solved) return std::nullopt;
  }
  for (const StateSolution& state : snapshot.states ? *snapshot.states : *solved) {
    FrequencyCase& made = cases[static_cast<std::size_t>(state.state)];
    if (stop.stop_requested()) return std::nullopt;
    if (state.isSolved()) fillCase(made, snapshot, {state.rates, state.idleRates}, options.lines);
  }
  return cases;
}

std::string referenceText(const Mechanism& mechanism, const ReferenceShaft& reference) {
  if (const auto* joint = std::get_if<JointOrdinal>(&reference))
    return translated("input shaft: joint %1", {std::to_string(mechanism.jointLabel(*joint))});
  return translated("input shaft: link %1", {labelText(mechanism, std::get<LinkOrdinal>(reference))});
}

std::string absenceText(const Mechanism& mechanism, const FrequencyCase& of) {
  switch (of.absence) {
    case FrequencyAbsence::none:
      return {};
    case FrequencyAbsence::unfinished:
      return translated("No motion is known, so there are no frequencies.");
    case FrequencyAbsence::atRest:
      return of.reference
                 ? translated("The shaft does not turn (%1).", {referenceText(mechanism, *of.reference)})
                 : translated("No input turns, so there are no frequencies.");
    case FrequencyAbsence::free:
      return translated("The shaft has no speed of its own about one axis (%1).",
                        {referenceText(mechanism, *of.reference)});
  }
  return {};
}

std::string frequencyKindText(FrequencyKind kind) {
  switch (kind) {
    case FrequencyKind::shaft:
      return translated("shaft");
    case FrequencyKind::joint:
      return translated("turns on its bearer");
    case FrequencyKind::planetPass:
      return translated("planets pass");
    case FrequencyKind::toothMesh:
      return translated("tooth mesh");
    case FrequencyKind::sideband:
      return translated("sideband");
    case FrequencyKind::assemblyPhase:
      return translated("assembly phase");
    case FrequencyKind::huntingTooth:
      return translated("hunting tooth");
  }
  return {};
}

std::string sourceText(const Mechanism& mechanism, const FrequencyLine& line) {
  const std::string planets = std::to_string(line.planets);
  if (line.joint) return translated("joint %1", {std::to_string(mechanism.jointLabel(*line.joint))});
  if (line.mesh && line.link) {
    const std::string mesh = labelText(mechanism, *line.mesh);
    const std::string link = labelText(mechanism, *line.link);
    return line.planets > 0 ? translated("mesh %1, %2 planets past link %3", {mesh, planets, link})
                            : translated("mesh %1, turns of link %2", {mesh, link});
  }
  if (line.mesh) return translated("mesh %1", {labelText(mechanism, *line.mesh)});
  const std::string link = labelText(mechanism, *line.link);
  return line.kind == FrequencyKind::planetPass ? translated("%1 past link %2", {planets, link})
                                                : translated("link %1", {link});
}

ValueTable frequencyTable(const Mechanism& mechanism, const std::vector<FrequencyCase>& cases,
                          const VibrationOptions& options) {
  ValueTable table;
  const bool hasStates = std::any_of(cases.begin(), cases.end(),
                                     [](const FrequencyCase& each) { return each.state.has_value(); });
  const auto add = [&](const char* head, const char* unit, const char* meaning, bool isNumber,
                       bool isFraction = false) {
    table.columns.push_back(wordedColumn(head, unit, meaning, isNumber, isFraction));
  };
  if (hasStates) add(toTranslate("state"), "", toTranslate("The state whose couplings are engaged."), false);
  add(toTranslate("frequency"), "", toTranslate("What repeats."), false);
  add(toTranslate("of"), "", toTranslate("Where it repeats, by label."), false);
  add(toTranslate("harmonic"), "", toTranslate("The multiple of the tooth mesh."), true);
  add(toTranslate("sideband"), "",
      toTranslate("How often the modulating frequency is added to the harmonic, or taken from it."), true);
  add(toTranslate("ratio"), "", toTranslate("Cycles for a turn of the input shaft, exactly."), true);
  add(toTranslate("orders"), "", toTranslate("The same as a decimal."), true);
  if (options.rpm)
    add(toTranslate("frequency"), "Hz", toTranslate("At the given speed of the input shaft."), true);
  for (const FrequencyCase& of : cases) {
    for (const FrequencyLine& line : of.lines) {
      ForceRow& row = table.rows.emplace_back();
      row.elements = elementsOf(mechanism, line);
      if (hasStates)
        row.cells.push_back(
            {of.state ? mechanism.states[static_cast<std::size_t>(*of.state)].name : "", {}, {}});
      const bool isMultiple = line.kind == FrequencyKind::toothMesh || line.kind == FrequencyKind::sideband;
      row.cells.push_back(spokenCell([&] { return frequencyKindText(line.kind); }));
      row.cells.push_back(spokenCell([&] { return sourceText(mechanism, line); }));
      row.cells.push_back(wholeCell(isMultiple, line.harmonic));
      row.cells.push_back(wholeCell(line.kind == FrequencyKind::sideband, line.sideband));
      row.cells.push_back({line.ratio.toString(), {}, {}});
      row.cells.push_back(decimalCell(line.ratio.toDouble()));
      if (options.rpm) row.cells.push_back(decimalCell(hertzOf(line, *options.rpm)));
    }
  }
  return table;
}

std::string vibrationJson(const Mechanism* mechanism, const std::vector<FrequencyCase>* cases,
                          const VibrationOptions& options) {
  TextSink sink;
  {
    JsonWriter json(sink);
    json.beginObject();
    json.member("format", "geargraph-vibration");
    json.member("version", 1);
    json.key("rpm");
    options.rpm ? json.number(*options.rpm) : json.null();
    json.key("cases");
    json.beginArray();
    if (mechanism != nullptr && cases != nullptr) {
      for (const FrequencyCase& of : *cases) writeCase(json, *mechanism, of, options.rpm);
    }
    json.endArray();
    json.endObject();
  }
  return sink.take();
}

}  // namespace geargraph
