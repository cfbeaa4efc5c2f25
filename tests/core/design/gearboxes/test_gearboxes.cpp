#include <QTest>
#include <cmath>

#include "core/design/gearboxes/gear_balance.h"
#include "core/design/gearboxes/gearbox_document.h"
#include "core/design/gearboxes/gearbox_json.h"
#include "core/design/gearboxes/gearbox_run.h"
#include "core/design/gearboxes/gearbox_shards.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "core/mechanism/model/validate.h"
#include "core/theory/analysis/analysis.h"

using namespace geargraph;

namespace {

constexpr int kRatioPrecision = 100'000;

GearboxWish gearboxWishOf(const std::string& json) {
  auto wish = readGearboxWish(json);
  if (!wish) qFatal("%s", wish.error().front().message.c_str());
  return *std::move(wish);
}

const std::string kSimpson = R"({"forward": ["2.52", "1.52", "1"], "reverse": "1.94", "tolerance": 0.01,
  "sets": ["simple", "simple"], "links": 5, "elements": 4, "k": [1.5, 4], "teeth": {"fewest": 15, "mostRing": 90}})";
const std::string kRavigneaux = R"({"forward": ["2.74", "1.57", "1", "0.7"], "reverse": "any",
  "tolerance": 0.02, "sets": ["ravigneaux"], "links": 5, "elements": 5, "k": [1.5, 4]})";
const std::string kLepelletier = R"({"forward": ["4.171", "2.340", "1.521", "1.143", "0.867", "0.691"],
  "reverse": "3.403", "tolerance": 0.01, "sets": ["simple", "ravigneaux"], "links": 6, "held": 1, "elements": 5,
  "k": [1.5, 4], "teeth": {"fewest": 15, "mostRing": 110}})";
const std::string kEightSpeed =
    R"({"forward": ["4.696", "3.130", "2.104", "1.667", "1.285", "1", "0.839", "0.667"],
  "reverse": "3.297", "sets": ["simple", "simple", "simple", "simple"], "links": 8, "freeInput": false,
  "elements": 5, "k": [1.5, 4.2], "teeth": {"fewest": 19, "mostRing": 120})";

const GearboxSearch& gearboxSearch(const std::string& json) {
  static std::map<std::string, GearboxSearch> known;
  if (!known.contains(json)) known.emplace(json, findGearboxes(gearboxWishOf(json)).value());
  return known.at(json);
}

QStringList elementsOf(const GearboxWish& wish, const Gearbox& gearbox) {
  const BasicSets sets = basicSets(wish.limits.kinds);
  QStringList words;
  for (const ElementLinks& each : gearbox.elements) {
    const auto word = [&](int link) {
      return link == 0 ? QString("0") : QString::fromStdString(linkWord(sets, gearbox.layout, link));
    };
    words << word(each.a) + "=" + word(each.b);
  }
  return words;
}

/// Is some link that of all these members, "S1 S2", with input or output where these are named?
bool hasLink(const GearboxWish& wish, const Gearbox& gearbox, const QString& members) {
  const BasicSets sets = basicSets(wish.limits.kinds);
  for (int link = 1; link <= wish.limits.shafts; ++link) {
    QStringList words;
    for (const std::string& each : membersOn(sets, gearbox.layout, link))
      words << QString::fromStdString(each);
    if (words == members.split(' ')) return true;
  }
  return false;
}

bool isEightSpeed(const GearLayout& layout) {
  std::array<int, 4> order{0, 1, 2, 3};
  do {
    const auto link = [&](int set, SetMember member) {
      return layout.link(order[static_cast<std::size_t>(set)], member);
    };
    using enum SetMember;
    if (link(0, sun) == link(1, sun) && link(0, carrier) == link(3, ring) && link(1, ring) == link(2, sun) &&
        link(2, ring) == link(3, sun) && layout.input == link(1, carrier) &&
        layout.output == link(3, carrier))
      return true;
  } while (std::next_permutation(order.begin(), order.end()));
  return false;
}

