#include <QTest>

#include "core/presentation/typeset/tex_reader.h"

namespace geargraph {

/// Formulas as trees.
class TexReaderTest : public QObject {
  Q_OBJECT

  static FormulaNode number(const char* digits) { return {FormulaKind::number, digits}; }

 private slots:
  void scriptsHangOnTheirBase() {
    const FormulaNode formula = formulaOf("\\omega_{51}''");
    QCOMPARE(formula.parts.size(), std::size_t{1});
    const FormulaNode& scripts = formula.parts.front();
    QCOMPARE(scripts.kind, FormulaKind::scripts);
    QCOMPARE(scripts.parts.front(), (FormulaNode{FormulaKind::letter, "ω"}));
    QCOMPARE(scripts.below.front().parts.front(), number("51"));
    QCOMPARE(scripts.above.front(), (FormulaNode{FormulaKind::sign, "′′"}));
  }

  void aMinusSignOfATermIsNoDifference() {
    QCOMPARE(formulaOf("a = -2").parts[2].kind, FormulaKind::negative);
    QCOMPARE(formulaOf("a - 2").parts[1], (FormulaNode{FormulaKind::sign, "−"}));
  }

  void tablesKnowTheirColumnsBarsAndRules() {
    const FormulaNode formula = formulaOf("\\begin{array}{c|rl} & 8 & 9 \\\\ \\hline 1 & x & y \\end{array}");
    const FormulaNode& table = formula.parts.front();
    QCOMPARE(table.cells.size(), std::size_t{2});
    QCOMPARE(table.cells[0].size(), std::size_t{3});
    QVERIFY(table.cells[0][0].parts.empty());
    QCOMPARE(table.cells[0][2].parts.front(), number("9"));
    QVERIFY(!table.hasBar(0) && table.hasBar(1) && !table.hasBar(2));
    QVERIFY(!table.hasRule(0) && table.hasRule(1));
    QCOMPARE(QByteArray(1, table.alignmentOf(0)) + table.alignmentOf(1) + table.alignmentOf(2),
             QByteArray("crl"));
  }

  void whatIsNotUnderstoodIsSaid_data() {
    QTest::addColumn<QByteArray>("tex");
    QTest::addColumn<QByteArray>("fault");
    QTest::newRow("command") << QByteArray("a + \\sqrt{2}")
                             << QByteArray("At 4, \"\\sqrt{2}\": no command that is known.");
    QTest::newRow("environment") << QByteArray("\\begin{cases} a \\end{cases}")
                                 << QByteArray("At 13, \" a \\end{cases}\": no environment that is known.");
    QTest::newRow("letter") << QByteArray("\u00e4") << QByteArray("At 0, \"\u00e4\": no sign of a formula.");
    QTest::newRow("open brace") << QByteArray("a_{1") << QByteArray("At 4, \"\": \"}\" is missing.");
    QTest::newRow("stray brace") << QByteArray("a}")
                                 << QByteArray("At 1, \"}\": nothing that begins here ends so.");
    QTest::newRow("two scripts") << QByteArray("a_1_2")
                                 << QByteArray("At 5, \"\": a second script at one place.");
    QTest::newRow("nothing to raise to")
        << QByteArray("a^") << QByteArray("At 2, \"\": the formula breaks off.");
    QTest::newRow("open fence") << QByteArray("\\left[ a")
                                << QByteArray("At 8, \"\": \"\\right\" is missing.");
    QTest::newRow("wrong end") << QByteArray("\\begin{pmatrix} a \\end{array}")
                               << QByteArray("At 29, \"\": another environment ends.");
    QTest::newRow("open table") << QByteArray("\\begin{pmatrix} a &")
                                << QByteArray("At 19, \"\": \"\\end\" is missing.");
  }
  void whatIsNotUnderstoodIsSaid() {
    QFETCH(QByteArray, tex);
    QFETCH(QByteArray, fault);
    QCOMPARE(QByteArray::fromStdString(readTex(tex.toStdString()).fault), fault);
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::TexReaderTest)
#include "test_tex_reader.moc"
