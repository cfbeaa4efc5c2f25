#include <QTest>
#include <algorithm>
#include <array>
#include <numeric>
#include <set>
#include <thread>

#include "core/design/atlas/atlas_file.h"
#include "core/design/atlas/chain_choices.h"
#include "core/design/atlas/chain_document.h"
#include "core/design/atlas/chain_enumeration.h"
#include "core/design/atlas/chain_freedom.h"
#include "core/design/atlas/identify.h"
#include "core/machine/body_layout/derived_geometry.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "core/mechanism/model/validate.h"
#include "core/theory/analysis/kinematics.h"

using namespace geargraph;

namespace {

/// A random number of a seeded sequence, below `end`.
int randomBelow(std::uint64_t& state, int end) {
  state = state * 6364136223846793005U + 1442695040888963407U;
  return static_cast<int>((state >> 33U) % static_cast<std::uint64_t>(end));
}

/// The same chain with its links named otherwise, its lists in another order and gears exchanged.
Chain shuffled(const Chain& chain, std::vector<int>& newName, std::uint64_t& state) {
  newName.resize(static_cast<std::size_t>(chain.links));
  std::iota(newName.begin(), newName.end(), 0);
  for (int i = chain.links - 1; i > 0; --i)
    std::swap(newName[static_cast<std::size_t>(i)],
              newName[static_cast<std::size_t>(randomBelow(state, i + 1))]);
  Chain other = renamed(chain, newName);
  std::rotate(other.axes.begin(), other.axes.begin() + 1, other.axes.end());
  std::reverse(other.meshes.begin(), other.meshes.end());
  for (ChainMesh& mesh : other.meshes)
    if (randomBelow(state, 2) == 0) std::swap(mesh.tail, mesh.head);
  return other;
}

/// Empty if the document opens, is placed without a diagnostic, has this freedom with both methods in
/// agreement, and is identified as this chain; else what is wrong.
std::string faultOf(const Mechanism& document, const AtlasChain& chain) {
  if (*readMechanism(writeMechanism(document)) != document) return "is another document when it is read";
  if (!wellFormedDiagnostics(document).empty() || !treeDiagnostics(document).empty()) return "is no tree";
  const PlacedMechanism placed(document);
  if (!placed.placement().diagnostics.empty()) return placed.placement().diagnostics.front().message;
  const LiveKinematicsPtr live = liveKinematics(placed);
  if (live->matroid->dof != chain.number.dof) return "has freedom " + std::to_string(live->matroid->dof);
  const auto identity = identifyTrain(document, placed.placement(), *drawnChain(document, placed.placement()),
                                      Atlas::shipped());
  if (isNonfractionated(chain.chain) &&
      (identity->parts.size() != 1 || identity->parts.front().displacement != chain.number))
    return "is identified otherwise";
  for (const IdentifiedChain& part : identity->parts) {
    if (part.isLocked != (chain.number.dof == 0)) return "is locked, or is not";
    if (part.turnsByTeeth) return "turns by its teeth only";
  }
  const SolvedKinematicsPtr solved = solvedKinematics(document, *live, {.symbolic = false});
  if (chain.number.dof == 0) return "";
  return solved->agreement && solved->agreement->equal && solved->agreement->compared > 0
             ? ""
             : "has methods that disagree";
}

}  // namespace

class AtlasTest : public QObject {
  Q_OBJECT

 private slots:
  /// Rotation and displacement graphs: Yang, Ding et al., J. Mech. Des. 141(4), 2019, 043301.
  void countsAreThosePublished() {
    const auto counts = [](int links, int dof) {
      const ChainCounts found = countsOf(Atlas::shipped().chains(links, dof));
      return std::pair(found.rotations, found.displacements);
    };
    QCOMPARE(counts(3, 1), std::pair(1, 1));
    QCOMPARE(counts(4, 1), std::pair(2, 3));
    QCOMPARE(counts(5, 1), std::pair(6, 13));
    QCOMPARE(counts(6, 1), std::pair(27, 81));
    QCOMPARE(counts(7, 1), std::pair(152, 647));
    QCOMPARE(counts(8, 1), std::pair(0, 0));
    QCOMPARE(Atlas::shipped().mostLinks(1), 7);
    int locked = 0;
    for (int links = 4; links <= 7; ++links) locked += counts(links, 0).second;
    QCOMPARE(locked, 40);
  }

