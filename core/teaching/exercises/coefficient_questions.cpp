// A row of the coefficient matrix P.

#include <algorithm>

#include "core/teaching/exercises/exercise_entry.h"
#include "core/teaching/exercises/pair_teaching.h"
#include "core/teaching/exercises/question_builder.h"
#include "core/teaching/exercises/question_facts.h"

namespace geargraph {
namespace {

constexpr int kMaxCoefficients = 12;

std::vector<std::string> picked(const std::vector<Rational>& row, const std::vector<int>& joints) {
  std::vector<Rational> some;
  for (const JointOrdinal joint : joints) some.push_back(row[static_cast<std::size_t>(joint)]);
  return asTexts(some);
}

Question coefficientQuestion(const ExerciseSource& source, ExerciseRandom& random) {
  const Digraph& graph = source.graph();
  const MeshOrdinal mesh = random.below(graph.c());
  const std::string label = source.meshLabel(mesh);
  const GearMesh& gears = source.mechanism().gearMeshes[mesh];
  const ByJoint<Rational> row = source.teethRow(mesh);
  std::vector<int> joints;
  std::vector<int> others;
  for (JointOrdinal joint = 0; joint < graph.t(); ++joint)
    (row[joint].isZero() ? others : joints).push_back(joint);
  for (const JointOrdinal joint :
       random.someOf(others, std::max(0, kMaxCoefficients - static_cast<int>(joints.size()))))
    joints.push_back(joint);
  std::sort(joints.begin(), joints.end());

  QuestionBuilder build(ExerciseKind::coefficients, 5);
  build.question.prompt = translated(
      "Write the row of mesh $%1$ of the coefficient matrix $P$. Mesh $%1$ has $%2$ teeth on link $%3$ and "
      "$%4$ on link $%5$. Any multiple of the row is right: radii, numbers of teeth or the ratio $i_{%1}$.",
      {label, asText(gears.tailTeeth), source.linkLabel(graph.meshEdge(mesh).tail), asText(gears.headTeeth),
       source.linkLabel(graph.meshEdge(mesh).head)});
  build.question.elements = {source.meshId(mesh)};
  build.question.rule = translated(
      "A joint on the axis of a gear counts with this gear's radius, the sign is that of the cycle, and the "
      "joints of both gears have the signs of the mesh.");
  std::vector<std::string> columns;
  for (const JointOrdinal joint : joints) columns.push_back(source.edgeLabel(joint));
  build.table({"C" + label}, columns, FieldKind::number);
  for (std::size_t i = 0; i < joints.size(); ++i)
    build.question.fields[i].elements = {source.edgeId(joints[i])};
  const std::vector<std::string> right = picked(row, joints);
  build.accept(right, {{Test::multiple, {}, {right}}});

  const std::vector<ElementId> elements{source.meshId(mesh)};
  const PairTeaching& teaching = pairTeaching(source.meshKind(mesh));
  build.wrongMultiple("ratio-upside-down", picked(source.teethRow(mesh, RowChange::upsideDown), joints),
                      translated("You exchange the radii of both gears: the joints on an axis count with the "
                                 "radius of the gear on it."),
                      elements);
  build.wrongMultiple(teaching.signMistake, picked(source.teethRow(mesh, RowChange::signOfHead), joints),
                      filled(translated(std::string_view(teaching.signInRow)), {label}), elements);
  std::vector<Rational> cycle(row.size());
  std::vector<Rational> senseless(row.size());
  for (std::size_t joint = 0; joint < row.size(); ++joint) {
    const int entry = source.matrix(MatrixKind::spanningTree)->entry(mesh, static_cast<int>(joint));
    cycle[joint] = entry;
    senseless[joint] = row[joint] * Rational(entry);
  }
  build.wrongMultiple(
      "coefficients-left-out", picked(cycle, joints),
      translated("This is the row of the cycle: in P its signs are multiplied by the radii of the gears."),
      elements);
  build.wrongMultiple(
      "arrow-sense-lost", picked(senseless, joints),
      translated("You write the radii without the signs of the cycle, which walks against some arrows."),
      elements);
  for (std::size_t other = 0; other < source.mechanism().gearMeshes.size(); ++other) {
    if (static_cast<int>(other) == mesh) continue;
    build.wrongMultiple(
        "another-cycle", picked(source.teethRow(static_cast<int>(other)), joints),
        translated("This is the row of mesh %1.", {source.meshLabel(static_cast<int>(other))}),
        {source.meshId(static_cast<int>(other))});
  }
  std::vector<std::string> bothWrong = picked(source.teethRow(mesh, RowChange::upsideDown), joints);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const auto joint = static_cast<std::size_t>(joints[i]);
    const bool isHead = source.teethRow(mesh, RowChange::signOfHead)[joint] != row[joint];
    if (isHead) bothWrong[i] = (-*Rational::fromText(bothWrong[i])).toString();
  }
  build.wrongMultiple(
      "sign-and-ratio", bothWrong,
      translated("You exchange the radii of both gears, and the sign of the mesh is wrong, too."), elements);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const auto field = static_cast<int>(i);
    const std::vector<ElementId> joint{source.edgeId(joints[i])};
    const Rational& value = row[joints[i]];
    std::vector<std::string> turned = right;
    turned[i] = (-value).toString();
    std::vector<std::string> without = right;
    without[i] = "0";
    const std::string name = edgeName(source, joints[i]);
    if (value.isZero()) {
      build.wrongIf("joint-off-the-walk", {{Test::differs, {field}, {{"0"}}}},
                    translated("The cycle of mesh %1 does not use %2: 0.", {label, name}), joint, {field});
      continue;
    }
    build.wrongIf(
        "walked-against-arrow", {{Test::multiple, {}, {turned}}},
        translated("The sign of %1 is the opposite: the walk passes its arrow the other way.", {name}), joint,
        {field});
    build.wrongIf("joint-left-out", {{Test::values, {field}, {{"0"}}}},
                  translated("The cycle of mesh %1 uses %2: its coefficient is not 0.", {label, name}), joint,
                  {field});
  }
  return std::move(build.question);
}

}  // namespace

ExerciseEntry coefficientEntry() {
  return {.kind = ExerciseKind::coefficients,
          .name = "p",
          .title = toTranslate("Fill in a row of P"),
          .hint = toTranslate(
              "Start from the cycle of the mesh: only its joints have entries. The size of an entry is "
              "the number of teeth of the gear on whose axis the joint turns."),
          .lack = withoutEquations,
          .make = coefficientQuestion};
}

}  // namespace geargraph
