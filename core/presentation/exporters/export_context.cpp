#include "core/presentation/exporters/export_context.h"

#include <memory>
#include <utility>

#include "core/foundations/files/file.h"
#include "core/presentation/exporters/engagement_options.h"
#include "core/presentation/mechanism_scene/mechanism_scene.h"

namespace geargraph {

std::variant<MechanismPtr, ExportError> ExportContext::document() {
  if (m_document) return m_document;
  auto read = m_source.read();
  if (auto* error = std::get_if<ExportError>(&read)) return std::move(*error);
  m_document = std::make_shared<const Mechanism>(std::get<Mechanism>(std::move(read)));
  return m_document;
}

std::variant<Mechanism, ExportError> ExportContext::engaged(const OptionValues& given) {
  const auto read = document();
  if (const auto* error = std::get_if<ExportError>(&read)) return *error;
  auto made = withEngagementOptions(*std::get<MechanismPtr>(read), given);
  if (auto* error = std::get_if<UsageError>(&made))
    return ExportError{ExportError::Kind::usage, std::move(error->message)};
  return std::get<Mechanism>(std::move(made));
}

std::variant<SnapshotPtr, ExportError> ExportContext::analysed(Mechanism mechanism, bool isComplete,
                                                               const std::stop_token& stop) {
  const SnapshotPtr& there = m_source.snapshot;
  const bool isThere = there && *there->mechanism == mechanism;
  SnapshotPtr snapshot;
  if (isComplete && isThere) {
    snapshot = there;
  } else if (isComplete) {
    snapshot = analyze(std::make_shared<const Mechanism>(std::move(mechanism)), 0, stop);
  } else if (isThere) {
    snapshot = analyzeLive(there->geometry, 0, stop);
  } else {
    snapshot = analyzeLive(std::make_shared<const Mechanism>(std::move(mechanism)), 0, stop);
  }
  if (!snapshot) return outOfTime(translated("the analysis"));
  tell(snapshot->diagnostics);
  return snapshot;
}

std::variant<SnapshotPtr, ExportError> ExportContext::live(Mechanism mechanism, const std::stop_token& stop) {
  return analysed(std::move(mechanism), false, stop);
}

std::variant<SnapshotPtr, ExportError> ExportContext::complete(Mechanism mechanism,
                                                               const std::stop_token& stop) {
  return analysed(std::move(mechanism), true, stop);
}

std::variant<SnapshotPtr, ExportError> ExportContext::live(const OptionValues& given,
                                                           const std::stop_token& stop) {
  auto made = engaged(given);
  if (auto* error = std::get_if<ExportError>(&made)) return std::move(*error);
  return live(std::get<Mechanism>(std::move(made)), stop);
}

std::variant<ExportTrain, ExportError> ExportContext::train(Mechanism mechanism, bool isPart,
                                                            const std::stop_token& stop) {
  const int links = mechanism.n();
  if (links > kMaxStageLinks && !isPart) {
    return ExportError{
        ExportError::Kind::limit,
        translated("A train of %1 links has no 3D, which is made of up to %2 links; --gear and "
                   "--link export a part of it. Nothing was written.",
                   {std::to_string(links), std::to_string(kMaxStageLinks)}),
        kTooLargeRefusal.code};
  }
  const auto analyzed = live(std::move(mechanism), stop);
  if (const auto* error = std::get_if<ExportError>(&analyzed)) return *error;
  auto made = exportTrain(std::get<SnapshotPtr>(analyzed), stop);
  if (const auto* why = std::get_if<ExportFailure>(&made)) return errorOf(*why);
  auto& train = std::get<ExportTrain>(made);
  tell(train.diagnostics);
  if (train.train.hasSimpleBodies) {
    tell(
        translated("A train of %1 gears (over %2): wheels are plain discs, shafts and arms are straight and "
                   "pass through other parts.",
                   {std::to_string(train.train.gears.size()), std::to_string(kMaxRoutedGears)}));
  }
  return std::move(train);
}

void ExportContext::tell(const Diagnostics& diagnostics) const {
  if (m_source.diagnose) m_source.diagnose(diagnostics);
}

void ExportContext::tell(std::string text, ExportNote::About about) const {
  if (m_source.note) m_source.note({about, std::move(text)});
}

ExportError ExportContext::errorOf(const ExportFailure& why) const {
  using Kind = ExportFailure::Kind;
  if (why.kind == Kind::stopped) return outOfTime(why.message);
  if (why.kind == Kind::choice) return {ExportError::Kind::usage, why.message + "."};
  tell(why.diagnostics);
  if (why.kind == Kind::mechanism && why.message.empty())
    return {ExportError::Kind::mechanism, {}, kGearsRefusal.code};
  if (why.kind == Kind::mechanism) {
    return {ExportError::Kind::mechanism, translated("%1; nothing was written.", {why.message}),
            kErrorsRefusal.code};
  }
  return {ExportError::Kind::limit,
          why.kind == Kind::triangles ? translated("%1; choose a coarser --tolerance.", {why.message})
                                      : why.message + ".",
          kTooLargeRefusal.code};
}

std::optional<ExportError> writeExport(std::string_view bytes, const std::filesystem::path& path) {
  if (path == "-") {
    StandardOutput out;
    out.write(bytes);
    return out.failed() ? std::optional(streamFailure()) : std::nullopt;
  }
  const auto error = writeFile(path, bytes);
  return error ? std::optional(ExportError{ExportError::Kind::file, error->message}) : std::nullopt;
}

ExportError outOfTime(std::string what) {
  return {ExportError::Kind::stopped, std::move(what)};
}

ExportError streamFailure() {
  return {ExportError::Kind::file, translated("Standard output could not be written.")};
}

ExportError meshErrorOf(const MeshFileError& why) {
  using Kind = MeshFileError::Kind;
  if (why.kind == Kind::stopped) return outOfTime(translated("the file"));
  if (why.kind == Kind::limit) return {ExportError::Kind::limit, why.message, kTooLargeRefusal.code};
  return {ExportError::Kind::file, why.message};
}

}  // namespace geargraph
