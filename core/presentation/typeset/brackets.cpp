#include <array>
#include <cmath>

#include "core/foundations/base/contract.h"
#include "core/presentation/typeset/formula_box.h"

namespace geargraph {
namespace {

struct Pieces {
  char bracket;
  char32_t top, middle, bottom;
};
constexpr std::array kPieces{Pieces{'(', U'⎛', U'⎜', U'⎝'}, Pieces{')', U'⎞', U'⎟', U'⎠'},
                             Pieces{'[', U'⎡', U'⎢', U'⎣'}, Pieces{']', U'⎤', U'⎥', U'⎦'}};

const Pieces& piecesOf(char bracket) {
  for (const Pieces& pieces : kPieces) {
    if (pieces.bracket == bracket) return pieces;
  }
  GEARGRAPH_REQUIRE(false);
}

double inkOf(const FormulaBox& glyph) {
  const auto metrics = glyphMetrics(glyph.glyphs.front().face, glyph.glyphs.front().character);
  return (metrics->height + metrics->depth) * glyph.glyphs.front().size;
}

/// How far below its own baseline the ink of a glyph ends.
double inkDepth(const FormulaBox& glyph) {
  const PlacedGlyph& placed = glyph.glyphs.front();
  return glyphMetrics(placed.face, placed.character)->depth * placed.size;
}

/// Top and bottom, and between them as many middles as fill the gap, each over the one before.
FormulaBox built(const Pieces& pieces, double total, double size) {
  const FormulaBox top = glyphBox(FontFace::size4, pieces.top, size);
  const FormulaBox middle = glyphBox(FontFace::size4, pieces.middle, size);
  const FormulaBox bottom = glyphBox(FontFace::size4, pieces.bottom, size);
  const double all = std::max(total, inkOf(top) + inkOf(bottom));
  const double gap = all - inkOf(top) - inkOf(bottom);
  const double lowest = all / 2 - kFormulaAxis * size;  // below the baseline
  FormulaBox box;
  box.width = top.width;
  box.put(top, 0, lowest - all + inkOf(top) - inkDepth(top));
  const double step = inkOf(middle);
  const int count = static_cast<int>(std::ceil(gap / (0.9 * step)));
  for (int i = 0; i < count; ++i) {
    const double end = lowest - inkOf(bottom) - gap * i / count + (i == 0 ? 0.02 : 0.0) * size;
    box.put(middle, 0, end - inkDepth(middle));
  }
  box.put(bottom, 0, lowest - inkDepth(bottom));
  box.height = all - lowest;
  box.depth = lowest;
  return box;
}

}  // namespace

FormulaBox bracketBox(char bracket, double total, double size) {
  const auto character = static_cast<char32_t>(bracket);
  for (const FontFace face :
       {FontFace::main, FontFace::size1, FontFace::size2, FontFace::size3, FontFace::size4}) {
    const FormulaBox glyph = glyphBox(face, character, size);
    const double ink = inkOf(glyph);
    if (ink < total) continue;
    FormulaBox box;
    box.width = glyph.width;
    box.put(glyph, 0, ink / 2 - inkDepth(glyph) - kFormulaAxis * size);
    return box;
  }
  return built(piecesOf(bracket), total, size);
}

}  // namespace geargraph
