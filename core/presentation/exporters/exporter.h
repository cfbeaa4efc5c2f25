#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/foundations/base/translation.h"
#include "core/presentation/exporters/option_values.h"

namespace geargraph {

class ExportContext;

/// What an option takes.
enum class OptionType { flag, number, choice, text };

/// An option as one exporter takes it. What it means is in the table of exportOptionTexts().
struct ExportOption {
  std::string_view name;  ///< "--tolerance"
  OptionType type = OptionType::flag;
  std::string_view otherwise = {};  ///< the value that holds without it; empty: its text tells what does
  bool isNeeded = false;            ///< without it nothing is written
  double least = 0;                 ///< bounds of a number, included
  double most = 0;
  std::string_view unit = {};  ///< of a number: "s", "modules"; empty: none. To be translated
  bool isWhole = false;        ///< a whole number
  std::vector<std::string> (*choices)() = nullptr;
};

/// What a document has to have, so that there is something to write.
enum class ExportNeed : std::uint8_t {
  nothing,
  kinematics,  ///< no errors, and a spanning tree with the geometry of every mesh
  tree,        ///< a spanning tree
  solution,    ///< no errors, and a solution
};

/// A reason for which an exporter may write nothing. The code is as stable as those of diagnostics.
struct ExportRefusal {
  std::string_view code;
  std::string_view meaning;  ///< to be translated
};

/// Why nothing was written.
struct ExportError {
  enum class Kind {
    usage,      ///< of the options
    stopped,    ///< a stop was requested; `message` names what was not finished ("the analysis")
    file,       ///< a file could not be read or written
    mechanism,  ///< the document does not have what is needed
    limit,      ///< a limit was exceeded, or graphics are missing
  };
  Kind kind = Kind::usage;
  std::string message;         ///< a sentence; empty if diagnostics that were told say it
  std::string_view code = {};  ///< of `mechanism` and `limit`: of a refusal that the exporter lists
};

/// What was written.
struct ExportOutcome {
  bool isFlawed = false;  ///< the mechanism has errors, or a part that cannot be made was left out
};

using ExportResult = std::variant<ExportOutcome, ExportError>;

/// Where an exporter writes.
struct ExportTarget {
  std::filesystem::path path;                 ///< "-": standard output, for an exporter that writes a stream
  bool mayOverwrite = false;                  ///< files in a folder
  std::function<void(double)> progress = {};  ///< the fraction done, on the caller's thread; may be empty
};

/// What an exporter makes.
enum class ExportFiles {
  file,    ///< one file, which may be a stream
  files,   ///< one file that brings another of its name, which a stream lacks
  folder,  ///< a folder
};

/// A format: what the command line, its help and completion, Python, `serve`, the window and the laws of
/// fuzzing know about it. To add one, add an entry to its family.
struct Exporter {
  std::string_view id;     ///< unique, as stable as a code: "dot"
  std::string_view form;   ///< the word after `--to`
  std::string_view title;  ///< of the format, in a list: "Graphviz (DOT)". To be translated
  std::string_view what;   ///< what the file holds, in a sentence: "a graph". To be translated
  ExportFiles files = ExportFiles::file;
  std::string_view suffix = {};  ///< of the file, without its dot; empty for a folder
  std::span<const ExportOption> options = {};
  /// Options that choose this exporter among those of its form; an empty value: a flag, or any value.
  std::span<const std::pair<std::string_view, std::string_view>> implied = {};
  ExportNeed need = ExportNeed::nothing;
  std::span<const ExportRefusal* const> refusals = {};
  /// Writes whole or not at all, and tells the context what a user should know. @pre `given` holds the
  /// implied options
  ExportResult (*write)(ExportContext& context, const OptionValues& given, const ExportTarget& target,
                        const std::stop_token& stop) = nullptr;
  /// Why this system cannot write it, as a sentence; empty: it can. Null: every system can.
  std::string (*missing)() = nullptr;
  /// Does it know sliding joints? Else nothing is written of a document that has some (writeExport()).
  bool knowsSlides = false;
};

/// What people export for.
enum class ExportPurpose : std::uint8_t { print, cad, simulator, web, data };
inline constexpr std::array kExportPurposes = {ExportPurpose::print, ExportPurpose::cad,
                                               ExportPurpose::simulator, ExportPurpose::web,
                                               ExportPurpose::data};

/// Exporters of one kind of thing. An option is rejected where no exporter of the family takes it.
struct ExportFamily {
  std::string_view title;  ///< in a list: "Graphs". To be translated
  std::string_view name;   ///< in a sentence: "graphs", to be translated; empty: the words that ask for it
  std::string_view how;    ///< the words that ask for it; empty: "--to " and the forms
  bool hasView = false;    ///< `--view` says what is written
  std::span<const Exporter> exporters;
  ExportPurpose purpose = ExportPurpose::cad;
  /// The id of the exporter whose file, a picture or a text, shows a person what these write; empty: none, or
  /// their own files do.
  std::string_view shownBy = {};
  /// Options with which a preview is quick, though it is only a part of what would be written.
  std::span<const std::pair<std::string_view, std::string_view>> forPreview = {};
};

// The refusals of several exporters.
inline constexpr ExportRefusal kErrorsRefusal{"errors", toTranslate("The mechanism has errors.")};
inline constexpr ExportRefusal kNoSolutionRefusal{
    "no-solution", toTranslate("There is no solution, because nothing can move or inputs are missing.")};
inline constexpr ExportRefusal kTooLargeRefusal{
    "too-large", toTranslate("The mechanism, or what would be written, is too large.")};
inline constexpr ExportRefusal kGearsRefusal{"gears", toTranslate("Gears cannot be made.")};
inline constexpr ExportRefusal kSlidesRefusal{
    "slides", toTranslate("This format does not cover sliding joints, racks and screws.")};
inline constexpr ExportRefusal kGraphicsRefusal{
    "graphics", toTranslate("Nothing can paint pictures here, or a picture is too large to be painted.")};

// How entries write their options.

constexpr ExportOption flagOption(std::string_view name) {
  return {name};
}

constexpr ExportOption textOption(std::string_view name, std::string_view otherwise = {}) {
  return {name, OptionType::text, otherwise};
}

constexpr ExportOption numberOption(std::string_view name, double least, double most,
                                    std::string_view otherwise = {}, std::string_view unit = {},
                                    bool isWhole = false) {
  return {name, OptionType::number, otherwise, false, least, most, unit, isWhole};
}

constexpr ExportOption choiceOption(std::string_view name, std::vector<std::string> (*choices)(),
                                    std::string_view otherwise = {}, bool isNeeded = false) {
  return {name, OptionType::choice, otherwise, isNeeded, 0, 0, {}, false, choices};
}

}  // namespace geargraph