/// The gearbox that the search finds in the 8HP's layout.
Gearbox eightSpeed(const GearboxWish& wish) {
  const auto layouts = gearLayouts(wish.limits).value();
  const auto layout = std::find_if(layouts.begin(), layouts.end(), isEightSpeed);
  if (layout == layouts.end()) qFatal("no such layout");
  SearchCounts counts;
  JudgeCounts judgeCounts;
  std::vector<Gearbox> found;
  for (const GearboxCandidate& each : searchLayout(searchProblem(wish), *layout, counts)) {
    if (auto gearbox = judged(wish, each, judgeCounts)) found.push_back(*std::move(gearbox));
  }
  if (found.size() != 1) qFatal("%d gearboxes", static_cast<int>(found.size()));
  return found.front();
}

/// The other route to an efficiency, without a balance of powers: ratios with k of each set times its basic
/// efficiency, or over it, whichever lessens the size of the ratio (W. Kreines; J. H. Glover).
Rational efficiencyByRatios(const GearboxWish& wish, const Gearbox& gearbox, std::size_t gear) {
  const BasicSets sets = basicSets(wish.limits.kinds);
  std::vector<ElementLinks> engaged;
  for (const int each : gearbox.gears[gear].engaged)
    engaged.push_back(gearbox.elements[static_cast<std::size_t>(each)]);
  const auto ratioAt = [&](const std::vector<Rational>& k) {
    const auto balance =
        gearBalance<FractionNumbers>(sets, gearbox.layout, wish.limits.shafts, k, engaged, FractionNumbers());
    return balance.value().ratio.abs();
  };
  std::vector<Rational> k;
  for (const TeethOption& option : gearbox.teeth)
    for (const SetTeeth& part : option.parts) k.emplace_back(part.ring, part.sun);
  const Rational ratio = ratioAt(k);
  std::vector<Rational> lossy = k;
  for (std::size_t set = 0; set < k.size(); ++set) {
    std::vector<Rational> more = k;
    more[set] *= Rational(1'000'001, 1'000'000);
    const bool isLessened = ratioAt(more) > ratio;
    lossy[set] *= isLessened ? wish.efficiency->basic : wish.efficiency->basic.inverse();
  }
  return ratioAt(lossy) / ratio;
}

double roundedRatio(const std::optional<Rational>& value) {
  return value ? std::round(value->toDouble() * kRatioPrecision) / kRatioPrecision : -1;
}

/// Where the first diagnostic of a wish is: a good one with some members instead of its own.
QString gearboxFaultPlace(const std::string& json) {
  const auto wish = readGearboxWish(json);
  return wish ? "accepted" : QString::fromStdString(wish.error().front().pointer);
}

}  // namespace

class GearboxesTest : public QObject {
  Q_OBJECT

