#include <QTest>

#include "core/teaching/work_check/work_check.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/train_sketch.h"

namespace geargraph {

/// The matrices and equations as the paper prints them, right and wrong, in the notations that people use.
class PaperCheckTest : public QObject {
  Q_OBJECT

  ExerciseSource m_robot{test::example("robot")};

  MatrixVerdict check(const char* text, std::optional<PaperMatrix> kind = {}) const {
    auto verdict = checkPaper(m_robot, text, kind);
    if (!verdict) {
      const Diagnostic& why = verdict.error().front();
      qWarning("%d:%d %s", why.line, why.column, why.message.c_str());
      return {};
    }
    return std::get<MatrixVerdict>(*verdict);
  }
  static QString firstMistake(const MatrixVerdict& verdict) {
    return verdict.differences.empty() ? QString() : QString::fromStdString(verdict.differences.front().name);
  }
  EquationVerdict equation(const char* text) const {
    auto verdict = checkPaper(m_robot, text);
    if (!verdict) {
      qWarning("%s", verdict.error().front().message.c_str());
      return {};
    }
    return std::get<std::vector<EquationVerdict>>(*verdict).front();
  }
  Diagnostic fault(const char* text, std::optional<PaperMatrix> kind = {}) const {
    const auto verdict = checkPaper(m_robot, text, kind);
    return verdict ? Diagnostic{} : verdict.error().front();
  }

 private slots:
  void eq05_inEveryNotation_isRecognised() {
    const char* const texts[] = {
        "C,8,9,10,11,12,13,14,15,16,17,18\nC15,1,0,-1,0,0,0,0,1,0,0,0\nC16,0,1,-1,0,-1,0,0,0,1,0,0\n"
        "C17,0,0,0,1,-1,-1,0,0,0,1,0\nC18,0,0,0,0,0,1,-1,0,0,0,1\n",
        "C = [1 0 -1 0 0 0 0 1 0 0 0; 0 1 -1 0 -1 0 0 0 1 0 0;\n0 0 0 1 -1 -1 0 0 0 1 0; 0 0 0 0 0 1 -1 0 0 "
        "0 1];",
        "\\begin{bmatrix} 1&0&-1&0&0&0&0&\\vdots&1&0&0&0\\\\0&1&-1&0&-1&0&0&\\vdots&0&1&0&0\\\\"
        "0&0&0&1&-1&-1&0&\\vdots&0&0&1&0\\\\0&0&0&0&0&1&-1&\\vdots&0&0&0&1\\end{bmatrix}",
        "1\t0\t\u22121\t0\t0\t0\t0\t1\t0\t0\t0\r\n0\t1\t\u22121\t0\t\u22121\t0\t0\t0\t1\t0\t0\r\n"
        "0\t0\t0\t1\t\u22121\t\u22121\t0\t0\t0\t1\t0\r\n0\t0\t0\t0\t0\t1\t\u22121\t0\t0\t0\t1\r\n",
        "np.array([[1, 0, -1, 0, 0, 0, 0, 1, 0, 0, 0],\n [0, 1, -1, 0, -1, 0, 0, 0, 1, 0, 0],\n"
        " [0, 0, 0, 1, -1, -1, 0, 0, 0, 1, 0], [0, 0, 0, 0, 0, 1, -1, 0, 0, 0, 1]])",
    };
    for (const char* text : texts) {
      const MatrixVerdict verdict = check(text);
      QVERIFY2(verdict.outcome == WorkOutcome::right, text);
      QVERIFY(verdict.isRecognised && verdict.kind == PaperMatrix::cycleBasis);
      QVERIFY(verdict.notes.empty());
      QCOMPARE(verdict.entries.size(), std::size_t{4});
      QCOMPARE(verdict.entries[1][2].derived, std::string("-1"));
    }
  }