  /// The file has the chains that follow from the definitions, each once, in the same groups.
  void fileIsWhatIsEnumerated_data() {
    QTest::addColumn<int>("links");
    QTest::addColumn<int>("dof");
    for (int links = 3; links <= 7; ++links) {
      for (int dof = links < 4 ? 1 : 0; dof <= std::min(2, links - 2); ++dof)
        QTest::addRow("%d links, %d freedoms", links, dof) << links << dof;
    }
  }
  void fileIsWhatIsEnumerated() {
    QFETCH(const int, links);
    QFETCH(const int, dof);
    const auto groups = dof == 0 ? enumerateLockedChains(links) : enumerateChains(links, dof);
    const auto section = Atlas::shipped().chains(links, dof);
    std::size_t count = 0;
    std::set<ChainNumber> found;
    std::set<ChainNumber> rotations;
    for (const std::vector<Chain>& group : groups) {
      const auto rotation = Atlas::shipped().rotationNumberOf(group.front());
      QVERIFY(rotation && rotations.insert(*rotation).second);
      QCOMPARE(group.size(), Atlas::shipped().group(*rotation).size());
      for (const Chain& chain : group) {
        const auto number = Atlas::shipped().numberOf(chain);
        QVERIFY(number && number->links == links && number->dof == dof);
        QCOMPARE(number->rotation, rotation->rotation);
        QVERIFY(found.insert(*number).second);
        ++count;
      }
    }
    QCOMPARE(count, section.size());
  }

  /// By the number of links of each set of meshes, and by rank and locked links at generic ratios.
  void bothDefinitionsOfDegenerateAgree() {
    std::uint64_t state = 2026;
    int degenerate = 0;
    int sound = 0;
    for (int links = 3; links <= 7; ++links) {
      for (const Chain& tree : axisTrees(links)) {
        const std::vector<ChainMesh> possible = possibleMeshes(tree);
        if (possible.empty()) continue;
        for (int round = 0; round < 60; ++round) {
          Chain chain = tree;
          std::set<ChainMesh> meshes;
          const int wanted = 1 + randomBelow(state, links - 1);
          for (int m = 0; m < wanted; ++m)
            meshes.insert(
                possible[static_cast<std::size_t>(randomBelow(state, static_cast<int>(possible.size())))]);
          chain.meshes.assign(meshes.begin(), meshes.end());
          const auto culprits = degenerateMeshes(chain);
          QCOMPARE(culprits.has_value(),
                   genericMotion(chain, static_cast<std::uint64_t>(round)).isDegenerate());
          ++(culprits ? degenerate : sound);
          if (!culprits) continue;
          Chain smallest = chain;  // what is named is degenerate by itself, and nothing less of it
          smallest.meshes.clear();
          for (const int m : *culprits) smallest.meshes.push_back(chain.meshes[static_cast<std::size_t>(m)]);
          QCOMPARE(static_cast<int>(linksOf(chain, *culprits).size()),
                   static_cast<int>(culprits->size()) + 1);
          for (std::size_t m = 0; m < smallest.meshes.size(); ++m) {
            Chain less = smallest;
            less.meshes.erase(less.meshes.begin() + static_cast<std::ptrdiff_t>(m));
            QVERIFY(!genericMotion(less).isDegenerate());
          }
        }
      }
    }
    QVERIFY(degenerate > 300 && sound > 3000);
  }

  void everyChainIsADocument() {
    for (const AtlasChain& chain : Atlas::shipped().chains()) {
      if (chain.number.links > 6) break;
      const std::string fault = faultOf(chainDocument(chain.chain, chain.number.toString()), chain);
      QVERIFY2(fault.empty(), (chain.number.toString() + ' ' + fault).c_str());
    }
  }