 private slots:
  /// Counts of layouts, of which those of four sets were counted by an independent program, too.
  void layoutsAreCountedOnce() {
    using enum SetKind;
    const auto count = [](const std::vector<SetKind>& kinds, int shafts, int held, bool freeInput) {
      return gearLayouts({kinds, shafts, held, freeInput}).value().size();
    };
    QCOMPARE(count({simple, simple, simple, simple}, 8, 0, false), 134'273U);
    QCOMPARE(count({simple, simple, simple}, 6, 0, false), 4'428U);
    QCOMPARE(count({ravigneaux}, 4, 0, false), 12U);  // input and output of four links
    QCOMPARE(count({simple}, 3, 0, false), 6U);
    QCOMPARE(count({simple}, 2, 1, false), 0U);  // one freedom: input and output in a fixed ratio
  }

  /// The exchange of equal sets gives the same layout; that of different ones does not.
  void layoutsAreTheLeastOfTheirExchanges() {
    const auto layouts = gearLayouts({{SetKind::simple, SetKind::simple}, 4, 0, false}).value();
    for (const GearLayout& each : layouts) {
      GearLayout other;
      std::array<std::uint8_t, kMaxShafts + 1> numbers{};
      std::uint8_t next = 1;
      for (std::size_t member = 0; member < 6; ++member) {
        const std::uint8_t link = each.linkOf[(member + 3) % 6];
        if (link != 0 && numbers[link] == 0) numbers[link] = next++;
        other.linkOf[member] = numbers[link];
      }
      other.input = numbers[each.input];
      other.output = numbers[each.output];
      QVERIFY(each <= other);
      QCOMPARE(std::count(layouts.begin(), layouts.end(), each), 1);
    }
  }

  /// Set 1 with the common suns, its carrier on the output with ring 2: three elements make three gears.
  void simpsonsGearboxIsFoundFromItsRatios() {
    const GearboxWish wish = gearboxWishOf(kSimpson);
    const GearboxSearch& search = gearboxSearch(kSimpson);
    QVERIFY(!search.isComplete);
    QCOMPARE(search.searched, search.layouts);
    const auto simpson = std::find_if(search.found.begin(), search.found.end(), [&](const Gearbox& each) {
      return hasLink(wish, each, "S1 S2") &&
             (hasLink(wish, each, "out C1 R2") || hasLink(wish, each, "out R1 C2"));
    });
    QVERIFY(simpson != search.found.end());
    QCOMPARE(simpson->elements.size(), 4U);
    // With k1 of the set whose carrier is on the output and k2 of the other one, from Willis's equation.
    const bool isFirst = hasLink(wish, *simpson, "out C1 R2");
    const Rational k1 = simpson->teeth[isFirst ? 0 : 1].parts[0].k();
    const Rational k2 = simpson->teeth[isFirst ? 1 : 0].parts[0].k();
    QCOMPARE(simpson->gears[1].ratio, Rational(1) + k1.inverse());
    QCOMPARE(simpson->gears[0].ratio, Rational(1) + k1.inverse() + k2 / k1);
    QCOMPARE(simpson->gears[2].ratio, Rational(1));
    QCOMPARE(simpson->gears[3].ratio, -k2);
  }

  void aFourSpeedRavigneauxIsFoundFromItsRatios() {
    const GearboxWish wish = gearboxWishOf(kRavigneaux);
    const GearboxSearch& search = gearboxSearch(kRavigneaux);
    // The small sun drives with the carrier held, the large one in reverse.
    const auto large = [](const Gearbox& each) { return each.teeth[0].parts[0].k(); };
    const auto small = [](const Gearbox& each) { return each.teeth[0].parts[1].k(); };
    const auto usual = std::find_if(search.found.begin(), search.found.end(), [&](const Gearbox& each) {
      return hasLink(wish, each, "out R1 R2") && each.gears[0].ratio == small(each) &&
             each.gears[4].ratio == -large(each);
    });
    QVERIFY(usual != search.found.end());
    QVERIFY(hasLink(wish, *usual, "in"));
    QCOMPARE(usual->gears[1].ratio, (large(*usual) + small(*usual)) / (Rational(1) + large(*usual)));
    QCOMPARE(usual->gears[2].ratio, Rational(1));
    QCOMPARE(usual->gears[3].ratio, large(*usual) / (Rational(1) + large(*usual)));
    const auto& parts = usual->teeth[0].parts;
    QCOMPARE(parts[0].ring, parts[0].sun + 2 * parts[0].planet);
    QCOMPARE(parts[1].ring, parts[0].ring);
    QVERIFY(parts[1].sun < parts[0].sun);
  }

  /// The first set's sun is part of the housing; its carrier drives one or both suns of the other.
  void lepelletiersSixSpeedIsFoundFromItsRatios() {
    const GearboxWish wish = gearboxWishOf(kLepelletier);
    const GearboxSearch& search = gearboxSearch(kLepelletier);
    const auto lepelletier = std::find_if(search.found.begin(), search.found.end(), [&](const Gearbox& each) {
      return hasLink(wish, each, "in R1") && hasLink(wish, each, "out R2 R3") &&
             each.layout.link(0, SetMember::sun) == 0;
    });
    QVERIFY(lepelletier != search.found.end());
    QCOMPARE(lepelletier->elements.size(), 5U);
    const Rational reduction = Rational(1) + lepelletier->teeth[0].parts[0].k().inverse();
    const Rational large = lepelletier->teeth[1].parts[0].k();
    const Rational small = lepelletier->teeth[1].parts[1].k();
    QCOMPARE(lepelletier->gears[0].ratio, reduction * small);
    QCOMPARE(lepelletier->gears[2].ratio, reduction);
    QCOMPARE(lepelletier->gears[5].ratio, large / (Rational(1) + large));
    QCOMPARE(lepelletier->gears[6].ratio, -reduction * large);
    QVERIFY(!lepelletier->brokenRule);
  }

  /// From ratios as printed, without tolerance: each is rounded to its last digit.
  void theEightSpeedGearboxFollowsFromItsPrintedRatios() {
    const GearboxWish wish = gearboxWishOf(kEightSpeed + "}");
    const Gearbox gearbox = eightSpeed(wish);
    const auto example = readMechanism([] {
      QFile file(SOURCE "/resources/examples/eight-speed-gearbox.geargraph");
      return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
    }());
    const auto snapshot = analyzeStates(analyzeLive(std::make_shared<const Mechanism>(*example)), {false});
    QCOMPARE(gearbox.gears.size(), snapshot->states->size());
    for (std::size_t i = 0; i < gearbox.gears.size(); ++i) {
      QCOMPARE(QString::fromStdString(gearbox.gears[i].ratio.toString()),
               QString::fromStdString((*snapshot->states)[i].ratio->toString()));
    }
    QVERIFY(!gearbox.brokenRule);
    QCOMPARE(elementsOf(wish, gearbox).size(), 5);
    QCOMPARE(std::count_if(gearbox.elements.begin(), gearbox.elements.end(),
                           [](const ElementLinks& each) { return each.isBrake(); }),
             2);
  }

  /// GM's 8L45 has the layout of the 8HP with other teeth.
  void anotherEightSpeedGearboxFollowsFromItsPrintedRatios() {
    const GearboxWish wish =
        gearboxWishOf(R"({"forward": ["4.615", "3.038", "2.065", "1.658", "1.259", "1", "0.849",
      "0.658"], "reverse": "any", "sets": ["simple", "simple", "simple", "simple"], "links": 8, "freeInput": false,
      "elements": 5, "k": [1.5, 4.2], "teeth": {"fewest": 17, "mostRing": 120}})");
    const Gearbox gearbox = eightSpeed(wish);
    const std::array expected = {4.615, 3.038, 2.065, 1.658, 1.259, 1.0, 0.849, 0.658};
    for (std::size_t gear = 0; gear < expected.size(); ++gear)
      QCOMPARE(std::round(gearbox.gears[gear].ratio.toDouble() * 1000) / 1000, expected[gear]);
    QVERIFY(!gearbox.brokenRule);
  }

