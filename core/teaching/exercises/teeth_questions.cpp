// Numbers of teeth that are to be chosen.

#include <numeric>

#include "core/teaching/exercises/exercise_entry.h"
#include "core/teaching/exercises/question_builder.h"
#include "core/teaching/exercises/question_facts.h"

namespace geargraph {
namespace {

constexpr int kMinTeethAsked = 15;
constexpr int kMaxTeethAsked = 120;
constexpr int kLargestTerm = 5;  ///< of a ratio

}  // namespace

std::vector<PlanetPair> planetPairs(const ExerciseSource& source) {
  std::vector<PlanetPair> pairs;
  const TtGraph* const graph = source.ttGraph();
  if (graph == nullptr) return pairs;
  const auto& vertices = graph->transferVertices().ofMesh;
  for (MeshOrdinal sunMesh = 0; sunMesh < source.graph().c(); ++sunMesh) {
    if (!isBesideEachOther(source.meshKind(sunMesh))) continue;
    const TerminalPair& sunPair = *graph->terminal(sunMesh);
    for (MeshOrdinal ringMesh = 0; ringMesh < source.graph().c(); ++ringMesh) {
      if (!hasRing(source.meshKind(ringMesh))) continue;
      const TerminalPair& ringPair = *graph->terminal(ringMesh);
      const bool isRingTail = ringPair.tailTeeth > ringPair.headTeeth;
      const int planet = isRingTail ? ringPair.head : ringPair.tail;
      if ((sunPair.tail != planet && sunPair.head != planet) || sunPair.carrier != ringPair.carrier) continue;
      const bool isSunTail = sunPair.head == planet;
      const TransferVertex& atSun = *vertices[sunMesh];
      const TransferVertex& atRing = *vertices[ringMesh];
      const int sunLevel = isSunTail ? atSun.tailLevel : atSun.headLevel;
      const int ringLevel = isRingTail ? atRing.tailLevel : atRing.headLevel;
      if (sunLevel != ringLevel) continue;
      pairs.push_back({sunMesh, ringMesh, planet, isSunTail ? sunPair.tail : sunPair.head,
                       isRingTail ? ringPair.tail : ringPair.head,
                       isSunTail ? sunPair.tailTeeth : sunPair.headTeeth,
                       isSunTail ? sunPair.headTeeth : sunPair.tailTeeth,
                       isRingTail ? ringPair.headTeeth : ringPair.tailTeeth});
    }
  }
  return pairs;
}

namespace {

Question teethQuestion(const ExerciseSource& source, ExerciseRandom& random) {
  const MeshOrdinal mesh = random.below(source.graph().c());
  const std::string label = source.meshLabel(mesh);
  const GearMesh& gears = source.mechanism().gearMeshes[mesh];
  const bool isInternal = hasRing(source.meshKind(mesh));
  const bool isRingTail = gears.tailTeeth > gears.headTeeth;
  int above = 1;
  int below = 1;
  while (above == below || std::gcd(above, below) != 1 || (isInternal && isRingTail != (above > below))) {
    above = random.between(1, kLargestTerm);
    below = random.between(1, kLargestTerm);
  }
  const Rational ratio(above, below);
  const std::string tail = source.linkLabel(source.graph().meshEdge(mesh).tail);
  const std::string head = source.linkLabel(source.graph().meshEdge(mesh).head);
  const int factor = (kMinTeethAsked + std::min(above, below) - 1) / std::min(above, below);
  const std::string least = asText(kMinTeethAsked);
  const std::string most = asText(kMaxTeethAsked);
  QuestionBuilder build(ExerciseKind::teeth, 2);
  build.question.prompt = translated(
      "Choose numbers of teeth between $%1$ and $%2$ for mesh $%3$ so that $i_{%3} = \\frac{N_{%4}}{N_{%5}} "
      "= %6$.",
      {least, most, label, tail, head, asTex(ratio)});
  build.question.elements = {source.meshId(mesh)};
  build.question.rule =
      translated("N%1 : N%2 = %3 : %4, for example %5 and %6 teeth.",
                 {tail, head, asText(above), asText(below), asText(above * factor), asText(below * factor)});
  build.field("N" + tail, FieldKind::integer, {}, {source.linkId(source.graph().meshEdge(mesh).tail)});
  build.field("N" + head, FieldKind::integer, {}, {source.linkId(source.graph().meshEdge(mesh).head)});
  build.accept({asText(above * factor), asText(below * factor)},
               {{Test::quotient, {}, {{ratio.toString()}}}, {Test::within, {}, {{least, most}}}});
  build.wrongIf("teeth-out-of-range", {{Test::outside, {}, {{least, most}}}},
                translated("A number of teeth is a whole number between %1 and %2 here.", {least, most}));
  build.wrongIf(
      "ratio-upside-down", {{Test::quotient, {}, {{ratio.inverse().toString()}}}},
      translated("Your ratio is upside down: it is %1, not %2.", {inWords(ratio.inverse()), inWords(ratio)}),
      {source.meshId(mesh)});
  build.wrongIf("ratio-not-met", {{Test::within, {}, {{least, most}}}},
                translated("The quotient of your numbers is not %1.", {inWords(ratio)}),
                {source.meshId(mesh)});
  return std::move(build.question);
}

Question ringTeethQuestion(const ExerciseSource& source, ExerciseRandom& random) {
  const PlanetPair pair = random.oneOf(planetPairs(source));
  const int sun = random.between(16, 40);
  const int atSun = random.between(14, 30);
  const bool isStepped = pair.planetTeethAtSun != pair.planetTeethAtRing;
  const int atRing = isStepped ? random.between(14, 30) : atSun;
  const int right = sun + atSun + atRing;
  const std::string planet = source.linkLabel(pair.planet);
  const std::string sunLabel = source.meshLabel(pair.sunMesh);
  const std::string ringLabel = source.meshLabel(pair.ringMesh);
  QuestionBuilder build(ExerciseKind::ringTeeth, 2);
  const std::string teeth =
      isStepped
          ? translated(
                "Let link $%1$ have $%2$ teeth and the planet $%3$ in mesh $%4$ and $%5$ in mesh $%6$, all "
                "of one module and without profile shift.",
                {source.linkLabel(pair.sun), asText(sun), asText(atSun), sunLabel, asText(atRing), ringLabel})
          : translated(
                "Let link $%1$ have $%2$ teeth and the planet $%3$, all of one module and without profile "
                "shift.",
                {source.linkLabel(pair.sun), asText(sun), asText(atSun)});
  build.question.prompt = translated(
      "Planet $%1$ is in external mesh $%2$ with link $%3$ and in internal mesh $%4$ with ring $%5$. %6 How "
      "many teeth must the ring have, so that both centre distances are equal?",
      {planet, sunLabel, source.linkLabel(pair.sun), ringLabel, source.linkLabel(pair.ring), teeth});
  build.question.elements = {source.meshId(pair.sunMesh), source.meshId(pair.ringMesh)};
  build.question.rule = translated(
      "The centre distance is half the sum of an external pair and half the difference of an internal one: "
      "%1 + %2 = N − %3, so that N = %4.",
      {asText(sun), asText(atSun), asText(atRing), asText(right)});
  build.field(toTranslate("teeth of the ring"), FieldKind::integer, {}, {source.linkId(pair.ring)});
  build.accept({asText(right)});
  build.wrong(
      "ring-teeth-added", {asText(sun + atSun - atRing)},
      translated(
          "You add the teeth of the ring: the centre distance of an internal pair is half the difference."),
      {source.meshId(pair.ringMesh)});
  build.wrong("planet-counted-once", {asText(sun + atSun)},
              translated("You count the planet once: it is between the sun and the ring on both sides."),
              {source.linkId(pair.planet)});
  return std::move(build.question);
}

Lack withoutPlanets(const ExerciseSource& source) {
  if (const Lack reason = withoutEquations(source)) return reason;
  return planetPairs(source).empty() ? Lack(translated("no planet between a sun and a ring")) : std::nullopt;
}

}  // namespace

ExerciseEntry teethEntry() {
  return {.kind = ExerciseKind::teeth,
          .name = "teeth",
          .title = toTranslate("Teeth for a ratio"),
          .hint = toTranslate(
              "Reduce the fraction. Then multiply both of its parts by the same whole number until both "
              "are within the bounds."),
          .view = LessonView::schematic,
          .lack = withoutEquations,
          .make = teethQuestion};
}

ExerciseEntry ringTeethEntry() {
  return {.kind = ExerciseKind::ringTeeth,
          .name = "ring-teeth",
          .title = toTranslate("Teeth of the ring"),
          .hint = toTranslate(
              "The centre distance goes with the sum of the teeth where both gears are external, and with "
              "their difference where one is a ring."),
          .view = LessonView::schematic,
          .lack = withoutPlanets,
          .make = ringTeethQuestion};
}

}  // namespace geargraph
