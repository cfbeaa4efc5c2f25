#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/presentation/typeset/font_face.h"

namespace geargraph {

/// The colour role: the formula itself, or the labels of rows and columns.
enum class FormulaInk { formula, label };

/// x to the right from the box's left edge, y downwards from its baseline; em at size 1.
struct PlacedGlyph {
  FontFace face = FontFace::main;
  std::uint32_t glyph = 0;
  char32_t character = 0;
  double size = 1;  ///< of the em
  double x = 0, y = 0;
  FormulaInk ink = FormulaInk::formula;
};

/// A filled rectangle from its upper left corner; a dashed one is a dashed vertical line in its middle.
struct PlacedRule {
  double x = 0, y = 0;
  double width = 0, height = 0;
  bool dashed = false;
};

/// A typeset formula: glyphs, rules and its extent.
struct FormulaBox {
  double width = 0;
  double height = 0;  ///< above the baseline
  double depth = 0;   ///< below it
  std::vector<PlacedGlyph> glyphs = {};
  std::vector<PlacedRule> rules = {};

  /// Adds another box with its left edge at x and its baseline y below this one's; height and depth grow, the
  /// width stays.
  void put(const FormulaBox& box, double x, double y);
  /// Adds another box at the right end; the width grows by its width.
  void append(const FormulaBox& box);
};

/// One character.
/// @pre the face has it
[[nodiscard]] FormulaBox glyphBox(FontFace face, char32_t character, double size);

/// One of ()[] with a height of at least `total`, centred on the formula axis, assembled from pieces if no
/// glyph is large enough.
[[nodiscard]] FormulaBox bracketBox(char bracket, double total, double size);

/// The math axis: the height at which fractions, brackets and minus signs are centred, em.
constexpr double kFormulaAxis = 0.25;
constexpr double kFormulaRule = 0.04;  ///< thickness of a fraction's bar, em

}  // namespace geargraph
