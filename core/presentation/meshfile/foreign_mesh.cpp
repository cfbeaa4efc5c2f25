#include "core/presentation/meshfile/foreign_mesh.h"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cstdlib>
#include <vector>

#include "core/foundations/base/translation.h"
#include "core/foundations/files/utf8.h"
#include "core/foundations/platform/child_process.h"
#include "core/foundations/platform/system.h"

namespace geargraph {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kMaxReport = 4096;         // bytes that the reader writes about what went wrong
constexpr std::size_t kMaxSentenceLength = 300;  // characters of it that are shown

MeshFileError rejected(const std::string& why, MeshFileError::Kind kind = MeshFileError::Kind::file) {
  return {kind, why};
}

MeshFileError tooSlow(const ForeignLimits& limits) {
  return rejected(
      translated("Reading it took longer than %1 s.", {std::to_string(static_cast<int>(limits.mostSeconds))}),
      MeshFileError::Kind::limit);
}

/// What the reader wrote, as one line that is safe to show: the file decides what is in it.
std::string sentenceOf(std::string_view report) {
  std::string sentence;
  std::size_t characters = 0;
  for (std::size_t i = 0; i < report.size() && characters < kMaxSentenceLength; ++characters) {
    const std::size_t length = utf8Length(report, i);
    const auto first = static_cast<unsigned char>(report[i]);
    const bool isShown = length > 1 ? first != 0xC2 || static_cast<unsigned char>(report[i + 1]) >= 0xA0
                                    : length == 1 && first >= 0x20 && first != 0x7F;
    if (isShown) {
      sentence.append(report, i, length);
    } else if (!sentence.empty() && sentence.back() != ' ') {
      sentence += ' ';
    }
    i += std::max<std::size_t>(length, 1);
  }
  if (characters == kMaxSentenceLength) sentence += "...";
  return sentence;
}

/// A readerReport() in the current language. Its text may be any other: a hostile file can have written it.
std::string translatedReport(std::string_view report) {
  std::vector<std::string> parts;
  for (std::size_t from = 0; from <= report.size() && parts.size() < 3;) {
    const std::size_t to = std::min(report.find(kReportSeparator, from), report.size());
    parts.push_back(sentenceOf(report.substr(from, to - from)));
    from = to + 1;
  }
  const std::string text = translated(std::string_view(parts.front()));
  if (parts.size() == 1) return text;
  if (parts.size() == 2) return filled(text, {parts[1]});
  return filled(text, {parts[1], parts[2]});
}

/// Why the reader gave no solid.
MeshFileError failureOf(const ChildResult& result, const ForeignLimits& limits) {
  constexpr int kBeyondLimit = 3;  // geargraph-mesh's exit status
  const std::string sentence = translatedReport(result.errors);
  switch (result.end) {
    case ChildEnd::exited:
      break;
    case ChildEnd::crashed:
      return rejected(
          confinesChildren()
              ? translated(
                    "It is damaged, or made to do harm: the program that reads it crashed, and was confined.")
              : translated(
                    "It is damaged, or made to do harm: the program that reads it crashed. This system "
                    "does not confine it."));
    case ChildEnd::outOfTime:
      return tooSlow(limits);
    case ChildEnd::stopped:
      return rejected(translated("Reading it was stopped."), MeshFileError::Kind::stopped);
    case ChildEnd::notStarted:
      return rejected(translated("The program geargraph-mesh cannot be run."));
    case ChildEnd::tooManyFiles:
      return rejected(translated("There are too many open files."));
    case ChildEnd::inputMissing:
      return rejected(translated("It is not there."));
    case ChildEnd::inputUnreadable:
      return rejected(translated("It cannot be opened."));
    case ChildEnd::inputNoFile:
      return rejected(translated("It is no file."));
    case ChildEnd::inputTooLarge:
      return rejected(translated("It has %1 bytes, more than the limit of %2.",
                                 {std::to_string(result.inputSize), std::to_string(limits.mostBytes)}),
                      MeshFileError::Kind::limit);
  }
  if (result.status != 0 && !sentence.empty()) {
    return rejected(sentence,
                    result.status == kBeyondLimit ? MeshFileError::Kind::limit : MeshFileError::Kind::file);
  }
  return rejected(
      translated("It is damaged, or made to do harm: what the program that reads it answers is no solid."));
}

}  // namespace

std::optional<MeshFormat> foreignFormat(const fs::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const MeshFormat format : {MeshFormat::stl, MeshFormat::obj, MeshFormat::ply, MeshFormat::glb}) {
    if (ending == "." + std::string(meshFormatName(format))) return format;
  }
  return std::nullopt;
}

std::variant<Solid, MeshFileError> readForeignMesh(const fs::path& reader, const fs::path& path,
                                                   const ForeignLimits& limits, const std::stop_token& stop) {
  const auto format = foreignFormat(path);
  if (!format) return rejected(translated("It is none of STL, OBJ, PLY and GLB."));
  if (reader.empty())
    return rejected(translated("The program geargraph-mesh, which reads 3D files, is missing."));
  ChildProgram child;
  child.program = reader;
  child.words = {std::string(meshFormatName(*format)), std::to_string(limits.mostBytes),
                 std::to_string(limits.mostTriangles), std::to_string(limits.mostMemory),
                 std::to_string(static_cast<long>(limits.mostSeconds) + 1)};
  child.input = path;
  child.mostInput = limits.mostBytes;
  // A triangle has at most three vertices of its own.
  child.mostOutput = 64 + limits.mostTriangles * (6 * sizeof(Float3) + sizeof(Triangle));
  child.mostErrors = kMaxReport;
  child.deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                      std::chrono::duration<double>(limits.mostSeconds));
  const ChildResult result = runChild(child, stop);
  if (result.end == ChildEnd::exited && result.status == 0) {
    if (auto solid = unpackedSolid(result.output, limits.mostTriangles)) return *std::move(solid);
  }
  return failureOf(result, limits);
}

fs::path foreignMeshReader() {
  if (const char* named = std::getenv("GEARGRAPH_MESH_READER"))
    return named;  // NOLINT: nobody sets it meanwhile
  std::error_code error;
  const fs::path here = programPath().parent_path();
  for (const char* place :
       {"geargraph-mesh", "../mesh/geargraph-mesh", "../libexec/geargraph/geargraph-mesh"}) {
    const fs::path program = (here / place).lexically_normal();
    if (!here.empty() && fs::is_regular_file(program, error)) return program;
  }
  return {};
}

}  // namespace geargraph
