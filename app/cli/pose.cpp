// `pose FILE --angle 8=30deg ... [--inputs 8,9,11] [--state NAME] [--json]`: where every link is for given
// angles of the inputs.

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <memory>
#include <numbers>
#include <sstream>

#include "app/cli/analyze_document.h"
#include "app/cli/command.h"
#include "app/cli/diagnostics_output.h"
#include "app/cli/engagement_options.h"
#include "app/cli/number_options.h"
#include "app/cli/time_limit.h"
#include "core/foundations/base/translation.h"
#include "core/presentation/export_api/input_pose.h"
#include "core/presentation/exporters/element_words.h"
#include "core/presentation/exporters/input_options.h"
#include "core/theory/analysis/analysis.h"
#include "core/theory/pose/joint_limits.h"

namespace geargraph::cli {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// The column of an input by its label; none where it is none.
std::optional<std::size_t> inputNamed(const AnalysisSnapshot& snapshot, std::string_view label) {
  const std::vector<int>& inputs = snapshot.matroid()->choice.joints;
  const auto joint = jointNamed(*snapshot.mechanism, std::string(label));
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (joint == inputs[i]) return i;
  }
  return std::nullopt;
}

std::optional<UsageError> setTravel(const AnalysisSnapshot& snapshot, std::string_view word,
                                    InputAngles& inputs) {
  const std::size_t sign = word.find('=');
  const std::string_view label = word.substr(0, std::min(sign, word.size()));
  std::string_view value = sign < word.size() ? word.substr(sign + 1) : std::string_view();
  const std::string& unit = snapshot.mechanism->unit;
  if (!unit.empty() && value.ends_with(unit)) value.remove_suffix(unit.size());
  const auto travel = Rational::fromText(value);
  if (!travel || !std::isfinite(travel->toDouble())) {
    return UsageError{translated("%1 is like 9=20%2: an input's label and its travel in the document's unit.",
                                 {"--travel", unit})};
  }
  const auto input = inputNamed(snapshot, label);
  if (!input)
    return UsageError{
        translated("Joint %1 is not an input; see --inputs.", {'"' + std::string(label) + '"'})};
  if (!slides(snapshot.mechanism->turningJoints[snapshot.matroid()->choice.joints[*input]])) {
    return UsageError{translated("Joint %1 turns: its angle is given by --angle.", {label})};
  }
  inputs.radians[*input] = *travel;
  return std::nullopt;
}

std::optional<UsageError> setAngle(const AnalysisSnapshot& snapshot, std::string_view word,
                                   InputAngles& angles) {
  const std::string label(word.substr(0, std::min(word.find('='), word.size())));
  const auto read = angleOption("--angle", word);
  if (const auto* error = std::get_if<UsageError>(&read)) return *error;
  const auto input = inputNamed(snapshot, label);
  if (!input) return UsageError{translated("Joint %1 is not an input; see --inputs.", {'"' + label + '"'})};
  if (slides(snapshot.mechanism->turningJoints[snapshot.matroid()->choice.joints[*input]]))
    return UsageError{translated("Joint %1 slides: its travel is given by --travel.", {label})};
  angles.degrees[*input] = std::get<TypedAngle>(read).degrees;
  angles.radians[*input] = std::get<TypedAngle>(read).radians;
  return std::nullopt;
}

/// "170 deg", "-133.33333 deg", "20 mm", or "none" for an open end.
std::string limitText(const AnalysisSnapshot& snapshot, std::size_t joint, double angle) {
  if (!std::isfinite(angle)) return translated("none");
  std::ostringstream text;
  if (slides(snapshot.mechanism->turningJoints[joint])) {
    text << std::setprecision(8) << angle << ' ' << snapshot.mechanism->unit;
    return text.str();
  }
  text << std::setprecision(8) << angle / kDegree;
  return translated("%1 deg", {text.str()});
}

/// One line a joint that is turned beyond its limits.
std::string warningsBeyondLimits(const std::string& file, const AnalysisSnapshot& snapshot,
                                 const InputPose& pose) {
  const std::vector<AngleLimits> limits = angleLimits(*snapshot.mechanism);
  std::string text;
  for (const int joint : pose.beyondLimits) {
    const auto j = static_cast<std::size_t>(joint);
    text +=
        file + ": warning: " +
        translated("joint %1 at %2 is beyond its limits (%3, %4)",
                   {std::to_string(snapshot.graph->edgeLabel(joint)), limitText(snapshot, j, pose.angles[j]),
                    limitText(snapshot, j, limits[j].low), limitText(snapshot, j, limits[j].high)}) +
        '\n';
  }
  return text;
}

void writeTriple(JsonWriter& json, const Eigen::Vector3d& triple) {
  json.beginArray(JsonWriter::Layout::row);
  for (const double component : triple) json.number(component);
  json.endArray();
}

