#include <QTest>
#include <fstream>
#include <map>

#include "core/mechanism/graph/matrices.h"
#include "core/mechanism/graph/paper_equation.h"

namespace geargraph {
namespace {

/// By number: what the paper prints beside it.
std::map<int, std::string> printedEquations() {
  std::ifstream file(GEARGRAPH_NUMBERED_EQUATIONS);
  std::map<int, std::string> printed;
  std::string line;
  std::getline(file, line);  // says what the file is
  while (std::getline(file, line)) {
    const std::size_t tab = line.find('\t');
    printed.emplace(std::stoi(line.substr(0, tab)), line.substr(tab + 1));
  }
  return printed;
}

struct PrintedPart {
  PaperEquation equation;
  const char* part;  ///< of the equation as printed, and of no other
};

const std::vector<PrintedPart>& printedParts() {
  static const std::vector<PrintedPart> parts = {
      {PaperEquation::incidenceMatrix, R"(\Gamma^0 =)"},
      {PaperEquation::reducedIncidenceMatrix, R"(\Gamma = \begin{bmatrix} G & \vdots & G^*)"},
      {PaperEquation::pathMatrix, R"(Z =)"},
      {PaperEquation::spanningTreeMatrix, R"(\mathbf{T} = \mathbf{G}^{*T} \cdot \mathbf{Z}^{T})"},
      {PaperEquation::cycleBasisMatrix, R"(\mathbf{C} = [\mathbf{T})"},
      {PaperEquation::screw, R"(\hat{\mathbf{u}}_{c,k}^{0} =)"},
      {PaperEquation::jointDirection, R"(\mathbf{u}_{k}^{0} = \mathbf{D}_{0,k})"},
      {PaperEquation::offsetRotation, R"(\mathbf{D}_{0,k} =)"},
      {PaperEquation::directionComponents, R"(L_k = 0)"},
      {PaperEquation::moment, R"(\mathbf{r}_{c,k}^0 =)"},
      {PaperEquation::offsetVector, R"((x_k - x_c)"},
      {PaperEquation::momentComponents, R"(P_{c,k} = z_{c,k})"},
      {PaperEquation::twist, R"(\hat{\mathbf{s}}_k^0 = \hat{\mathbf{u}}_{c,k}^0)"},
      {PaperEquation::twistSums, R"([\mathbf{C} \circ \hat{\mathbf{s}}_k^0] =)"},
      {PaperEquation::meshVelocities, R"(\dot{\boldsymbol{\theta}}_c =)"},
      {PaperEquation::momentSums, R"(\mathbf{T} \circ \mathbf{r}_{c,t}^{0})"},
      {PaperEquation::meshEquations, R"(\left[ \mathbf{P}_{c,t} \right] \cdot)"},
      {PaperEquation::coefficientMatrix, R"(\mathbf{P}_{c,t} = \left[ \mathbf{T} \circ P_{c,t})"},
      {PaperEquation::coefficientsInNumbers, R"(P_{15,8})"},
      {PaperEquation::gearRatios, R"(i_{15} = \frac{d_4}{d_1})"},
      {PaperEquation::freedom, R"(E = t - r)"},
      {PaperEquation::partedEquations, R"(\mathbf{P}_{r,E} & \vdots & \mathbf{P}_{r,r})"},
      {PaperEquation::solutionByInverse, R"(= -\left[\mathbf{P}_r\right]^{-1})"},
      {PaperEquation::equationsInRatios, R"(-i_{15} & 0 & 0 & \vdots & -1)"},
      {PaperEquation::matroidSolution, R"(\dot{\theta}_{14} \end{pmatrix} = \begin{bmatrix} -i_{15})"},
      {PaperEquation::gearRelation, R"(M'_{23})"},
      {PaperEquation::terminal41, R"((4,1)(0):)"},
      {PaperEquation::terminal52, R"((5,2)(1):)"},
      {PaperEquation::terminal67, R"((6,7)(2):)"},
      {PaperEquation::terminal73, R"((7,3)(2):)"},
      {PaperEquation::circuit51, R"(\omega_{51}'' = \omega_{50})"},
      {PaperEquation::circuit62, R"(\omega_{62}''' = \omega_{61})"},
      {PaperEquation::circuit40, R"(\omega_{40}' = \omega_{40})"},
      {PaperEquation::circuit10, R"(\omega_{10}' = \omega_{10})"},
      {PaperEquation::circuit21, R"(\omega_{21}'' = \omega_{21})"},
      {PaperEquation::circuit72, R"(\omega_{72}''' = \omega_{72})"},
      {PaperEquation::secondCircuit72, R"(\omega_{72}'''' = \omega_{72})"},
      {PaperEquation::circuit32, R"(\omega_{32}'''' = \omega_{32})"},
      {PaperEquation::velocity10, R"(\omega'_{10} = \omega_{10} = -1/n_{14})"},
      {PaperEquation::velocity21, R"(\omega_{21} = \omega''_{21} =)"},
      {PaperEquation::velocity32, R"(\omega_{32} = n_{73}n_{67}\omega_{21})"},
      {PaperEquation::velocity72, R"(\omega_{72} = n_{37}\omega_{32})"},
      {PaperEquation::ttSolution, R"(-n_{41} & 0 & 0)"},
      {PaperEquation::ratioNames, R"(n_{41} = i_{15})"},
      {PaperEquation::ttSolutionInGearRatios, R"(\omega_{72} \end{pmatrix} = \begin{bmatrix} -i_{15})"},
  };
  return parts;
}

}  // namespace

/// The one table of the paper's numbers against the paper.
class PaperEquationsTest : public QObject {
  Q_OBJECT

 private slots:
  void everyNameHasTheNumberOfItsEquation() {
    const std::map<int, std::string> printed = printedEquations();
    QCOMPARE(printed.size(), std::size_t{kPaperEquations});
    QCOMPARE(printedParts().size(), std::size_t{kPaperEquations});
    for (const PrintedPart& each : printedParts()) {
      for (const auto& [number, text] : printed) {
        QVERIFY2((text.find(each.part) != std::string::npos) == (number == numberOf(each.equation)),
                 (std::to_string(number) + ": " + each.part).c_str());
      }
    }
  }

  void matricesCiteIt() {
    std::vector<int> numbers;
    for (const MatrixKind kind : allMatrixKinds()) numbers.push_back(numberOf(matrixEquation(kind)));
    QCOMPARE(numbers, (std::vector<int>{1, 2, 3, 4, 5, 0}));
    QCOMPARE(cited(PaperEquation::cycleBasisMatrix), std::string("(5)"));
    QCOMPARE(cited(PaperEquation::none), std::string());
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::PaperEquationsTest)
#include "test_paper_equations.moc"