  /// Shafts, arms and wheels have room in all documents to 6 links, and with 7 links in all but a few.
  void bodiesHaveRoom() {
    int crowded = 0;
    for (const AtlasChain& chain : Atlas::shipped().chains()) {
      if (chain.number.dof != 1) continue;
      const DerivedGeometry geometry(PlacedMechanism(chainDocument(chain.chain, "")));
      if (geometry.diagnostics()->empty()) continue;
      QVERIFY2(chain.number.links == 7, chain.number.toString().c_str());
      ++crowded;
    }
    QVERIFY(crowded <= 4);
  }

  void everyFrameAndRingGearIsADocument() {
    for (const AtlasChain& chain : Atlas::shipped().chains()) {
      if (chain.number.links > 5) break;
      for (int frame = 0; frame < chain.chain.links; ++frame) {
        for (int ring = 0; ring < static_cast<int>(chain.chain.meshes.size()); ++ring) {
          const Mechanism document = chainDocument(chain.chain, "", {frame, {ring}});
          QCOMPARE(document.links.front().name, "link " + std::to_string(frame + 1) + " of the chain");
          QVERIFY(*document.gearMeshes[ring].kind == MeshKind::internal);
          const std::string fault = faultOf(document, chain);
          QVERIFY2(fault.empty(), (chain.number.toString() + ' ' + fault).c_str());
        }
      }
    }
  }

  void isomorphismMapsLinkByLink() {
    std::uint64_t state = 47;
    for (const AtlasChain& entry : Atlas::shipped().chains()) {
      std::vector<int> newName;
      const Chain other = shuffled(entry.chain, newName, state);
      QCOMPARE(Atlas::shipped().numberOf(other), std::optional(entry.number));
      for (const ChainLikeness likeness : {ChainLikeness::displacement, ChainLikeness::rotation}) {
        const auto image = isomorphism(entry.chain, other, likeness);
        QVERIFY(image.has_value());
        const Chain mapped = renamed(entry.chain, *image);
        std::vector<int> same(static_cast<std::size_t>(other.links));
        std::iota(same.begin(), same.end(), 0);
        const Chain sorted = renamed(other, same);
        QCOMPARE(mapped.meshes, sorted.meshes);
        if (likeness == ChainLikeness::displacement) QCOMPARE(mapped.axes, sorted.axes);
      }
    }
    const Chain& planetary = Atlas::shipped().find({4, 1, 1, 1})->chain;
    QVERIFY(!isomorphism(planetary, Atlas::shipped().find({4, 1, 1, 2})->chain, ChainLikeness::displacement));
    QVERIFY(isomorphism(planetary, Atlas::shipped().find({4, 1, 1, 2})->chain, ChainLikeness::rotation));
    QVERIFY(!isomorphism(planetary, Atlas::shipped().find({4, 1, 2, 1})->chain, ChainLikeness::rotation));
  }

  /// nauty keeps its work space per thread.
  void numbersAreFoundOnSeveralThreads() {
    const auto chains = Atlas::shipped().chains();
    std::vector<int> wrong(4, 0);
    {
      std::vector<std::jthread> threads;
      for (int& count : wrong) {
        threads.emplace_back([&count, chains] {
          for (const AtlasChain& chain : chains)
            if (Atlas::shipped().numberOf(chain.chain) != chain.number) ++count;
        });
      }
    }
    QCOMPARE(wrong, std::vector<int>(4, 0));
  }

  void relativesAreMutual() {
    const Atlas& atlas = Atlas::shipped();
    int pairs = 0;
    for (int links = 3; links <= 5; ++links) {
      for (const AtlasChain& chain : atlas.chains(links, 1)) {
        const ChainRelatives relatives = relativesOf(chain.chain, atlas);
        for (const ChainNumber& more : relatives.oneMeshMore) {
          const auto back = relativesOf(atlas.find(more)->chain, atlas).oneMeshLess;
          QVERIFY(std::find(back.begin(), back.end(), chain.number) != back.end());
          ++pairs;
        }
        QCOMPARE(relatives.sameEquations.size() + 1, atlas.group(chain.number).size());
      }
    }
    QVERIFY(pairs > 50);
    // A gear pair has its two gears or its carrier as the frame.
    QCOMPARE(relativesOf(atlas.find({3, 1, 1, 1})->chain, atlas).frames, 2);
  }