std::string asJson(const AnalysisSnapshot& snapshot, const InputPose& pose) {
  const auto& [angles, links, beyond] = pose;
  TextSink sink;
  {
    JsonWriter json(sink);
    json.beginObject();
    json.member("format", "geargraph-pose");
    json.member("version", 1);
    json.key("jointAngles");
    json.beginObject(JsonWriter::Layout::row);
    for (std::size_t joint = 0; joint < angles.size(); ++joint) {
      json.key(std::to_string(snapshot.graph->edgeLabel(static_cast<int>(joint))));
      json.numberOrNull(angles[joint]);
    }
    json.endObject();
    if (!beyond.empty()) {
      json.key("beyondLimits");
      json.beginArray(JsonWriter::Layout::row);
      for (const int joint : beyond) json.number(std::int64_t{snapshot.graph->edgeLabel(joint)});
      json.endArray();
    }
    json.key("links");
    json.beginObject();
    for (std::size_t node = 0; node < links.size(); ++node) {
      json.key(std::to_string(snapshot.graph->nodeLabel(static_cast<int>(node))));
      json.beginObject(JsonWriter::Layout::row);
      json.key("rotation");
      json.beginArray();
      for (int row = 0; row < 3; ++row) writeTriple(json, links[node].linear().row(row));
      json.endArray();
      json.key("point");
      writeTriple(json, links[node].translation());
      json.endObject();
    }
    json.endObject();
    json.endObject();
  }
  return sink.take();
}

/// With four decimals and no -0.
std::string rounded(double value) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(4) << std::round(value * 1e4) / 1e4 + 0.0;
  return text.str();
}

/// With all turns; where four decimals are beyond a double, eight digits.
std::string degreesText(double angle) {
  constexpr double kMaxWithDecimals = 1e11;
  const double degrees = angle / kDegree;
  if (std::abs(degrees) < kMaxWithDecimals) return rounded(degrees);
  std::ostringstream text;
  text << std::setprecision(8) << degrees;
  return text.str();
}

std::string asText(const AnalysisSnapshot& snapshot, const InputPose& pose) {
  const auto triple = [](const Eigen::Vector3d& v) {
    return "(" + rounded(v.x()) + ", " + rounded(v.y()) + ", " + rounded(v.z()) + ")";
  };
  std::string text = translated("Joints") + '\n';
  for (std::size_t joint = 0; joint < pose.angles.size(); ++joint) {
    if (slides(snapshot.mechanism->turningJoints[joint])) {
      text +=
          "  " +
          translated("%1 moved by %2 %3", {std::to_string(snapshot.graph->edgeLabel(static_cast<int>(joint))),
                                           rounded(pose.angles[joint]), snapshot.mechanism->unit}) +
          '\n';
      continue;
    }
    text +=
        "  " +
        translated("%1 turned by %2 deg", {std::to_string(snapshot.graph->edgeLabel(static_cast<int>(joint))),
                                           degreesText(pose.angles[joint])}) +
        '\n';
  }
  text += '\n' +
          translated(
              "Links, against the reference pose: turned, and where the point went that was at the origin") +
          '\n';
  for (std::size_t node = 1; node < pose.links.size(); ++node) {
    const Eigen::AngleAxisd turn(pose.links[node].linear());
    text += "  " +
            translated("%1 by %2 deg about %3 to %4",
                       {std::to_string(snapshot.graph->nodeLabel(static_cast<int>(node))),
                        rounded(turn.angle() / kDegree), triple(turn.axis()),
                        triple(pose.links[node].translation())}) +
            '\n';
  }
  return text;
}

int runPose(const Arguments& arguments) {
  if (arguments.files.size() != 1) return wrongUsage(kPose, translated("One file is needed."));
  const std::string& file = arguments.files.front();
  auto document = loadEngaged(kPose, arguments);
  if (const int* status = std::get_if<int>(&document)) return *status;
  auto mechanism = withInputOptions(std::get<Mechanism>(std::move(document)), arguments);
  if (const auto* error = std::get_if<UsageError>(&mechanism)) return wrongUsage(kPose, error->message);
  const auto analyzed = analyzeAndReport(std::get<Mechanism>(std::move(mechanism)), arguments);
  if (const int* status = std::get_if<int>(&analyzed)) return *status;
  const auto& snapshot = std::get<SnapshotPtr>(analyzed);
  if (hasErrors(snapshot->diagnostics) || snapshot->matroid() == nullptr) return kMechanismErrors;

  InputAngles inputs = restingInputs(*snapshot);
  for (const std::string& word : arguments.values("--angle")) {
    if (const auto error = setAngle(*snapshot, word, inputs)) return wrongUsage(kPose, error->message);
  }
  for (const std::string& word : arguments.values("--travel")) {
    if (const auto error = setTravel(*snapshot, word, inputs)) return wrongUsage(kPose, error->message);
  }
  const auto pose = poseOfInputs(*snapshot, inputs, arguments.stop);
  if (!pose) return outOfTime(arguments, translated("the pose"));
  std::cerr << warningsBeyondLimits(file, *snapshot, *pose);
  return print(arguments.has("--json") ? asJson(*snapshot, *pose) : asText(*snapshot, *pose));
}

constexpr std::array kPoseOptions = {
    Option{"--angle", "8=30deg",
           toTranslate("the angle of an input (deg, rad or turns; without it 0); may be repeated")},
    Option{"--travel", "9=20mm",
           toTranslate("the travel of an input that slides, in the document's unit; may be repeated")},
    Option{"--inputs", "8,9,11", toTranslate("drive these joints (by label) instead of the document's")},
    kStateOption,
    kEngageOption,
    Option{"--json", "", toTranslate("as JSON")},
};

}  // namespace

const Command kPose = {
    "pose",
    "FILE --angle 8=30deg ... [--travel 9=20mm ...] [--inputs 8,9,11] [--state NAME | --engage A,B] [--json]",
    toTranslate("Says where every link is for given angles of the inputs."),
    kPoseOptions,
    runPose,
    false,
    true,
    nullptr,
    MethodInput::document,
    {},
    true};

}  // namespace geargraph::cli
