#include "core/presentation/typeset/formula_setter.h"

#include <algorithm>
#include <array>

#include "core/foundations/base/contract.h"
#include "core/presentation/typeset/typeset.h"

namespace geargraph {
namespace {

// The parameters of TeX's fonts, in em.
constexpr double kLetterHeight = 0.431;  // of an x
constexpr double kScriptRoom = 0.05;
constexpr double kFractionRoom = 0.12;
constexpr double kSkew = 0.118;  // how far a slanted letter's top leans, for its height

SetAtom setNode(const FormulaNode& node, SetStyle style);

InternedStringClass classOf(std::string_view sign) {
  static constexpr std::array kBinary{"+", "−", "×", "⋅", "∘", "±", "*"};
  static constexpr std::array kRelations{"=", "≈", "|", "<", ">", ":"};
  if (std::find(kBinary.begin(), kBinary.end(), sign) != kBinary.end()) return InternedStringClass::binary;
  if (std::find(kRelations.begin(), kRelations.end(), sign) != kRelations.end())
    return InternedStringClass::relation;
  if (sign == "(" || sign == "[") return InternedStringClass::opening;
  if (sign == ")" || sign == "]") return InternedStringClass::closing;
  return sign == "," || sign == ";" ? InternedStringClass::punctuation : InternedStringClass::ordinary;
}

/// The sign that is printed for one of the keyboard.
char32_t printed(char32_t sign) {
  return sign == U'*' ? U'∗' : sign;
}

FormulaBox characters(std::string_view text, FontFace face, double size) {
  FormulaBox box;
  while (!text.empty()) box.append(glyphBox(face, printed(takeCharacter(text)), size));
  return box;
}

/// "cos": upright, with a gap before its argument.
SetAtom functionName(const FormulaNode& node, SetStyle style) {
  constexpr double kGap = 0.17;  // em
  SetAtom atom{characters(node.text, FontFace::main, style.size())};
  atom.box.width += kGap * style.size();
  return atom;
}

SetAtom letter(const FormulaNode& node, SetStyle style) {
  std::string_view text = node.text;
  const char32_t character = takeCharacter(text);
  if (!text.empty()) return functionName(node, style);
  // The italic face has no script letters.
  const bool upright = character == U'Γ' || !glyphMetrics(FontFace::italic, character);
  const FontFace face = upright ? FontFace::main : FontFace::italic;
  SetAtom atom{glyphBox(face, character, style.size())};
  atom.isCharacter = true;
  atom.slant = glyphMetrics(face, character)->slant() * style.size();
  return atom;
}

SetAtom sign(const FormulaNode& node, SetStyle style) {
  SetAtom atom{characters(node.text, FontFace::main, style.size())};
  atom.kind = classOf(node.text);
  atom.isCharacter = true;
  return atom;
}

/// Appendix G, rule 15.
SetAtom fraction(const FormulaNode& node, SetStyle style) {
  const int level = std::min(style.level + 1, 3);
  FormulaBox over = setRow(node.parts[0], {level, style.cramped});
  FormulaBox under = setRow(node.parts[1], {level, true});
  const double size = style.size(), rule = kFormulaRule * size, axis = kFormulaAxis * size;
  const bool own = style.level == 0;
  const double least = own ? 3 * rule : rule;
  double up = (own ? 0.677 : 0.394) * size, down = (own ? 0.686 : 0.345) * size;
  up = std::max(up, axis + rule / 2 + least + over.depth);
  down = std::max(down, rule / 2 - axis + least + under.height);
  const double inside = std::max(over.width, under.width), room = kFractionRoom * size;
  SetAtom atom;
  atom.box.width = inside + 2 * room;
  atom.box.put(over, room + (inside - over.width) / 2, -up);
  atom.box.rules.push_back({room, -axis - rule / 2, inside, rule});
  atom.box.put(under, room + (inside - under.width) / 2, down);
  return atom;
}

/// Rule 12.
SetAtom accent(const FormulaNode& node, SetStyle style) {
  const FormulaNode& base = node.parts.front();
  SetAtom below;
  if (base.kind == FormulaKind::row && base.parts.size() == 1) {
    below = setNode(base.parts.front(), {style.level, true});
  } else {
    below.box = setRow(base, {style.level, true});
  }
  std::string_view text = node.text;
  const FormulaBox mark = glyphBox(FontFace::main, takeCharacter(text), style.size());
  const double lift = below.box.height - std::min(below.box.height, kLetterHeight * style.size());
  const double lean = below.isCharacter ? kSkew * below.box.height : 0;
  SetAtom atom = below;
  atom.kind = InternedStringClass::ordinary;
  atom.box.put(mark, (below.box.width - mark.width) / 2 + lean, -lift);
  return atom;
}

/// How far up and down the scripts stand: rule 18.
std::pair<double, double> scriptShifts(const SetAtom& base, const FormulaBox* below, const FormulaBox* above,
                                       SetStyle style) {
  const double size = style.size(), inner = style.above().size(), x = kLetterHeight * size;
  double up = base.isCharacter ? 0 : base.box.height - 0.386 * inner;
  double down = base.isCharacter ? 0 : base.box.depth + 0.05 * inner;
  if (above != nullptr) {
    const double least = style.cramped ? 0.289 : style.level == 0 ? 0.413 : 0.363;
    up = std::max({up, least * size, above->depth + x / 4});
  }
  if (below != nullptr && above == nullptr) down = std::max({down, 0.15 * size, below->height - 0.8 * x});
  if (below == nullptr || above == nullptr) return {up, down};
  down = std::max(down, 0.247 * size);
  const double least = 4 * kFormulaRule * size;
  const double gap = (up - above->depth) - (below->height - down);
  if (gap < least) {
    down += least - gap;
    const double lift = 0.8 * x - (up - above->depth);
    if (lift > 0) {
      up += lift;
      down -= lift;
    }
  }
  return {up, down};
}

SetAtom scripts(const FormulaNode& node, SetStyle style) {
  SetAtom atom = setNode(node.parts.front(), style);
  const auto set = [](const FormulaNode& script, SetStyle inner) {
    FormulaNode row = script;
    if (script.kind != FormulaKind::row) row = {FormulaKind::row, {}, 0, {script}};
    return setRow(row, inner);
  };
  FormulaBox below, above;
  if (!node.below.empty()) below = set(node.below.front(), style.below());
  if (!node.above.empty()) above = set(node.above.front(), style.above());
  const auto [up, down] =
      scriptShifts(atom, node.below.empty() ? nullptr : &below, node.above.empty() ? nullptr : &above, style);
  const double end = atom.box.width, room = kScriptRoom * style.size();
  if (!node.below.empty()) {
    atom.box.put(below, end, down);
    atom.box.width = end + below.width + room;
  }
  if (!node.above.empty()) {
    atom.box.put(above, end + atom.slant, -up);
    atom.box.width = std::max(atom.box.width, end + atom.slant + above.width + room);
  }
  atom.slant = 0;
  atom.isCharacter = false;
  return atom;
}

SetAtom fenced(const FormulaNode& node, SetStyle style) {
  const FormulaBox inside = setRow(node.parts.front(), style);
  const double axis = kFormulaAxis * style.size();
  const double total = 2 * std::max(inside.height - axis, inside.depth + axis);
  SetAtom atom;
  atom.kind = InternedStringClass::inner;
  atom.box.append(bracketBox(node.text[0], bracketTotal(total, style.size()), style.size()));
  atom.box.append(inside);
  atom.box.append(bracketBox(node.text[1], bracketTotal(total, style.size()), style.size()));
  return atom;
}

SetAtom setNode(const FormulaNode& node, SetStyle style) {
  switch (node.kind) {
    case FormulaKind::row:
      return {setRow(node, style)};
    case FormulaKind::number:
      return {characters(node.text, FontFace::main, style.size()), InternedStringClass::ordinary, false,
              true};
    case FormulaKind::letter:
      return letter(node, style);
    case FormulaKind::sign:
      return sign(node, style);
    case FormulaKind::negative:
      return {glyphBox(FontFace::main, U'−', style.size())};
    case FormulaKind::scripts:
      return scripts(node, style);
    case FormulaKind::fraction:
      return fraction(node, style);
    case FormulaKind::accent:
      return accent(node, style);
    case FormulaKind::space: {
      SetAtom atom;
      atom.box.width = node.width * style.size();
      atom.isSpace = true;
      return atom;
    }
    case FormulaKind::fenced:
      return fenced(node, style);
    case FormulaKind::table:
      return {setTable(node, style), node.table == FormulaTableKind::brackets
                                         ? InternedStringClass::inner
                                         : InternedStringClass::ordinary};
  }
  GEARGRAPH_REQUIRE(false);
}

}  // namespace

std::vector<SetAtom> setAtoms(const std::vector<FormulaNode>& parts, SetStyle style) {
  std::vector<SetAtom> atoms;
  SetAtom* last = nullptr;  // that has a class
  const auto notBinary = [](SetAtom* atom) {
    if (atom != nullptr && atom->kind == InternedStringClass::binary)
      atom->kind = InternedStringClass::ordinary;
  };
  atoms.reserve(parts.size());
  // Bars in pairs are those of absolute values, close to what they enclose; one alone is a relation.
  const auto isBar = [](const FormulaNode& part) {
    return part.kind == FormulaKind::sign && part.text == "|";
  };
  const bool areFences = std::count_if(parts.begin(), parts.end(), isBar) % 2 == 0;
  bool isOpen = false;
  for (const FormulaNode& part : parts) {
    atoms.push_back(setNode(part, style));
    SetAtom& atom = atoms.back();
    if (areFences && isBar(part)) {
      atom.kind = isOpen ? InternedStringClass::closing : InternedStringClass::opening;
      isOpen = !isOpen;
    }
    atom.box.width += atom.slant;
    atom.slant = 0;
    if (atom.isSpace) continue;
    const bool nothingBefore = last == nullptr || last->kind == InternedStringClass::binary ||
                               last->kind == InternedStringClass::relation ||
                               last->kind == InternedStringClass::opening ||
                               last->kind == InternedStringClass::punctuation;
    if (nothingBefore) notBinary(&atom);
    if (atom.kind == InternedStringClass::relation || atom.kind == InternedStringClass::closing ||
        atom.kind == InternedStringClass::punctuation) {
      notBinary(last);
    }
    last = &atom;
  }
  notBinary(last);
  return atoms;
}

double bracketTotal(double held, double size) {
  return std::max(0.9 * held, held - 0.5 * size);
}

double roomBetween(const SetAtom& left, const SetAtom& right, SetStyle style) {
  // In eighteenths of an em, by class; a row for the left one.
  static constexpr std::array<std::array<int, 7>, 7> kRooms{{{0, 4, 5, 0, 0, 0, 3},
                                                             {4, 0, 0, 4, 0, 0, 4},
                                                             {5, 0, 0, 5, 0, 0, 5},
                                                             {0, 0, 0, 0, 0, 0, 0},
                                                             {0, 4, 5, 0, 0, 0, 3},
                                                             {3, 0, 3, 3, 3, 3, 3},
                                                             {3, 4, 5, 3, 0, 3, 3}}};
  if (style.level >= 2 || left.isSpace || right.isSpace) return 0;
  return kRooms[static_cast<std::size_t>(left.kind)][static_cast<std::size_t>(right.kind)] * style.size() /
         18;
}

FormulaBox setRow(const FormulaNode& row, SetStyle style) {
  FormulaBox box;
  const std::vector<SetAtom> atoms = setAtoms(row.parts, style);
  for (std::size_t i = 0; i < atoms.size(); ++i) {
    if (i > 0) box.width += roomBetween(atoms[i - 1], atoms[i], style);
    box.append(atoms[i].box);
  }
  return box;
}

FormulaBox typesetFormula(const FormulaNode& formula, FormulaPlace place) {
  return setRow(formula, {place == FormulaPlace::ownLine ? 0 : 1});
}

}  // namespace geargraph