  /// Figures of the published gearbox: power through a member and circulating power are two measures. Its
  /// clutch E locks sun and ring of the third set; locking the carrier has the same effect on all speeds.
  void measuresAreThoseOfTheGearbox() {
    const GearboxWish wish = gearboxWishOf(kEightSpeed + R"(, "efficiency": {"set": 0.98}})");
    const Gearbox own = eightSpeed(wish);
    QCOMPARE(elementsOf(wish, own).size(), 5);
    const auto third = std::find_if(own.variants.begin(), own.variants.end(),
                                    [](const auto& variants) { return variants.size() == 3; });
    QVERIFY(third != own.variants.end());
    std::vector<Rational> slips;
    for (const ElementLinks& variant : *third) {
      Gearbox other;
      other.layout = own.layout;
      other.elements = own.elements;
      other.elements[static_cast<std::size_t>(third - own.variants.begin())] = variant;
      for (const GearState& gear : own.gears) other.gears.push_back({{}, gear.engaged, {}, {}, {}});
      for (const TeethOption& option : own.teeth) other.teeth.push_back({option.parts, {}});
      auto evaluatedOne = evaluated(wish, other);
      QVERIFY(evaluatedOne.has_value());
      QCOMPARE(evaluatedOne->gears[0].ratio, own.gears[0].ratio);
      slips.push_back(evaluatedOne->measures.slip);
      if (roundedRatio(evaluatedOne->measures.slip) < 2.915 ||
          roundedRatio(evaluatedOne->measures.slip) > 2.925)
        continue;
      QCOMPARE(checkByDocument(wish, *evaluatedOne, true), GearboxCheck::right);
      const auto hundredths = [](const Rational& value) { return std::round(value.toDouble() * 100) / 100; };
      QCOMPARE(hundredths(evaluatedOne->measures.torque), 2.64);
      QCOMPARE(hundredths(evaluatedOne->measures.speed), 2.25);
      QCOMPARE(hundredths(evaluatedOne->gears[2].measures.power), 1.66);
      QCOMPARE(evaluatedOne->losses->circulating[2], std::optional(Rational(0)));
    }
    QCOMPARE(slips.size(), 3U);
    QCOMPARE(std::round(std::max({slips[0], slips[1], slips[2]}).toDouble() * 100) / 100, 2.92);
  }

