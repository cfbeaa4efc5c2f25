#include <QTest>
#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/shift_edits.h"
#include "core/theory/analysis/analysis.h"
#include "core/theory/states/engagement.h"
#include "core/theory/states/relative_speed.h"
#include "core/theory/states/state_edits.h"
#include "tests/core/support/diagnostic_codes.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/gearboxes.h"
#include "tests/core/support/train_sketch.h"
#include "tests/core/support/trains.h"

namespace geargraph {
namespace {

using test::codesOf;
/// Both steps, without what the teeth have to say.
SnapshotPtr analysed(const Mechanism& mechanism) {
  const SnapshotPtr live = analyzeStates(analyzeLive(std::make_shared<const Mechanism>(mechanism)));
  auto snapshot = std::make_shared<AnalysisSnapshot>(*live);
  if (live->matroid() != nullptr && live->matroid()->solution)
    snapshot->solved = solvedKinematics(*live->mechanism, *live->kinematics);
  return snapshot;
}

Mechanism engaging(const Mechanism& mechanism, const std::vector<ShiftElementId>& couplings) {
  return withEngagement(mechanism, couplings).value();
}

bool has(const AnalysisSnapshot& snapshot, Code code) {
  const std::vector<Code> codes = codesOf(snapshot.diagnostics);
  return std::find(codes.begin(), codes.end(), code) != codes.end();
}

const Diagnostic& diagnosticOf(const AnalysisSnapshot& snapshot, Code code) {
  return *std::find_if(snapshot.diagnostics.begin(), snapshot.diagnostics.end(),
                       [&](const Diagnostic& each) { return each.code == code; });
}

/// A sum of turns about directions, in doubles: nothing where it turns at 0.
Vector3 velocityOf(const AnalysisSnapshot& snapshot, int link, const std::vector<Rational>& rates) {
  Vector3 sum{0, 0, 0};
  const Placement& placement = snapshot.kinematics->placement();
  for (const PathStep& step : treePath(*snapshot.tree, 0, link)) {
    const auto joint = static_cast<std::size_t>(step.joint);
    const Vector3& direction =
        placement.axes[static_cast<std::size_t>(placement.tree->axisOf[joint])].direction;
    sum = sum + (step.direction * rates[joint].toDouble()) * direction;
  }
  return sum;
}

/// Does every engaged brake hold its link, and turn every engaged clutch its two as one? In exact rates, from
/// the joints between the links alone.
void engagedCouplingsHold(const AnalysisSnapshot& snapshot) {
  const Mechanism& mechanism = *snapshot.mechanism;
  const std::vector<Rational>& rates = snapshot.solved->exact->rates;
  double fastest = 1;
  for (const Rational& rate : rates) fastest = std::max(fastest, std::abs(rate.toDouble()));
  const auto linkAt = [&](LinkId id) {
    return static_cast<int>(std::find_if(mechanism.links.begin(), mechanism.links.end(),
                                         [&](const Link& link) { return link.id == id; }) -
                            mechanism.links.begin());
  };
  for (const int position : engagedCouplings(mechanism)) {
    const ShiftElement& coupling = mechanism.couplings[static_cast<std::size_t>(position)];
    Vector3 slip = velocityOf(snapshot, linkAt(coupling.links.front()), rates);
    if (coupling.kind == ShiftElementKind::clutch)
      slip = slip - velocityOf(snapshot, linkAt(coupling.links.back()), rates);
    QVERIFY2(length(slip) <= 1e-9 * fastest, qPrintable(QString::fromStdString(coupling.id.text())));
    if (coupling.kind == ShiftElementKind::brake)
      QVERIFY(absoluteSpeed(snapshot.kinematics->placement(), rates, linkAt(coupling.links.front())).empty());
  }
}

/// Both methods say the same, exactly and in symbols, about the train as engaged; and the matrices are those
/// of the train without couplings.
void bothMethodsAgreeAsEngaged(const AnalysisSnapshot& snapshot) {
  QVERIFY(snapshot.solved && snapshot.solved->agreement);
  const MatroidAnalysis& matroid = *snapshot.matroid();
  const SolvedKinematics& solved = *snapshot.solved;
  QVERIFY(solved.agreement->equal);
  QCOMPARE(static_cast<int>(matroid.choice.joints.size()), matroid.dof);
  QCOMPARE(matroid.rank, static_cast<int>(matroid.independentMeshes.size() + matroid.independentHeld.size()));
  QCOMPARE(static_cast<int>(matroid.redundancies.size()),
           snapshot.kinematics->model->equations() - matroid.rank);
  const auto determination = ttDetermination(*snapshot.kinematics->ttGraph, solved.ttPlan).value();
  QVERIFY(determination.valid());
  QCOMPARE(static_cast<int>(determination.surplusEquations.size()),
           snapshot.kinematics->ttGraph->equations() - matroid.rank);
  const SubstitutionPlan byLevels = substitutionPlan(*snapshot.kinematics->ttGraph, matroid.choice.joints, 0);
  QCOMPARE(ttRates(*snapshot.kinematics->ttGraph, byLevels, matroid.speeds).value(), solved.exact->rates);
  for (std::size_t joint = 0; joint < solved.exact->rates.size(); ++joint) {
    const double expected = solved.exact->rates[joint].toDouble();
    QVERIFY(std::abs(matroid.solution->rates[joint] - expected) <= 1e-9 * (1 + std::abs(expected)));
    QCOMPARE(matroid.solution->rates[joint] == 0, solved.exact->rates[joint].isZero());
  }
  if (solved.symbolic) {
    const auto ratios = solved.symbolic->ring->values();
    for (std::size_t entry = 0; entry < solved.symbolic->matrix.size(); ++entry) {
      if (const auto& function = solved.symbolic->matrix[entry])
        QCOMPARE(function->valueAt(ratios).value(), solved.exact->matrix[entry]);
    }
  }
  engagedCouplingsHold(snapshot);
}

/// A random train with some random brakes and clutches on it, all of which close without a linkage.
Mechanism randomGearbox(int seed, int links, int couplings) {
  std::mt19937_64 random(static_cast<std::uint64_t>(seed) * 7919);
  const auto below = [&](int limit) {
    return static_cast<int>(random() % static_cast<std::uint64_t>(limit));
  };
  Mechanism train = test::randomTrain(random(), links, links / 2 + below(links / 2));
  train = test::moved(train, test::rotation(1 + below(4), below(4), below(3) - 1, below(4)),
                      {below(90), -below(70), Rational(below(500), 11)});
  const Placement placement = placementOf(train);
  std::vector<ShiftElementId> engaged;
  for (int i = 0; i < couplings; ++i) {
    const LinkId one = train.links[static_cast<std::size_t>(1 + below(train.n()))].id;
    const LinkId other = train.links[static_cast<std::size_t>(1 + below(train.n()))].id;
    const auto more = below(2) == 0 || one == other ? withBrake(train, one) : withClutch(train, one, other);
    const auto position = static_cast<int>(more->couplings.size()) - 1;
    if (!closesWithoutLinkage(*more, placement, position)) continue;
    train = *more;
    engaged.push_back(train.couplings.back().id);
  }
  return engaging(train, engaged);
}

/// Sun 1, ring 2, carrier 3, planet 4, the ring held by brake A; driven at the sun and at the ring.
Mechanism heldPlanetary() {
  Mechanism set = test::planetary(18, 27);
  set.inputs = {{set.turningJoints[0].id, Number(1), {}}, {set.turningJoints[1].id, Number(7), {}}};
  return engaging(*withBrake(set, set.links[2].id), {ShiftElementId("A")});
}

}  // namespace

/// The train as its document engages its couplings, by both methods.
class EngagementTest : public QObject {
  Q_OBJECT

