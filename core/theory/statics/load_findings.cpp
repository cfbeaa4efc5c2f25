#include "core/theory/statics/load_findings.h"

#include <algorithm>

#include "core/foundations/base/spoken.h"
#include "core/foundations/base/wording.h"
#include "core/foundations/base/words.h"

namespace geargraph::inline statics {
namespace {

/// Other codes of a report (a state that locks) are those of the document's own analysis.
bool isOnLoads(Code code) {
  switch (code) {
    case Code::unbalanced:
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

Diagnostics loadFindings(const Mechanism& mechanism, const StaticsReport& report) {
  Diagnostics findings;
  if (mechanism.loads.empty()) return findings;
  for (const Diagnostic& each : report.diagnostics)
    if (isOnLoads(each.code)) findings.push_back(each);
  return findings;
}

Diagnostics loadFindings(const Mechanism& mechanism, std::span<const StaticsReport* const> byState) {
  Diagnostics findings;
  std::vector<std::vector<std::string>> states;  // by finding: in which states it is
  for (std::size_t state = 0; state < byState.size(); ++state) {
    if (byState[state] == nullptr) continue;
    for (Diagnostic& each : loadFindings(mechanism, *byState[state])) {
      if (each.severity() == Severity::info) continue;
      const auto at = std::find(findings.begin(), findings.end(), each);
      const auto place = static_cast<std::size_t>(at - findings.begin());
      if (at == findings.end()) {
        findings.push_back(std::move(each));
        states.emplace_back();
      }
      states[place].push_back(mechanism.states[state].name);
    }
  }
  for (std::size_t i = 0; i < findings.size(); ++i)
    findings[i].message = inStates(states[i], std::move(findings[i].message));
  return findings;
}

}  // namespace geargraph::inline statics