  /// Published efficiencies of the gears, 0.98 and 0.97 a set; third gear by the power balance.
  void efficienciesOfTheEightSpeedGearbox_data() {
    QTest::addColumn<QString>("basic");
    QTest::addColumn<QList<double>>("expected");
    QTest::newRow("0.98") << "0.98" << QList<double>{0.98426, 0.97761, 0.98794, 0.98674, 0.99018,
                                                     1,       0.99470, 0.99324, 0.94596};
    QTest::newRow("0.97") << "0.97" << QList<double>{0.97639, 0.96643, 0.98192, 0.98016, 0.98534,
                                                     1,       0.99197, 0.98980, 0.91947};
  }
  void efficienciesOfTheEightSpeedGearbox() {
    QFETCH(QString, basic);
    QFETCH(QList<double>, expected);
    const GearboxWish wish =
        gearboxWishOf(kEightSpeed + R"(, "efficiency": {"set": )" + basic.toStdString() + "}}");
    Gearbox gearbox = eightSpeed(wish);
    QCOMPARE(checkByDocument(wish, gearbox, true), GearboxCheck::right);
    for (int gear = 0; gear < expected.size(); ++gear)
      QCOMPARE(roundedRatio(gearbox.losses->efficiencies[static_cast<std::size_t>(gear)]), expected[gear]);
    for (std::size_t gear = 0; gear < gearbox.gears.size(); ++gear)
      QCOMPARE(*gearbox.losses->efficiencies[gear], efficiencyByRatios(wish, gearbox, gear));
  }

  void variantsHaveTheSameSpeeds() {
    const GearboxWish wish = gearboxWishOf(kSimpson);
    int tried = 0;
    for (const Gearbox& gearbox : gearboxSearch(kSimpson).found) {
      for (std::size_t i = 0; i < gearbox.elements.size(); ++i) {
        for (const ElementLinks& element : gearbox.variants[i]) {
          const auto variant = withVariant(wish, gearbox, i, element);
          QVERIFY(variant.has_value());
          QVERIFY(variant->elements[i] == element);
          QCOMPARE(variant->variants[i].size(), gearbox.variants[i].size());
          Gearbox checked = *variant;
          QCOMPARE(checkByDocument(wish, checked, false), GearboxCheck::right);
          for (std::size_t gear = 0; gear < gearbox.gears.size(); ++gear)
            QCOMPARE(variant->gears[gear].ratio, gearbox.gears[gear].ratio);
          const bool isItself = element == gearbox.elements[i];
          if (isItself) QCOMPARE(variant->measures.torque, gearbox.measures.torque);
          tried += isItself ? 0 : 1;
        }
      }
    }
    QVERIFY(tried > 0);
  }

  void aLeastEfficiencyRejects() {
    const GearboxWish wish = gearboxWishOf(kEightSpeed + R"(, "efficiency": {"set": 0.98, "least": 0.95}})");
    Gearbox gearbox = eightSpeed(wish);
    QCOMPARE(checkByDocument(wish, gearbox, false), GearboxCheck::limited);  // reverse has 0.946
    const GearboxWish lower = gearboxWishOf(kEightSpeed + R"(, "efficiency": {"set": 0.98, "least": 0.94}})");
    QCOMPARE(checkByDocument(lower, gearbox, false), GearboxCheck::right);
  }

  /// Whatever is shown has been solved from its document.
  void documentsHaveTheRatios() {
    for (const std::string& json : {kSimpson, kRavigneaux, kLepelletier}) {
      const GearboxWish wish = gearboxWishOf(json);
      for (Gearbox gearbox : gearboxSearch(json).found) {
        const Mechanism document = gearboxDocument(wish, gearbox);
        QVERIFY(wellFormedDiagnostics(document).empty() && treeDiagnostics(document).empty());
        QCOMPARE(checkByDocument(wish, gearbox, true), GearboxCheck::right);
        gearbox.gears[0].ratio += Rational(1, 1000);
        QCOMPARE(checkByDocument(wish, gearbox, false), GearboxCheck::wrong);
      }
    }
  }