 private slots:
  void everyStateOfEveryExample_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("state");
    int states = 0;
    for (const std::string& name : test::exampleNames()) {
      const Mechanism example = test::example(name);
      for (std::size_t i = 0; i < example.states.size(); ++i, ++states)
        QTest::addRow("%s, %s", name.c_str(), example.states[i].name.c_str())
            << QString::fromStdString(name) << static_cast<int>(i);
    }
    QVERIFY(states >= 17);
  }

  void everyStateOfEveryExample() {
    QFETCH(QString, name);
    QFETCH(int, state);
    const Mechanism example = test::example(name.toStdString());
    const Mechanism engaged = withStateEngaged(example, state).value();
    QVERIFY(isEngaged(engaged, state));
    const SnapshotPtr snapshot = analysed(engaged);
    QVERIFY(!hasErrors(snapshot->diagnostics));
    bothMethodsAgreeAsEngaged(*snapshot);
    const StateSolution& solution = (*snapshot->states)[static_cast<std::size_t>(state)];
    QCOMPARE(snapshot->matroid()->dof, solution.dof);
    QCOMPARE(snapshot->matroid()->rank, solution.rank);
    QCOMPARE(snapshot->solved->exact->rates, solution.rates);  // the drive turns at 1

    // What is engaged changes no matrix, and releasing leaves valid inputs.
    const SnapshotPtr released = analysed(*withCouplingsEngaged(engaged, {}));
    QVERIFY(!hasErrors(released->diagnostics));
    QCOMPARE(released->solved->exact->rates, snapshot->solved->exact->rates);  // the motion stays
    for (const MatrixKind kind : allMatrixKinds()) {
      const IntegerMatrix& one = *snapshot->matrix(kind);
      const IntegerMatrix& other = *released->matrix(kind);
      QCOMPARE(one.rows(), other.rows());
      for (int row = 0; row < one.rows(); ++row)
        for (int column = 0; column < one.columns(); ++column)
          QCOMPARE(one.entry(row, column), other.entry(row, column));
    }
    QCOMPARE(
        CoefficientMatrix(engaged, *snapshot->kinematics->model, snapshot->kinematics->placement()).rows(),
        engaged.c());
  }

