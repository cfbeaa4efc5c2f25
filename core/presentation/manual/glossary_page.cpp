#include "core/presentation/manual/glossary_page.h"

#include <algorithm>
#include <cctype>

#include "core/foundations/base/contract.h"
#include "core/presentation/manual/manual.h"
#include "core/presentation/manual/markdown.h"
#include "core/teaching/derivation/named_results.h"
#include "core/teaching/derivation/result_text.h"
#include "core/teaching/lessons/course.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph {
namespace {

constexpr const char* kShownExample = "planetary-ring-held";  // of matrices: small enough for a line

/// The matrix of the digraph that the term names, or null.
const NamedResult* matrixOf(Term term) {
  for (const NamedResult* result : namedResults())
    if (result->of == ResultOf::graph && result->term == term) return result;
  return nullptr;
}

/// The numbered equations of [AU] that the glossary names. Those that are matrices of the paper's robot are
/// given as the rule that makes them.
std::string equationTex(PaperEquation equation) {
  switch (equation) {
    case PaperEquation::incidenceMatrix:
      return "\\Gamma^0_{ie} = 1 , \\quad \\Gamma^0_{je} = -1 , \\quad e = (j, i)";
    case PaperEquation::reducedIncidenceMatrix:
      return "\\Gamma = [\\, G \\mid G^* \\,]";
    case PaperEquation::pathMatrix:
      return "Z = -G^{-1}";
    case PaperEquation::spanningTreeMatrix:
      return "T = G^{*T} Z^T";
    case PaperEquation::cycleBasisMatrix:
      return "C = [\\, T \\mid U \\,]";
    case PaperEquation::screw:
      return "\\hat{u}_{c,k} = \\begin{pmatrix} L_k & M_k & N_k & P_{c,k} & Q_{c,k} & R_{c,k} "
             "\\end{pmatrix}^T";
    case PaperEquation::jointDirection:
      return "u_k = D_{0,k} \\, u";
    case PaperEquation::offsetVector:
      return "\\ell_{c,k} = \\begin{pmatrix} x_k - x_c & y_k - y_c & z_k - z_c \\end{pmatrix}^T";
    case PaperEquation::coefficientMatrix:
      return "P = [\\, T \\circ P_{c,t} \\,]";
    case PaperEquation::gearRatios:
      return "i_{15} = \\frac{d_4}{d_1} = \\frac{N_4}{N_1}";
    case PaperEquation::freedom:
      return "E = t - r";
    case PaperEquation::solutionByInverse:
      return "\\dot{\\theta}_r = -P_r^{-1} P_E \\, \\dot{\\theta}_E";
    case PaperEquation::gearRelation:
      return "\\omega_{ik} = \\pm \\frac{N_j}{N_i} \\, \\omega_{jk}";
    case PaperEquation::circuit51:
      return "\\omega_{51}'' = \\omega_{50} - \\omega_{10}";
    default:
      return {};
  }
}

std::string matrixParagraph(const NamedResult& matrix) {
  const SnapshotPtr snapshot = analyzeLive(*bundledExample(kShownExample));
  std::string tex = resultText(*exactTable(matrix, {snapshot}), TableFormat::latex);
  std::replace(tex.begin(), tex.end(), '\n', ' ');
  return "For the planetary train with sun 1, carrier 2 and planet 3:\n\n$$" + tex + "$$\n\n";
}

std::string termMarkdown(const Definition& definition) {
  const std::string name = escapedMarkdown(definition.name);
  std::string text = "## " + name + "\n\n";
  if (!definition.symbol.empty()) text += "**" + escapedMarkdown(definition.symbol) + "**   ";
  text += escapedMarkdown(definition.text) + "\n\n";
  text += "![" + name + "](picture:" + std::string(pictureOf(definition.term)) + ")\n\n";
  if (const std::string formula = formulaOfTerm(definition.term); !formula.empty()) {
    text += "$$" + formula + "$$\n\nEquation " + cited(definition.equation) + " of the paper.\n\n";
  }
  if (const NamedResult* matrix = matrixOf(definition.term)) text += matrixParagraph(*matrix);
  const Lesson* lesson = lessonAbout(definition.term);
  if (lesson == nullptr) return text + "No lesson is about it.\n\n";
  return text + "Lesson: [" + escapedMarkdown(lesson->title) + "](lesson:" + lesson->id + ")\n\n";
}

}  // namespace

