// The T-T graph: levels and carriers, terminal equations, fundamental circuits.

#include <algorithm>
#include <set>

#include "core/mechanism/graph/spanning_tree.h"
#include "core/teaching/exercises/exercise_entry.h"
#include "core/teaching/exercises/pair_teaching.h"
#include "core/teaching/exercises/question_builder.h"
#include "core/teaching/exercises/question_facts.h"
#include "core/theory/ttgraph/notation.h"

namespace geargraph {
namespace {

constexpr int kMaxBranches = 12;

std::vector<std::string> linkLabels(const ExerciseSource& source) {
  std::vector<std::string> labels;
  for (LinkOrdinal node = 0; node < source.graph().nodeCount(); ++node)
    labels.push_back(source.linkLabel(node));
  return labels;
}

/// The nodes of the path between both gears, the gears included.
std::vector<int> pathNodes(const ExerciseSource& source, const DigraphEdge& gears) {
  std::vector<int> nodes{gears.tail};
  for (const PathStep& step : treePath(*source.tree(), gears.tail, gears.head)) {
    const DigraphEdge& joint = source.graph().turningEdge(step.joint);
    nodes.push_back(joint.tail == nodes.back() ? joint.head : joint.tail);
  }
  return nodes;
}

/// What is mistaken about a carrier in field `field`.
void addCarrierMistakes(const ExerciseSource& source, QuestionBuilder& build, MeshOrdinal mesh, int field,
                        LinkOrdinal carrier) {
  const DigraphEdge& gears = source.graph().meshEdge(mesh);
  const std::vector<int> path = pathNodes(source, gears);
  const std::string right = source.linkLabel(carrier);
  for (const int gear : {gears.tail, gears.head}) {
    build.wrongField(
        "gear-as-carrier", field, {source.linkLabel(gear)},
        translated("Link %1 is a gear of mesh %2, not its carrier: the level changes at link %3.",
                   {source.linkLabel(gear), source.meshLabel(mesh), right}),
        {source.linkId(gear), source.linkId(carrier)});
  }
  for (LinkOrdinal node = 0; node < source.graph().nodeCount(); ++node) {
    if (node == carrier || node == gears.tail || node == gears.head) continue;
    const bool isOnPath = std::find(path.begin(), path.end(), node) != path.end();
    const char* const name = node == 0  ? "ground-as-carrier"
                             : isOnPath ? "wrong-level"
                                        : "carrier-off-the-path";
    const std::string why =
        node == 0 ? translated("You measure from the ground, but the level changes at link %1.", {right})
        : isOnPath
            ? translated("Both edges of the path at link %1 are on one level: the level changes at link %2.",
                         {source.linkLabel(node), right})
            : translated("Link %1 is not on the path between both gears: the level changes at link %2.",
                         {source.linkLabel(node), right});
    build.wrongField(name, field, {source.linkLabel(node)}, why,
                     {source.linkId(node), source.linkId(carrier)});
  }
}

std::vector<int> coefficientsOf(const ExerciseSource& source, std::span<const CircuitTerm> terms) {
  ByJoint<int> row(static_cast<std::size_t>(source.graph().t()), 0);
  for (const CircuitTerm& term : terms) row[term.joint] = term.coefficient;
  return row;
}

std::vector<std::string> picked(const std::vector<int>& row, const std::vector<int>& joints) {
  std::vector<int> some;
  for (const JointOrdinal joint : joints) some.push_back(row[static_cast<std::size_t>(joint)]);
  return asTexts(some);
}

Question levelsQuestion(const ExerciseSource& source, ExerciseRandom& random) {
  const TtGraph& graph = *source.ttGraph();
  const MeshOrdinal mesh = random.below(source.graph().c());
  const DigraphEdge& gears = source.graph().meshEdge(mesh);
  const TransferVertex vertex = *graph.transferVertices().ofMesh[mesh];
  const AxisLevels& levels = graph.levels();
  const std::string tail = source.linkLabel(gears.tail);
  const std::string head = source.linkLabel(gears.head);
  const std::string carrier = source.linkLabel(vertex.carrier);
  const std::string tailLevel = levels.name(vertex.tailLevel);
  const std::string headLevel = levels.name(vertex.headLevel);
  QuestionBuilder build(ExerciseKind::levels, 3);
  build.question.prompt = translated(
      "Walk from link $%1$ through the tree branches to link $%2$, the gears of mesh $%3$. On which levels "
      "do both gears turn in their carrier, and which link is the transfer vertex?",
      {tail, head, source.meshLabel(mesh)});
  build.question.elements = {source.meshId(mesh)};
  build.question.rule = translated(
      "The walk begins on level %1 and ends on level %2; the link where the level changes, %3, is the "
      "transfer vertex: the carrier of the mesh.",
      {tailLevel, headLevel, carrier});
  std::vector<std::string> names;
  for (int level = 0; level < levels.count(); ++level) names.push_back(levels.name(level));
  build.field("level of link " + tail, FieldKind::choice, names, {source.linkId(gears.tail)});
  build.titled(translated("level of link %1", {tail}));
  build.field("level of link " + head, FieldKind::choice, names, {source.linkId(gears.head)});
  build.titled(translated("level of link %1", {head}));
  build.field(toTranslate("transfer vertex"), FieldKind::choice, linkLabels(source));
  build.accept({tailLevel, headLevel, carrier});
  build.wrongFields("levels-exchanged", {0, 1}, {{headLevel, tailLevel}},
                    translated("You exchange the levels: link %1 turns on level %2, link %3 on level %4.",
                               {tail, tailLevel, head, headLevel}),
                    {source.linkId(gears.tail), source.linkId(gears.head)});
  addCarrierMistakes(source, build, mesh, 2, vertex.carrier);
  for (const int field : {0, 1}) {
    const std::string& right = field == 0 ? tailLevel : headLevel;
    const std::string& other = field == 0 ? headLevel : tailLevel;
    build.wrongField(
        "levels-exchanged", field, {other},
        translated("Level %1 is that of the other gear: this one turns on level %2.", {other, right}),
        {source.linkId(field == 0 ? gears.tail : gears.head)});
    if (levels.count() == 2) continue;
    build.wrongIf(
        "level-off-the-path", {{Test::differs, {field}, {{right}, {other}}}},
        translated("The walk between both gears uses the levels %1 and %2 only.", {tailLevel, headLevel}),
        {source.linkId(field == 0 ? gears.tail : gears.head)}, {field});
  }
  return std::move(build.question);
}

Question terminalEquationQuestion(const ExerciseSource& source, ExerciseRandom& random) {
  const MeshOrdinal mesh = random.below(source.graph().c());
  const TerminalPair& pair = *source.ttGraph()->terminal(mesh);
  const std::string label = source.meshLabel(mesh);
  const std::string tail = source.linkLabel(pair.tail);
  const std::string head = source.linkLabel(pair.head);
  const std::string comma = source.graph().n() > 9 ? "," : "";
  const Rational factor(pair.sign * pair.headTeeth, pair.tailTeeth);
  QuestionBuilder build(ExerciseKind::terminalEquation, 4);
  build.question.prompt = translated(
      "Write the terminal equation of mesh $%1$, with $N_{%2} = %3$ and $N_{%4} = %5$ teeth: the carrier "
      "$k$, and the factor $f$ with its sign.",
      {label, tail, asText(pair.tailTeeth), head, asText(pair.headTeeth)});
  build.question.formula = "\\omega_{" + tail + comma + "k} = f \\, \\omega_{" + head + comma + "k}";
  build.question.elements = {source.meshId(mesh)};
  const PairTeaching& teaching = pairTeaching(source.meshKind(mesh));
  const bool isSame = pair.sign > 0;
  const std::string right = inWords(factor);
  build.question.rule = isSame ? translated(
                                     "Seen from carrier %1, the gears of mesh %2 turn the same way, each "
                                     "along its own axis: f = %3.",
                                     {source.linkLabel(pair.carrier), label, right})
                               : translated(
                                     "Seen from carrier %1, the gears of mesh %2 turn against each other, "
                                     "each along its own axis: f = %3.",
                                     {source.linkLabel(pair.carrier), label, right});
  const std::string why = filled(
      translated(std::string_view(isSame ? teaching.sameWay : teaching.againstEachOther)), {label, right});
  build.field("k", FieldKind::choice, linkLabels(source));
  build.field("f", FieldKind::number, {}, {source.meshId(mesh)});
  build.accept({source.linkLabel(pair.carrier), factor.toString()});

  const std::vector<ElementId> elements{source.meshId(mesh)};
  build.wrongField(teaching.signMistake, 1, {(-factor).toString()}, why, elements);
  build.wrongField(
      "ratio-upside-down", 1, {factor.inverse().toString()},
      translated("Your ratio is upside down: the gear with more teeth turns more slowly, f = %1.",
                 {inWords(factor)}),
      elements);
  build.wrongField(
      "sign-and-ratio", 1, {(-factor.inverse()).toString()},
      translated("Your ratio is upside down, and the sign is wrong, too: f = %1.", {inWords(factor)}),
      elements);
  std::set<Rational> others;
  for (int other = 0; other < source.graph().c(); ++other) {
    const TerminalPair& next = *source.ttGraph()->terminal(other);
    for (const auto& [link, teeth] :
         {std::pair(next.tail, next.tailTeeth), std::pair(next.head, next.headTeeth)}) {
      if (other == mesh) continue;
      if (link == pair.tail && teeth != pair.tailTeeth)
        others.insert(Rational(pair.sign * pair.headTeeth, teeth));
      if (link == pair.head && teeth != pair.headTeeth)
        others.insert(Rational(pair.sign * teeth, pair.tailTeeth));
    }
  }
  for (const Rational& other : others) {
    const bool isUsed =
        other == factor || other == -factor || other == factor.inverse() || other == -factor.inverse();
    if (isUsed) continue;
    build.wrongField(
        "teeth-of-another-wheel", 1, {other.toString()},
        translated("You take the teeth of another wheel on the same link: mesh %1 has %2 and %3.",
                   {label, asText(pair.tailTeeth), asText(pair.headTeeth)}),
        elements);
  }
  addCarrierMistakes(source, build, mesh, 0, pair.carrier);
  return std::move(build.question);
}

Question fundamentalCircuitQuestion(const ExerciseSource& source, ExerciseRandom& random) {
  const TtGraph& graph = *source.ttGraph();
  const MeshOrdinal mesh = random.below(source.graph().c());
  const bool isTail = random.below(2) == 0;
  const TerminalPair& pair = *graph.terminal(mesh);
  const int gear = isTail ? pair.tail : pair.head;
  const ByJoint<int> row = coefficientsOf(source, isTail ? graph.tailCircuit(mesh) : graph.headCircuit(mesh));
  const std::vector<int> other =
      coefficientsOf(source, isTail ? graph.headCircuit(mesh) : graph.tailCircuit(mesh));
  std::vector<int> toGround(row.size());
  std::vector<int> whole(row.size());
  std::vector<int> joints;
  std::vector<int> rest;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const auto joint = static_cast<int>(i);
    toGround[i] = -source.tree()->pathEntry(joint, gear);
    whole[i] = row[i] - other[i];
    (row[i] != 0 || other[i] != 0 || toGround[i] != 0 ? joints : rest).push_back(joint);
  }
  for (const JointOrdinal joint :
       random.someOf(rest, std::max(0, kMaxBranches - static_cast<int>(joints.size()))))
    joints.push_back(joint);
  std::sort(joints.begin(), joints.end());

