#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <variant>

#include "core/foundations/files/byte_sink.h"
#include "core/presentation/export_api/train_export.h"
#include "core/presentation/exporters/exporter.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph {

/// What an export has to say besides its result.
struct ExportNote {
  enum class About {
    file,      ///< the document
    program,   ///< what was done with it
    nextTime,  ///< how to get the same again
  };
  About about = About::program;
  std::string text;
};

/// Where a context takes the document from, and who listens.
struct ExportSource {
  /// Reads the document, when first asked. An error without a message has been told already.
  std::function<std::variant<Mechanism, ExportError>()> read;
  SnapshotPtr snapshot = {};           ///< a complete analysis of the document, if there is one already
  std::filesystem::path folder = ".";  ///< of the document, for attached 3D files
  std::string stem = "mechanism";      ///< name of the main file of a folder
  bool isFile = true;                  ///< the document is a file, which can be read again
  std::function<void(const Diagnostics&)> diagnose = {};  ///< called as soon as they are known
  std::function<void(const ExportNote&)> note = {};
};

/// What exporters read: the document with the options that change it, its analysis, its gears. Everything is
/// computed when it is asked for, and what was found out about the document is told then. For one export.
class ExportContext {
 public:
  explicit ExportContext(ExportSource source) : m_source(std::move(source)) {}

  /// As it is in its file; read once.
  [[nodiscard]] std::variant<MechanismPtr, ExportError> document();
  /// With the couplings engaged that `--state` or `--engage` name.
  [[nodiscard]] std::variant<Mechanism, ExportError> engaged(const OptionValues& given);

  /// The live analysis of a mechanism, and the complete one; its diagnostics are told.
  [[nodiscard]] std::variant<SnapshotPtr, ExportError> live(Mechanism mechanism, const std::stop_token& stop);
  [[nodiscard]] std::variant<SnapshotPtr, ExportError> complete(Mechanism mechanism,
                                                                const std::stop_token& stop);
  /// The live analysis of the document as engaged.
  [[nodiscard]] std::variant<SnapshotPtr, ExportError> live(const OptionValues& given,
                                                            const std::stop_token& stop);
  /// The gears of a mechanism without errors; `isPart`: only a part of them is written, so that more links
  /// than the 3D view has are fine.
  [[nodiscard]] std::variant<ExportTrain, ExportError> train(Mechanism mechanism, bool isPart,
                                                             const std::stop_token& stop);

  [[nodiscard]] const std::filesystem::path& folder() const { return m_source.folder; }
  [[nodiscard]] const std::string& stem() const { return m_source.stem; }
  [[nodiscard]] bool isFile() const { return m_source.isFile; }

  void tell(const Diagnostics& diagnostics) const;
  void tell(std::string text, ExportNote::About about = ExportNote::About::program) const;
  /// Tells the diagnostics of a failure. `kind` choice is wrong usage.
  [[nodiscard]] ExportError errorOf(const ExportFailure& why) const;

 private:
  [[nodiscard]] std::variant<SnapshotPtr, ExportError> analysed(Mechanism mechanism, bool isComplete,
                                                                const std::stop_token& stop);

  ExportSource m_source;
  MechanismPtr m_document;
};

/// Writes a file atomically, or to standard output for "-"; std::nullopt on success.
[[nodiscard]] std::optional<ExportError> writeExport(std::string_view bytes,
                                                     const std::filesystem::path& path);
[[nodiscard]] ExportError outOfTime(std::string what);
/// "Standard output could not be written."
[[nodiscard]] ExportError streamFailure();
[[nodiscard]] ExportError meshErrorOf(const MeshFileError& why);

}  // namespace geargraph