  void partsMeetInOneLink() {
    // Two gear pairs on link 0, a planetary set 5, 6, 7 (planet) round link 4 on a carrier of its own.
    const Chain chain{
        8, {{0, 1, 4}, {0, 2}, {0, 3}, {4, 5, 6}, {5, 7}}, {{1, 2, 0}, {4, 7, 5}, {3, 4, 0}, {6, 7, 5}}};
    const auto parts = partsOf(chain);
    QCOMPARE(parts.size(), std::size_t{3});
    QCOMPARE(parts[0], std::vector<int>({0}));
    QCOMPARE(parts[1], std::vector<int>({1, 3}));
    QCOMPARE(parts[2], std::vector<int>({2}));
    QCOMPARE(linksOf(chain, parts[1]), std::vector<int>({4, 5, 6, 7}));
    QVERIFY(!isNonfractionated(chain));
    QVERIFY(isNonfractionated(subchain(chain, {4, 5, 6, 7})));
    // One freedom is never parted, which the count of links implies.
    for (const AtlasChain& entry : Atlas::shipped().chains())
      if (entry.number.dof < 2) QVERIFY(isNonfractionated(entry.chain));
    QCOMPARE(std::count_if(Atlas::shipped().chains(6, 2).begin(), Atlas::shipped().chains(6, 2).end(),
                           [](const AtlasChain& entry) { return isNonfractionated(entry.chain); }),
             3);
  }

  /// Five coaxial links without meshes have four freedoms: the pairs that determine their motion are the 5^3
  /// trees, which are found by another way.
  void treesAreTheInputsOfCoaxialLinks() {
    const Chain chain{5, {{0, 1, 2, 3, 4}}, {}};
    auto choices = choicesOf(chain, {}, 1000);
    QVERIFY(choices.has_value());
    QCOMPARE(*choices->treeCount, 125);
    QCOMPARE(choices->inputSetCount, 125);
    std::sort(choices->trees.begin(), choices->trees.end());
    QCOMPARE(choices->trees, choices->inputSets);
    QCOMPARE(choices->frames, (std::vector<std::vector<int>>{{0, 1, 2, 3, 4}}));
    QCOMPARE(choicesOf(chain, {}, 7)->trees.size(), std::size_t{7});
    QCOMPARE(choicesOf(chain, {}, 7)->inputSetCount, 125);
  }

  void choicesOfAPlanetarySet() {
    const Chain& chain = Atlas::shipped().find({4, 1, 1, 1})->chain;  // carrier 0, planet 1, sun and ring
    const std::vector<SignedTeeth> teeth{{18, -24}, {18, 60}};
    const auto choices = choicesOf(chain, teeth, 100);
    QCOMPARE(*choices->treeCount, 3);
    const std::vector<std::vector<TurningPair>> trees{
        {{0, 1}, {0, 2}, {0, 3}}, {{0, 1}, {0, 2}, {2, 3}}, {{0, 1}, {0, 3}, {2, 3}}};
    auto found = choices->trees;
    std::sort(found.begin(), found.end());
    QCOMPARE(found, trees);
    QCOMPARE(choices->inputSets,
             (std::vector<std::vector<TurningPair>>{{{0, 1}}, {{0, 2}}, {{0, 3}}, {{2, 3}}}));
    QCOMPARE(choices->frames, (std::vector<std::vector<int>>{{0}, {1}, {2, 3}}));
  }

  void tooManyChoicesAreNotTried() {
    Chain chain{30, {{}}, {}};
    for (int link = 0; link < 30; ++link) chain.axes.front().push_back(link);
    QVERIFY(!choicesOf(chain, {}, 10));
  }