  void boundsOfCellsLoseNothing() {
    for (const std::string& json : {kSimpson, kRavigneaux}) {
      SearchProblem problem = searchProblem(gearboxWishOf(json));
      const auto layouts = gearLayouts(problem.limits).value();
      problem.steps = 4;
      SearchCounts pruned;
      SearchCounts all;
      for (const GearLayout& layout : layouts) {
        problem.prunes = true;
        const auto few = searchLayout(problem, layout, pruned);
        problem.prunes = false;
        const auto many = searchLayout(problem, layout, all);
        QCOMPARE(few.size(), many.size());
        for (std::size_t i = 0; i < few.size(); ++i) QCOMPARE(few[i].gears, many[i].gears);
      }
      QVERIFY(pruned.candidates < all.candidates);
    }
  }

  void limitsLeaveOut() {
    const auto count = [](const std::string& limit) {
      std::string json = kSimpson;
      json.insert(1, limit + ", ");
      return gearboxSearch(json).found.size();
    };
    const GearboxSearch& all = gearboxSearch(kSimpson);
    QVERIFY(all.found.size() > 1);
    Rational torque = all.found.front().measures.torque;
    Rational slip = all.found.front().measures.slip;
    Rational speed = all.found.front().measures.speed;
    for (const Gearbox& each : all.found) {
      torque = std::min(torque, each.measures.torque);
      slip = std::min(slip, each.measures.slip);
      speed = std::min(speed, each.measures.speed);
    }
    const auto with = [&](const std::string& name, const Rational& least, const auto& measure) {
      const auto expected = static_cast<std::size_t>(
          std::count_if(all.found.begin(), all.found.end(),
                        [&](const Gearbox& each) { return measure(each.measures) <= least; }));
      return expected > 0 && count("\"" + name + "\": \"" + least.toString() + "\"") == expected;
    };
    QVERIFY(with("torque", torque, [](const GearMeasures& each) { return each.torque; }));
    QVERIFY(with("slip", slip, [](const GearMeasures& each) { return each.slip; }));
    QVERIFY(with("speed", speed, [](const GearMeasures& each) { return each.speed; }));
    QCOMPARE(count("\"spread\": 3"), 0U);
    std::string twoBrakes = kSimpson;
    twoBrakes.insert(1, "\"brakes\": [2, 2], \"clutches\": [2, 2], ");
    QVERIFY(!gearboxSearch(twoBrakes).found.empty());
    for (const Gearbox& each : gearboxSearch(twoBrakes).found) {
      QCOMPARE(std::count_if(each.elements.begin(), each.elements.end(),
                             [](const ElementLinks& element) { return element.isBrake(); }),
               2);
    }
    const auto drawable = static_cast<std::size_t>(std::count_if(
        all.found.begin(), all.found.end(), [](const Gearbox& each) { return !each.brokenRule; }));
    QVERIFY(drawable > 0);
    QCOMPARE(count("\"buildable\": true"), drawable);
  }

  /// A set whose sun and ring are outside the same two carriers cannot leave the third one a way out.
  void sectionsThatCannotBeDrawnNameTheirRule() {
    const GearboxWish wish = gearboxWishOf(kEightSpeed + "}");
    const BasicSets sets = basicSets(wish.limits.kinds);
    const Gearbox gearbox = eightSpeed(wish);
    QVERIFY(!brokenSectionRule(sets, gearbox.layout, 8, gearbox.elements));
    const auto& found = gearboxSearch(kLepelletier).found;
    QVERIFY(std::any_of(found.begin(), found.end(), [](const Gearbox& each) {
      return each.brokenRule == SectionRule::endsReach;  // the output is on the inner carrier
    }));
    // All links braked and clutched to each other are a complete graph.
    std::vector<ElementLinks> all;
    for (std::uint8_t a = 1; a <= 8; ++a) {
      for (std::uint8_t b = a + 1; b <= 8; ++b) all.push_back({a, b});
    }
    QCOMPARE(brokenSectionRule(sets, gearbox.layout, 8, all), SectionRule::clutchesReach);
    // Links 2 and 4 both surround 1, 3 and 5, so that the housing cannot reach all three.
    GearLayout enclosed;
    enclosed.linkOf = {1, 2, 3, 1, 4, 3, 2, 5, 4, 0, 0, 0};
    enclosed.input = 2;
    enclosed.output = 4;
    const std::vector<ElementLinks> three{{1, 0}, {3, 0}, {5, 0}};
    QCOMPARE(brokenSectionRule(BasicSets(3), enclosed, 5, three), SectionRule::brakesReach);
    QVERIFY(brokenSectionRule(BasicSets(3), enclosed, 5, std::span(three).first(2)) !=
            SectionRule::brakesReach);
    // Two carriers on one link, whose suns and rings would have to lie in turn round it.
    GearLayout interleaved;
    interleaved.linkOf = {1, 5, 3, 2, 5, 4, 1, 2, 3, 3, 4, 1};
    interleaved.input = 5;
    interleaved.output = 1;
    QCOMPARE(brokenSectionRule(BasicSets(4), interleaved, 5, {}), SectionRule::shaftsNest);
    interleaved.linkOf = {1, 5, 3, 2, 6, 4, 1, 2, 3, 3, 4, 1};  // on two links that need not touch
    QVERIFY(brokenSectionRule(BasicSets(4), interleaved, 6, {}) != SectionRule::shaftsNest);
  }

