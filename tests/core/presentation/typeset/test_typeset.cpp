#include <QTest>
#include <cmath>

#include "core/presentation/report/report.h"
#include "core/presentation/typeset/tex_reader.h"
#include "core/presentation/typeset/typeset.h"
#include "tests/core/presentation/report/derived_report.h"
#include "tests/core/support/example_files.h"

namespace geargraph {
namespace {

using test::reportOf;

FormulaBox boxOf(const char* tex, FormulaPlace place = FormulaPlace::ownLine) {
  return typesetFormula(formulaOf(tex), place);
}

/// The n-th glyph of this character.
const PlacedGlyph& glyphOf(const FormulaBox& box, char32_t character, int n = 0) {
  for (const PlacedGlyph& glyph : box.glyphs) {
    if (glyph.character == character && n-- == 0) return glyph;
  }
  qFatal("no such glyph");
}

double advanceOf(const PlacedGlyph& glyph) {
  return glyphMetrics(glyph.face, glyph.character)->advance * glyph.size;
}
double endOf(const PlacedGlyph& glyph) {
  return glyph.x + advanceOf(glyph);
}
double middleOf(const PlacedGlyph& glyph) {
  return glyph.x + advanceOf(glyph) / 2;
}

/// The ink of a glyph, y downwards.
struct Ink {
  double left, right, top, bottom;
};
Ink inkOf(const PlacedGlyph& glyph) {
  const auto metrics = glyphMetrics(glyph.face, glyph.character);
  return {glyph.x + metrics->left * glyph.size, glyph.x + metrics->right * glyph.size,
          glyph.y - metrics->height * glyph.size, glyph.y + metrics->depth * glyph.size};
}

/// Ink that overlaps another's, or reaches out of the box. Pieces of brackets belong together.
QString faultOf(const FormulaBox& box) {
  constexpr double kTouch = 0.02;
  const auto isPiece = [](const PlacedGlyph& glyph) {
    return glyph.character >= 0x239B && glyph.character <= 0x23A6;
  };
  // Dots and hats stand over their letters, and slanted letters lean over what follows.
  const auto mayTouch = [](const PlacedGlyph& glyph) {
    return glyph.character == 0x2D9 || glyph.character == U'^' || glyph.face == FontFace::italic;
  };
  for (std::size_t i = 0; i < box.glyphs.size(); ++i) {
    const Ink a = inkOf(box.glyphs[i]);
    if (a.left < -0.1 || a.right > box.width + 0.15 || a.top < -box.height - 0.1 ||
        a.bottom > box.depth + 0.1)
      return QStringLiteral("glyph %1 of %2 is outside").arg(i).arg(box.glyphs.size());
    for (std::size_t j = i + 1; j < box.glyphs.size() && j < i + 200; ++j) {
      const Ink b = inkOf(box.glyphs[j]);
      if (isPiece(box.glyphs[i]) && isPiece(box.glyphs[j])) continue;
      if (mayTouch(box.glyphs[i]) || mayTouch(box.glyphs[j])) continue;
      if (std::min(a.right, b.right) - std::max(a.left, b.left) > kTouch &&
          std::min(a.bottom, b.bottom) - std::max(a.top, b.top) > kTouch) {
        return QStringLiteral("glyphs %1 and %2 overlap").arg(i).arg(j);
      }
    }
  }
  return {};
}

void compare(double measured, double expected) {
  if (std::abs(measured - expected) > 1e-9) qFatal("%.6f is not %.6f", measured, expected);
}

}  // namespace

/// Where glyphs and rules of formulas are.
class TypesetTest : public QObject {
  Q_OBJECT

 private slots:
  void lettersAreItalicAndDigitsUpright() {
    const FormulaBox box = boxOf("r2\\theta\\Gamma");
    QCOMPARE(glyphOf(box, U'r').face, FontFace::italic);
    QCOMPARE(glyphOf(box, U'2').face, FontFace::main);
    QCOMPARE(glyphOf(box, U'θ').face, FontFace::italic);
    QCOMPARE(glyphOf(box, U'Γ').face, FontFace::main);
  }

