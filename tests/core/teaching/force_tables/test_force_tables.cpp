#include <QTest>

#include "core/teaching/force_tables/cutset_words.h"
#include "core/teaching/force_tables/dual_equations.h"
#include "core/teaching/force_tables/efficiency_table.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/gearboxes.h"
#include "tests/core/support/statics_case.h"
#include "tests/core/support/train_sketch.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

ForceTable tableOf(const StaticsCase& train, const StaticsReport& report, ForceTableKind kind) {
  return forceTable(train.mechanism, train.model, train.placement, report, kind);
}

/// The texts of one column.
std::vector<std::string> column(const ForceTable& table, const std::string& head) {
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < table.columns.size(); ++i)
    if (table.columns[i].head == head)
      for (const ForceRow& row : table.rows) texts.push_back(row.cells[i].text);
  return texts;
}

/// Sun 5 driven at 100 rad/s with 10 N m, ring held, carrier out, as the picture of the window has it.
struct Picture {
  Mechanism mechanism;
  StaticsOptions options;
  explicit Picture(int planets = 1) : mechanism(planetary(24, 18, planets)) {
    const auto& joints = mechanism.turningJoints;
    mechanism.links[1].name = "sun";
    mechanism.inputs = std::vector<Input>{{joints[0].id, Number(100), {}}, {joints[1].id, Number(0), {}}};
    options.loads = {{{}, JointTorque{joints[0].id, Number(10)}}};
    options.balances = {{joints[1].id}, {joints[2].id}};
    options.losses = true;
    options.efficiency = Rational(98, 100);
  }
};

}  // namespace

class ForceTablesTest : public QObject {
  Q_OBJECT

 private slots:
  void jointsOfAPlanetarySet() {
    const Picture picture;
    const StaticsCase train(picture.mechanism);
    const ForceTable table = tableOf(train, reportOf(train, picture.options), ForceTableKind::joints);
    QCOMPARE(column(table, "at"), (std::vector<std::string>{"5", "6", "7", "8"}));
    QCOMPARE(column(table, "turns").front(), std::string("1 sun"));
    QCOMPARE(column(table, "carried by"), (std::vector<std::string>{"load", "balance", "balance", "free"}));
    QCOMPARE(column(table, "lossless"), (std::vector<std::string>{"10", "25", "-35", "0"}));
    QCOMPARE(column(table, "exact torque"), (std::vector<std::string>{"10", "2401/100", "-3401/100", "0"}));
    QCOMPARE(column(table, "torque"), (std::vector<std::string>{"10", "24.01", "-34.01", "0"}));
    QCOMPARE(column(table, "rate"), (std::vector<std::string>{"100", "0", "28.5714", "-95.2381"}));
    QCOMPARE(column(table, "power"), (std::vector<std::string>{"1000", "0", "-971.714", "0"}));
    QVERIFY(table.rows[0].elements.front() == ElementId(train.mechanism.turningJoints[0].id));
  }

  /// Only where torques are put in, with what each is and the names of links.
  void whatIsNeededOfAPlanetarySet() {
    const Picture picture;
    const StaticsCase train(picture.mechanism);
    const StaticsReport report = reportOf(train, picture.options);
    const ForceTable table = tableOf(train, report, ForceTableKind::needs);
    QCOMPARE(column(table, "at"), (std::vector<std::string>{"joint 5", "joint 6", "joint 7"}));
    QCOMPARE(column(table, "link").front(), std::string("1 sun"));
    QCOMPARE(column(table, "part in it"),
             (std::vector<std::string>{"motor, given", "held, found", "balance, found"}));
    QCOMPARE(column(table, "exact torque"), (std::vector<std::string>{"10", "2401/100", "-3401/100"}));
    QCOMPARE(column(table, "rate"), (std::vector<std::string>{"100", "0", "28.5714"}));
    QCOMPARE(column(table, "power"), (std::vector<std::string>{"1000", "0", "-971.714"}));
  }

