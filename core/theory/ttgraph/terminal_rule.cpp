#include "core/theory/ttgraph/terminal_rule.h"

namespace geargraph {
namespace {

std::optional<int> againstEachOther(int sense) {
  return -sense;
}

std::optional<int> theSameWay(int sense) {
  return sense;
}

std::optional<int> asThePointSays(int /*sense*/) {
  return std::nullopt;
}

constexpr TerminalRule kExternalTerminals{againstEachOther};
constexpr TerminalRule kInternalTerminals{theSameWay};
constexpr TerminalRule kBevelTerminals{asThePointSays};
constexpr TerminalRule kOpenStrandTerminals{theSameWay};
constexpr TerminalRule kPinTerminals{theSameWay};

}  // namespace

KindTable<MeshKind, TerminalRule>& terminalRules() {
  static constinit KindTable<MeshKind, TerminalRule> table(
      &kExternalTerminals, &kInternalTerminals, &kBevelTerminals, &kOpenStrandTerminals, &kPinTerminals);
  return table;
}

}  // namespace geargraph
