#include "tests/faults/versions.h"

#include <charconv>
#include <random>

#include "tests/core/support/example_files.h"

namespace geargraph::test {
namespace {

constexpr std::string_view kName = "version ";

}  // namespace

Mechanism version(int number) {
  static const Mechanism robot = example("robot");
  Mechanism mechanism = robot;
  mechanism.name = std::string(kName) + std::to_string(number);
  std::mt19937_64 random(static_cast<std::uint64_t>(number));
  constexpr std::size_t kMaxNotesLength = 300'000;
  mechanism.notes.resize(random() % kMaxNotesLength);
  for (char& letter : mechanism.notes) letter = static_cast<char>('a' + random() % 26);
  return mechanism;
}

std::optional<int> versionOf(const Mechanism& mechanism) {
  const std::string_view name = mechanism.name;
  if (!name.starts_with(kName)) return std::nullopt;
  int number = 0;
  const auto [end, error] = std::from_chars(name.data() + kName.size(), name.data() + name.size(), number);
  if (error != std::errc() || end != name.data() + name.size()) return std::nullopt;
  return mechanism == version(number) ? std::optional(number) : std::nullopt;
}

}  // namespace geargraph::test
