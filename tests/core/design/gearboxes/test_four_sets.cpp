#include <QTest>
#include <thread>

#include "core/design/gearboxes/gearbox_json.h"
#include "core/design/gearboxes/gearbox_run.h"

using namespace geargraph;

/// Searches of minutes: published gearboxes of four sets from nothing but their printed ratios.
class FourSetsTest : public QObject {
  Q_OBJECT

 private slots:
  void publishedGearboxesAreFound_data() {
    QTest::addColumn<QString>("forward");
    QTest::addColumn<QString>("reverse");
    QTest::newRow("8HP") << R"("4.696", "3.130", "2.104", "1.667", "1.285", "1", "0.839", "0.667")"
                         << R"("3.297")";
    QTest::newRow("8L45") << R"("4.615", "3.038", "2.065", "1.658", "1.259", "1", "0.849", "0.658")"
                          << R"("any")";
  }
  void publishedGearboxesAreFound() {
    QFETCH(QString, forward);
    QFETCH(QString, reverse);
    const auto wish = readGearboxWish(QString(R"({"forward": [%1], "reverse": %2, "tolerance": 0.005,
      "sets": ["simple", "simple", "simple", "simple"], "links": 8, "freeInput": false, "elements": 5,
      "k": [1.5, 4.2], "buildable": true})")
                                          .arg(forward, reverse)
                                          .toStdString());
    GearboxRunOptions options;
    options.threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    const auto search = findGearboxes(*wish, options);
    QCOMPARE(search->layouts, 134'273);
    QCOMPARE(search->searched, 134'273);
    QVERIFY(!search->found.empty());
    // Both have this layout, with other teeth.
    const BasicSets sets = basicSets(wish->limits.kinds);
    bool isThere = false;
    for (const Gearbox& each : search->found) {
      std::array<int, 4> order{0, 1, 2, 3};
      do {
        const auto link = [&](int set, SetMember member) {
          return each.layout.link(order[static_cast<std::size_t>(set)], member);
        };
        using enum SetMember;
        isThere =
            isThere || (link(0, sun) == link(1, sun) && link(0, carrier) == link(3, ring) &&
                        link(1, ring) == link(2, sun) && link(2, ring) == link(3, sun) &&
                        each.layout.input == link(1, carrier) && each.layout.output == link(3, carrier));
      } while (std::next_permutation(order.begin(), order.end()));
    }
    QVERIFY(isThere);
    qInfo("%zu gearboxes", search->found.size());
  }
};

QTEST_APPLESS_MAIN(FourSetsTest)
#include "test_four_sets.moc"
