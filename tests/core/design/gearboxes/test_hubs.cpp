#include <QTest>

#include "core/design/gearboxes/hub_document.h"
#include "core/design/gearboxes/hub_json.h"
#include "core/design/gearboxes/hub_search.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "core/theory/analysis/analysis.h"
#include "tests/core/support/pseudo_language.h"

using namespace geargraph;

namespace {

/// What the maker's sheet of a seven-speed hub says, with what is known of such hubs.
std::string sevenSpeeds(const std::string& more = "") {
  return R"({"ratios": ["0.632", "0.741", "0.843", "0.989", "1.145", "1.335", "1.545"], "sets": 2,
    "planets": [12, 30], "suns": [15, 60], "rings": [40, 90], "slack": 3)" +
         more + "}";
}

HubSearch hubsOf(const std::string& json) {
  const auto wish = readHubWish(json);
  if (!wish) qFatal("%s", wish.error().front().message.c_str());
  return findHubs(*wish).value();
}

QStringList hubRatios(const HubCandidate& candidate) {
  QStringList ratios;
  for (const Rational& each : candidate.ratios) ratios << QString::fromStdString(each.toString());
  return ratios;
}

/// "sun/planet" of each sun, the ring, then the numbers of planets.
QString writtenHubSet(const HubSet& set) {
  QStringList words;
  for (const HubSun& sun : set.suns) words << QString("%1/%2").arg(sun.teeth).arg(sun.planet);
  words << QString::number(set.ring) << ":";
  for (const int each : set.planets) words << QString::number(each);
  return words.join(' ');
}

/// Where the first diagnostic of a wish is.
QString hubFaultPlace(const std::string& json) {
  const auto wish = readHubWish(json);
  return wish ? "accepted" : QString::fromStdString(wish.error().front().pointer);
}

}  // namespace

class HubsTest : public QObject {
  Q_OBJECT

 private slots:
  /// The teeth that were counted when such a hub was opened are the first candidate.
  void aSevenSpeedHubFollowsFromItsRoundedRatios() {
    const HubSearch search = hubsOf(sevenSpeeds());
    QCOMPARE(search.structures, 1);
    QCOMPARE(search.tried, (std::vector<std::int64_t>{378'060, 378'060}));
    QCOMPARE(search.assembled.size(), 3U);
    QCOMPARE(search.others.size(), 14U);
    QCOMPARE(writtenHubSet(search.assembled[0].sets[0]), "42/14 36/20 72 : 2 3 6");
    QCOMPARE(writtenHubSet(search.assembled[0].sets[1]), "36/14 30/19 66 : 2 3 6");
    QCOMPARE(writtenHubSet(search.assembled[1].sets[1]), "30/14 25/19 55 : 5");
    QCOMPARE(writtenHubSet(search.assembled[2].sets[1]), "36/16 29/21 66 : 2");
    QCOMPARE(hubRatios(search.assembled[0]),
             (QStringList{"12/19", "20/27", "3348/3971", "620/627", "340/297", "279/209", "17/11"}));
  }

  void oneCountDecidesBetweenItsCandidates() {
    const HubSearch search = hubsOf(sevenSpeeds());
    const HubQuestion& first = search.questions.front();
    QVERIFY(first.isCount);
    QCOMPARE(first.name, std::string("2.sun2"));
    QCOMPARE(first.leaves, 1U);
    QCOMPARE(leftBy(first),
             (std::map<std::string, std::vector<std::size_t>>{{"25", {1}}, {"29", {2}}, {"30", {0}}}));
    for (std::size_t i = 1; i < search.questions.size(); ++i) QCOMPARE(search.questions[i].leaves, 2U);
    QCOMPARE(inseparable(search), (std::vector<std::vector<std::size_t>>{{0, 1}}));
    QCOMPARE(sharedWheels(search),
             (std::vector<std::pair<std::string, int>>{
                 {"1.sun1", 42}, {"1.planet1", 14}, {"1.sun2", 36}, {"1.planet2", 20}, {"1.ring", 72}}));
  }

