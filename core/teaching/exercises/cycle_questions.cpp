// The fundamental cycles: which edges, in which senses.

#include <algorithm>

#include "core/mechanism/graph/spanning_tree.h"
#include "core/teaching/exercises/exercise_entry.h"
#include "core/teaching/exercises/question_builder.h"
#include "core/teaching/exercises/question_facts.h"

namespace geargraph {
namespace {

/// The joints of the walk from a mesh's head back to its tail, with their senses.
std::vector<PathStep> backThroughTree(const ExerciseSource& source, MeshOrdinal mesh) {
  const DigraphEdge& gears = source.graph().meshEdge(mesh);
  return treePath(*source.tree(), gears.head, gears.tail);
}

std::vector<int> jointsOf(const std::vector<PathStep>& steps) {
  std::vector<int> joints;
  for (const PathStep& step : steps) joints.push_back(step.joint);
  std::sort(joints.begin(), joints.end());
  return joints;
}

std::string setOf(const ExerciseSource& source, const std::vector<int>& joints) {
  std::vector<std::string> labels;
  for (const JointOrdinal joint : joints) labels.push_back(source.edgeLabel(joint));
  return setText(labels);
}

std::vector<int> unionOf(const std::vector<int>& a, const std::vector<int>& b) {
  std::vector<int> both;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return both;
}

std::vector<ElementId> idsOf(const ExerciseSource& source, const std::vector<int>& edges) {
  std::vector<ElementId> ids;
  for (const int edge : edges) ids.push_back(source.edgeId(edge));
  return ids;
}

Question cycleQuestion(const ExerciseSource& source, ExerciseRandom& random) {
  const Digraph& graph = source.graph();
  const MeshOrdinal mesh = random.below(graph.c());
  const std::string label = source.meshLabel(mesh);
  const DigraphEdge& gears = graph.meshEdge(mesh);
  const std::vector<int> joints = jointsOf(backThroughTree(source, mesh));
  QuestionBuilder build(ExerciseKind::cycle, 2);
  build.question.prompt =
      translated("Which turning joints lie on the fundamental cycle of mesh $%1$?", {label});
  build.question.elements = {source.meshId(mesh)};
  build.question.rule = translated(
      "The cycle of mesh %1 consists of the mesh and of the path through the tree from link %2 to link %3.",
      {label, source.linkLabel(gears.tail), source.linkLabel(gears.head)});
  std::vector<std::string> options;
  for (int edge = 0; edge < graph.edgeCount(); ++edge) options.push_back(source.edgeLabel(edge));
  build.field(toTranslate("joints"), FieldKind::set, options);
  build.accept({setOf(source, joints)});

  const std::vector<int> tailPath = jointsOf(treePath(*source.tree(), gears.tail, 0));
  const std::vector<int> headPath = jointsOf(treePath(*source.tree(), gears.head, 0));
  const std::vector<int> toGround = unionOf(tailPath, headPath);
  std::vector<int> beyond;
  std::set_difference(toGround.begin(), toGround.end(), joints.begin(), joints.end(),
                      std::back_inserter(beyond));
  build.wrong(
      "paths-to-ground", {setOf(source, toGround)},
      translated(
          "You follow both paths to the ground: the cycle turns back at the first link that they share."),
      idsOf(source, beyond));
  for (const auto& [path, gear] : {std::pair(tailPath, gears.tail), std::pair(headPath, gears.head)}) {
    if (path.empty()) continue;
    build.wrong(
        "one-gear-only", {setOf(source, path)},
        translated(
            "You follow the path of link %1 to the ground: the cycle needs the path between both gears.",
            {source.linkLabel(gear)}),
        {source.linkId(gear)});
  }
  for (int other = 0; other < graph.c(); ++other) {
    if (other == mesh) continue;
    build.wrong("another-cycle", {setOf(source, jointsOf(backThroughTree(source, other)))},
                translated("These are the joints on the cycle of mesh %1.", {source.meshLabel(other)}),
                {source.meshId(other)});
  }
  for (int other = 0; other < graph.c(); ++other) {
    build.wrongIf(
        "mesh-among-joints", {{Test::touches, {}, {{source.meshLabel(other)}}}},
        translated("%1 is a mesh: the question asks for the turning joints.", {source.meshLabel(other)}),
        {source.meshId(other)});
  }
  for (JointOrdinal joint = 0; joint < graph.t(); ++joint) {
    const std::string name = source.edgeLabel(joint);
    if (std::binary_search(joints.begin(), joints.end(), joint)) {
      build.wrongIf("joint-left-out", {{Test::lacks, {}, {{name}}}},
                    translated("The path between links %1 and %2 leads through joint %3.",
                               {source.linkLabel(gears.tail), source.linkLabel(gears.head), name}),
                    {source.edgeId(joint)});
    } else {
      build.wrongIf("joint-off-the-walk", {{Test::touches, {}, {{name}}}},
                    translated("The path between links %1 and %2 does not lead through joint %3.",
                               {source.linkLabel(gears.tail), source.linkLabel(gears.head), name}),
                    {source.edgeId(joint)});
    }
  }
  return std::move(build.question);
}

Question cycleSenseQuestion(const ExerciseSource& source, ExerciseRandom& random) {
  const MeshOrdinal mesh = random.below(source.graph().c());
  const std::string label = source.meshLabel(mesh);
  std::vector<PathStep> steps = backThroughTree(source, mesh);
  std::sort(steps.begin(), steps.end(),
            [](const PathStep& a, const PathStep& b) { return a.joint < b.joint; });
  steps.push_back({source.graph().t() + mesh, 1});
  QuestionBuilder build(ExerciseKind::cycleSense, 2);
  build.question.prompt = translated(
      "Walk once round the cycle of mesh $%1$, in either sense: $1$ for each arrow that you follow, $-1$ for "
      "each that you walk against.",
      {label});
  build.question.elements = {source.meshId(mesh)};
  build.question.rule = translated(
      "One walk runs along mesh %1 and back through the tree; the opposite walk has all signs exchanged and "
      "is right, too.",
      {label});
  std::vector<std::string> columns;
  std::vector<int> right;
  for (const PathStep& step : steps) {
    columns.push_back(source.edgeLabel(step.joint));
    right.push_back(step.direction);
  }
  build.table({"C" + label}, columns, FieldKind::integer);
  for (std::size_t i = 0; i < steps.size(); ++i)
    build.question.fields[i].elements = {source.edgeId(steps[i].joint)};
  build.accept(asTexts(right), {asTexts(negated(right))});
  build.wrong(
      "signs-left-out", asTexts(magnitudes(right)),
      translated("You give all edges one sense: some arrows point against every walk round the cycle."),
      {source.meshId(mesh)});
  build.wrong(
      "signs-left-out", asTexts(negated(magnitudes(right))),
      translated("You give all edges one sense: some arrows point against every walk round the cycle."),
      {source.meshId(mesh)});
  for (std::size_t i = 0; i < steps.size(); ++i) {
    std::vector<int> turned = right;
    turned[i] = -turned[i];
    const auto field = static_cast<int>(i);
    const std::string name = edgeName(source, steps[i].joint);
    const std::vector<std::vector<std::string>> both{asTexts(turned), asTexts(negated(turned))};
    if (steps.size() > 2) {
      build.wrongIf("walked-against-arrow", {{Test::values, {}, both}},
                    translated("Your walk passes %1 the other way: with the other senses that you give, its "
                               "sign is the opposite.",
                               {name}),
                    {source.edgeId(steps[i].joint)}, {field});
    }
    build.wrongField("joint-left-out", field, {"0"},
                     translated("Every walk round the cycle uses %1: 1 or −1, not 0.", {name}),
                     {source.edgeId(steps[i].joint)});
  }
  build.wrongNonSigns();
  build.wrongIf("orientation-lost", {{Test::within, {}, {{"-1", "1"}}}},
                translated("These senses belong to no single walk round the cycle: start at one link and "
                           "follow the edges one by one."),
                {source.meshId(mesh)});
  return std::move(build.question);
}

Question anyCyclesQuestion(const ExerciseSource& source, ExerciseRandom& /*random*/) {
  const Digraph& graph = source.graph();
  const IntegerMatrix& cycles = *source.matrix(MatrixKind::cycleBasis);
  QuestionBuilder build(ExerciseKind::anyCycles, 6);
  build.question.prompt = translated(
      "Write down all fundamental cycles, one in each row: in any order, each walked in either sense.");
  build.question.rule = translated(
      "There is a cycle for each mesh; its row may be multiplied by −1, and rows may be exchanged.");
  std::vector<std::string> rows;
  std::vector<std::string> columns;
  for (int edge = 0; edge < graph.edgeCount(); ++edge) columns.push_back(source.edgeLabel(edge));
  std::vector<std::string> solution;
  std::vector<std::string> unsignedRows;
  std::vector<std::string> twice;
  std::vector<std::string> withoutMeshes;
  Condition accepted{Test::rows, {}, {}};
  for (MeshOrdinal mesh = 0; mesh < graph.c(); ++mesh) {
    rows.push_back("cycle " + asText(mesh + 1));
    std::vector<std::string> row;
    for (int edge = 0; edge < graph.edgeCount(); ++edge) {
      row.push_back(asText(cycles.entry(mesh, edge)));
      unsignedRows.push_back(asText(std::abs(cycles.entry(mesh, edge))));
      twice.push_back(asText(cycles.entry(mesh + 1 < graph.c() ? mesh : MeshOrdinal(0), edge)));
      withoutMeshes.push_back(edge < graph.t() ? row.back() : "0");
    }
    solution.insert(solution.end(), row.begin(), row.end());
    accepted.values.push_back(std::move(row));
  }
  build.table(rows, columns, FieldKind::integer);
  build.question.table.partition = graph.t();
  for (int i = 0; i < graph.c() * graph.edgeCount(); ++i)
    build.question.fields[static_cast<std::size_t>(i)].elements = {source.edgeId(i % graph.edgeCount())};
  build.accept(solution, {accepted});
  build.wrong("signs-left-out", unsignedRows,
              translated("You mark the edges of the cycles without their senses: a walk that runs against an "
                         "arrow has −1."));
  build.wrong("another-cycle", twice,
              translated("You write one cycle twice: each mesh closes a cycle of its own."));
  build.wrong("own-mesh-left-out", withoutMeshes,
              translated("You leave out the meshes: each cycle holds the mesh that closes it."));
  build.wrongNonSigns();
  return std::move(build.question);
}

constexpr int kMaxAnyCycles = 3;
constexpr int kMaxAnyEdges = 14;

Lack withoutOneCycle(const ExerciseSource& source) {
  if (const Lack reason = withoutMeshes(source)) return reason;
  const bool isSmall = source.graph().c() <= kMaxAnyCycles && source.graph().edgeCount() <= kMaxAnyEdges;
  return isSmall ? Lack() : translated("too many cycles");
}

}  // namespace

ExerciseEntry cycleEntry() {
  return {.kind = ExerciseKind::cycle,
          .name = "cycle",
          .title = toTranslate("Find the cycle of a mesh"),
          .hint = toTranslate(
              "From both links of the mesh, walk along turning joints toward the ground until the two "
              "walks meet. What they share from there on is not part of the cycle."),
          .lack = withoutMeshes,
          .make = cycleQuestion};
}

ExerciseEntry cycleSenseEntry() {
  return {.kind = ExerciseKind::cycleSense,
          .name = "cycle-sense",
          .title = toTranslate("Walk a cycle in either sense"),
          .hint = toTranslate(
              "Choose a link of the cycle and go once round without turning back. Only the direction of "
              "each arrow against your own counts."),
          .lack = withoutMeshes,
          .make = cycleSenseQuestion};
}

ExerciseEntry anyCyclesEntry() {
  return {.kind = ExerciseKind::anyCycles,
          .name = "any-cycles",
          .title = toTranslate("Write all cycles"),
          .hint = toTranslate(
              "Each mesh closes one cycle with the turning joints. Go round one after the other; within a "
              "row all signs belong to the same walk."),
          .lack = withoutOneCycle,
          .make = anyCyclesQuestion};
}

}  // namespace geargraph