  void randomTrainsWithRandomCouplings_data() {
    QTest::addColumn<int>("links");
    QTest::addColumn<int>("seed");
    for (int seed = 1; seed <= 120; ++seed) QTest::addRow("%d", seed) << 6 + seed % 25 << seed;
  }

  void randomTrainsWithRandomCouplings() {
    QFETCH(int, links);
    QFETCH(int, seed);
    bothMethodsAgreeAsEngaged(*analysed(randomGearbox(seed, links, 1 + seed % 5)));
  }

  void couplingsAcrossAxesHoldEveryDirection() {
    const Mechanism differential = test::bevelDifferential();
    for (const ShiftElement& coupling : differential.couplings) {
      const SnapshotPtr snapshot = analysed(engaging(differential, {coupling.id}));
      bothMethodsAgreeAsEngaged(*snapshot);
      // A brake on the pinion holds the carrier too: two rows, of one coupling.
      if (coupling.id == ShiftElementId("P")) {
        QCOMPARE(snapshot->kinematics->model->held().size(), std::size_t(2));
        QVERIFY(has(*snapshot, Code::locked));
      }
    }
  }

  /// A clutch ties links that turn about one line against each other: on one axis, or a planet and its
  /// carrier.
  void aClutchBetweenDifferentAxesIsAnError() {
    const Mechanism set = test::planetary(18, 27);  // sun 1, ring 2, carrier 3, planet 4
    const auto errorOf = [&](int one, int other) -> std::optional<Diagnostic> {
      const Mechanism coupled = withClutch(set, set.links[one].id, set.links[other].id).value();
      const SnapshotPtr snapshot = analysed(coupled);
      for (const Diagnostic& each : snapshot->diagnostics)
        if (each.detail == Detail::clutchAxes) return each;
      return std::nullopt;
    };
    QVERIFY(!errorOf(1, 2) && !errorOf(1, 3) && !errorOf(3, 4));
    for (const int central : {0, 1, 2}) {
      const auto error = errorOf(4, central);
      QVERIFY(error && error->severity() == Severity::error && error->code == Code::turningLoop);
      QVERIFY(error->elements.front() == ElementId(ShiftElementId("A")));
      QVERIFY(error->message.find("their axes are not one line") != std::string::npos);
    }
  }