  /// In a state: its drive, its driven link, and what is engaged.
  void whatIsNeededInAState() {
    const StaticsCase train(eightSpeed());
    StaticsOptions options;
    options.state = 0;
    options.driveTorque = Rational(1);
    const StaticsReport report = reportOf(train, options);
    QVERIFY(report.lossless.isBalanced());
    const ForceTable table = tableOf(train, report, ForceTableKind::needs);
    const std::size_t engaged = train.mechanism.states[0].engaged.size();
    QCOMPARE(table.rows.size(), 2 + engaged);
    QCOMPARE(column(table, "part in it").front(), std::string("motor, given"));
    QCOMPARE(column(table, "part in it")[1], std::string("balance, found"));
    QCOMPARE(column(table, "exact torque").front(), std::string("1"));
    QCOMPARE(column(table, "at")[2], "brake " + train.mechanism.states[0].engaged.front().text());
    QCOMPARE(column(table, "power").front(), column(table, "rate").front());  // of 1 N m
    QVERIFY(table.rows[2].elements.front() == ElementId(train.mechanism.states[0].engaged.front()));
  }

  /// The link of a bearing is named for people; files have its joint.
  void bearingsAreNamedOnTheScreenOnly() {
    const Picture picture;
    const StaticsCase train(picture.mechanism);
    const ForceTable table = tableOf(train, reportOf(train, picture.options), ForceTableKind::bearings);
    QCOMPARE(column(table, "turns").front(), std::string("1 sun"));
    TextSink sink;
    writeForceCsv(sink, table);
    QVERIFY2(sink.text().starts_with("joint,force [N]"), sink.text().c_str());
  }

  /// What acts on links from outside stands below the joints.
  void loadsAndBalancesOnLinks() {
    const StaticsCase train(eightSpeed());
    StaticsOptions options;
    options.state = 0;
    const LinkId third("3");
    options.loads = {{{}, LinkTorque{LinkId("1"), {}, Number(2)}},
                     {{}, LinkForce{third, {Number(0), Number(1), Number(0)}, {}}}};
    const StaticsReport report = reportOf(train, options);
    QVERIFY(report.lossless.isBalanced());
    const ForceTable table = tableOf(train, report, ForceTableKind::joints);
    const auto joints = static_cast<std::size_t>(train.model.t());
    QCOMPARE(table.rows.size(), joints + 3);
    QCOMPARE(column(table, "at")[joints], std::string("link 1"));
    QCOMPARE(column(table, "exact torque")[joints], std::string("2"));
    QCOMPARE(column(table, "carried by")[joints + 1], std::string("force"));
    QCOMPARE(column(table, "exact torque")[joints + 1], std::string());
    QCOMPARE(column(table, "carried by")[joints + 2], std::string("balance"));
    QCOMPARE(column(table, "exact torque")[joints + 2], std::string("-216/23"));
    QCOMPARE(column(table, "power")[joints + 2], std::string("-2"));
  }

  void everyCellBelongsToAColumnThatIsExplained() {
    const StaticsCase set(Picture().mechanism);
    const StaticsCase gearbox(eightSpeed());
    StaticsOptions state;
    state.state = 0;
    const std::pair<const StaticsCase*, StaticsReport> cases[] = {
        {&set, reportOf(set, Picture().options)},
        {&set, reportOf(set, {})},
        {&gearbox, reportOf(gearbox, state)},
    };
    for (const auto& [train, report] : cases) {
      for (const ForceTableKind kind : allForceTableKinds()) {
        const ForceTable table = tableOf(*train, report, kind);
        QVERIFY(!table.columns.empty() && table.kind == kind);
        for (const ForceColumn& each : table.columns)
          QVERIFY2(each.meaning.size() > 10 && each.meaning.back() == '.', each.head.c_str());
        for (const ForceRow& row : table.rows) QCOMPARE(row.cells.size(), table.columns.size());
      }
    }
    QVERIFY(!tableOf(gearbox, cases[2].second, ForceTableKind::couplings).rows.empty());
    QVERIFY(!tableOf(gearbox, cases[2].second, ForceTableKind::powers).rows.empty());
  }