  void eq05_rowsInAnotherOrder_cyclesTheOtherWay() {
    const MatrixVerdict verdict = check(
        "0 0 0 0 0 -1 1 0 0 0 -1\n1 0 -1 0 0 0 0 1 0 0 0\n0 1 -1 0 -1 0 0 0 1 0 0\n0 0 0 1 -1 -1 0 0 0 1 "
        "0\n");
    QVERIFY(verdict.outcome == WorkOutcome::right);
    QCOMPARE(verdict.notes.size(), std::size_t{2});
    QCOMPARE(verdict.rows.front().text, std::string("C18"));
  }

  void eq05_ofAnotherTree_isRight() {
    // Chords 8, 16, 17, 18: mesh 15 takes the place of joint 8 in the tree, and cycle C15 is the same.
    const MatrixVerdict same = check(
        "C = [1 0 -1 0 0 0 0 1 0 0 0; 0 1 -1 0 -1 0 0 0 1 0 0; 0 0 0 1 -1 -1 0 0 0 1 0; 0 0 0 0 0 1 -1 0 0 0 "
        "1]");
    QVERIFY(same.outcome == WorkOutcome::right);
    // C16 - C15: joint 10 becomes a chord and mesh 15 a branch.
    const MatrixVerdict other = check(
        "C = [1 0 -1 0 0 0 0 1 0 0 0; -1 1 0 0 -1 0 0 -1 1 0 0; 0 0 0 1 -1 -1 0 0 0 1 0; 0 0 0 0 0 1 -1 0 0 "
        "0 1]");
    QVERIFY(other.outcome == WorkOutcome::right);
    QVERIFY(other.notes.front().find("another spanning tree") != std::string::npos);
  }

  void eq05_mistakes_areNamed() {
    const struct {
      const char* text;
      const char* mistake;
      EntryPlace place;
    } cases[] = {
        {"C=[1 0 1 0 0 0 0 1 0 0 0;0 1 -1 0 -1 0 0 0 1 0 0;0 0 0 1 -1 -1 0 0 0 1 0;0 0 0 0 0 1 -1 0 0 0 1]",
         "walked-against-arrow",
         {0, 2}},
        {"C=[1 0 -1 0 0 0 0 1 0 0 0;0 1 -1 0 0 0 0 0 1 0 0;0 0 0 1 -1 -1 0 0 0 1 0;0 0 0 0 0 1 -1 0 0 0 1]",
         "joint-left-out",
         {1, 4}},
        {"C=[1 0 -1 0 0 0 0 1 0 0 0;0 1 -1 0 -1 0 0 0 1 0 0;0 0 0 1 -1 -1 1 0 0 1 0;0 0 0 0 0 1 -1 0 0 0 1]",
         "joint-off-the-walk",
         {2, 6}},
        {"C=[1 0 -1 0 0 0 0 1 0 0 0;0 1 -1 0 -1 0 0 0 0 0 0;0 0 0 1 -1 -1 0 0 0 1 0;0 0 0 0 0 1 -1 0 0 0 1]",
         "own-mesh-left-out",
         {1, 8}},
        {"C=[1 0 -1 0 0 0 0 1 0 0 0;0 1 -1 0 -1 0 0 0 1 1 0;0 0 0 1 -1 -1 0 0 0 1 0;0 0 0 0 0 1 -1 0 0 0 1]",
         "another-mesh-in-cycle",
         {1, 9}},
        {"C=[1 0 -1 0 0 0 0 1 0 0 0;0 2 -1 0 -1 0 0 0 1 0 0;0 0 0 1 -1 -1 0 0 0 1 0;0 0 0 0 0 1 -1 0 0 0 1]",
         "entry-not-a-sign",
         {1, 1}},
    };
    for (const auto& one : cases) {
      const MatrixVerdict verdict = check(one.text);
      QVERIFY2(verdict.outcome == WorkOutcome::wrong, one.text);
      QCOMPARE(firstMistake(verdict), QString(one.mistake));
      QCOMPARE(verdict.differences.size(), std::size_t{1});
      QVERIFY(verdict.differences.front().entries.front() == one.place);
      QVERIFY(!verdict.differences.front().elements.empty());
      QVERIFY(
          verdict.entries[static_cast<std::size_t>(one.place.row)][static_cast<std::size_t>(one.place.column)]
              .differs);
    }
  }

