#include <memory>

#include "core/mechanism/document_format/mechanism_file.h"
#include "core/theory/analysis/analysis.h"
#include "tests/fuzz/laws.h"

namespace geargraph::test {

Analysed checkAnalysis(const std::string& text) {
  const auto document = readMechanism(text);
  if (!document) return Analysed::rejected;
  const SnapshotPtr snapshot = analyze(std::make_shared<const Mechanism>(*document));
  if (!snapshot || !snapshot->isComplete) lawFailed("The analysis stopped on its own", text);
  if (hasErrors(snapshot->diagnostics)) {
    if (snapshot->solved) lawFailed("Numbers in spite of errors", text);
    return Analysed::withErrors;
  }
  if (!snapshot->solved || !snapshot->solved->exact) lawFailed("No errors, and yet no numbers", text);
  if (!snapshot->solved->agreement || !snapshot->solved->agreement->equal)
    lawFailed("The two methods differ", text);
  return Analysed::withNumbers;
}

}  // namespace geargraph::test
