// Numbers of teeth that are to be chosen.

#include <numeric>

#include "core/teaching/exercises/question_builder.h"
#include "core/teaching/exercises/question_makers.h"

namespace geargraph::inline exercises {
namespace {

constexpr int kFewestTeethAsked = 15;
constexpr int kMostTeethAsked = 120;
constexpr int kLargestTerm = 5;  ///< of a ratio

}  // namespace

Question teethQuestion(const ExerciseSource& source, ExerciseRandom& random) {
  const int mesh = random.below(source.graph().c());
  const std::string label = source.meshLabel(mesh);
  const GearMesh& gears = source.mechanism().gearMeshes[static_cast<std::size_t>(mesh)];
  const bool isInternal = source.meshKind(mesh) == MeshKind::internal;
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
  const int factor = (kFewestTeethAsked + std::min(above, below) - 1) / std::min(above, below);
  const std::string least = asText(kFewestTeethAsked);
  const std::string most = asText(kMostTeethAsked);
  QuestionBuilder build(ExerciseKind::teeth, 2);
  build.question.prompt = "Choose numbers of teeth between $" + least + "$ and $" + most + "$ for mesh $" +
                          label + "$ so that $i_{" + label + "} = \\frac{N_{" + tail + "}}{N_{" + head +
                          "}} = " + asTex(ratio) + "$.";
  build.question.elements = {source.meshId(mesh)};
  build.question.rule = "N" + tail + " : N" + head + " = " + asText(above) + " : " + asText(below) +
                        ", for example " + asText(above * factor) + " and " + asText(below * factor) +
                        " teeth.";
  build.field("N" + tail, FieldKind::integer, {}, {source.linkId(source.graph().meshEdge(mesh).tail)});
  build.field("N" + head, FieldKind::integer, {}, {source.linkId(source.graph().meshEdge(mesh).head)});
  build.accept({asText(above * factor), asText(below * factor)},
               {{Test::quotient, {}, {{ratio.toString()}}}, {Test::within, {}, {{least, most}}}});
  build.wrongIf("teeth-out-of-range", {{Test::outside, {}, {{least, most}}}},
                "A number of teeth is a whole number between " + least + " and " + most + " here.");
  build.wrongIf(
      "ratio-upside-down", {{Test::quotient, {}, {{ratio.inverse().toString()}}}},
      "Your ratio is upside down: it is " + inWords(ratio.inverse()) + ", not " + inWords(ratio) + ".",
      {source.meshId(mesh)});
  build.wrongIf("ratio-not-met", {{Test::within, {}, {{least, most}}}},
                "The quotient of your numbers is not " + inWords(ratio) + ".", {source.meshId(mesh)});
  return std::move(build.question);
}

std::vector<PlanetPair> planetPairs(const ExerciseSource& source) {
  std::vector<PlanetPair> pairs;
  const TtGraph* const graph = source.ttGraph();
  if (graph == nullptr) return pairs;
  const auto& vertices = graph->transferVertices().ofMesh;
  for (int sunMesh = 0; sunMesh < source.graph().c(); ++sunMesh) {
    if (source.meshKind(sunMesh) != MeshKind::external) continue;
    const TerminalPair& sunPair = *graph->terminal(sunMesh);
    for (int ringMesh = 0; ringMesh < source.graph().c(); ++ringMesh) {
      if (source.meshKind(ringMesh) != MeshKind::internal) continue;
      const TerminalPair& ringPair = *graph->terminal(ringMesh);
      const bool isRingTail = ringPair.tailTeeth > ringPair.headTeeth;
      const int planet = isRingTail ? ringPair.head : ringPair.tail;
      if ((sunPair.tail != planet && sunPair.head != planet) || sunPair.carrier != ringPair.carrier) continue;
      const bool isSunTail = sunPair.head == planet;
      const TransferVertex& atSun = *vertices[static_cast<std::size_t>(sunMesh)];
      const TransferVertex& atRing = *vertices[static_cast<std::size_t>(ringMesh)];
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
  build.question.prompt =
      "Planet $" + planet + "$ is in external mesh $" + sunLabel + "$ with link $" +
      source.linkLabel(pair.sun) + "$ and in internal mesh $" + ringLabel + "$ with ring $" +
      source.linkLabel(pair.ring) + "$. Let link $" + source.linkLabel(pair.sun) + "$ have $" + asText(sun) +
      "$ teeth and the planet $" + asText(atSun) + "$" +
      (isStepped ? " in mesh $" + sunLabel + "$ and $" + asText(atRing) + "$ in mesh $" + ringLabel + "$"
                 : std::string()) +
      ", all of one module and without profile shift. How many teeth must the ring have, so that both "
      "centre distances are equal?";
  build.question.elements = {source.meshId(pair.sunMesh), source.meshId(pair.ringMesh)};
  build.question.rule =
      "The centre distance is half the sum of an external pair and half the difference of an internal "
      "one: " +
      asText(sun) + " + " + asText(atSun) + " = N \u2212 " + asText(atRing) +
      ", so that N = " + asText(right) + ".";
  build.field("teeth of the ring", FieldKind::integer, {}, {source.linkId(pair.ring)});
  build.accept({asText(right)});
  build.wrong(
      "ring-teeth-added", {asText(sun + atSun - atRing)},
      "You add the teeth of the ring: the centre distance of an internal pair is half the difference.",
      {source.meshId(pair.ringMesh)});
  build.wrong("planet-counted-once", {asText(sun + atSun)},
              "You count the planet once: it is between the sun and the ring on both sides.",
              {source.linkId(pair.planet)});
  return std::move(build.question);
}

}  // namespace geargraph::inline exercises
