#include "core/presentation/typeset/formula_box.h"

#include <algorithm>

#include "core/foundations/base/contract.h"

namespace geargraph {

void FormulaBox::put(const FormulaBox& box, double x, double y) {
  height = std::max(height, box.height - y);
  depth = std::max(depth, box.depth + y);
  for (PlacedGlyph glyph : box.glyphs) {
    glyph.x += x;
    glyph.y += y;
    glyphs.push_back(glyph);
  }
  for (PlacedRule rule : box.rules) {
    rule.x += x;
    rule.y += y;
    rules.push_back(rule);
  }
}

void FormulaBox::append(const FormulaBox& box) {
  put(box, width, 0);
  width += box.width;
}

FormulaBox glyphBox(FontFace face, char32_t character, double size) {
  const auto metrics = glyphMetrics(face, character);
  GEARGRAPH_REQUIRE(metrics.has_value());
  FormulaBox box{metrics->advance * size, std::max(metrics->height, 0.0) * size,
                 std::max(metrics->depth, 0.0) * size};
  box.glyphs.push_back({face, metrics->glyph, character, size});
  return box;
}

}  // namespace geargraph
