// The coupling of motors and joints, for a robot's controller.

#include <algorithm>
#include <array>

#include "core/foundations/base/text_lists.h"
#include "core/presentation/exporters/element_words.h"
#include "core/presentation/exporters/export_context.h"
#include "core/presentation/exporters/export_families.h"
#include "core/presentation/simulators/controller_coupling.h"

namespace geargraph {
namespace {

constexpr ExportRefusal kNoCoupling{
    "no-coupling", toTranslate("The speeds of these joints do not determine those of the motors.")};

ExportError noCoupling(std::string message) {
  return {ExportError::Kind::mechanism, std::move(message), kNoCoupling.code};
}

template <std::string (*text)(const Mechanism&, const JointCoupling&)>
ExportResult writeCoupling(ExportContext& context, const OptionValues& given, const ExportTarget& target,
                           const std::stop_token& stop) {
  auto engaged = context.engaged(given);
  if (auto* error = std::get_if<ExportError>(&engaged)) return *std::move(error);
  const auto analyzed = context.complete(std::get<Mechanism>(std::move(engaged)), stop);
  if (const auto* error = std::get_if<ExportError>(&analyzed)) return *error;
  const auto& snapshot = std::get<SnapshotPtr>(analyzed);
  if (hasErrors(snapshot->diagnostics))
    return ExportError{ExportError::Kind::mechanism, {}, kErrorsRefusal.code};
  if (!snapshot->solved || !snapshot->solved->exact || snapshot->solved->exact->inputs.empty()) {
    return ExportError{ExportError::Kind::mechanism, translated(kNoSolutionRefusal.meaning),
                       kNoSolutionRefusal.code};
  }
  const ExactSolution& exact = *snapshot->solved->exact;
  if (exact.matrix.empty() && !exact.outputs.empty()) {
    return ExportError{ExportError::Kind::limit, translated(kTooLargeRefusal.meaning), kTooLargeRefusal.code};
  }
  const Mechanism& mechanism = *snapshot->mechanism;
  std::vector<JointOrdinal> joints;
  if (const auto named = given.value("--outputs")) {
    auto read = jointsNamed(mechanism, "--outputs", *named);
    if (auto* error = std::get_if<UsageError>(&read))
      return ExportError{ExportError::Kind::usage, std::move(error->message)};
    joints = std::get<std::vector<JointOrdinal>>(std::move(read));
    if (joints.size() != exact.inputs.size()) {
      return noCoupling(translated("There are %1 motors: name as many joints, not %2.",
                                   {std::to_string(exact.inputs.size()), std::to_string(joints.size())}));
    }
  } else {
    joints = usualJoints(exact, *snapshot->tree, mechanism).value();
    std::vector<std::string> labels;
    for (const JointOrdinal joint : joints) labels.push_back(std::to_string(mechanism.jointLabel(joint)));
    context.tell(translated("The joints are %1: --outputs names others.", {listed(labels, labels.size())}));
  }
  const auto coupling = jointCoupling(exact, std::move(joints));
  if (!coupling) return noCoupling(translated(kNoCoupling.meaning));
  if (auto error = writeExport(text(mechanism, *coupling), target.path)) return *std::move(error);
  return ExportOutcome{};
}

constexpr std::array kOutputs = {textOption("--outputs")};
constexpr std::array kCouplingOptions = {
    textOption("--outputs"), choiceOption(
                                 "--as",
                                 [] {
                                   return std::vector<std::string>{"json", "header", "python", "ros2"};
                                 },
                                 "json")};
constexpr std::array kHeader = {std::pair<std::string_view, std::string_view>{"--as", "header"}};
constexpr std::array kPython = {std::pair<std::string_view, std::string_view>{"--as", "python"}};
constexpr std::array kRos2 = {std::pair<std::string_view, std::string_view>{"--as", "ros2"}};
constexpr std::array kCouplingRefusals = {&kErrorsRefusal, &kNoSolutionRefusal, &kTooLargeRefusal,
                                          &kNoCoupling};
constexpr std::string_view kCoupling = toTranslate("the coupling of motors and joints");

constexpr std::array kControllerExporters = {
    Exporter{"coupling",
             "coupling",
             toTranslate("Coupling of motors and joints (JSON)"),
             kCoupling,
             ExportFiles::file,
             "json",
             kCouplingOptions,
             {},
             ExportNeed::solution,
             kCouplingRefusals,
             writeCoupling<couplingJson>},
    Exporter{"coupling-header", "coupling", toTranslate("Coupling of motors and joints (C++)"), kCoupling,
             ExportFiles::file, "h", kOutputs, kHeader, ExportNeed::solution, kCouplingRefusals,
             writeCoupling<couplingHeader>},
    Exporter{"coupling-python", "coupling", toTranslate("Coupling of motors and joints (Python)"), kCoupling,
             ExportFiles::file, "py", kOutputs, kPython, ExportNeed::solution, kCouplingRefusals,
             writeCoupling<couplingPython>},
    Exporter{"coupling-ros2", "coupling", toTranslate("Transmissions of ros2_control (XML)"), kCoupling,
             ExportFiles::file, "xml", kOutputs, kRos2, ExportNeed::solution, kCouplingRefusals,
             writeCoupling<couplingTransmissions>},
};

}  // namespace

ExportFamily controllerFamily() {
  return {toTranslate("Controllers"), {}, {}, false, kControllerExporters, ExportPurpose::simulator};
}

}  // namespace geargraph
