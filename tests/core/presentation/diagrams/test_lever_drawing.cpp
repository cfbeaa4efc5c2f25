#include <QTest>
#include <algorithm>
#include <map>

#include "core/presentation/diagrams/bar_lengths.h"
#include "core/presentation/diagrams/lever_card.h"
#include "core/presentation/diagrams/lever_drawing.h"
#include "core/presentation/diagrams/lever_layout.h"
#include "core/presentation/diagrams/lever_words.h"
#include "core/presentation/diagrams/nomogram.h"
#include "core/presentation/diagrams/point_plan.h"
#include "core/presentation/diagrams/speed_plan_drawing.h"
#include "core/presentation/drawing/hit_test.h"
#include "core/presentation/export_api/levers_json.h"
#include "core/presentation/export_api/named_drawings.h"
#include "core/theory/states/state_edits.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/gearboxes.h"
#include "tests/core/support/snapshot_of.h"
#include "tests/core/support/train_sketch.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

SnapshotPtr liveOf(Mechanism mechanism) {
  return analyzeLive(std::make_shared<const Mechanism>(std::move(mechanism)));
}

/// An example, and with each of its states engaged.
std::vector<std::pair<std::string, SnapshotPtr>> snapshotsOf(const std::string& name) {
  const Mechanism mechanism = example(name);
  std::vector<std::pair<std::string, SnapshotPtr>> all{{name, liveOf(mechanism)}};
  for (std::size_t state = 0; state < mechanism.states.size(); ++state) {
    all.emplace_back(name + ' ' + mechanism.states[state].name,
                     liveOf(*withStateEngaged(mechanism, static_cast<int>(state))));
  }
  return all;
}

/// Texts that touch each other or a disc that is not theirs.
std::string overlapsIn(const DisplayList& list) {
  struct Placed {
    std::string text;
    Extent extent;
  };
  std::vector<Placed> texts;
  std::vector<Extent> discs;
  for (const Mark& mark : list.marks) {
    if (const auto* const text = std::get_if<Text>(&mark.what))
      texts.push_back({text->text, extentOf(mark).grown(-0.5)});
    if (const auto* const fill = std::get_if<Fill>(&mark.what);
        fill != nullptr && mark.role == MarkRole::node)
      discs.push_back(extentOf(fill->shape).grown(-0.5));
  }
  std::string found;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    for (std::size_t j = i + 1; j < texts.size(); ++j) {
      if (texts[i].extent.meets(texts[j].extent)) found += texts[i].text + " on " + texts[j].text + "; ";
    }
    for (const Extent& disc : discs) {
      const bool isItsOwn = std::abs(disc.center.x - texts[i].extent.center.x) < 0.01 &&
                            std::abs(disc.center.y - texts[i].extent.center.y) < 0.01;
      if (!isItsOwn && disc.meets(texts[i].extent)) found += texts[i].text + " on a disc; ";
    }
  }
  return found;
}

std::vector<std::string> textsIn(const DisplayList& list) {
  std::vector<std::string> texts;
  for (const Mark& mark : list.marks) {
    if (const auto* const text = std::get_if<Text>(&mark.what)) texts.push_back(text->text);
  }
  return texts;
}

bool says(const DisplayList& list, const std::string& words) {
  const auto texts = textsIn(list);
  return std::any_of(texts.begin(), texts.end(),
                     [&](const std::string& text) { return text.find(words) != std::string::npos; });
}

/// Planetary sets in a row: the ring of each is the sun of the next.
Mechanism chainOf(int sets) {
  TrainSketch train(1 + 3 * sets);
  for (int link = 1; link <= 1 + 2 * sets; ++link) train.joint(0, link, "a");
  for (int set = 0; set < sets; ++set)
    train.joint(3 + 2 * set, 2 + 2 * sets + set, "p" + std::to_string(set));
  for (int set = 0; set < sets; ++set) {
    const int planet = 2 + 2 * sets + set;
    train.mesh(set == 0 ? 1 : 2 * set, planet, 20, 20, MeshKind::external);
    train.mesh(planet, 2 + 2 * set, 20, 60, MeshKind::internal);
  }
  return train.build();
}

LeverLayout layoutOf(const SnapshotPtr& snapshot) {
  return leverLayout(*snapshot->mechanism, leverPictureOf(*snapshot)->plan);
}

}  // namespace

class LeverDrawingTest : public QObject {
  Q_OBJECT