const Lesson* lessonAbout(Term term) {
  const std::string name(definitionOf(term).name);
  for (const Lesson& lesson : course())
    if (std::find(lesson.terms.begin(), lesson.terms.end(), name) != lesson.terms.end()) return &lesson;
  return nullptr;
}

std::string formulaOfTerm(Term term) {
  return equationTex(definitionOf(term).equation);
}

std::string_view pictureOf(Term term) {
  switch (term) {
    case Term::movingLinks:
      return "digraph/robot/links";
    case Term::turningJoints:
    case Term::spanningTree:
    case Term::degreesOfFreedom:
      return "digraph/robot/joints";
    case Term::gearMeshes:
    case Term::rank:
    case Term::coefficientMatrix:
      return "digraph/robot/meshes";
    case Term::incidenceMatrix:
    case Term::reducedIncidenceMatrix:
      return "digraph/planetary-ring-held/link.3+joint.6+mesh.7+mesh.8";
    case Term::pathMatrix:
      return "digraph/planetary-ring-held/link.3+joint.6+joint.5+link.0";
    case Term::spanningTreeMatrix:
    case Term::cycleBasisMatrix:
      return "digraph/planetary-ring-held/cycle.7";
    case Term::cutsetMatrix:
      return "digraph/planetary-ring-held/joint.6+mesh.7+mesh.8";
    case Term::digraph:
    case Term::label:
      return "digraph/robot";
    case Term::functionalSchematic:
      return "schematic/robot";
    case Term::link:
      return "digraph/robot/link.4";
    case Term::ground:
      return "digraph/robot/link.0";
    case Term::turningJoint:
      return "digraph/robot/joint.12";
    case Term::gearMesh:
      return "digraph/robot/mesh.16";
    case Term::input:
    case Term::solution:
      return "digraph/robot/joint.8+joint.9+joint.11";
    case Term::axis:
    case Term::axisPoint:
    case Term::axisDirection:
    case Term::jointLimits:
      return "schematic/robot/joint.8";
    case Term::offset:
      return "schematic/spur-pair/joint.3";
    case Term::teeth:
    case Term::module:
    case Term::gearRatio:
    case Term::pitchPoint:
      return "schematic/spur-pair/mesh.5";
    case Term::helixAngle:
      return "schematic/helical-reverted-train/mesh.7";
    case Term::meshKind:
      return "schematic/planetary-ring-held/mesh.8";
    case Term::cycle:
      return "digraph/robot/cycle.16";
    case Term::screw:
      return "schematic/robot/mesh.15+joint.8";
    case Term::ttGraph:
    case Term::level:
      return "ttgraph/robot";
    case Term::transferVertex:
      return "ttgraph/robot/link.1";
    case Term::chord:
    case Term::ttCutsetMatrix:
    case Term::terminalEquation:
      return "ttgraph/robot/mesh.16";
    case Term::fundamentalCircuit:
    case Term::ttCircuitMatrix:
      return "ttgraph/robot/cycle.16";
  }
  GEARGRAPH_REQUIRE(false);
}

std::string glossaryMarkdown() {
  std::vector<Definition> terms = glossary();
  const auto key = [](const Definition& definition) {
    std::string name(definition.name);
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return name;
  };
  std::sort(terms.begin(), terms.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
  std::string text =
      "# Glossary\n\nEvery technical term that the program shows: what it means, a drawing of it, the "
      "paper's "
      "equation where it has one, and the lesson that teaches it. **Learn > Look up a term** finds a term by "
      "its name or symbol.\n\n";
  for (const Definition& definition : terms) text += termMarkdown(definition);
  return text;
}

std::string courseMarkdown() {
  std::string text;
  int number = 0;
  for (const Lesson& lesson : course()) {
    text += std::to_string(++number) + ". [" + escapedMarkdown(lesson.title) + "](lesson:" + lesson.id +
            "), " + std::to_string(lesson.minutes) + " minutes: afterwards you can " +
            escapedMarkdown(lesson.goal) + ".\n";
  }
  return text;
}

}  // namespace geargraph
