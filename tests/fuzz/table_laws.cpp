#include "core/mechanism/document_format/mechanism_file.h"
#include "core/mechanism/document_format/mechanism_table.h"
#include "core/mechanism/model/validate.h"
#include "tests/fuzz/laws.h"

namespace geargraph::test {

bool checkTable(const std::string& text) {
  const auto first = readMechanismTable(text);
  if (!first) {
    for (const Diagnostic& diagnostic : first.error()) {
      if (diagnostic.message.empty() || diagnostic.severity() != Severity::error || diagnostic.line < 1 ||
          diagnostic.column < 1)
        lawFailed("A finding has no sentence or no place", text);
    }
    return false;
  }
  if (!wellFormedDiagnostics(*first).empty()) lawFailed("Read, but not well formed", text);
  const auto opened = readMechanism(writeMechanism(*first));
  if (!opened || !(*opened == *first)) lawFailed("What was read is not saved and opened again", text);
  if (!tablePart(*first).lost.empty()) lawFailed("A table gave what tables do not hold", text);
  for (const char separator : {',', ';', '\t'}) {
    const std::string written = writeMechanismTable(*first, {separator, false});
    const auto second = readMechanismTable(written);
    if (!second || !(*second == *first)) lawFailed("What was written is not read back", text);
    if (writeMechanismTable(*second, {separator, false}) != written)
      lawFailed("Writing is not canonical", text);
  }
  return true;
}

}  // namespace geargraph::test
