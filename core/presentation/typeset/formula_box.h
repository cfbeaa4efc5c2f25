#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/presentation/typeset/font_face.h"

namespace geargraph::inline typeset {

/// What is set beside a formula's own ink: the labels of rows and columns.
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

/// A filled rectangle from its upper left corner; a dashed one is a broken line down its middle.
struct PlacedRule {
  double x = 0, y = 0;
  double width = 0, height = 0;
  bool dashed = false;
};

/// A formula, set: glyphs and rules and the room they take.
struct FormulaBox {
  double width = 0;
  double height = 0;  ///< above the baseline
  double depth = 0;   ///< below it
  std::vector<PlacedGlyph> glyphs = {};
  std::vector<PlacedRule> rules = {};

  /// Adds another box with its left edge at x and its baseline y below this one's, and makes room for it. The
  /// width stays.
  void put(const FormulaBox& box, double x, double y);
  /// Adds it at the right end, and grows by its width.
  void append(const FormulaBox& box);
};

/// One character.
/// @pre the face has it
[[nodiscard]] FormulaBox glyphBox(FontFace face, char32_t character, double size);

/// One of ()[] of at least `total`, its middle on the axis of formulas, out of pieces where no glyph is as
/// large.
[[nodiscard]] FormulaBox bracketBox(char bracket, double total, double size);

/// Height of the line on which fractions, brackets and minus signs are centred.
constexpr double kFormulaAxis = 0.25;
constexpr double kFormulaRule = 0.04;  ///< thickness of a fraction's bar

}  // namespace geargraph::inline typeset
