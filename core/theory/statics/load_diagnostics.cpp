#include "core/theory/statics/load_diagnostics.h"

#include <algorithm>

#include "core/foundations/base/locale.h"
#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"

namespace geargraph {
namespace {

/// Other codes of a report (a state that locks) are those of the document's own analysis.
bool isOnLoads(Code code) {
  switch (code) {
    case Code::unbalanced:
    case Code::loadOnBalance:
    case Code::staticallyIndeterminate:
    case Code::selfLocking:
    case Code::recirculation:
    case Code::noMotion:
    case Code::deadLoad:
    case Code::unknownUnit:
    case Code::patternLimit:
      return true;
    default:
      return false;
  }
}

/// English goes on in lower case behind the colon; what it does in other languages is for their catalogues.
std::string inStates(const std::vector<std::string>& names, std::string message) {
  if (isEnglish())
    message.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(message.front())));
  const std::string states = listed(names, kAllNames);
  return names.size() == 1 ? translated("In state %1: %2", {states, message})
                           : translated("In states %1: %2", {states, message});
}

}  // namespace

Diagnostics solvedLoadDiagnostics(const Mechanism& mechanism, const StaticsReport& report) {
  Diagnostics diagnostics;
  if (mechanism.loads.empty()) return diagnostics;
  for (const Diagnostic& each : report.diagnostics)
    if (isOnLoads(each.code)) diagnostics.push_back(each);
  return diagnostics;
}

Diagnostics solvedLoadDiagnostics(const Mechanism& mechanism, std::span<const StaticsReport* const> byState) {
  Diagnostics diagnostics;
  std::vector<std::vector<std::string>> states;  // by diagnostic: in which states it is
  for (std::size_t state = 0; state < byState.size(); ++state) {
    if (byState[state] == nullptr) continue;
    for (Diagnostic& each : solvedLoadDiagnostics(mechanism, *byState[state])) {
      if (each.severity() == Severity::info) continue;
      const auto at = std::find(diagnostics.begin(), diagnostics.end(), each);
      const auto place = static_cast<std::size_t>(at - diagnostics.begin());
      if (at == diagnostics.end()) {
        diagnostics.push_back(std::move(each));
        states.emplace_back();
      }
      states[place].push_back(mechanism.states[state].name);
    }
  }
  for (std::size_t i = 0; i < diagnostics.size(); ++i)
    diagnostics[i].message = inStates(states[i], std::move(diagnostics[i].message));
  return diagnostics;
}

}  // namespace geargraph