  void eq01_mistakesOfTheWhole() {
    const char* const rows[] = {"-1,-1,-1,0,0,0,0,0,0,0,0", "0,0,1,-1,-1,0,0,1,0,0,0",
                                "0,0,0,0,1,-1,-1,0,1,0,0",  "0,0,0,0,0,0,1,0,0,0,1",
                                "1,0,0,0,0,0,0,-1,0,0,0",   "0,1,0,0,0,0,0,0,-1,0,0",
                                "0,0,0,1,0,0,0,0,0,-1,0",   "0,0,0,0,0,1,0,0,0,1,-1"};
    std::string all;
    std::string exchanged;
    std::string plain;
    std::string reduced;
    for (const char* row : rows) {
      const QString line(row);
      all += line.toStdString() + '\n';
      exchanged += QString(line).replace("-1", "x").replace("1", "-1").replace("x", "1").toStdString() + '\n';
      plain += QString(line).remove('-').toStdString() + '\n';
      if (row != rows[0]) reduced += line.toStdString() + '\n';
    }
    QVERIFY(check(all.c_str()).outcome == WorkOutcome::right);
    QVERIFY(check(all.c_str()).kind == PaperMatrix::incidence);
    QVERIFY(check(reduced.c_str()).kind == PaperMatrix::reducedIncidence);
    QCOMPARE(firstMistake(check(exchanged.c_str())), QString("incidence-exchanged"));
    QCOMPARE(firstMistake(check(plain.c_str())), QString("signs-left-out"));
    QCOMPARE(firstMistake(check(all.c_str(), PaperMatrix::reducedIncidence)), QString("ground-row-left-in"));
    QCOMPARE(firstMistake(check(reduced.c_str(), PaperMatrix::incidence)), QString("ground-row-left-out"));
    QCOMPARE(firstMistake(check(reduced.c_str(), PaperMatrix::cycleBasis)), QString("another-matrix"));
    QCOMPARE(firstMistake(check("1 2\n3 4", PaperMatrix::cycleBasis)), QString("another-size"));
  }

  void eq24_anyMultipleOfARow_isRight() {
    const char* const texts[] = {
        "P = [-i15 0 -1 0 0 0 0; 0 i16 -i16 0 1 0 0; 0 0 0 i17 -i17 1 0; 0 0 0 0 0 -i18 1]",
        // (19) with (20) in pitch diameters, as printed: a row is a multiple of the other
        "P = [-d4/2 0 -d1/2 0 0 0 0; 0 d5/2 -d5/2 0 d2/2 0 0; 0 0 0 d6/2 -d6/2 d7'/2 0; 0 0 0 0 0 -d7''/2 "
        "d3/2]",
        "P = [18 0 36 0 0 0 0; 0 20 -20 0 30 0 0; 0 0 0 4/3 -4/3 1 0; 0 0 0 0 0 16 -24]",
        "\\begin{bmatrix}-i_{15}&0&0&\\vdots&-1&0&0&0\\\\0&+i_{16}&0&\\vdots&-i_{16}&+1&0&0\\\\"
        "0&0&+i_{17}&\\vdots&0&-i_{17}&+1&0\\\\0&0&0&\\vdots&0&0&-i_{18}&+1\\end{bmatrix}\\cdot"
        "\\begin{pmatrix}\\dot{\\theta}_8\\\\\\dot{\\theta}_9\\\\\\dot{\\theta}_{11}\\\\\\cdots\\\\\\dot{"
        "\\theta}_{10}"
        "\\\\\\dot{\\theta}_{12}\\\\\\dot{\\theta}_{13}\\\\\\dot{\\theta}_{14}\\end{pmatrix}=\\begin{pmatrix}"
        "0\\\\0\\\\0\\\\0\\end{pmatrix}",
    };
    for (const char* text : texts) {
      const MatrixVerdict verdict = check(text);
      QVERIFY2(verdict.outcome == WorkOutcome::right, text);
      QVERIFY(verdict.kind == PaperMatrix::coefficients);
    }
  }

