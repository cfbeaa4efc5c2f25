// `dynamics FILE ...`: masses, the equation of motion in the inputs, and the motion that torques cause.

#include <array>
#include <iostream>
#include <memory>
#include <numbers>

#include "app/cli/analyze_document.h"
#include "app/cli/command.h"
#include "app/cli/diagnostics_output.h"
#include "app/cli/dynamics_output.h"
#include "app/cli/engagement_options.h"
#include "app/cli/number_options.h"
#include "app/cli/time_limit.h"
#include "core/foundations/base/translation.h"
#include "core/foundations/files/file.h"
#include "core/machine/body_layout/derived_geometry.h"
#include "core/machine/train/train.h"
#include "core/mechanism/model/quantity.h"
#include "core/presentation/exporters/element_words.h"
#include "core/presentation/exporters/input_options.h"
#include "core/presentation/exporters/mass_options.h"

namespace geargraph::cli {
namespace {

constexpr double kMaxSeconds = 1e6;
constexpr double kLeastInterval = 1e-6;

using ReadNumber = std::optional<double> (*)(std::string_view text);

std::optional<double> valueOf(const std::optional<Number>& number) {
  return number ? std::optional(number->value()) : std::nullopt;
}
std::optional<double> plainNumber(std::string_view text) {
  return valueOf(typedNumber(text));
}
std::optional<double> speedNumber(std::string_view text) {
  return valueOf(quantityFromText(text, Quantity::speed));
}
std::optional<double> torqueNumber(std::string_view text) {
  return valueOf(withUnitFromText(text, Quantity::torque));
}
/// In rad.
std::optional<double> angleNumber(std::string_view text) {
  const auto angle = angleFromText(text);
  if (!angle) return std::nullopt;
  return angle->degrees.toDouble() * std::numbers::pi / 180 + angle->radians.toDouble();
}

/// Sets a number of one input by a word like `example`, "8=1.5Nm".
std::optional<UsageError> setByInput(const DynamicsResult& result, std::string_view option,
                                     std::string_view word, std::string_view example, ReadNumber read,
                                     const std::function<void(std::size_t, double)>& set) {
  const std::size_t equals = std::min(word.find('='), word.size());
  const std::string_view label = word.substr(0, equals);
  const auto number = read(word.substr(std::min(equals + 1, word.size())));
  if (!number) {
    return UsageError{
        translated("%1 names an input and its number, like %2, not \"%3\".", {option, example, word})};
  }
  const auto joint = jointNamed(*result.snapshot->mechanism, label);
  for (std::size_t i = 0; i < result.dynamics.inputs.size(); ++i) {
    if (joint != result.dynamics.inputs[i]) continue;
    set(i, *number);
    return std::nullopt;
  }
  return UsageError{translated("Joint %1 is not an input; see --inputs.", {'"' + std::string(label) + '"'})};
}

/// Motors, start and length of the motion.
std::optional<UsageError> readStart(DynamicsResult& result, const Arguments& arguments) {
  SimulationOptions& start = result.start;
  const auto inputs = static_cast<Eigen::Index>(result.dynamics.inputs.size());
  start.motors.resize(result.dynamics.inputs.size());
  start.angles = Eigen::VectorXd::Zero(inputs);
  start.speeds = Eigen::VectorXd::Zero(inputs);
  const auto at = [](std::size_t i) { return static_cast<Eigen::Index>(i); };
  for (const std::string& word : arguments.values("--torque")) {
    if (const auto error = setByInput(result, "--torque", word, "8=1.5Nm", torqueNumber,
                                      [&](std::size_t i, double torque) { start.motors[i].torque = torque; }))
      return error;
  }
  bool isNegative = false;
  for (const std::string& word : arguments.values("--damping")) {
    if (const auto error =
            setByInput(result, "--damping", word, "8=0.01", plainNumber, [&](std::size_t i, double damping) {
              start.motors[i].damping = damping;
              isNegative = isNegative || damping < 0;
            }))
      return error;
  }
  if (isNegative) return UsageError{translated("--damping is at least 0, in N m s.")};
  for (const std::string& word : arguments.values("--angle")) {
    const auto read = angleOption("--angle", word);
    if (const auto* error = std::get_if<UsageError>(&read)) return *error;
    if (const auto error = setByInput(result, "--angle", word, "8=30deg", angleNumber,
                                      [&](std::size_t i, double angle) { start.angles[at(i)] = angle; }))
      return error;
  }
  for (const std::string& word : arguments.values("--start-speed")) {
    if (const auto error = setByInput(result, "--start-speed", word, "8=1", speedNumber,
                                      [&](std::size_t i, double speed) { start.speeds[at(i)] = speed; }))
      return error;
  }
  const auto seconds = numberWithin(arguments, "--seconds", 1, kLeastInterval, kMaxSeconds);
  if (const auto* error = std::get_if<UsageError>(&seconds)) return *error;
  start.seconds = std::get<double>(seconds);
  const auto interval =
      numberWithin(arguments, "--interval", start.seconds / 100, kLeastInterval, kMaxSeconds);
  if (const auto* error = std::get_if<UsageError>(&interval)) return *error;
  start.interval = std::get<double>(interval);
  if (start.seconds / start.interval >= static_cast<double>(kMaxSamples))
    return UsageError{translated("--seconds over --interval are at most a million samples.")};
  start.limits = angleLimits(*result.snapshot->mechanism);
  return std::nullopt;
}

/// The equation of motion at the start, and the motion where it is asked for.
void solve(DynamicsResult& result, const Arguments& arguments) {
  TrainDynamics dynamics(result.dynamics.train);
  result.equation = dynamics.at(result.start.angles, result.start.speeds);
  result.reflected = dynamics.reflectedInertias(result.start.angles);
  result.torques = Eigen::VectorXd::Zero(result.equation.bias.size());
  for (std::size_t i = 0; i < result.start.motors.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    result.torques[at] = result.start.motors[i].torqueAt(result.start.speeds[at]);
  }
  result.accelerations = accelerationsFor(result.equation, result.torques);
  if (arguments.has("--seconds") || arguments.has("-o"))
    result.simulation = simulate(dynamics, result.start, arguments.stop);
}

std::string asJson(const DynamicsResult* result, const Diagnostics& diagnostics) {
  TextSink sink;
  {
    JsonWriter json(sink);
    writeDynamicsJson(json, result, diagnostics);
  }
  return sink.take();
}

int writeCsv(const std::string& path, const DynamicsResult& result) {
  if (path == "-") {
    StandardOutput out;
    writeMotionCsv(out, result, {});
    return out.failed() ? fileFailure(translated("Standard output could not be written.")) : kFine;
  }
  AtomicFile file(path);
  writeMotionCsv(file, result, {});
  const auto error = file.commit();
  return error ? fileFailure(error->message) : kFine;
}

int runDynamics(const Arguments& arguments) {
  if (arguments.files.size() != 1) return wrongUsage(kDynamics, translated("One file is needed."));
  const std::string& file = arguments.files.front();
  auto document = loadEngaged(kDynamics, arguments);
  if (const int* status = std::get_if<int>(&document)) return *status;
  auto driven = withInputOptions(std::get<Mechanism>(std::move(document)), arguments);
  if (const auto* error = std::get_if<UsageError>(&driven)) return wrongUsage(kDynamics, error->message);
  auto mechanism = withMassOptions(std::get<Mechanism>(std::move(driven)), arguments);
  if (const auto* error = std::get_if<UsageError>(&mechanism)) return wrongUsage(kDynamics, error->message);
  DynamicsResult result;
  auto analyzed = analyzeAndReport(std::get<Mechanism>(std::move(mechanism)), arguments);
  if (const int* status = std::get_if<int>(&analyzed)) return *status;
  result.snapshot = std::get<SnapshotPtr>(std::move(analyzed));
  const AnalysisSnapshot& snapshot = *result.snapshot;
  const MatroidAnalysis* const matroid = snapshot.matroid();
  if (hasErrors(snapshot.diagnostics) || matroid == nullptr || !matroid->solution) {
    return arguments.has("--json") ? print(asJson(nullptr, snapshot.diagnostics), kMechanismErrors)
                                   : kMechanismErrors;
  }
  const bool isTooLarge =
      matroid->solution->inputs.size() * matroid->solution->outputs.size() > LiveSolution::kMaxLiveEntries;
  if (isTooLarge) {
    std::cerr << "geargraph-cli: "
              << translated(
                     "Dynamics is computed for up to %1 entries of the solution (inputs times other joints).",
                     {std::to_string(LiveSolution::kMaxLiveEntries)})
              << '\n';
    return kResourceLimit;
  }
  const auto train = snapshot.geometry->train(arguments.stop);
  if (!train) return outOfTime(arguments, translated("the gear train"));
  auto dynamics = dynamicsOf(*snapshot.mechanism, *snapshot.kinematics->model,
                             snapshot.kinematics->placement(), *matroid, *train, arguments.stop);
  if (!dynamics) return outOfTime(arguments, translated("the masses"));
  if (!*dynamics) {
    std::cerr << diagnosticLines(file, dynamics->error());
    return arguments.has("--json") ? print(asJson(nullptr, dynamics->error()), kMechanismErrors)
                                   : kMechanismErrors;
  }
  result.dynamics = **std::move(dynamics);
  if (const auto error = readStart(result, arguments)) return wrongUsage(kDynamics, error->message);
  solve(result, arguments);
  if (arguments.stop.stop_requested()) return outOfTime(arguments, translated("the motion"));
  if (const auto path = arguments.value("-o")) {
    if (result.simulation->samples.empty()) {
      std::cerr << "geargraph-cli: "
                << translated("A motion of the inputs moves no mass: there is no motion to write.") << '\n';
      return kMechanismErrors;
    }
    const int status = writeCsv(*path, result);
    if (status != kFine || *path == "-") return status;
  }
  return print(arguments.has("--json") ? asJson(&result, snapshot.diagnostics) : dynamicsText(result));
}

constexpr std::array kDynamicsOptions = {
    Option{"--torque", "8=1.5Nm",
           toTranslate("the torque of an input's motor (without it 0); may be given again")},
    Option{"--damping", "8=0.01", toTranslate("less this for each rad/s, N m s; may be given again")},
    Option{"--angle", "8=30deg", toTranslate("the angle of an input at the start; may be given again")},
    Option{"--start-speed", "8=1",
           toTranslate("its speed at the start, rad/s or with a unit (without it 0); may be given again")},
    Option{"--seconds", "10", toTranslate("follow the motion for so long")},
    Option{"--interval", "0.01",
           toTranslate("seconds between samples (without it a hundredth of the motion)")},
    Option{"-o", "OUT.csv", toTranslate("write the samples of the motion as CSV")},
    kGravityOption,
    kDensityOption,
    Option{"--inputs", "8,9,11", toTranslate("drive these joints (by label) instead of the document's")},
    kStateOption,
    kEngageOption,
    Option{"--json", "", toTranslate("as JSON")},
};

}  // namespace

const Command kDynamics = {
    "dynamics",
    "FILE [--torque 8=1.5Nm ...] [--gravity 0,0,-9.81] [--seconds 10 [-o OUT.csv]] "
    "[--state NAME | --engage A,B] [--json]",
    toTranslate("Masses, the inertia that motors feel, and the motion that torques cause."), kDynamicsOptions,
    runDynamics};

}  // namespace geargraph::cli
