#pragma once

#include <vector>

#include "core/presentation/typeset/formula.h"
#include "core/presentation/typeset/formula_box.h"

namespace geargraph::inline typeset {

// How the typesetter works: a row becomes atoms, whose classes say what room is between them (TeX's rules,
// see Knuth, The TeXbook, appendix G).

enum class AtomClass { ordinary, binary, relation, opening, closing, punctuation, inner };

struct SetStyle {
  int level = 1;         ///< 0: on its own line, 1: in a sentence, 2: a script, 3: a script's script
  bool cramped = false;  ///< raised less: below something

  [[nodiscard]] double size() const { return level < 2 ? 1.0 : level == 2 ? 0.7 : 0.5; }
  [[nodiscard]] SetStyle above() const { return {level < 2 ? 2 : 3, cramped}; }
  [[nodiscard]] SetStyle below() const { return {level < 2 ? 2 : 3, true}; }
};

struct SetAtom {
  FormulaBox box;
  AtomClass kind = AtomClass::ordinary;
  bool isSpace = false;      ///< has no class: it parts nothing
  bool isCharacter = false;  ///< its scripts stand as at a letter
  double slant = 0;          ///< how far its ink reaches beyond the width
};

/// The parts of a row, each with its slant within its width, and signs between nothing no longer binary.
[[nodiscard]] std::vector<SetAtom> setAtoms(const std::vector<FormulaNode>& parts, SetStyle style);
/// How tall brackets have to be for what they hold: nine tenths of it, and no more than half an em less.
[[nodiscard]] double bracketTotal(double held, double size);
/// The room between two atoms.
[[nodiscard]] double roomBetween(const SetAtom& left, const SetAtom& right, SetStyle style);
[[nodiscard]] FormulaBox setRow(const FormulaNode& row, SetStyle style);
[[nodiscard]] FormulaBox setTable(const FormulaNode& table, SetStyle style);
/// The widths of its columns, in em, without what is between them.
[[nodiscard]] std::vector<double> columnWidths(const FormulaNode& table, SetStyle style);

}  // namespace geargraph::inline typeset