  void eq24_mistakes_areNamed() {
    const struct {
      const char* text;
      const char* mistake;
    } cases[] = {
        {"P = [-1 0 -i15 0 0 0 0; 0 i16 -i16 0 1 0 0; 0 0 0 i17 -i17 1 0; 0 0 0 0 0 -i18 1]",
         "ratio-upside-down"},
        {"P = [-i15 0 1 0 0 0 0; 0 i16 -i16 0 1 0 0; 0 0 0 i17 -i17 1 0; 0 0 0 0 0 -i18 1]",
         "external-as-internal"},
        {"P = [-1 0 i15 0 0 0 0; 0 i16 -i16 0 1 0 0; 0 0 0 i17 -i17 1 0; 0 0 0 0 0 -i18 1]",
         "sign-and-ratio"},
        {"P = [-i15 0 -1 0 0 0 0; 0 i16 i16 0 1 0 0; 0 0 0 i17 -i17 1 0; 0 0 0 0 0 -i18 1]",
         "walked-against-arrow"},
        {"P = [1 0 -1 0 0 0 0; 0 1 -1 0 -1 0 0; 0 0 0 1 -1 -1 0; 0 0 0 0 0 1 -1]", "coefficients-left-out"},
        {"P = [-i15 0 -1 0 0 0 0; 0 i16 0 0 1 0 0; 0 0 0 i17 -i17 1 0; 0 0 0 0 0 -i18 1]", "joint-left-out"},
    };
    for (const auto& one : cases) {
      const MatrixVerdict verdict = check(one.text);
      QVERIFY2(verdict.outcome == WorkOutcome::wrong, one.text);
      QCOMPARE(firstMistake(verdict), QString(one.mistake));
    }
  }

  /// The paper says that (45) is the same as (25); its rows 3 and 4 are exchanged.
  void eq45_againstEq25_byJointNotByRowNumber() {
    const char* const rowsOf45 =
        "\\begin{bmatrix}-i_{15}&0&0\\\\-i_{16}i_{15}&-i_{16}&0\\\\-i_{18}i_{17}i_{16}i_{15}&-i_{18}i_{17}i_{"
        "16}&"
        "-i_{18}i_{17}\\\\-i_{17}i_{16}i_{15}&-i_{17}i_{16}&-i_{17}\\end{bmatrix}";
    const std::string labelled =
        std::string(
            "\\begin{pmatrix}\\omega_{10}\\\\\\omega_{21}\\\\\\omega_{32}\\\\\\omega_{72}\\end{pmatrix}=") +
        rowsOf45 + "\\cdot\\begin{pmatrix}\\omega_{40}\\\\\\omega_{50}\\\\\\omega_{61}\\end{pmatrix}";
    const MatrixVerdict right = check(labelled.c_str());
    QVERIFY(right.outcome == WorkOutcome::right);
    QVERIFY(right.kind == PaperMatrix::solution);
    QCOMPARE(right.notes.size(), std::size_t{1});
    QCOMPARE(right.notes.front(), std::string("Your rows are in another order: 10, 12, 14 and 13."));

    const MatrixVerdict unlabelled = check(rowsOf45);
    QVERIFY(unlabelled.outcome == WorkOutcome::right);
    QCOMPARE(unlabelled.notes.front(), std::string("Your rows are in another order: 10, 12, 14 and 13."));

    std::string with25 =
        "\\begin{pmatrix}\\dot\\theta_{10}\\\\\\dot\\theta_{12}\\\\\\dot\\theta_{13}\\\\\\dot\\theta_{14}"
        "\\end{pmatrix}=";
    with25 += rowsOf45;
    with25 += "\\begin{pmatrix}\\dot\\theta_8\\\\\\dot\\theta_9\\\\\\dot\\theta_{11}\\end{pmatrix}";
    const MatrixVerdict wrong = check(with25.c_str());
    QVERIFY(wrong.outcome == WorkOutcome::wrong);
    QCOMPARE(wrong.differences.size(), std::size_t{2});
    QCOMPARE(firstMistake(wrong), QString("another-output"));
    QCOMPARE(wrong.differences[0].reason, std::string("This is the row of joint 14, not of joint 13."));
    QCOMPARE(wrong.differences[1].reason, std::string("This is the row of joint 13, not of joint 14."));
    QCOMPARE(wrong.differences[0].entries.front().row, 2);
  }