  /// Four parts, one of them stopped in its midst and resumed, give the bytes of one run.
  void partsGiveTheBytesOfOneRun() {
    const GearboxWish wish = gearboxWishOf(kLepelletier);
    const std::string whole = gearboxesJson(wish, gearboxSearch(kLepelletier), -1).value();
    std::vector<ShardFile> shards;
    for (int part = 0; part < 4; ++part) {
      GearboxRunOptions options;
      options.shard = {part, 4};
      std::string progress = progressHeader(wish, options.shard);
      std::optional<GearboxSearch> search;
      if (part == 2) {  // killed while it writes its second block
        int blocks = 0;
        options.onBlock = [&](const GearboxSearch& block, std::int64_t done, std::int64_t) {
          const std::string text = progressBlock(block, done);
          progress += blocks == 0 ? text : text.substr(0, text.size() / 2);
          return ++blocks < 2;
        };
        QVERIFY(!findGearboxes(wish, options));
        const auto read = readProgress(wish, options.shard, progress);
        QVERIFY(read.has_value());
        QCOMPARE(read->done, kBlockLayouts);
        options.from = read->done;
        options.onBlock = {};
        search = findGearboxes(wish, options);
        search->searched += read->search.searched;
        search->counts += read->search.counts;
        search->judged += read->search.judged;
        for (const Gearbox& each : read->search.found) search->found.push_back(each);
      } else {
        search = findGearboxes(wish, options);
      }
      ShardFile shard;
      shard.canonicalWish = wish.canonical;
      shard.parts = {part};
      shard.of = 4;
      shard.search = *std::move(search);
      shard.seconds = part;
      const auto again = readShard(shardText(shard));
      QVERIFY2(again.has_value(), again ? "" : again.error().front().message.c_str());
      shards.push_back(*again);
    }
    const auto merged = mergedShards({shards[3], shards[1], shards[0], shards[2], shards[1]});
    QVERIFY(merged.has_value());
    QVERIFY(missingParts(*merged).empty());
    QCOMPARE(gearboxesJson(wish, merged->search, -1).value(), whole);
    // Associative: merged files are merged as well.
    const auto left = mergedShards({*readShard(shardText(*mergedShards({shards[0], shards[2]}))), shards[3]});
    QCOMPARE(missingParts(*left), std::vector<int>{1});
    const auto right = mergedShards({shards[1], *readShard(shardText(*left))});
    QCOMPARE(gearboxesJson(wish, right->search, -1).value(), whole);
  }

  void otherSearchesAreNotMerged() {
    const GearboxWish wish = gearboxWishOf(kRavigneaux);
    const auto shardOf = [](const GearboxWish& own, int part, int of) {
      GearboxRunOptions options;
      options.shard = {part, of};
      return ShardFile{own.canonical, {part}, of, findGearboxes(own, options).value(), 0};
    };
    std::string other = kRavigneaux;
    other.replace(other.find("0.02"), 4, "0.03");
    const ShardFile first = shardOf(wish, 0, 2);
    QVERIFY(!mergedShards({first, shardOf(gearboxWishOf(other), 1, 2)}));
    QVERIFY(!mergedShards({first, shardOf(wish, 1, 3)}));
    QVERIFY(mergedShards({first, shardOf(wish, 1, 2)}).has_value());
    const std::string text = shardText(first);
    QVERIFY(readShard(text).has_value());
    QVERIFY(!readShard(text.substr(0, text.size() / 2)));
    std::string versioned = text;
    versioned.replace(versioned.find("\"version\": 1"), 12, "\"version\": 9");
    QVERIFY(!readShard(versioned));
    std::string changed = text;
    changed.replace(changed.find("0.02"), 4, "0.05");  // no longer what the hash is of
    QVERIFY(!readShard(changed));
    QVERIFY(!readProgress(wish, {1, 2}, progressHeader(wish, {0, 2})));
  }