  /// The powers at each link sum to 0 in the table, too.
  void powersOfALinkSumToZero() {
    const Picture picture;
    const StaticsCase train(picture.mechanism);
    const ForceTable table = tableOf(train, reportOf(train, picture.options), ForceTableKind::powers);
    std::map<std::string, double> sums;
    for (const ForceRow& row : table.rows) sums[row.cells[1].text] += row.cells[3].number.value();
    QVERIFY(sums.size() > 3);
    for (const auto& [link, sum] : sums) QVERIFY2(std::abs(sum) < 1e-9, link.c_str());
  }

  /// The torques that cross the cutset of every joint add up to 0 with and without losses, brakes, forces.
  void everyCutsetIsInBalance() {
    const Mechanism robot = example("robot");
    StaticsOptions onRobot;
    onRobot.loads = {{{}, JointTorque{robot.turningJoints[6].id, Number(10)}},
                     {{}, JointTorque{robot.turningJoints[4].id, Number(-3)}}};
    StaticsOptions state;
    state.state = 0;
    state.losses = true;
    state.efficiency = Rational(49, 50);
    StaticsOptions loaded = state;
    loaded.loads = {{{}, LinkTorque{LinkId("1"), {}, Number(2)}},
                    {{}, LinkForce{LinkId("3"), {Number(0), Number(1), Number(0)}, {}}}};
    const Picture picture;
    const std::pair<Mechanism, StaticsOptions> cases[] = {{picture.mechanism, picture.options},
                                                          {robot, onRobot},
                                                          {eightSpeed(), state},
                                                          {eightSpeed(), loaded}};
    int meshes = 0;
    int couplings = 0;
    for (const auto& [mechanism, options] : cases) {
      const StaticsCase train(mechanism);
      const StaticsReport report = reportOf(train, options);
      QVERIFY(report.lossless.isBalanced());
      for (int joint = 0; joint < train.model.t(); ++joint) {
        const auto words = cutsetWords(train.mechanism, train.model, train.placement, report, joint);
        QVERIFY(words.has_value());
        QVERIFY(!words->beyond.empty());
        Real sum;
        for (const CutsetTerm& term : words->terms) {
          sum += term.torque;
          meshes += term.element.kind == ElementKind::gearMesh && !term.torque.isZero() ? 1 : 0;
          couplings += term.element.kind == ElementKind::coupling && !term.torque.isZero() ? 1 : 0;
        }
        QVERIFY2(std::abs(sum.number()) < 1e-9, (words->sentence + words->equation).c_str());
      }
    }
    QVERIFY(meshes > 20);
    QVERIFY(couplings > 3);
  }

  void aCutsetAndADriverInWords() {
    const Picture picture;
    const StaticsCase train(picture.mechanism);
    StaticsOptions lossless = picture.options;
    lossless.losses = false;
    const StaticsReport report = reportOf(train, lossless);
    const auto words = cutsetWords(train.mechanism, train.model, train.placement, report, 2);
    QCOMPARE(words->sentence, std::string("Joint 7 cuts off links 3 and 4: meshes 9 and 10 cross."));
    QCOMPARE(words->equation, std::string("T7 + M9 + M10 = 0: -35 + 10 + 25 = 0 N m"));
    QCOMPARE(words->elements().size(), std::size_t{5});
    QCOMPARE(*driverSentence(train.mechanism, train.placement, report, 0),
             std::string("Gear 1 drives gear 4 in mesh 9: seen from carrier 3, it turns against the teeth's "
                         "torque on it and passes 714.286 W."));
    StaticsOptions unloaded = lossless;
    unloaded.loads.clear();
    QVERIFY(driverSentence(train.mechanism, train.placement, reportOf(train, unloaded), 0)
                ->find("bears no load") != std::string::npos);
    StaticsOptions loose = lossless;
    loose.balances = {{train.mechanism.turningJoints[1].id}};
    QVERIFY(!cutsetWords(train.mechanism, train.model, train.placement, reportOf(train, loose), 2));
  }