  void signsHaveTheRoomOfTheirClass() {
    const FormulaBox box = boxOf("1 = 2 + 3 , 4");
    const auto room = [&](char32_t left, char32_t right) {
      return glyphOf(box, right).x - endOf(glyphOf(box, left));
    };
    compare(room(U'1', U'='), 5.0 / 18);
    compare(room(U'=', U'2'), 5.0 / 18);
    compare(room(U'2', U'+'), 4.0 / 18);
    compare(room(U'+', U'3'), 4.0 / 18);
    compare(room(U'3', U','), 0);
    compare(room(U',', U'4'), 3.0 / 18);
  }

  void barsInPairsAreCloseToWhatTheyEnclose() {
    const auto widthOf = [](const char* tex) { return boxOf(tex).width; };
    const double bar = widthOf("|"), letter = widthOf("\\omega");
    compare(widthOf("|\\omega|"), 2 * bar + letter);
    // One alone stands between its sides as an equals sign does.
    compare(widthOf("\\omega|\\omega") - bar, widthOf("\\omega=\\omega") - widthOf("="));
    // Behind the second one a sign has its room.
    compare(widthOf("|\\omega|=\\omega") - 2 * bar, widthOf("\\omega=\\omega"));
  }

  void aMinusSignOfATermIsCloseToIt() {
    const FormulaBox box = boxOf("1 = -2 - 3");
    compare(glyphOf(box, U'2').x, endOf(glyphOf(box, U'−')));
    compare(glyphOf(box, U'3').x, endOf(glyphOf(box, U'−', 1)) + 4.0 / 18);
    const FormulaBox script = boxOf("1^{2-3}");
    compare(glyphOf(script, U'3').x, endOf(glyphOf(script, U'−')));
  }

  void aNumeratorIsCentredOverItsBar() {
    const FormulaBox box = boxOf("\\frac{1}{234}");
    QCOMPARE(box.rules.size(), std::size_t{1});
    const PlacedRule& bar = box.rules.front();
    compare(bar.y + bar.height / 2, -kFormulaAxis);
    compare(middleOf(glyphOf(box, U'1')), bar.x + bar.width / 2);
    compare(middleOf(glyphOf(box, U'3')), bar.x + bar.width / 2);
    compare(bar.width, 3 * advanceOf(glyphOf(box, U'2')));
    QVERIFY(inkOf(glyphOf(box, U'1')).bottom < bar.y);
    QVERIFY(inkOf(glyphOf(box, U'3')).top > bar.y + bar.height);
  }

  void fractionsOfASentenceAreSmaller() {
    QCOMPARE(glyphOf(boxOf("\\frac{1}{2}"), U'1').size, 1.0);
    QCOMPARE(glyphOf(boxOf("\\frac{1}{2}", FormulaPlace::inLine), U'1').size, 0.7);
    QCOMPARE(glyphOf(boxOf("x^{\\frac{1}{2}}"), U'1').size, 0.5);
  }

  void scriptsStandBelowAndAbove() {
    const FormulaBox below = boxOf("x_1");
    QCOMPARE(glyphOf(below, U'1').size, 0.7);
    compare(glyphOf(below, U'1').y, 0.15);
    const FormulaBox above = boxOf("x^1");
    compare(glyphOf(above, U'1').y, -0.413);
    compare(glyphOf(boxOf("x^1", FormulaPlace::inLine), U'1').y, -0.363);
    const FormulaBox both = boxOf("\\omega_{51}''");
    compare(glyphOf(both, U'′').x, glyphOf(both, U'5').x);
    QVERIFY(inkOf(glyphOf(both, U'′')).bottom < inkOf(glyphOf(both, U'5')).top);
    QVERIFY(glyphOf(both, U'5').y > 0.2);
  }

  void aScriptBehindASlantedLetterClearsIt() {
    const FormulaBox box = boxOf("P_8^9");
    QVERIFY(glyphOf(box, U'9').x > glyphOf(box, U'8').x + 0.05);
    compare(glyphOf(box, U'8').x, endOf(glyphOf(box, U'P')));
  }

  void aDotStandsOverItsLetterAndMovesNoScript() {
    const FormulaBox box = boxOf("\\dot{\\theta}_8");
    const Ink dot = inkOf(glyphOf(box, U'˙')), letter = inkOf(glyphOf(box, U'θ'));
    QVERIFY(dot.bottom < letter.top);
    QVERIFY(dot.left > letter.left && dot.right < letter.right);
    const FormulaBox twice = boxOf("\\ddot{\\theta}_8");
    const Ink dots = inkOf(glyphOf(twice, U'¨')), under = inkOf(glyphOf(twice, U'θ'));
    QVERIFY(dots.bottom < under.top && dots.left < dot.left && dots.right > dot.right);
    compare(glyphOf(box, U'8').y, glyphOf(boxOf("\\theta_8"), U'8').y);
  }

