#include "core/theory/ttgraph/terminal_rule.h"

#include <cmath>

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

/// s = -cos(beta_i + beta_j + Sigma): of two threads that run the same way, the one drives the other aside as
/// it would drive a nut.
std::optional<int> asHandsSay(double sum) {
  return std::cos(sum) > 0 ? -1 : 1;
}

constexpr TerminalRule kExternalTerminals{againstEachOther};
constexpr TerminalRule kInternalTerminals{theSameWay};
constexpr TerminalRule kBevelTerminals{asThePointSays};
constexpr TerminalRule kOpenStrandTerminals{theSameWay};
constexpr TerminalRule kPinTerminals{theSameWay};
constexpr TerminalRule kCrossedTerminals{asThePointSays, asHandsSay};

}  // namespace

KindTable<MeshKind, TerminalRule>& terminalRules() {
  static constinit KindTable<MeshKind, TerminalRule> table(
      &kExternalTerminals, &kInternalTerminals, &kBevelTerminals, &kOpenStrandTerminals, &kPinTerminals,
      &kCrossedTerminals, &kCrossedTerminals);
  return table;
}

}  // namespace geargraph