  /// One that closes a linkage as well is reported once.
  void aClutchBetweenDifferentAxesIsReportedOnce() {
    Mechanism robot = withClutch(test::example("robot"), LinkId("1"), LinkId("7")).value();
    robot.engaged = {robot.couplings.back().id};
    const SnapshotPtr snapshot = analysed(robot);
    const Diagnostics& diagnostics = snapshot->diagnostics;
    const auto isOfClutch = [](const Diagnostic& each) { return each.code == Code::turningLoop; };
    QCOMPARE(std::count_if(diagnostics.begin(), diagnostics.end(), isOfClutch), std::ptrdiff_t{1});
  }

  /// The ring is held while teeth change: what turned it before was a speed that went with the old teeth.
  void aHeldRingStandsAfterAChangeOfTeeth() {
    const Mechanism held = heldPlanetary();
    for (const Mechanism& mechanism : {held, withTeeth(held, held.gearMeshes[0].id, 24, 27).value(),
                                       withName(held, held.links[1].id, "sun").value()}) {
      const SnapshotPtr snapshot = analysed(mechanism);
      QCOMPARE(mechanism.engaged, std::vector{ShiftElementId("A")});
      QCOMPARE(snapshot->matroid()->dof, 1);
      QCOMPARE(snapshot->matroid()->choice.joints, std::vector{0});
      QCOMPARE(snapshot->solved->exact->rates[1], Rational(0));
      QVERIFY(snapshot->matroid()->linkVelocities[2] == (Vector3{0, 0, 0}));
      bothMethodsAgreeAsEngaged(*snapshot);
    }
  }

  /// Inputs that a coupling decides wait: they drive again once it is released.
  void inputsThatFollowAreNotDriven() {
    const Mechanism held = heldPlanetary();
    const SnapshotPtr snapshot = analysed(held);
    QCOMPARE(snapshot->matroid()->choice.rejected, std::vector{1});
    QVERIFY(!hasErrors(snapshot->diagnostics));
    const SnapshotPtr released = analysed(engaging(held, {}));
    QCOMPARE(released->matroid()->choice.joints, (std::vector{0, 1}));
    QCOMPARE(released->solved->exact->rates[1], Rational(7));
  }

  void missingAndRepeatedInputsAreStillErrors() {
    Mechanism held = heldPlanetary();
    held.inputs = std::vector<Input>();
    QVERIFY(has(*analysed(held), Code::invalidInputs));
    held.inputs = {{held.turningJoints[0].id, Number(1), {}}, {held.turningJoints[0].id, Number(1), {}}};
    QVERIFY(has(*analysed(held), Code::invalidInputs));
    held.inputs.reset();
    QCOMPARE(analysed(held)->matroid()->choice.joints, std::vector{0});
  }

  void whatHoldsNothingIsNamed() {
    Mechanism box = test::eightSpeed();
    const auto state = box.states[0].engaged;
    box = engaging(box, state);
    QVERIFY(!has(*analysed(box), Code::redundantCoupling) && !has(*analysed(box), Code::deadJoint));
    box = *withBrake(box, box.couplings[0].links.front(), "A2");  // holds what A holds
    box.engaged.push_back(ShiftElementId("A2"));
    const SnapshotPtr snapshot = analysed(box);
    const Diagnostic& diagnostic = diagnosticOf(*snapshot, Code::redundantCoupling);
    QCOMPARE(diagnostic.message, std::string("Brake A2 is engaged and holds nothing that could move: that "
                                             "follows from brake A."));
    QVERIFY(diagnostic.elements.front() == ElementId(ShiftElementId("A2")));
    bothMethodsAgreeAsEngaged(*snapshot);
  }

