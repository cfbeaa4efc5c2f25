#pragma once

#include <vector>

#include "core/presentation/typeset/formula.h"
#include "core/presentation/typeset/formula_box.h"

namespace geargraph {

// Internals of the typesetter: a row becomes atoms, whose classes determine the space between them (TeX's
// rules, see Knuth, The TeXbook, appendix G).

enum class InternedStringClass { ordinary, binary, relation, opening, closing, punctuation, inner };

struct SetStyle {
  int level = 1;         ///< 0: on its own line, 1: in a sentence, 2: a script, 3: a script's script
  bool cramped = false;  ///< superscripts are raised less: TeX's cramped style

  [[nodiscard]] double size() const { return level < 2 ? 1.0 : level == 2 ? 0.7 : 0.5; }
  [[nodiscard]] SetStyle above() const { return {level < 2 ? 2 : 3, cramped}; }
  [[nodiscard]] SetStyle below() const { return {level < 2 ? 2 : 3, true}; }
};

struct SetAtom {
  FormulaBox box;
  InternedStringClass kind = InternedStringClass::ordinary;
  bool isSpace = false;      ///< has no class
  bool isCharacter = false;  ///< its scripts are placed as for a letter
  double slant = 0;          ///< how far its ink extends beyond the width
};

/// The atoms of a row, each with its slant included in its width; binary signs without operands become
/// ordinary.
[[nodiscard]] std::vector<SetAtom> setAtoms(const std::vector<FormulaNode>& parts, SetStyle style);
/// The height of brackets for a content of height `held`: at least 0.9 of it, and at most half an em less.
[[nodiscard]] double bracketTotal(double held, double size);
/// The space between two atoms, em.
[[nodiscard]] double roomBetween(const SetAtom& left, const SetAtom& right, SetStyle style);
[[nodiscard]] FormulaBox setRow(const FormulaNode& row, SetStyle style);
[[nodiscard]] FormulaBox setTable(const FormulaNode& table, SetStyle style);
/// The widths of its columns, in em, without column spacing.
[[nodiscard]] std::vector<double> columnWidths(const FormulaNode& table, SetStyle style);

}  // namespace geargraph