 private slots:
  void noTextOverlapsInAnyExample_data() {
    QTest::addColumn<QString>("name");
    for (const std::string& name : exampleNames())
      QTest::newRow(name.c_str()) << QString::fromStdString(name);
  }
  void noTextOverlapsInAnyExample() {
    QFETCH(const QString, name);
    for (const auto& [title, snapshot] : snapshotsOf(name.toStdString())) {
      for (const char* const drawing : {"levers", "nomogram", "plan"}) {
        const DisplayList list = drawingNamed(drawing)->draw(*snapshot, nullptr, {});
        QVERIFY2(!list.marks.empty(), title.c_str());
        QVERIFY2(overlapsIn(list).empty(), (title + ", " + drawing + ": " + overlapsIn(list)).c_str());
      }
    }
  }

  void barsOfTheEightSpeedGearboxCloseLevel() {
    const LeverLayout layout = layoutOf(liveOf(example("eight-speed-gearbox")));
    QCOMPARE(layout.bars.size(), std::size_t{4});
    std::vector<std::string> lengths;
    for (std::size_t bar = 0; bar < 4; ++bar) {
      QCOMPARE(layout.bars[bar].lever, static_cast<int>(bar));
      QVERIFY(layout.bars[bar].bottom.isZero());
      lengths.push_back(layout.bars[bar].length.toString());
    }
    QCOMPARE(lengths, (std::vector<std::string>{"9/5", "1", "1", "6/5"}));
    QCOMPARE(layout.ties.size(), std::size_t{4});
    for (const BarTie& tie : layout.ties) QVERIFY(tie.isLevel);
  }

  void tiesAreLevelExactlyAndPassNoBar() {
    for (const std::string& name : exampleNames()) {
      const SnapshotPtr snapshot = liveOf(example(name));
      const LeverPlan plan = leverPictureOf(*snapshot)->plan;
      const LeverLayout layout = leverLayout(*snapshot->mechanism, plan);
      for (const BarTie& tie : layout.ties) {
        if (!tie.isLevel) continue;
        const auto height = [&](int bar) {
          const BarPlace& place = layout.bars[static_cast<std::size_t>(bar)];
          return place.heightOf(*plan.levers[static_cast<std::size_t>(place.lever)].pointOf(tie.link));
        };
        QVERIFY2(height(tie.from) == height(tie.to), name.c_str());
        for (int bar = tie.from + 1; bar < tie.to; ++bar) {
          const BarPlace& place = layout.bars[static_cast<std::size_t>(bar)];
          QVERIFY2(height(tie.from) < place.bottom || place.bottom + place.length < height(tie.from),
                   name.c_str());
        }
      }
    }
  }

  void manyBarsAreLaidOutOneByOne() {
    for (const int sets : {5, 9}) {
      const SnapshotPtr snapshot = liveOf(chainOf(sets));
      const LeverLayout layout = layoutOf(snapshot);
      QCOMPARE(layout.bars.size(), static_cast<std::size_t>(sets));
      QCOMPARE(layout.ties.size(), static_cast<std::size_t>(sets - 1));
      for (const BarTie& tie : layout.ties) {
        QVERIFY(tie.isLevel);
        QCOMPARE(tie.to, tie.from + 1);
      }
      QVERIFY(layout.height <= Rational(3, 2));  // bars turned over in turns stay side by side
      const DisplayList list = drawingNamed("levers")->draw(*snapshot, nullptr, {});
      QVERIFY2(overlapsIn(list).empty(), overlapsIn(list).c_str());
    }
  }

  void lengthsAreTheLeastThatFit() {
    // The middle of bar 0 level with the top of bar 2, above bar 1.
    BarDemands demands;
    demands.bars = 3;
    demands.level.push_back({{0, Rational(1, 2)}, {2, 1}});
    demands.passes.push_back({{0, Rational(1, 2)}, 1, true});
    const auto lengths = barLengths(demands);
    QVERIFY(lengths.has_value());
    const Rational level = lengths->bottoms[0] + lengths->lengths[0] / 2;
    QVERIFY(level == lengths->bottoms[2] + lengths->lengths[2]);
    QVERIFY(level - (lengths->bottoms[1] + lengths->lengths[1]) >= barClearance());
    QVERIFY(lengths->height == Rational(17, 10));  // the bar 0 from 7/10 to 17/10 about 6/5
    // Above a bar whose top it is level with: impossible.
    demands.level.push_back({{0, Rational(1, 2)}, {1, 1}});
    QVERIFY(!barLengths(demands));
  }