  const std::string comma = source.graph().n() > 9 ? "," : "";
  const std::string chord = source.linkLabel(gear) + comma + source.linkLabel(pair.carrier);
  QuestionBuilder build(ExerciseKind::fundamentalCircuit, 3);
  build.question.prompt = translated(
      "Write the f-circuit equation of the chord between gear $%1$ and carrier $%2$: the coefficients of the "
      "branches.",
      {source.linkLabel(gear), source.linkLabel(pair.carrier)});
  build.question.elements = {source.meshId(mesh), source.linkId(gear), source.linkId(pair.carrier)};
  build.question.rule = translated(
      "The speed of gear %1 in carrier %2 is the sum over the branches between them: 1 for a branch that "
      "points to the gear, −1 for one that points to the carrier, as their axes do.",
      {source.linkLabel(gear), source.linkLabel(pair.carrier)});
  std::vector<std::string> columns;
  std::string sum;
  for (const JointOrdinal joint : joints) {
    columns.push_back(source.edgeLabel(joint));
    sum += (sum.empty() ? "" : " + ") +
           ("a_{" + columns.back() + "} \\, \\dot{\\theta}_{" + columns.back() + "}");
  }
  build.question.formula = "\\omega_{" + chord + "} = " + sum;
  build.table({"a"}, columns, FieldKind::integer);
  for (std::size_t i = 0; i < joints.size(); ++i)
    build.question.fields[i].elements = {source.edgeId(joints[i])};
  build.accept(picked(row, joints));
  build.wrong(
      "chord-backwards", picked(negated(row), joints),
      translated("You write the speed of the carrier relative to the gear: all signs are the opposite."),
      {source.linkId(gear), source.linkId(pair.carrier)});
  build.wrong("another-chord", picked(other, joints),
              translated("This is the circuit of the other chord of mesh %1, of gear %2.",
                         {source.meshLabel(mesh), source.linkLabel(isTail ? pair.head : pair.tail)}),
              {source.linkId(isTail ? pair.head : pair.tail)});
  build.wrong("circuit-to-ground", picked(toGround, joints),
              translated("You write the speed relative to the ground: the chord ends at carrier %1.",
                         {source.linkLabel(pair.carrier)}),
              {source.linkId(pair.carrier), source.linkId(0)});
  build.wrong("whole-walk", picked(whole, joints),
              translated("You follow the walk from gear to gear: the chord ends at carrier %1.",
                         {source.linkLabel(pair.carrier)}),
              {source.linkId(pair.carrier)});
  build.wrong("whole-walk", picked(negated(whole), joints),
              translated("You follow the walk from gear to gear: the chord ends at carrier %1.",
                         {source.linkLabel(pair.carrier)}),
              {source.linkId(pair.carrier)});
  build.wrong(
      "signs-left-out", picked(magnitudes(row), joints),
      translated("You give all branches one sign: one that points from the gear to the carrier counts −1."));
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const auto field = static_cast<int>(i);
    const int value = row[joints[i]];
    const std::vector<ElementId> elements{source.edgeId(joints[i])};
    const std::string name = edgeName(source, joints[i]);
    if (value == 0) {
      build.wrongField("joint-off-the-walk", field, {"1", "-1"},
                       translated("The branches between gear %1 and carrier %2 do not include %3: 0.",
                                  {source.linkLabel(gear), source.linkLabel(pair.carrier), name}),
                       elements);
      continue;
    }
    build.wrongField("walked-against-arrow", field, {asText(-value)},
                     translated("The sign of %1 is the opposite on the way from the carrier to the gear: %2.",
                                {name, inWords(value)}),
                     elements);
    build.wrongField("joint-left-out", field, {"0"},
                     translated("The circuit closes through %1: %2, not 0.", {name, inWords(value)}),
                     elements);
  }
  build.wrongNonSigns();
  return std::move(build.question);
}

}  // namespace

