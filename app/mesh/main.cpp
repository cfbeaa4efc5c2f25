// `geargraph-mesh FORMAT BYTES TRIANGLES MEMORY SECONDS`: reads a 3D file from standard input and writes its
// triangles to standard output. It enters the sandbox before the first byte, so that a hostile file can read,
// write, start and reach nothing. Exit status: 0 fine, 2 not readable, 3 beyond a limit.

#include <array>
#include <charconv>
#include <cstdlib>
#include <iostream>
#include <new>
#include <string>

#include "core/foundations/base/translation.h"
#include "core/foundations/files/byte_sink.h"
#include "core/foundations/files/file.h"
#include "core/foundations/sandbox/sandbox.h"
#include "core/presentation/meshfile/foreign_mesh.h"

namespace geargraph {
namespace {

enum ExitStatus { kFine = 0, kUnreadable = 2, kLimit = 3 };

std::optional<std::size_t> number(const char* text) {
  std::size_t value = 0;
  const std::string_view word(text);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

int read(const char* format, std::size_t mostBytes, std::size_t mostTriangles) {
  const auto known = meshFormatFromName(format);
  if (!known) return kUnreadable;
  const auto input = readFile("-", mostBytes);
  if (std::holds_alternative<FileError>(input)) {
    std::cerr << readerReport(toTranslate("It could not be read."), {});
    return kUnreadable;
  }
  const auto& bytes = std::get<std::string>(input);
  if (bytes.size() > mostBytes) {
    std::cerr << readerReport(toTranslate("It has more than %1 bytes."), {std::to_string(mostBytes)});
    return kLimit;
  }
  const auto read = readForeignBytes(bytes, *known, mostTriangles);
  if (const auto* error = std::get_if<MeshFileError>(&read)) {
    std::cerr << error->message;
    return error->kind == MeshFileError::Kind::limit ? kLimit : kUnreadable;
  }
  StandardOutput out;
  out.write(packedSolid(std::get<Solid>(read)));
  return out.failed() ? kUnreadable : kFine;
}

int run(int count, char** words) {
  constexpr int kWords = 6;
  if (count != kWords) return kUnreadable;
  std::array<std::size_t, 4> numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto value = number(words[i + 2]);
    if (!value) return kUnreadable;
    numbers[i] = *value;
  }
  if (const auto why = enterSandbox({numbers[2], static_cast<long>(numbers[3])})) {
    std::cerr << readerReport(toTranslate("This system cannot confine the program that reads 3D files (%1)."),
                              {*why});
    return kUnreadable;
  }
  try {
    return read(words[1], numbers[0], numbers[1]);
  } catch (const std::bad_alloc&) {
    std::cerr << readerReport(toTranslate("Reading it takes more than %1 MiB of memory."),
                              {std::to_string(numbers[2] / (1U << 20U))});
    return kLimit;
  } catch (const std::exception& error) {
    std::cerr << readerReport(toTranslate("It is damaged: %1"), {error.what()});
    return kUnreadable;
  }
}

}  // namespace
}  // namespace geargraph

// Ends without destructors: the system takes everything back at once, and what looks for leaks needs a
// thread.
int main(int count, char** words) {
  std::_Exit(geargraph::run(count, words));
}