  // Every letter and sign that the reader knows by name has a glyph in one of the faces.
  void everyNamedCharacterIsSet() {
    for (const char* name : {"Gamma", "ell", "omega", "tau", "theta", "varphi", "times", "circ", "cdot", "pm",
                             "mid", "approx"}) {
      const FormulaBox box = boxOf((std::string("\\") + name).c_str());
      QCOMPARE(box.glyphs.size(), std::size_t{1});
      QVERIFY2(box.width > 0, name);
    }
  }

  void namesOfFunctionsAreUpright() {
    const FormulaBox box = boxOf("\\cos\\varphi_k");
    QCOMPARE(box.glyphs.size(), std::size_t{5});
    const PlacedGlyph& s = glyphOf(box, U's');
    QVERIFY(s.face == FontFace::main);
    QVERIFY(glyphOf(box, U'φ').x > endOf(s) + 0.1);
  }

  void columnsOfAMatrixAreAligned() {
    const FormulaBox box = boxOf("\\left[ \\begin{array}{r|r} -1 & 2 \\\\ 3 & -4 \\end{array} \\right]");
    compare(endOf(glyphOf(box, U'1')), endOf(glyphOf(box, U'3')));
    compare(endOf(glyphOf(box, U'2')), endOf(glyphOf(box, U'4')));
    compare(glyphOf(box, U'1').y, glyphOf(box, U'2').y);
    compare(glyphOf(box, U'3').y - glyphOf(box, U'1').y, 1.2);
    const PlacedRule& bar = box.rules.front();
    QVERIFY(bar.dashed);
    QVERIFY(bar.x > endOf(glyphOf(box, U'1')) && bar.x < glyphOf(box, U'−', 1).x);
  }

  void bracketsGrowWithWhatTheyHold() {
    for (int rows = 1; rows <= 40; ++rows) {
      std::string tex = "\\begin{pmatrix} 1";
      for (int row = 1; row < rows; ++row) tex += " \\\\ 1";
      const FormulaBox box = boxOf((tex + " \\end{pmatrix}").c_str());
      double top = 0, bottom = 0;
      for (const PlacedGlyph& glyph : box.glyphs) {
        if (glyph.character == U'1' || glyph.x > box.width / 2) continue;
        top = std::min(top, inkOf(glyph).top);
        bottom = std::max(bottom, inkOf(glyph).bottom);
      }
      compare((top + bottom) / 2, -kFormulaAxis);
      QVERIFY2(
          bottom - top >= 1.07 * rows && bottom - top > 1.2 * rows - 0.6 && bottom - top < 1.2 * rows + 1,
          qPrintable(QString::number(rows)));
    }
  }

  // Pieces follow one another without a gap.
  void aTallBracketIsOneStroke() {
    const FormulaBox box = bracketBox('[', 17, 1);
    std::vector<Ink> pieces;
    for (const PlacedGlyph& glyph : box.glyphs) pieces.push_back(inkOf(glyph));
    std::sort(pieces.begin(), pieces.end(), [](const Ink& a, const Ink& b) { return a.top < b.top; });
    for (std::size_t i = 1; i < pieces.size(); ++i) QVERIFY(pieces[i].top < pieces[i - 1].bottom);
    compare(pieces.back().bottom - pieces.front().top, 17);
  }

  void labelsStandOutsideOfTheBrackets() {
    const FormulaBox box =
        boxOf("Z = \\begin{array}{c|rr} & 8 & 9 \\\\ \\hline 5 & 1 & 0 \\\\ 6 & 2 & 3 \\end{array}");
    const PlacedGlyph& open = glyphOf(box, U'[');
    const PlacedGlyph& row = glyphOf(box, U'5');
    const PlacedGlyph& column = glyphOf(box, U'8');
    QCOMPARE(row.ink, FormulaInk::label);
    QCOMPARE(column.ink, FormulaInk::label);
    QCOMPARE(glyphOf(box, U'1').ink, FormulaInk::formula);
    QVERIFY(endOf(row) < open.x && inkOf(open).right < glyphOf(box, U'1').x);
    QVERIFY(column.y < inkOf(open).top);
    compare(row.y, glyphOf(box, U'1').y);
    compare(endOf(column), endOf(glyphOf(box, U'1')));
    QVERIFY(box.rules.empty());
    // The middle of the rows, not of the labels, is level with the sign.
    compare((inkOf(open).top + inkOf(open).bottom) / 2, -kFormulaAxis);
  }