ExerciseEntry levelsEntry() {
  return {.kind = ExerciseKind::levels,
          .name = "levels",
          .title = toTranslate("Levels and transfer vertex"),
          .hint = toTranslate(
              "The level of a joint is the letter of its axis. Name the axis of each joint on the walk: "
              "where the letter changes is the transfer vertex."),
          .view = LessonView::schematic,
          .lack = withoutEquations,
          .make = levelsQuestion};
}

ExerciseEntry terminalEquationEntry() {
  return {.kind = ExerciseKind::terminalEquation,
          .name = "terminal",
          .title = toTranslate("Terminal equation, sign"),
          .hint = toTranslate(
              "The carrier is the link where the level changes on the way between both gears. The gear "
              "with fewer teeth turns faster; for the sign, look at each gear along its own axis."),
          .view = LessonView::schematic,
          .lack = withoutEquations,
          .make = terminalEquationQuestion};
}

ExerciseEntry fundamentalCircuitEntry() {
  return {.kind = ExerciseKind::fundamentalCircuit,
          .name = "f-circuit",
          .title = toTranslate("f-circuit equation"),
          .hint = toTranslate(
              "Walk from the carrier to the gear along turning joints: only these joints count. Compare "
              "their arrows with your direction."),
          .view = LessonView::schematic,
          .lack = withoutEquations,
          .make = fundamentalCircuitQuestion};
}

}  // namespace geargraph