  void numbersAreReadAsWritten() {
    const auto number = ChainNumber::fromText("6-1.5.12");
    QVERIFY(number.has_value());
    QCOMPARE(*number, (ChainNumber{6, 1, 5, 12}));
    QCOMPARE(number->toString(), std::string("6-1.5.12"));
    QCOMPARE(ChainNumber::fromText("6-1.5")->toString(), std::string("6-1.5"));
    for (const char* const wrong : {"", "6", "6-1", "6-1.", "6-1.0", "6-1.5.", "6-1.5.0", "6-1.5.1.1",
                                    "6-1.5.1 ", "6.1-5.1", "-6-1.5.1", "6-1.5.x", "6-1.99999999999"})
      QVERIFY2(!ChainNumber::fromText(wrong), wrong);
  }

  void brokenFilesAreRejectedByLine_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<int>("line");
    const QByteArray head = "geargraph-atlas 1\n3-1.1.1 12/13 231\n";
    QTest::newRow("empty") << QByteArray() << 1;
    QTest::newRow("another file") << QByteArray("{\"format\": \"geargraph\"}\n") << 1;
    QTest::newRow("another version") << QByteArray("geargraph-atlas 2\n") << 1;
    QTest::newRow("no number") << head + "12/134 231/241\n" << 3;
    QTest::newRow("a gap") << head + "4-1.1.2 12/134 231/241\n" << 3;
    QTest::newRow("starts at 2") << head + "4-1.2.1 12/134 231/241\n" << 3;
    QTest::newRow("the same with other names") << head + "3-1.1.2 13/23 123\n" << 3;
    QTest::newRow("another rotation graph in the group")
        << head + "4-1.1.1 12/134 231/241\n4-1.1.2 12/13/24 142/231\n"
        << 4;
    QTest::newRow("the rotation graph of another group")
        << head + "4-1.1.1 12/134 231/241\n4-1.2.1 12/13/14 231/241\n"
        << 4;
    QTest::newRow("no tree") << head + "4-1.1.1 12/12/34 231/241\n" << 3;
    QTest::newRow("a loop of axes") << head + "4-1.1.1 12/13/23/14 231/241\n" << 3;
    QTest::newRow("a link that is none") << head + "4-1.1.1 12/135 231/251\n" << 3;
    QTest::newRow("gears on one axis") << head + "4-1.1.1 12/134 341/241\n" << 3;
    QTest::newRow("another carrier") << head + "4-1.1.1 12/134 234/241\n" << 3;
    QTest::newRow("a mesh too few") << head + "4-1.1.1 12/134 231\n" << 3;
    QTest::newRow("more after it") << head + "4-1.1.1 12/134 231/241 x\n" << 3;
    QTest::newRow("a section before another") << head + "4-1.1.1 12/134 231/241\n3-1.2.1 12/13 231\n" << 4;
  }
  void brokenFilesAreRejectedByLine() {
    QFETCH(const QByteArray, text);
    QFETCH(const int, line);
    const auto read = Atlas::read({text.data(), static_cast<std::size_t>(text.size())});
    QVERIFY(!read);
    QCOMPARE(read.error().front().line, line);
    QCOMPARE(read.error().front().code, line == 1 ? Code::format : Code::syntax);
  }

  void writtenAtlasIsReadBack() {
    const std::string text = atlasText(5);
    const auto read = Atlas::read(text);
    QVERIFY(read.has_value());
    QCOMPARE(read->mostLinks(1), 5);
    QCOMPARE(countsOf(read->chains(5, 1)).displacements, 13);
  }

  void stopsWhereItIsAsked() {
    std::stop_source source;
    source.request_stop();
    QVERIFY(axisTrees(6, source.get_token()).empty());
    QVERIFY(enumerateChains(6, 1, source.get_token()).empty());
    QVERIFY(enumerateLockedChains(6, source.get_token()).empty());
    QVERIFY(atlasText(6, source.get_token()).empty());
  }
};

QTEST_APPLESS_MAIN(AtlasTest)
#include "test_atlas.moc"
