// Rank, freedom, inputs, and meshes that add nothing.

#include <algorithm>

#include "core/teaching/exercises/exercise_entry.h"
#include "core/teaching/exercises/question_builder.h"
#include "core/teaching/exercises/question_facts.h"

namespace geargraph {
namespace {

constexpr int kMaxPairs = 40;  ///< of proportional joints that are named

/// The factor f with a = f b, if there is one and neither is 0.
std::optional<Rational> factorBetween(const std::vector<Rational>& a, const std::vector<Rational>& b) {
  std::optional<Rational> factor;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].isZero() != b[i].isZero()) return std::nullopt;
    if (a[i].isZero()) continue;
    const Rational here = a[i] / b[i];
    if (factor && *factor != here) return std::nullopt;
    factor = here;
  }
  return factor;
}

}  // namespace

std::vector<char> dispensableMeshes(const ExerciseSource& source) {
  ByMesh<char> dispensable(static_cast<std::size_t>(source.graph().c()), 0);
  for (const Redundancy& redundancy : source.matroid()->redundancies) {
    dispensable[redundancy.equation] = 1;
    for (const MeshOrdinal mesh : redundancy.dependsOn) dispensable[mesh] = 1;
  }
  return dispensable;
}

namespace {

Question freedomQuestion(const ExerciseSource& source, ExerciseRandom& /*random*/) {
  const MatroidAnalysis& matroid = *source.matroid();
  const int t = source.graph().t();
  const int c = source.graph().c();
  const int r = matroid.rank;
  const int e = matroid.dof;
  QuestionBuilder build(ExerciseKind::freedom, 3);
  build.question.prompt = translated(
      "What is the rank $r$ of the coefficient matrix $P$, and how many degrees of freedom $E$ does the "
      "mechanism have with every brake and clutch released?");
  if (source.mechanism().couplings.empty())
    build.question.prompt = translated(
        "What is the rank $r$ of the coefficient matrix $P$, and how many degrees of freedom $E$ does the "
        "mechanism have?");
  const std::string counted = "r = " + asText(r) + ", E = t \u2212 r = " + asText(t) + " \u2212 " +
                              asText(r) + " = " + asText(e) + ".";
  std::vector<ElementId> redundant;
  for (const Redundancy& found : matroid.redundancies) redundant.push_back(source.meshId(found.equation));
  build.question.rule =
      r < c ? translated("Of the %1 rows of P, %2 are independent: %3", {asText(c), asText(r), counted})
            : translated("All %1 rows of P are independent: %2", {asText(c), counted});
  build.field("r", FieldKind::integer);
  build.field("E", FieldKind::integer);
  const auto pair = [](int rank, int dof) { return std::vector<std::string>{asText(rank), asText(dof)}; };
  build.accept(pair(r, e));
  if (r < c) {
    build.wrong(
        "kutzbach-with-redundant-mesh", pair(c, t - c),
        c - r == 1
            ? translated(
                  "You count every mesh as a constraint: one mesh follows from the others, so that r is %1.",
                  {asText(r)})
            : translated(
                  "You count every mesh as a constraint: %1 meshes follow from the others, so that r is %2.",
                  {asText(c - r), asText(r)}),
        redundant);
    build.wrongFields(
        "kutzbach-with-redundant-mesh", {0}, {{asText(c)}},
        c - r == 1 ? translated("The rank is not the number of meshes: one mesh follows from the others.")
                   : translated("The rank is not the number of meshes: %1 meshes follow from the others.",
                                {asText(c - r)}),
        redundant);
  }
  build.wrong("rank-and-dof-exchanged", pair(e, r),
              translated("You exchange both numbers: r counts equations, E = t − r is left."));
  build.wrong("ground-counted", pair(r, e + 1),
              translated("You count the ground among the moving links: it has no turning joint of its own."),
              {source.linkId(0)});
  for (const int rank : {r, c, 2 * c}) {
    build.wrong("mesh-takes-two", pair(rank, t - 2 * c),
                translated("You take two degrees of freedom for each mesh: its gears roll and slide, so that "
                           "it takes one."));
    build.wrong(
        "meshes-ignored", pair(rank, t),
        translated(
            "You count the freedoms of the turning joints only: each independent mesh takes one of them."));
  }
  build.wrong(
      "meshes-ignored", pair(0, t),
      translated(
          "You count the freedoms of the turning joints only: each independent mesh takes one of them."));
  build.wrongIf("not-t-minus-r", {{Test::values, {0}, {{asText(r)}}}, {Test::differs, {1}, {{asText(e)}}}},
                translated("The rank is right, but E = t − r = %1 − %2.", {asText(t), asText(r)}), {}, {1});
  return std::move(build.question);
}

Question inputsQuestion(const ExerciseSource& source, ExerciseRandom& /*random*/) {
  const MatroidAnalysis& matroid = *source.matroid();
  const int t = source.graph().t();
  const std::string count = asText(matroid.dof);
  const auto& rates = source.rates();
  QuestionBuilder build(ExerciseKind::inputs, 3);
  build.question.prompt =
      translated("Choose a valid set of inputs: turning joints whose speeds determine the whole motion.");
  const bool isOne = matroid.dof == 1;
  build.question.rule =
      isOne ? translated(
                  "A valid set has one joint, whose speed can be chosen freely and determines all others.")
            : translated(
                  "A valid set has %1 joints whose speeds can be chosen freely and determine all others.",
                  {count});
  std::vector<std::string> options;
  std::vector<std::vector<std::string>> rows;
  for (JointOrdinal joint = 0; joint < t; ++joint) {
    options.push_back(source.edgeLabel(joint));
    rows.push_back({source.edgeLabel(joint)});
    for (const std::string& rate : asTexts(rates[static_cast<std::size_t>(joint)]))
      rows.back().push_back(rate);
  }
  build.field(toTranslate("joints"), FieldKind::set, options);
  std::vector<int> inputs = source.inputs();
  std::sort(inputs.begin(), inputs.end());
  std::vector<std::string> solution;
  for (const JointOrdinal joint : inputs) solution.push_back(source.edgeLabel(joint));
  build.accept({setText(solution)}, {{Test::basis, {}, rows}});
  for (JointOrdinal joint = 0; joint < t; ++joint) {
    if (matroid.dead[joint] == 0) continue;
    build.wrongIf(
        "dead-input", {{Test::touches, {}, {{source.edgeLabel(joint)}}}},
        translated("Joint %1 can never turn, so that it cannot be driven.", {source.edgeLabel(joint)}),
        {source.edgeId(joint)});
  }
  build.wrongIf(
      "too-many-inputs", {{Test::more, {}, {{count}}}},
      isOne ? translated("With one degree of freedom the other joints you name follow from one of them.")
            : translated("With %1 degrees of freedom the other joints you name follow from %1 of them.",
                         {count}));
  for (JointOrdinal joint = 0; joint < t; ++joint) {
    if (matroid.idle[joint] == 0) continue;
    build.wrongIf("idle-joint-missing", {{Test::lacks, {}, {{source.edgeLabel(joint)}}}},
                  translated("Joint %1 is on no cycle, so that only an input can determine its speed.",
                             {source.edgeLabel(joint)}),
                  {source.edgeId(joint)});
  }
  int pairs = 0;
  for (int a = 0; a < t; ++a) {
    for (int b = 0; b < a && pairs < kMaxPairs; ++b) {
      const auto factor =
          factorBetween(rates[static_cast<std::size_t>(a)], rates[static_cast<std::size_t>(b)]);
      if (!factor) continue;
      ++pairs;
      build.wrongIf(
          "dependent-inputs", {{Test::includes, {}, {{source.edgeLabel(b), source.edgeLabel(a)}}}},
          translated(
              "Joint %1 always turns at %2 times the speed of joint %3: only one of them can be chosen.",
              {source.edgeLabel(a), inWords(*factor), source.edgeLabel(b)}),
          {source.edgeId(a), source.edgeId(b)});
    }
  }
  build.wrongIf(
      "dependent-inputs", {{Test::dependent, {}, rows}},
      translated("The speeds of these joints depend on each other, so that some other joint stays free."));
  if (matroid.dof == 1) return std::move(build.question);
  build.wrongIf(
      "too-few-inputs", {{Test::fewer, {}, {{count}}}},
      translated("The mechanism has %1 degrees of freedom: your inputs leave a motion open.", {count}));
  return std::move(build.question);
}

Question redundantMeshQuestion(const ExerciseSource& source, ExerciseRandom& /*random*/) {
  const int c = source.graph().c();
  const std::string count = asText(c - source.matroid()->rank);
  const ByMesh<char> dispensable = dispensableMeshes(source);
  QuestionBuilder build(ExerciseKind::redundantMesh, 3);
  build.question.prompt = translated(
      "How many meshes are redundant, and which mesh could be left out without another motion? Name one of "
      "them.");
  std::vector<std::string> meshes;
  std::vector<std::vector<std::string>> right;
  std::vector<std::string> names;
  for (MeshOrdinal mesh = 0; mesh < c; ++mesh) {
    meshes.push_back(source.meshLabel(mesh));
    if (dispensable[mesh] == 0) continue;
    right.push_back({count, meshes.back()});
    names.push_back(meshes.back());
  }
  const std::string rank = asText(source.matroid()->rank);
  const std::string all = listed(names, kAllNames);
  build.question.rule =
      count == "1"
          ? translated(
                "The rank is %1 with %2 meshes, so that one is redundant; each of %3 follows from others.",
                {rank, asText(c), all})
          : translated(
                "The rank is %1 with %2 meshes, so that %3 are redundant; each of %4 follows from others.",
                {rank, asText(c), count, all});
  build.field(toTranslate("redundant meshes"), FieldKind::integer);
  build.field(toTranslate("one of them"), FieldKind::choice, meshes);
  build.accept(right.front(), right);
  build.wrongField("redundancy-overlooked", 0, {"0"},
                   translated("The rows of P are not independent: their rank is %1, fewer than %2 meshes.",
                              {asText(source.matroid()->rank), asText(c)}));
  build.wrongIf("redundancy-miscounted", {{Test::differs, {0}, {{count}}}},
                translated("There are as many redundant meshes as rows of P beyond its rank: %1 − %2.",
                           {asText(c), asText(source.matroid()->rank)}),
                {}, {0});
  for (MeshOrdinal mesh = 0; mesh < c; ++mesh) {
    if (dispensable[mesh] != 0) continue;
    build.wrongField(
        "independent-mesh", 1, {meshes[static_cast<std::size_t>(mesh)]},
        translated("Without mesh %1 the mechanism would gain a degree of freedom: it follows from no others.",
                   {meshes[static_cast<std::size_t>(mesh)]}),
        {source.meshId(mesh)});
  }
  return std::move(build.question);
}

Lack withoutRedundancy(const ExerciseSource& source) {
  if (const Lack reason = withoutEquations(source)) return reason;
  return source.matroid()->redundancies.empty() ? Lack(translated("no mesh is redundant")) : std::nullopt;
}

}  // namespace

ExerciseEntry freedomEntry() {
  return {.kind = ExerciseKind::freedom,
          .name = "freedom",
          .title = toTranslate("Rank and DOF"),
          .hint = toTranslate(
              "Each mesh gives one equation. Count those that do not follow from the others, and subtract "
              "their number from that of the turning joints."),
          .lack = withoutEquations,
          .make = freedomQuestion};
}

ExerciseEntry redundantMeshEntry() {
  return {.kind = ExerciseKind::redundantMesh,
          .name = "redundant-mesh",
          .title = toTranslate("Redundant mesh"),
          .hint = toTranslate(
              "Look for meshes that tie the same links together in two ways. Leave one out: if the others "
              "still force the same speeds, it is redundant."),
          .lack = withoutRedundancy,
          .make = redundantMeshQuestion};
}

ExerciseEntry inputsEntry() {
  return {.kind = ExerciseKind::inputs,
          .name = "inputs",
          .title = toTranslate("Valid inputs"),
          .hint = toTranslate(
              "Take as many joints as there are degrees of freedom. Imagine all of them locked: nothing "
              "else may move, and no mesh may tie two of them to each other."),
          .lack = withoutFreedom,
          .make = inputsQuestion};
}

}  // namespace geargraph
