#include <nlohmann/json.hpp>

#include "core/foundations/files/json.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "core/mechanism/model/validate.h"
#include "tests/fuzz/laws.h"

namespace geargraph::test {
namespace {

void checkJsonAgainstOther(const std::string& text) {
  if (text.find('\0') != std::string::npos) return;  // for nlohmann's reader a text ends there
  const auto ours = JsonDocument::parse(text);
  if (!ours && ours.error().front().code == Code::schema) return;  // nested too deeply
  // nlohmann rejects numbers beyond a double as a parse error; for us they are JSON, rejected later.
  bool outOfRange = false;
  bool theirs = true;
  try {
    theirs = !nlohmann::json::parse(text).is_discarded();
  } catch (const nlohmann::json::out_of_range&) {
    outOfRange = true;
  } catch (const nlohmann::json::exception&) {
    theirs = false;
  }
  if (!outOfRange && ours.has_value() != theirs)
    lawFailed("Another reader judges the JSON differently", text);
}

}  // namespace

bool checkReader(const std::string& text) {
  checkJsonAgainstOther(text);
  const auto first = readMechanism(text);
  if (!first) {
    for (const Diagnostic& diagnostic : first.error()) {
      if (diagnostic.message.empty() || diagnostic.severity() != Severity::error)
        lawFailed("A finding says nothing", text);
    }
    return false;
  }
  if (!wellFormedDiagnostics(*first).empty()) lawFailed("Accepted, but not well formed", text);
  (void)treeDiagnostics(*first);
  const std::string written = writeMechanism(*first);
  const auto second = readMechanism(written);
  if (!second) lawFailed("What was written is not read", text);
  if (!(*second == *first)) lawFailed("What was written reads as another document", text);
  if (writeMechanism(*second) != written) lawFailed("Writing is not canonical", text);
  return true;
}

}  // namespace geargraph::test