  void aCurveAsATable() {
    const Picture picture;
    const StaticsCase train(picture.mechanism);
    StaticsOptions options = picture.options;
    options.efficiency = Rational(49, 50);
    const StaticsReport report = reportOf(train, options);
    const auto curve = efficiencyCurve(train.mechanism, train.model, train.placement, train.analysis, report,
                                       options, CurveAxis::speedRatio, {Rational(0), Rational(1), 2});
    const ValueTable table = efficiencyTable(train.mechanism, report, *curve);
    QCOMPARE(table.columns.size(), std::size_t{5});
    QCOMPARE(table.columns[0].head, std::string("speed of joint 6 / joint 5"));
    QCOMPARE(table.columns[3].head, std::string("torque at joint 6"));
    QCOMPARE(table.rows.size(), std::size_t{2});
    QCOMPARE(*table.rows[0].cells[1].number, Rational(3401, 3500).toDouble());
    QCOMPARE(*table.rows[0].cells[3].number, 24.01);
    QCOMPARE(*table.rows[1].cells[1].number, 1.0);
  }

  void sharedLoadsHaveNoNumber() {
    Picture picture(3);
    picture.options.losses = false;
    const StaticsCase train(picture.mechanism);
    const StaticsReport report = reportOf(train, picture.options);
    const ForceTable meshes = tableOf(train, report, ForceTableKind::meshes);
    QCOMPARE(column(meshes, "on tail").front(), std::string("shared"));
    QCOMPARE(column(meshes, "tangential").front(), std::string("shared"));
    QVERIFY(!meshes.rows[0].cells[4].number.has_value());
    QCOMPARE(column(tableOf(train, report, ForceTableKind::joints), "lossless")[1], std::string("25"));
  }

  void csvHasUnitsAndDecimals() {
    const Picture picture;
    const StaticsCase train(picture.mechanism);
    const ForceTable table = tableOf(train, reportOf(train, picture.options), ForceTableKind::joints);
    TextSink sink;
    writeForceCsv(sink, table);
    const std::string csv = sink.take();
    QCOMPARE(csv.substr(0, csv.find("\n8,")),
             std::string("at,turns,carried by,lossless [N m],torque [N m],rate [rad/s],power [W]\n"
                         "5,1 sun,load,10,10,100,1000\n"
                         "6,2,balance,25,24.01,0,0\n"
                         "7,3,balance,-35,-34.01,28.571428571428573,-971.7142857142857"));
    TextSink german;
    writeForceCsv(german, table, CsvOptions{';', ',', false, false});
    QVERIFY(german.text().starts_with("5;1 sun;load;10;10;100;1000\n6;2;balance;25;24,01;0;0\n"));
    TextSink quoted;
    writeForceCsv(quoted, table, CsvOptions{',', ',', false, false});
    QVERIFY(quoted.text().find("25,\"24,01\",0,0") != std::string::npos);
  }

  /// The torques of a gearbox's couplings as multiples of the input torque; what is open has none.
  void theShiftTable() {
    const StaticsCase train(eightSpeed());
    std::vector<StateForces> states;
    for (int state = 0; state < static_cast<int>(train.mechanism.states.size()); ++state) {
      StaticsOptions options;
      options.state = state;
      options.losses = true;
      options.efficiency = Rational(98, 100);
      states.push_back({state, reportOf(train, options)});
    }
    states.push_back({0, std::nullopt});  // nothing was solved
    const ForceTable table = shiftTable(train.mechanism, states);
    QCOMPARE(table.rows.size(), std::size_t{10});
    QCOMPARE(table.columns.size(), std::size_t{13});
    QCOMPARE(column(table, "exact ratio")[0], std::string("108/23"));
    StaticsOptions lossless;
    lossless.state = 0;
    const std::vector<StateForces> first{{0, reportOf(train, lossless)}};
    QCOMPARE(shiftTable(train.mechanism, first).rows[0].cells[2].exact, std::string("170/69"));
    QCOMPARE(column(table, "state")[5], std::string("6"));
    QCOMPARE(column(table, "efficiency")[5], std::string("1"));  // direct drive
    QCOMPARE(column(table, "circulating")[5], std::string("0"));
    for (std::size_t row = 0; row < 9; ++row) {
      const auto& engaged = states[row].report->problem.engaged;
      for (int coupling = 0; coupling < 5; ++coupling) {
        const bool isEngaged = std::find(engaged.begin(), engaged.end(), coupling) != engaged.end();
        QCOMPARE(table.rows[row].cells[1 + static_cast<std::size_t>(coupling)].number.has_value(), isEngaged);
      }
      // Torques from outside add up to 0: the input's, the output's, those of the brakes A and B.
      double sum = 1 + table.rows[row].cells[8].number.value();
      for (const std::size_t brake : {1U, 2U}) sum += table.rows[row].cells[brake].number.value_or(0);
      QVERIFY(std::abs(sum) < 1e-12);
    }
    QVERIFY(column(table, "efficiency").back().empty());
    for (const ForceColumn& each : table.columns) QVERIFY(each.meaning.back() == '.');
  }