  void linesAreAlignedAtTheirSigns() {
    const FormulaBox box = boxOf("\\begin{aligned} 1+2 &= 3 \\\\ &= 4 \\end{aligned}");
    compare(glyphOf(box, U'=').x, glyphOf(box, U'=', 1).x);
    compare(glyphOf(box, U'=').x - endOf(glyphOf(box, U'2')), 5.0 / 18);
    const auto lines = typesetLines(formulaOf("\\begin{aligned} 1+2 &= 3 \\\\ &= 4 \\end{aligned}"), 100);
    QCOMPARE(lines.size(), std::size_t{2});
    compare(glyphOf(lines[0].box, U'=').x, glyphOf(lines[1].box, U'=').x);
    compare(glyphOf(lines[0].box, U'=').x, glyphOf(box, U'=').x);
  }

  void aWideLineGoesOnIndented() {
    const FormulaNode formula = formulaOf("\\begin{aligned} a &= 1 + 2 + 3 + 4 \\end{aligned}");
    const double whole = widthOf(typesetLines(formula, 100));
    const auto lines = typesetLines(formula, whole - 0.1);
    QCOMPARE(lines.size(), std::size_t{2});
    QVERIFY(widthOf(lines) <= whole - 0.1);
    compare(glyphOf(lines[1].box, U'+').x,
            endOf(glyphOf(lines[0].box, U'a')) + 2 + glyphMetrics(FontFace::italic, U'a')->slant());
    QCOMPARE(glyphOf(lines[1].box, U'4').y, 0.0);
    // What does not break stays.
    QCOMPARE(typesetLines(formulaOf("12345678"), 1).size(), std::size_t{1});
  }

  void aWideMatrixGoesOnInPartsOfItsColumns() {
    const FormulaNode formula = formulaOf(
        "Z = \\begin{array}{c|rr|rr} & 8 & 9 & 10 & 11 \\\\ \\hline 1 & 2 & 3 & 4 & 5 \\end{array}");
    const double whole = widthOf(typesetLines(formula, 100));
    const auto lines = typesetLines(formula, 0.8 * whole);
    QCOMPARE(lines.size(), std::size_t{2});
    QVERIFY(widthOf(lines) <= 0.8 * whole);
    const auto charactersOf = [](const FormulaBox& box) {
      std::u32string characters;
      for (const PlacedGlyph& glyph : box.glyphs) characters += glyph.character;
      return QString::fromStdU32String(characters);
    };
    QCOMPARE(charactersOf(lines[0].box), QStringLiteral("Z=89123["));
    QCOMPARE(charactersOf(lines[1].box), QStringLiteral("1011145]"));
    // The labels of the row stand one below the other.
    compare(glyphOf(lines[0].box, U'1').x, glyphOf(lines[1].box, U'1', 3).x);
  }

  void everyFormulaOfEveryExampleIsSet() {
    const std::vector<std::string> names = test::exampleNames();
    QVERIFY(names.size() >= 17);
    int formulas = 0;
    const auto check = [&](const std::string& tex, FormulaPlace place) {
      const ReadFormula read = readTex(tex);
      QCOMPARE(read.fault, std::string());
      const FormulaBox box = typesetFormula(read.formula, place);
      QVERIFY2(!box.glyphs.empty() && box.width > 0, tex.c_str());
      QVERIFY2(faultOf(box).isEmpty(), (qPrintable(faultOf(box)) + std::string(": ") + tex).c_str());
      ++formulas;
    };
    for (const std::string& name : names) {
      for (const ReportBlock& block : reportOf(test::example(name)).blocks) {
        if (const auto* equation = std::get_if<ReportEquation>(&block))
          check(equation->tex, FormulaPlace::ownLine);
        if (const auto* paragraph = std::get_if<ReportParagraph>(&block)) {
          for (const ReportSpan& span : paragraph->words)
            if (span.isFormula) check(span.text, FormulaPlace::inLine);
        }
      }
    }
    QVERIFY(formulas > 500);
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::TypesetTest)
#include "test_typeset.moc"