  void linksAndCouplingsCanBePicked() {
    const SnapshotPtr snapshot = liveOf(*withStateEngaged(example("eight-speed-gearbox"), 4));
    const DisplayList list = drawingNamed("levers")->draw(*snapshot, nullptr, {});
    const LeverPlan plan = leverPictureOf(*snapshot)->plan;
    const auto isPickable = [&](const ElementId& element) {
      return std::any_of(list.outlines.begin(), list.outlines.end(), [&](const Outline& outline) {
        return outline.element == element &&
               elementAt(list.outlines, extentOf(outline.shape).center) == element;
      });
    };
    for (const LinkOrdinal link : plan.links) {
      if (link != 0)
        QVERIFY2(isPickable(snapshot->mechanism->links[link].id), std::to_string(int{link}).c_str());
    }
    for (const ShiftElementId engaged : snapshot->mechanism->engaged) QVERIFY(isPickable(engaged));
  }

  void speedsOfAStateAreWritten() {
    const SnapshotPtr snapshot = liveOf(*withStateEngaged(example("eight-speed-gearbox"), 4));
    const DisplayList list = drawingNamed("levers")->draw(*snapshot, nullptr, {});
    for (const char* const value : {"0.719", "0.422", "2.156", "0.778"}) QVERIFY2(says(list, value), value);
    QVERIFY(says(list, "input") && says(list, "output"));
  }

  /// By itself: the section beside it keeps its texts apart as ever.
  void noTextOverlapsInAnySpeedPlan() {
    int drawn = 0;
    for (const std::string& name : exampleNames()) {
      for (const auto& [title, snapshot] : snapshotsOf(name)) {
        const SpeedPlan plan = *speedPlanFor(*snapshot);
        if (!whyNoSpeedPlan(plan).empty()) continue;
        const DisplayList list = speedPlanDrawing(*snapshot->mechanism, snapshot->kinematics->placement(),
                                                  plan, SchematicGeometry(), {});
        QVERIFY2(overlapsIn(list).empty(), (title + ": " + overlapsIn(list)).c_str());
        ++drawn;
      }
    }
    QVERIFY(drawn > 10);
  }

  void theSpeedPlanStandsBesideTheSection() {
    const SnapshotPtr snapshot = liveOf(example("planetary-ring-held"));
    const DisplayList list = drawingNamed("kutzbach")->draw(*snapshot, nullptr, {});
    for (const char* const words : {"0.286", "peripheral velocity in mm/s", "its slope is the speed"})
      QVERIFY2(says(list, words), words);
    const Extent section = extentOf(drawingNamed("schematic")->draw(*snapshot, nullptr, {}));
    QVERIFY(extentOf(list).right() > section.right() + 100);
    const auto isPickableBeside = [&](const ElementId& element) {
      return std::any_of(list.outlines.begin(), list.outlines.end(), [&](const Outline& outline) {
        return outline.element == element && extentOf(outline.shape).left() > section.right();
      });
    };
    for (const Link& link : snapshot->mechanism->links)
      QVERIFY2(isPickableBeside(link.id), link.id.text().c_str());
    for (const GearMesh& mesh : snapshot->mechanism->gearMeshes) QVERIFY(isPickableBeside(mesh.id));
    // A dotted line leads from the teeth in the section to where the lines cross, at one height.
    int leaders = 0;
    for (const Mark& mark : list.marks) {
      const auto* const stroke = std::get_if<Stroke>(&mark.what);
      const auto* const line = stroke != nullptr ? std::get_if<Polyline>(&stroke->shape) : nullptr;
      if (line == nullptr || stroke->dash != Dash::dotted || line->points.front().x < section.right())
        continue;
      QCOMPARE(line->points.front().y, line->points.back().y);
      ++leaders;
    }
    QCOMPARE(leaders, 2);
    QVERIFY(says(drawingNamed("kutzbach")->draw(*liveOf(example("robot")), nullptr, {}), "parallel"));
    QVERIFY(says(drawingNamed("kutzbach")->draw(*liveOf(example("ravigneaux")), nullptr, {}), "Mesh 14"));
  }

