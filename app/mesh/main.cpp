// `geargraph-mesh FORMAT BYTES TRIANGLES MEMORY SECONDS`: reads a 3D file from standard input with limits set
// on itself before the first byte, and writes its triangles to standard output. A process of its own, so that
// a hostile file can break nothing but it. Exit status: 0 fine, 2 not readable, 3 beyond a limit.

#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <charconv>
#include <iostream>
#include <new>
#include <string>

#include "core/io/byte_sink.h"
#include "core/io/file.h"
#include "core/meshfile/foreign_mesh.h"

namespace geargraph {
namespace {

enum ExitStatus { kFine = 0, kUnreadable = 2, kLimit = 3 };

std::optional<rlim_t> number(const char* text) {
  rlim_t value = 0;
  const std::string_view word(text);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

bool limit(int resource, rlim_t most) {
  const rlimit both{most, most};
  return setrlimit(static_cast<__rlimit_resource>(resource), &both) == 0;
}

/// All of standard input, or nothing where it has more bytes.
std::optional<std::string> input(std::size_t most) {
  std::string bytes;
  std::array<char, 1 << 16> piece{};
  for (;;) {
    const ssize_t count = ::read(STDIN_FILENO, piece.data(), piece.size());
    if (count <= 0) return bytes;
    bytes.append(piece.data(), static_cast<std::size_t>(count));
    if (bytes.size() > most) return std::nullopt;
  }
}

int run(const char* format, rlim_t mostBytes, rlim_t mostTriangles) {
  const auto known = meshFormatFromName(format);
  if (!known) return kUnreadable;
  const auto bytes = input(mostBytes);
  if (!bytes) {
    std::cerr << "It has more than " << mostBytes << " bytes.";
    return kLimit;
  }
  const auto read = readForeignBytes(*bytes, *known, mostTriangles);
  if (const auto* error = std::get_if<MeshFileError>(&read)) {
    std::cerr << error->message;
    return error->kind == MeshFileError::Kind::limit ? kLimit : kUnreadable;
  }
  DescriptorSink out(STDOUT_FILENO);
  out.write(packedSolid(std::get<Solid>(read)));
  return out.failed() ? kUnreadable : kFine;
}

}  // namespace
}  // namespace geargraph

int main(int count, char** words) {
  using namespace geargraph;
  constexpr int kWords = 6;
  if (count != kWords) return kUnreadable;
  std::array<rlim_t, 4> numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto read = number(words[i + 2]);
    if (!read) return kUnreadable;
    numbers[i] = *read;
  }
  // No other files, no core dump, no child.
  const bool limited = limit(RLIMIT_AS, numbers[2]) && limit(RLIMIT_CPU, numbers[3]) &&
                       limit(RLIMIT_CORE, 0) && limit(RLIMIT_FSIZE, 0) && limit(RLIMIT_NOFILE, 3);
  if (!limited) return kUnreadable;
  try {
    return run(words[1], numbers[0], numbers[1]);
  } catch (const std::bad_alloc&) {
    std::cerr << "Reading it takes more than " << numbers[2] / (1U << 20U) << " MiB of memory.";
    return kLimit;
  } catch (const std::exception& error) {
    std::cerr << "It is damaged: " << error.what();
    return kUnreadable;
  }
}