  void eq43_inTheNamesOfTheTtGraph_isRight() {
    const MatrixVerdict verdict = check(
        ",w40,w50,w61\nw10,-n41,0,0\nw21,-n52*n41,-n52,0\nw32,-n73 n67 n52 n41,-n73 n67 n52,-n73 n67\n"
        "w72,-n67 n52/n14,-n67 n52,-1/n76\n");
    QVERIFY(verdict.outcome == WorkOutcome::right);
    QVERIFY(verdict.kind == PaperMatrix::solution);
  }

  void eq25_mistakes_areNamed() {
    const struct {
      const char* text;
      const char* mistake;
    } cases[] = {
        {"S = [i15 0 0; i16*i15 i16 0; i17*i16*i15 i17*i16 i17; i18*i17*i16*i15 i18*i17*i16 i18*i17]",
         "minus-left-out"},
        {"S = [-i15 0 0; i16*i15 i16 0; -i17*i16*i15 -i17*i16 -i17; -i18*i17*i16*i15 -i18*i17*i16 -i18*i17]",
         "mesh-sign"},
        {"S = [-1/i15 0 0; -i16*i15 -i16 0; -i17*i16*i15 -i17*i16 -i17; -i18*i17*i16*i15 -i18*i17*i16 "
         "-i18*i17]",
         "speed-inverted"},
        {"S = [-i15 0 0; -i16*i15 0 0; -i17*i16*i15 -i17*i16 -i17; -i18*i17*i16*i15 -i18*i17*i16 -i18*i17]",
         "input-ignored"},
        {"S = [-i15 0 -i17; -i16*i15 -i16 0; -i17*i16*i15 -i17*i16 -i17; -i18*i17*i16*i15 -i18*i17*i16 "
         "-i18*i17]",
         "input-without-effect"},
    };
    for (const auto& one : cases) {
      const MatrixVerdict verdict = check(one.text);
      QVERIFY2(verdict.outcome == WorkOutcome::wrong, one.text);
      QCOMPARE(firstMistake(verdict), QString(one.mistake));
    }
    const MatrixVerdict numbers =
        check("-1/2,0,0\n-1/3,-2/3,0\n-0.444,-8/9,-4/3\n-0.2963,-0.593,-8/9\n", PaperMatrix::solution);
    QVERIFY(numbers.outcome == WorkOutcome::right);
  }

  /// Rows whose ratios are equal for these teeth are told apart by their formulas.
  void rowsOfEqualRatiosInAnotherOrder_areFoundByTheirSymbols() {
    const ExerciseSource twins(test::TrainSketch(3)
                                   .joint(0, 1, "a")
                                   .joint(0, 2, "b")
                                   .joint(0, 3, "c")
                                   .mesh(1, 2, 20, 40, MeshKind::external)
                                   .mesh(1, 3, 20, 40, MeshKind::external)
                                   .inputs({{4, "1"}})
                                   .build());
    const auto verdict = checkPaper(twins, "S = [-i8; -i7]", PaperMatrix::solution);
    QVERIFY(verdict);
    const auto& solution = std::get<MatrixVerdict>(*verdict);
    QVERIFY(solution.outcome != WorkOutcome::wrong);
    QCOMPARE(solution.notes.front(), std::string("Your rows are in another order: 6 and 5."));
  }

