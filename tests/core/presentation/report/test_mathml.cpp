#include <QTest>

#include "core/presentation/report/mathml.h"

namespace geargraph {

/// The formulas that core writes, as elements of MathML.
class MathMlTest : public QObject {
  Q_OBJECT

 private slots:
  void barsInPairsEnclose() {
    const std::string value = mathMl("| a | = b");
    QVERIFY2(value.find("<mo form=\"prefix\" stretchy=\"false\">|</mo><mi>a</mi>"
                        "<mo form=\"postfix\" stretchy=\"false\">|</mo>") != std::string::npos,
             value.c_str());
    QVERIFY(mathMl("G \\mid H").find("<mo>|</mo>") != std::string::npos);
  }

  void formulas_data() {
    QTest::addColumn<QString>("tex");
    QTest::addColumn<QString>("elements");
    QTest::newRow("sum") << "E = t - r"
                         << "<mi>E</mi><mo>=</mo><mi>t</mi><mo>−</mo><mi>r</mi>";
    QTest::newRow("a sign of a term") << "y = -2"
                                      << "<mi>y</mi><mo>=</mo><mo form=\"prefix\">−</mo><mn>2</mn>";
    QTest::newRow("subscript") << "i_{15}"
                               << "<msub><mi>i</mi><mrow><mn>15</mn></mrow></msub>";
    QTest::newRow("primes") << "\\omega_{51}''"
                            << "<msubsup><mi>ω</mi><mrow><mn>51</mn></mrow><mo>′′</mo></msubsup>";
    QTest::newRow("fraction") << "\\frac{1}{2}"
                              << "<mfrac><mrow><mn>1</mn></mrow><mrow><mn>2</mn></mrow></mfrac>";
    QTest::newRow("rate")
        << "\\dot{\\theta}_{8}"
        << "<msub><mover "
           "accent=\"true\"><mrow><mi>θ</mi></mrow><mo>˙</mo></mover><mrow><mn>8</mn></mrow></msub>";
    QTest::newRow("matrix") << "\\left[ \\begin{array}{r|r} 1 & 0 \\\\ \\hline x & y \\end{array} \\right]"
                            << "<mrow><mo stretchy=\"true\">[</mo><mtable><mtr><mtd "
                               "class=\"r\"><mn>1</mn></mtd><mtd class=\"r bar\">"
                               "<mn>0</mn></mtd></mtr><mtr><mtd class=\"r rule\"><mi>x</mi></mtd><mtd "
                               "class=\"r bar rule\"><mi>y</mi></mtd>"
                               "</mtr></mtable><mo stretchy=\"true\">]</mo></mrow>";
    QTest::newRow("lines") << "\\begin{aligned} a &= 1 \\\\ &= 2 \\end{aligned}"
                           << "<mtable class=\"aligned\" displaystyle=\"true\"><mtr><mtd "
                              "class=\"r\"><mi>a</mi></mtd><mtd class=\"l\">"
                              "<mo>=</mo><mn>1</mn></mtd></mtr><mtr><mtd class=\"r\"></mtd><mtd "
                              "class=\"l\"><mo>=</mo><mn>2</mn></mtd></mtr></mtable>";
  }
  void formulas() {
    QFETCH(QString, tex);
    QFETCH(QString, elements);
    QCOMPARE(QString::fromStdString(mathMl(tex.toStdString())), elements);
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::MathMlTest)
#include "test_mathml.moc"