  void withoutEquilibriumThereAreNoRows() {
    const StaticsCase train(Picture().mechanism);
    StaticsOptions options = Picture().options;
    options.balances.pop_back();
    const StaticsReport report = reportOf(train, options);
    QVERIFY(!report.lossless.isBalanced());
    for (const ForceTableKind kind : allForceTableKinds()) QVERIFY(tableOf(train, report, kind).rows.empty());
  }

  /// Row 10 of P holds the speeds of mesh 10, column 6 the torque in joint 6; they have 60 teeth in common.
  void aRowAndAColumnHaveAnEntryInCommon() {
    const Picture picture;
    const StaticsCase train(picture.mechanism);
    const StaticsReport report = reportOf(train, picture.options);
    const auto dual = dualEquations(train.mechanism, train.model, train.placement, report, 1, 1);
    QVERIFY(dual);
    QCOMPARE(dual->joints, (std::vector{1, 2, 3}));
    QCOMPARE(dual->meshes, (std::vector{1}));
    QCOMPARE(std::abs(dual->cells[0][0]), 60);
    QVERIFY2(dual->speeds.ends_with(" = 0"), dual->speeds.c_str());
    QCOMPARE(dual->torque, std::string("24.01"));
    // Every row is an equation that the speeds fulfil.
    for (int joint = 0; joint < train.model.t(); ++joint) {
      const auto each = dualEquations(train.mechanism, train.model, train.placement, report, joint, {});
      QVERIFY(each && each->joint == joint);
      Rational speeds;
      const auto row = std::find(each->meshes.begin(), each->meshes.end(), each->mesh) - each->meshes.begin();
      const std::vector<int>& cells = each->cells[static_cast<std::size_t>(row)];
      for (std::size_t at = 0; at < cells.size(); ++at)
        speeds += Rational(cells[at]) * (*report.motion)[static_cast<std::size_t>(each->joints[at])];
      QVERIFY(speeds.isZero());
    }
    // By itself a mesh is shown with a joint of its cycle.
    QCOMPARE(dualEquations(train.mechanism, train.model, train.placement, report, {}, 0)->joint, 0);
    QCOMPARE(dualEquations(train.mechanism, train.model, train.placement, report, {}, {})->mesh, 0);
  }

  /// Without losses every column of P is a torque, with one force per tooth for each mesh.
  void columnsOfDualEquationsAreTorques() {
    Picture picture;
    picture.options.losses = false;
    const StaticsCase train(picture.mechanism);
    const StaticsReport report = reportOf(train, picture.options);
    const auto at = [&](int joint) {
      return *dualEquations(train.mechanism, train.model, train.placement, report, joint, {});
    };
    // Joint 5 has mesh 9 alone, joint 6 mesh 10 alone; both are in joint 7, where the sun's 10 and the ring's
    // 25 N m are held by -35.
    const double sun = 10.0 / at(0).cells[0][0];  // its row begins with joint 5
    const double ring = 25.0 / at(1).cells[0][0];
    const DualEquations carrier = at(2);
    QCOMPARE(carrier.meshes, (std::vector{0, 1}));
    const auto column =
        std::size_t(std::find(carrier.joints.begin(), carrier.joints.end(), 2) - carrier.joints.begin());
    const double held = carrier.cells[0][column] * sun + carrier.cells[1][column] * ring;
    QVERIFY2(std::abs(held + 35) < 1e-9, qPrintable(QString::number(held)));
    QCOMPARE(carrier.torque, std::string("-35"));
  }
};

QTEST_APPLESS_MAIN(ForceTablesTest)
#include "test_force_tables.moc"