  /// With these teeth i16 = i18 = 2/3.
  void aRatioOfAnotherMesh_isAMistakeThoughTheNumberIsRight() {
    const MatrixVerdict verdict = check(
        "S = [-i15 0 0; -i16*i15 -i18 0; -i17*i16*i15 -i17*i16 -i17; -i18*i17*i16*i15 -i18*i17*i16 "
        "-i18*i17]");
    QVERIFY(verdict.outcome == WorkOutcome::wrong);
    QCOMPARE(firstMistake(verdict), QString("another-ratio-symbol"));
    QVERIFY(verdict.differences.front().entries.front() == (EntryPlace{1, 1}));
    QVERIFY(check("S = [-1/2 0 0; -i16/2 -2/3 0; -N6/18*N5/30*i15 -8/9 -i17; -i18*i17*i16*i15 -i18*i17*i16 "
                  "-i18*i17]")
                .outcome == WorkOutcome::right);
    const EquationVerdict other = equation("w21 = -n73 w51");
    QVERIFY(!other.isRight);
    QCOMPARE(other.difference->name, std::string("another-ratio-symbol"));
    QVERIFY(equation("w21 = -N5/N2 w51").isRight);
  }

  void theSolutionForOtherInputs_isRight() {
    // Driven at 10, 9 and 11: θ8 = -θ10 / i15.
    const MatrixVerdict verdict = check(
        "\u03b8,10,9,11\n8,-1/"
        "i15,0,0\n12,i16,-i16,0\n13,i17*i16,-i17*i16,-i17\n14,i18*i17*i16,-i18*i17*i16,-i18*i17\n");
    QVERIFY(verdict.outcome == WorkOutcome::right);
    QCOMPARE(fault("\u03b8,8,10,11\n9,1,1,1\n12,1,1,1\n13,1,1,1\n14,1,1,1\n").message,
             std::string("These inputs depend on each other, so there is no solution for them."));
  }

  void eqs27to42_hold() {
    const char* const equations[] = {
        "\\omega'_{40} = -n_{14}\\omega'_{10}",
        "w51'' = -n25 w21''",
        "\u03c962''' = -n76 \u03c972'''",
        "w72'''' = n37 w32''''",
        "w51'' = w50 - w10",
        "w62''' = w61 - w21",
        "w40' = w40",
        "w10' = w10 = -1/n14 w40' = -n41 w40",
        "w21 = w21'' = -n52 w51'' = -n52 (w50 - w10) = -n52 n41 w40 - n52 w50",
        "w32 = n73 w72 = n73(-n67 w62''') = -n73 n67 (w61 - w21)",
        "w32 = n73 n67 w21 - n73 n67 w61 = -n73 n67 n52 n41 w40 - n73 n67 n52 w50 - n73 n67 w61",
        "w72 = n37 w32 = -n67 n52 n41 w40 - n67 n52 w50 - n67 w61",
        "theta10 = -i15 theta8",
        "N4 \u03b88 + N1 \u03b810 = 0*\u03b88",
        "-d4/2 \u03b88 - d1/2 \u03b810 = 0 w40",
        "\u03b813 = -0.444 \u03b88 - 8/9 \u03b89 - 1,33 \u03b811",
    };
    for (const char* text : equations) QVERIFY2(equation(text).isRight, text);
  }

  void equationsThatDoNotHold_areExplained() {
    const struct {
      const char* text;
      const char* mistake;
    } cases[] = {
        {"w40' = n14 w10'", "mesh-sign"},
        {"w40' = -n41 w10'", "ratio-upside-down"},
        {"w40' = n41 w10'", "sign-and-ratio"},
        {"w51'' = w50 + w10", "walked-against-arrow"},
        {"w51'' = w50", "term-left-out"},
        {"w51'' = w50 - w21", "another-velocity"},
        {"w21 = -n52 n41 w40 - n52 w50 - w61 - w72", "equation-does-not-hold"},
    };
    for (const auto& one : cases) {
      const EquationVerdict verdict = equation(one.text);
      QVERIFY2(!verdict.isRight && verdict.difference, one.text);
      QCOMPARE(QString::fromStdString(verdict.difference->name), QString(one.mistake));
      QVERIFY(!verdict.difference->elements.empty());
    }
  }