  /// Brake B2 of the Simpson train holds link 4: on the line that is left it is where the ground is, and the
  /// arms give the ratio.
  void anEngagedBrakeProjectsThePlane() {
    const SnapshotPtr snapshot = liveOf(*withStateEngaged(example("simpson"), 0));
    const LeverPlan plan = *pointPlanOf(*snapshot);
    const auto coupling = projectingCoupling(*snapshot->mechanism, plan);
    QVERIFY(coupling.has_value());
    QCOMPARE(snapshot->mechanism->couplings[*coupling].id, ShiftElementId("B2"));
    const auto sheetAt = [&](double progress) {
      return pointPlanSheet(*snapshot->mechanism, plan, PlanProjection{*coupling, progress}, {});
    };
    const PointPlanSheet left = sheetAt(1);
    std::map<int, CanvasPoint> places;
    for (const PointPlanSheet::Spot& spot : left.spots) {
      for (const LinkOrdinal link : spot.links) places[int{link}] = spot.center;
    }
    QCOMPARE(places.size(), std::size_t{5});
    QCOMPARE(places.at(0), places.at(4));
    const double output = distance(places.at(3), places.at(0));
    QVERIFY(std::abs(distance(places.at(2), places.at(0)) / output - 61.0 / 25) < 1e-9);
    QVERIFY(!projectingCoupling(example("simpson"), *pointPlanOf(*liveOf(example("simpson")))));
    QCOMPARE(textOf(left.drawing), textOf(drawingNamed("plan")->draw(*snapshot, nullptr, {})));
    QVERIFY(overlapsIn(left.drawing).empty());
    QVERIFY(textOf(sheetAt(0.5).drawing) != textOf(left.drawing));
  }

  void numbersAreLeftOutWhereASheetIsToBeRead() {
    const SnapshotPtr snapshot = liveOf(*withStateEngaged(example("eight-speed-gearbox"), 4));
    LeverLook look;
    look.numbers = false;
    const LeverSheet sheet =
        leverSheet(*snapshot->mechanism, *leverPictureOf(*snapshot), layoutOf(snapshot), {}, look);
    QVERIFY(sheet.speedScale > 0);
    for (const char* const value : {"0.719", "0.422", "2.156", "0.778"})
      QVERIFY2(!says(sheet.drawing, value), value);
  }

  void nomogramNamesEveryStateThatHasARatio() {
    const Mechanism ravigneaux = example("ravigneaux");
    const DisplayList list = drawingNamed("nomogram")->draw(*liveOf(ravigneaux), nullptr, {});
    const auto texts = textsIn(list);
    for (const ShiftState& state : ravigneaux.states)
      QVERIFY2(std::find(texts.begin(), texts.end(), state.name) != texts.end(), state.name.c_str());
  }

  void absentLeversAreExplained() {
    QVERIFY(says(drawingNamed("levers")->draw(*liveOf(example("robot")), nullptr, {}), "mesh 16"));
    QVERIFY(says(drawingNamed("levers")->draw(*liveOf(example("spur-pair")), nullptr, {}), "no mesh joins"));
    QVERIFY(
        says(drawingNamed("levers")->draw(*liveOf(example("robot-to-mend")), nullptr, {}), "not finished"));
    QVERIFY(says(drawingNamed("nomogram")->draw(*liveOf(example("three-planets")), nullptr, {}),
                 "No states yet"));
    QVERIFY(says(drawingNamed("plan")->draw(*liveOf(example("eight-speed-gearbox")), nullptr, {}), "have 4"));
  }