  void countsAndMeasurementsNarrow() {
    const HubSearch counted = hubsOf(sevenSpeeds(R"(, "counted": {"2.sun2": 29})"));
    QCOMPARE(counted.assembled.size(), 1U);
    QCOMPARE(writtenHubSet(counted.assembled[0].sets[1]), "36/16 29/21 66 : 2");
    QVERIFY(counted.questions.empty());
    const HubSearch measured = hubsOf(sevenSpeeds(R"(, "measured": [{"gear": 4, "ratio": "0.98884"}])"));
    QCOMPARE(measured.assembled.size(), 2U);
    QVERIFY(hubsOf(sevenSpeeds(R"(, "counted": {"1.ring": 71})")).assembled.empty());
  }

  /// What is counted or turned leaves what a search with that count finds.
  void answersNarrow() {
    const HubSearch search = hubsOf(sevenSpeeds());
    const HubQuestion& first = search.questions.front();
    const HubSearch left = narrowed(search, first, "29");
    QCOMPARE(left.assembled.size(), 1U);
    QCOMPARE(writtenHubSet(left.assembled[0].sets[1]), "36/16 29/21 66 : 2");
    QVERIFY(left.questions.empty());
    QVERIFY(narrowed(search, first, "31").assembled.empty());
    const auto turns = std::find_if(search.questions.begin(), search.questions.end(),
                                    [](const HubQuestion& each) { return !each.isCount; });
    QVERIFY(turns != search.questions.end());
    QCOMPARE(narrowed(search, *turns, turns->answers[0]).assembled.size(), turns->leaves);
  }

  void hubsAreDocumentsWithTheirRatios_data() {
    QTest::addColumn<QString>("wish");
    QTest::newRow("seven speeds, two sets in series") << QString::fromStdString(sevenSpeeds());
    QTest::newRow("three speeds, ring and carrier exchanged")
        << R"({"ratios": ["0.75", "1", "1.333"], "stepped": false, "counted": {"1.sun1": 20}})";
    QTest::newRow("two speeds that increase")
        << R"({"ratios": ["1", "1.36"], "stepped": false, "rings": [70, 72]})";
  }
  void hubsAreDocumentsWithTheirRatios() {
    QFETCH(QString, wish);
    const HubSearch search = hubsOf(wish.toStdString());
    QVERIFY(!search.assembled.empty());
    for (const HubCandidate& candidate : search.assembled) {
      const Mechanism document = hubDocument(candidate);
      const auto read = readMechanism(writeMechanism(document));
      QVERIFY2(read, read ? "" : read.error().front().message.c_str());
      const SnapshotPtr snapshot = analyze(std::make_shared<const Mechanism>(document));
      QVERIFY(!hasErrors(snapshot->diagnostics));
      QCOMPARE(document.states.size(), candidate.ratios.size());
      for (std::size_t gear = 0; gear < candidate.ratios.size(); ++gear) {
        QVERIFY((*snapshot->states)[gear].ratio.has_value());
        QCOMPARE((*snapshot->states)[gear].ratio->inverse(), candidate.ratios[gear]);
      }
    }
  }

  /// One set with the ring driving, passed through, and with the carrier driving.
  void aThreeSpeedHubIsOneSet() {
    const HubSearch search =
        hubsOf(R"({"ratios": ["0.75", "1", "1.333"], "stepped": false, "counted": {"1.sun1": 20}})");
    QCOMPARE(search.assembled.size(), 1U);
    QCOMPARE(writtenHubSet(search.assembled[0].sets[0]), "20/20 60 : 2 4 5");
    QCOMPARE(hubRatios(search.assembled[0]), (QStringList{"3/4", "1", "4/3"}));
  }