  void aLockedEngagementNamesItsCouplings() {
    Mechanism box = test::eightSpeed();
    box = engaging(box, {ShiftElementId("A"), ShiftElementId("B"), ShiftElementId("C"), ShiftElementId("D")});
    const SnapshotPtr snapshot = analysed(box);
    QCOMPARE(snapshot->matroid()->dof, 0);
    const Diagnostic& diagnostic = diagnosticOf(*snapshot, Code::locked);
    QVERIFY(diagnostic.message.find("brake A, brake B, clutch C and clutch D hold everything") !=
            std::string::npos);
    QVERIFY(std::all_of(snapshot->solved->exact->rates.begin(), snapshot->solved->exact->rates.end(),
                        [](const Rational& rate) { return rate.isZero(); }));
  }

  /// Engaged by hand, one after the other: what a coupling decides is driven no longer, what comes free is
  /// driven as fast as it turns.
  void theInputsFollowTheCouplings() {
    const Mechanism box = test::example("eight-speed-gearbox");  // driven: 13 at 1, 14 and 15 at 0, 18 at 1
    const auto drivenBy = [](const Mechanism& mechanism) {
      QStringList joints;
      for (const Input& input : *mechanism.inputs)
        joints << QString::fromStdString(input.joint.text() + ":" + input.speed.text());
      return joints.join(QLatin1Char(' '));
    };
    Mechanism now = *withCouplingEngaged(box, ShiftElementId("A"), true);
    QCOMPARE(drivenBy(now), QStringLiteral("13:1 15:0 18:1"));
    now = *withCouplingEngaged(now, ShiftElementId("C"), true);
    QCOMPARE(drivenBy(now), QStringLiteral("13:1 15:0"));
    now = *withCouplingEngaged(now, ShiftElementId("A"), false);
    QCOMPARE(drivenBy(now), QStringLiteral("13:1 15:0 14:0"));
    QVERIFY(!hasErrors(analysed(now)->diagnostics));
    Mechanism chosen = box;
    chosen.inputs.reset();
    QVERIFY(!withCouplingEngaged(chosen, ShiftElementId("A"), true)->inputs);
    QCOMPARE(withCouplingEngaged(box, ShiftElementId("X"), false).error()[0].code, Code::unknownId);
  }

  void statesAreSolvedWhateverIsEngaged() {
    const Mechanism box = test::eightSpeed();
    const SnapshotPtr bare = analysed(box);
    const SnapshotPtr engaged = analysed(engaging(box, {ShiftElementId("B"), ShiftElementId("E")}));
    QCOMPARE(engaged->matroid()->dof, 2);
    for (std::size_t i = 0; i < box.states.size(); ++i)
      QCOMPARE((*engaged->states)[i].ratio, (*bare->states)[i].ratio);
  }

  /// Two states with the same couplings and different drives are told apart by what is driven.
  void aStateBringsItsDrive() {
    const Mechanism simpson = test::example("simpson");
    const Mechanism first = withStateEngaged(simpson, 0).value();
    const Mechanism reverse = withStateEngaged(simpson, 3).value();
    QCOMPARE(first.engaged, reverse.engaged);
    QCOMPARE(engagedState(first), 0);
    QCOMPARE(engagedState(reverse), 3);
    QCOMPARE(engagedState(simpson), -1);
    QCOMPARE(first.inputs->size(), std::size_t(1));
    QCOMPARE(analysed(reverse)->matroid()->choice.joints, std::vector{0});
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::EngagementTest)
#include "test_engagement.moc"
