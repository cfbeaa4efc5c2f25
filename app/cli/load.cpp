#include "app/cli/load.h"

#include <algorithm>
#include <filesystem>
#include <iostream>

#include "app/cli/command.h"
#include "app/cli/diagnostics_output.h"
#include "core/foundations/base/translation.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "core/mechanism/document_format/mechanism_graph.h"

namespace geargraph::cli {

namespace {

/// A table or a graph that `convert` reads; by its name also where it has faults.
bool isConvertible(const std::string& path, std::string_view bytes, const Diagnostics& faults) {
  const Code code = faults.front().code;
  if (code != Code::syntax && code != Code::format) return false;
  const std::string extension = std::filesystem::path(path).extension().string();
  const auto names = {".csv", ".tsv", ".dot", ".gv", ".graphml"};
  return std::find(names.begin(), names.end(), extension) != names.end() ||
         readAnyMechanism(bytes).has_value();
}

/// The mechanism, or the exit status after the reason was reported.
std::variant<Mechanism, int> saying(const std::string& path,
                                    std::variant<Expected<Mechanism>, FileError> loaded) {
  if (const auto* error = std::get_if<FileError>(&loaded)) return fileFailure(error->message);
  auto& document = std::get<Expected<Mechanism>>(loaded);
  if (document) return std::move(document).value();
  std::cerr << diagnosticLines(path, document.error());
  return static_cast<int>(kMechanismErrors);
}

}  // namespace

std::variant<Expected<Mechanism>, FileError> load(const std::string& path) {
  const auto bytes = readFile(path, kLargestFile);
  if (const auto* error = std::get_if<FileError>(&bytes)) return *error;
  auto document = readMechanism(std::get<std::string>(bytes));
  if (!document && isConvertible(path, std::get<std::string>(bytes), document.error())) {
    const std::string converted = std::filesystem::path(path).replace_extension(".geargraph").string();
    return FileError{
        translated("\"%1\" is a table or a graph, not a document. Convert it first: geargraph-cli convert %1 "
                   "--to geargraph "
                   "-o %2",
                   {path, path == "-" ? "converted.geargraph" : converted})};
  }
  return document;
}

std::variant<Expected<Mechanism>, FileError> load(const std::string& path, const Command& command) {
  auto loaded = load(path);
  const auto* document = std::get_if<Expected<Mechanism>>(&loaded);
  if (document == nullptr || !*document || command.knowsSlides || !hasSlides(**document)) return loaded;
  return FileError{
      translated("The command %1 does not cover sliding joints, and \"%2\" has some.", {command.name, path})};
}

std::variant<Mechanism, int> loadOrSay(const std::string& path) {
  return saying(path, load(path));
}

std::variant<Mechanism, int> loadOrSay(const std::string& path, const Command& command) {
  return saying(path, load(path, command));
}

}  // namespace geargraph::cli
