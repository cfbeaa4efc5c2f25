#include <cmath>

#include "core/presentation/typeset/tex_reader.h"
#include "core/presentation/typeset/typeset.h"
#include "tests/fuzz/laws.h"

namespace geargraph::test {

void checkTex(const std::string& text) {
  const ReadFormula read = readTex(text);
  if (!read.fault.empty() && read.fault.back() != '.') lawFailed("A fault is no sentence", text);
  for (const FormulaPlace place : {FormulaPlace::inLine, FormulaPlace::ownLine}) {
    const FormulaBox box = typesetFormula(read.formula, place);
    if (!std::isfinite(box.width) || !std::isfinite(box.height) || !std::isfinite(box.depth))
      lawFailed("A box has no finite size", text);
  }
  for (const double width : {0.0, 5.0, 1e6}) {
    const auto lines = typesetLines(read.formula, width);
    if (!std::isfinite(widthOf(lines))) lawFailed("A line has no finite width", text);
  }
}

}  // namespace geargraph::test