  void whatCannotBeRead_isBlamedAtItsPlace() {
    const struct {
      const char* text;
      int line;
      int column;
      const char* part;
    } cases[] = {
        {"", 1, 1, "no matrix"},
        {"1,0,-1\n0,1\n", 2, 1, "Row 2 has 2 entries"},
        {"1 0 0\n0 x 0\n", 2, 3, "cannot be read"},
        {"1 0 0\n0 i99 0\n", 2, 3, "no ratio i99"},
        {"[1 0; 0 1", 1, 1, "not closed"},
        {"a\n\\begin{pmatrix} 1 & 2", 2, 1, "\\end{pmatrix}"},
        {"5 0 3\n4 5 6\n7 8 9", 1, 1, "No matrix of this mechanism has the size 3"},
        {"w40 = -n14 w10\nw99 = w40", 2, 1, "names no links"},
        {"w40 = ", 1, 6, "empty"},
        {"w51 = w40 * w10", 1, 7, "multiplied by a velocity"},
        {"w30 = w10", 1, 1, "several directions"},
        {"1,234;0;0;0;0;0;0", 1, 1, "thousand"},
    };
    for (const auto& one : cases) {
      const Diagnostic why = fault(one.text);
      QVERIFY2(QString::fromStdString(why.message).contains(one.part),
               (std::string(one.text) + " -> " + why.message).c_str());
      QCOMPARE(why.line, one.line);
      QCOMPARE(why.column, one.column);
    }
    const Diagnostic label = fault(
        "T,8,9,10,11,12,13,14\nC15,1,0,-1,0,0,0,0\nC16,0,1,-1,0,-1,0,0\nC17,0,0,0,1,-1,-1,0\nC99,0,0,0,0,0,1,"
        "-1");
    QVERIFY(QString::fromStdString(label.message).contains("C99"));
    QCOMPARE(label.line, 5);
  }

  void aMechanismWithoutATree_hasItsErrors() {
    Mechanism loose = test::example("robot");
    loose.turningJoints.pop_back();
    const ExerciseSource source(loose);
    const auto verdict = checkPaper(source, "1 0\n0 1", PaperMatrix::path);
    QVERIFY(!verdict);
    QVERIFY(verdict.error().front().code == Code::disconnected);
  }

  void aMechanismWithInvalidInputs_isCheckedForTheNearestValidOnes() {
    Mechanism withOne = test::example("robot");
    withOne.inputs->resize(1);
    const ExerciseSource source(withOne);
    QVERIFY(source.matroid() != nullptr && !source.matroid()->solution);
    const auto equations = checkPaper(source, "w21 = -N5/N2 w51\nw21 = N5/N2 w51");
    QVERIFY(equations);
    const auto& verdicts = std::get<std::vector<EquationVerdict>>(*equations);
    QVERIFY(verdicts[0].isRight && !verdicts[1].isRight);
    const auto table = checkPaper(source, "1 0 0\n0 1 0\n0 0 1\n1 1 1");
    QVERIFY(table);
    QVERIFY(std::get<MatrixVerdict>(*table).kind == PaperMatrix::solution);
    QVERIFY(std::get<MatrixVerdict>(*table).outcome == WorkOutcome::wrong);
  }

  void anEquationForMeshesWithoutGeometry_hasTheErrorsOfTheMechanism() {
    Mechanism onOneLine = test::example("robot");
    for (Axis& axis : onOneLine.axes) {
      axis.point = onOneLine.axes.front().point;
      axis.direction = onOneLine.axes.front().direction;
    }
    const ExerciseSource source(onOneLine);
    QVERIFY(source.tree() != nullptr && source.matroid() == nullptr);
    const auto verdict = checkPaper(source, "w21 = -N5/N2 w51");
    QVERIFY(!verdict);
    QVERIFY(hasErrors(verdict.error()));
  }

  void everyMistakeHasATitle() {
    for (const MistakeName& mistake : paperMistakeNames())
      QCOMPARE(paperMistakeTitle(mistake.name), mistake.title);
    QCOMPARE(paperMistakeTitle("transposed"), mistakeTitle("transposed"));
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::PaperCheckTest)
#include "test_paper_check.moc"