  void decimalsAreRoundedFromTheFraction() {
    QCOMPARE(threeDecimals(Rational(2, 3)), std::string("0.667"));
    QCOMPARE(threeDecimals(Rational(-1, 16)), std::string("−0.062"));  // a tie, to even
    QCOMPARE(threeDecimals(Rational(3, 16)), std::string("0.188"));    // a tie, to even
    QCOMPARE(threeDecimals(Rational(7)), std::string("7"));
    QCOMPARE(threeDecimals(Rational(2, 100'000)), std::string("2e-05"));
  }

  void torquesOfEachLeverAddUpToZero() {
    Mechanism mechanism = example("planetary-ring-held");
    Load load;
    load.action = LinkTorque{mechanism.links[2].id, {}, *Number::fromText("10")};
    mechanism.loads.push_back(load);
    const auto picture = leverPictureOf(*liveOf(mechanism));
    QCOMPARE(picture->torques.size(), std::size_t{1});
    QCOMPARE(picture->torques[0].size(), picture->plan.levers[0].points.size());
    Rational force;
    Rational moment;
    for (std::size_t i = 0; i < picture->torques[0].size(); ++i) {
      force += picture->torques[0][i];
      moment += picture->torques[0][i] * picture->plan.levers[0].points[i].at;
    }
    QVERIFY(force.isZero() && moment.isZero());
    QVERIFY(!picture->torques[0][0].isZero());
  }

  void aSheetTellsWhereItsPointsAre() {
    const SnapshotPtr snapshot = liveOf(*withStateEngaged(example("eight-speed-gearbox"), 4));
    const LeverPicture picture = *leverPictureOf(*snapshot);
    const LeverLayout layout = layoutOf(snapshot);
    const LeverSheet sheet = leverSheet(*snapshot->mechanism, picture, layout, {});
    QCOMPARE(textOf(sheet.drawing), textOf(leverDrawing(*snapshot->mechanism, picture, {})));
    std::size_t points = 0;
    for (const Lever& lever : picture.plan.levers) points += lever.points.size();
    QCOMPARE(sheet.spots.size(), points);
    for (const LeverSpot& spot : sheet.spots) {
      const LeverPoint& point = picture.plan.levers[static_cast<std::size_t>(spot.lever)]
                                    .points[static_cast<std::size_t>(spot.point)];
      const Rational& speed =
          picture.speeds[static_cast<std::size_t>(picture.plan.positionOf(point.links.front()))];
      QVERIFY(std::abs(spot.tip.x - spot.at.x - sheet.speedScale * speed.toDouble()) < 1e-9);
    }
    LeverLook still;
    still.speeds = false;
    for (const LeverSpot& spot : leverSheet(*snapshot->mechanism, picture, layout, {}, still).spots)
      QCOMPARE(spot.tip.x, spot.at.x);
    LeverLook scaled;
    scaled.speedScale = 10;
    QCOMPARE(leverSheet(*snapshot->mechanism, picture, layout, {}, scaled).speedScale, 10.0);
  }

  void aNomogramTellsWhereItsStatesAre() {
    const SnapshotPtr snapshot = liveOf(*withStateEngaged(example("simpson"), 1));
    const auto states = statesOnLevers(*snapshot);
    QVERIFY(states && states->current == 1);
    const NomogramSheet sheet = nomogramSheet(*snapshot->mechanism, states->plan,
                                              snapshot->kinematics->placement(), states->states, 1, {});
    QVERIFY(sheet.missing.empty());
    QCOMPARE(textOf(sheet.drawing), textOf(drawingNamed("nomogram")->draw(*snapshot, nullptr, {})));
    for (const NomogramSheet::Tag& tag : sheet.tags) {
      for (const int state : tag.states)
        QVERIFY(std::any_of(sheet.lines.begin(), sheet.lines.end(),
                            [&](const NomogramSheet::Line& line) { return line.state == state; }));
    }
    QVERIFY(!sheet.tags.empty());
  }

  // 4 is the carrier of the first set: 48 : 96 teeth divide sun to ring.
  void aCardTellsPlaceSpeedAndTorque() {
    const SnapshotPtr snapshot = liveOf(*withStateEngaged(example("eight-speed-gearbox"), 4));
    const LeverPicture picture = *leverPictureOf(*snapshot);
    std::string all;
    for (std::size_t i = 0; i < picture.plan.levers.front().points.size(); ++i) {
      const LeverCard card = leverCard(*snapshot->mechanism, picture, 0, static_cast<int>(i));
      all += card.title + "\n";
      for (const LeverCard::Row& row : card.rows) all += row.name + " " + row.text + "\n";
      all += pointSentence(*snapshot->mechanism, picture, 0, static_cast<int>(i)) + "\n";
    }
    for (const char* const words :
         {"held by brake B", "4 divides", "96 : 48 teeth", "speed 1057/1471 = 0.719 rad/s: ",
          "torque 1955/6871 = 0.285 N m on this lever", "of the way from", ", 0.719 rad/s"})
      QVERIFY2(all.find(words) != std::string::npos, (words + (" in\n" + all)).c_str());
  }

  void lettingGoOfACouplingLeavesFreedoms() {
    const SnapshotPtr snapshot = liveOf(*withStateEngaged(example("eight-speed-gearbox"), 4));
    for (const ShiftElementOrdinal coupling : snapshot->mechanism->couplings.ordinals()) {
      const auto& engaged = snapshot->mechanism->engaged;
      const ShiftElementId id = snapshot->mechanism->couplings[coupling].id;
      const bool isEngaged = std::find(engaged.begin(), engaged.end(), id) != engaged.end();
      QCOMPARE(freedomWithout(*snapshot, coupling), std::optional(isEngaged ? 2 : 1));
    }
  }
};

QTEST_APPLESS_MAIN(LeverDrawingTest)
#include "test_lever_drawing.moc"
