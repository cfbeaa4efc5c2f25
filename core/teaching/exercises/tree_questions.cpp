// Spanning trees of the whole graph, with meshes as edges.

#include "core/mechanism/graph/spanning_tree.h"
#include "core/teaching/exercises/exercise_entry.h"
#include "core/teaching/exercises/question_builder.h"
#include "core/teaching/exercises/question_facts.h"

namespace geargraph {
namespace {

Question spanningTreeQuestion(const ExerciseSource& source, ExerciseRandom& random) {
  const Digraph& graph = source.graph();
  const MeshOrdinal mesh = random.below(graph.c());
  const std::string label = source.meshLabel(mesh);
  const std::string count = asText(graph.n());
  QuestionBuilder build(ExerciseKind::spanningTree, 3);
  build.question.prompt = translated(
      "Take meshes and turning joints alike as edges of one graph. Choose a spanning tree of it that "
      "contains mesh $%1$.",
      {label});
  build.question.elements = {source.meshId(mesh)};
  build.question.rule = translated(
      "A spanning tree of %1 links has %2 edges and no loop: take the mesh in and a joint of its cycle out.",
      {asText(graph.n() + 1), count});
  std::vector<std::string> options;
  std::vector<std::vector<std::string>> edges;
  for (int edge = 0; edge < graph.edgeCount(); ++edge) {
    options.push_back(source.edgeLabel(edge));
    edges.push_back({source.edgeLabel(edge), source.linkLabel(graph.edge(edge).tail),
                     source.linkLabel(graph.edge(edge).head)});
  }
  build.field(toTranslate("edges"), FieldKind::set, options);

  const DigraphEdge& gears = graph.meshEdge(mesh);
  const int out = treePath(*source.tree(), gears.tail, gears.head).front().joint;
  std::vector<std::string> solution;
  std::vector<std::string> turningTree;
  for (JointOrdinal joint = 0; joint < graph.t(); ++joint) {
    turningTree.push_back(source.edgeLabel(joint));
    if (joint != out) solution.push_back(source.edgeLabel(joint));
  }
  solution.push_back(label);
  build.accept({setText(solution)}, {{Test::spanningTree, {}, edges}, {Test::includes, {}, {{label}}}});
  build.wrong("required-edge-missing", {setText(turningTree)},
              translated("The turning joints are a spanning tree, but mesh %1 is not in it.", {label}),
              {source.meshId(mesh)});
  build.wrongIf("too-few-edges", {{Test::fewer, {}, {{count}}}},
                translated("A spanning tree of %1 links has %2 edges: yours leaves links loose.",
                           {asText(graph.n() + 1), count}));
  build.wrongIf("too-many-edges", {{Test::more, {}, {{count}}}},
                translated("A spanning tree of %1 links has %2 edges: with more of them some close a loop.",
                           {asText(graph.n() + 1), count}));
  build.wrongIf("closes-a-loop", {{Test::hasLoop, {}, edges}},
                translated("Some of your edges close a loop, so that another link is left loose."));
  build.wrongIf("required-edge-missing", {{Test::lacks, {}, {{label}}}},
                translated("Your edges are a spanning tree, but mesh %1 is not among them.", {label}),
                {source.meshId(mesh)});
  return std::move(build.question);
}

constexpr int kMaxTreeEdges = 24;

Lack withoutSmallGraph(const ExerciseSource& source) {
  if (const Lack reason = withoutMeshes(source)) return reason;
  return source.graph().edgeCount() <= kMaxTreeEdges ? Lack() : translated("too many edges");
}

}  // namespace

ExerciseEntry spanningTreeEntry() {
  return {.kind = ExerciseKind::spanningTree,
          .name = "spanning-tree",
          .title = toTranslate("Choose a spanning tree"),
          .hint = toTranslate(
              "The turning joints are a spanning tree already. With the mesh they close a loop: which "
              "edges of this loop could go?"),
          .lack = withoutSmallGraph,
          .make = spanningTreeQuestion};
}

}  // namespace geargraph