  void threadsDoNotChangeTheResult() {
    const GearboxWish wish = gearboxWishOf(kSimpson);
    GearboxRunOptions options;
    options.threads = 3;
    const auto search = findGearboxes(wish, options);
    QCOMPARE(gearboxesJson(wish, *search, -1).value(),
             gearboxesJson(wish, gearboxSearch(kSimpson), -1).value());
  }

  void tooFewStatesAreToldAtOnce() {
    std::string json = kSimpson;
    json.replace(json.find("\"elements\": 4"), 13, "\"elements\": 2");
    const GearboxSearch& search = gearboxSearch(json);
    QVERIFY(hasTooFewStates(gearboxWishOf(json)));
    QVERIFY(search.isComplete);
    QVERIFY(search.found.empty());
    QVERIFY(!hasTooFewStates(gearboxWishOf(kSimpson)));
  }

  void aStopEndsTheSearch() {
    std::stop_source stop;
    GearboxRunOptions options;
    options.onBlock = [&](const GearboxSearch&, std::int64_t, std::int64_t) {
      stop.request_stop();
      return true;
    };
    QVERIFY(!findGearboxes(gearboxWishOf(kLepelletier), options, stop.get_token()));
  }

  void faultsOfAWishHaveTheirPlaces() {
    const auto with = [](const std::string& members) {
      return gearboxFaultPlace(R"({"forward": ["3", "1"], "sets": ["simple", "simple"], "links": 5, )" +
                               members + "}");
    };
    QCOMPARE(with("\"reverse\": null"), "accepted");
    QCOMPARE(gearboxFaultPlace("{}"), "/forward");
    QCOMPARE(gearboxFaultPlace("[]"), "");
    QCOMPARE(gearboxFaultPlace(R"({"forward": ["3", "0"], "sets": ["simple", "simple"], "links": 5})"),
             "/forward/1");
    QCOMPARE(gearboxFaultPlace(R"({"forward": [3], "sets": ["simple", "simple"], "links": 5})"),
             "/forward/0");
    QCOMPARE(gearboxFaultPlace(R"({"forward": ["3"], "sets": ["triple"], "links": 4})"), "/sets");
    QCOMPARE(gearboxFaultPlace(R"({"forward": ["3"], "sets": ["simple"], "links": 9})"), "/links");
    QCOMPARE(gearboxFaultPlace(R"({"forward": ["3"], "sets": ["simple"]})"), "/links");
    QCOMPARE(with("\"revers\": \"any\""), "/revers");
    QCOMPARE(with("\"reverse\": \"4/0\""), "/reverse");
    QCOMPARE(with("\"tolerance\": -0.1"), "/tolerance");
    QCOMPARE(with("\"brakes\": [3, 1]"), "/brakes");
    QCOMPARE(with("\"k\": [4, 1.5]"), "/k");
    QCOMPARE(with("\"k\": [0.5, 2]"), "/k");
    QCOMPARE(with("\"elements\": 0"), "/elements");
    QCOMPARE(with("\"teeth\": {\"fewest\": 130}"), "/teeth/fewest");
    QCOMPARE(with("\"teeth\": {\"ring\": 130}"), "/teeth/ring");
    QCOMPARE(with("\"efficiency\": {\"mesh\": 0.98, \"set\": 0.98}"), "/efficiency");
    QCOMPARE(with("\"efficiency\": {\"mesh\": 1.5}"), "/efficiency/mesh");
    QCOMPARE(with("\"torque\": 0"), "/torque");
    QCOMPARE(with("\"singleShift\": 1"), "/singleShift");
    QVERIFY(gearboxFaultPlace("{").isEmpty());  // a syntax error has line and column instead
  }
};

QTEST_APPLESS_MAIN(GearboxesTest)
#include "test_gearboxes.moc"