  /// A sheet in percent: the ratios are quotients of rounded numbers.
  void sheetsInOtherUnitsRelateToTheDirectGear() {
    const HubSearch search =
        hubsOf(R"({"ratios": ["150", "200", "267"], "direct": 2, "tolerance": 0.002, "stepped": false,
                   "counted": {"1.sun1": 20}})");
    QVERIFY(std::any_of(search.assembled.begin(), search.assembled.end(), [](const HubCandidate& each) {
      return hubRatios(each) == QStringList{"3/4", "1", "4/3"};
    }));
    const auto wish = readHubWish(R"({"ratios": ["2.1", "2.8"], "direct": 2})");
    QVERIFY(wish->ratios[0].admits(Rational(3, 4)) && wish->ratios[0].admits(Rational(205, 285)));
    QVERIFY(!wish->ratios[0].admits(Rational(215, 275)));
    QVERIFY(wish->ratios[1].admits(Rational(1)) && !wish->ratios[1].admits(Rational(1001, 1000)));
    QCOMPARE(hubFaultPlace(R"({"ratios": ["0.5"], "direct": 2})"), "/direct");
  }

  void ratiosThatNothingGivesHaveNoCandidates() {
    const HubSearch search = hubsOf(R"({"ratios": ["0.75", "1.4"], "stepped": false})");
    QCOMPARE(search.structures, 0);  // 1 / 0.75 is no 1.4, and one set has one sun
    QVERIFY(search.assembled.empty() && search.others.empty() && search.questions.empty());
    const auto wish = readHubWish(R"({"ratios": ["0.75", "1.4"], "stepped": false})");
    const std::string json = hardwareJson(*wish, search, -1);
    QVERIFY(json.find("\"count\": 0,") != std::string::npos);
    QVERIFY(json.find("\"complete\": true,") != std::string::npos);
  }

  /// Both ends of the interval of a rounded decimal: the lower one counts, the upper one does not.
  void roundedDecimalsAreIntervals() {
    const auto rounded = wantedRatio("0.632", {});
    QVERIFY(rounded->admits(Rational(6315, 10000)));
    QVERIFY(!rounded->admits(Rational(6325, 10000)));
    QVERIFY(!rounded->admits(Rational(63149, 100000)));
    const auto tolerant = wantedRatio("4/3", Rational(1, 100));
    QVERIFY(tolerant->admits(Rational(4, 3) * Rational(101, 100)));
    QVERIFY(!tolerant->admits(Rational(4, 3) * Rational(1011, 1000)));
    const auto exact = wantedRatio("2", {});
    QVERIFY(exact->admits(Rational(2)) && !exact->admits(Rational(200001, 100000)));
    for (const char* none : {"0", "-1", "4/0", "", "one", "0.0"}) QVERIFY(!wantedRatio(none, {}));
  }

  void faultsOfAWishHaveTheirPlaces() {
    QCOMPARE(hubFaultPlace("{}"), "/ratios");
    QCOMPARE(hubFaultPlace(R"({"ratios": []})"), "/ratios");
    QCOMPARE(hubFaultPlace(R"({"ratios": ["0.5", "4/0"]})"), "/ratios/1");
    QCOMPARE(hubFaultPlace(R"({"ratios": ["0.5"], "planets": [30, 12]})"), "/planets");
    QCOMPARE(hubFaultPlace(R"({"ratios": ["0.5"], "series": false, "sets": 2})"), "/series");
    QCOMPARE(hubFaultPlace(R"({"ratios": ["0.5"], "counted": {"3.ring": 60}})"), "/counted/3.ring");
    QCOMPARE(hubFaultPlace(R"({"ratios": ["0.5"], "measured": [{"gear": 2, "ratio": "0.5"}]})"),
             "/measured/0/gear");
    QCOMPARE(hubFaultPlace(R"({"ratios": ["0.5"], "measured": [{"gear": 1, "ratio": "0.5", "turn": 2}]})"),
             "/measured/0/turn");
    QCOMPARE(hubFaultPlace(R"({"ratios": ["0.5"], "sun": [15, 60]})"), "/sun");
    QCOMPARE(hubFaultPlace(R"({"ratios": ["0.5"], "tolerance": 1})"), "/tolerance");
  }

  void aStopEndsTheSearch() {
    std::stop_source stop;
    stop.request_stop();
    QVERIFY(!findHubs(*readHubWish(sevenSpeeds()), stop.get_token()));
  }
};

QTEST_APPLESS_MAIN(HubsTest)
#include "test_hubs.moc"
