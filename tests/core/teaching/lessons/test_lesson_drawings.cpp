#include <QTest>
#include <algorithm>

#include "core/mechanism/model/arrow_flips.h"
#include "core/mechanism/model/edits.h"
#include "core/teaching/lessons/course.h"
#include "core/teaching/lessons/lesson_checker.h"
#include "tests/core/support/example_files.h"

namespace geargraph {

/// Every drawing task of the course accepts its solution and rejects ten drawings that do something else.
class LessonDrawingsTest : public QObject {
  Q_OBJECT

  struct Drawing {
    std::string what;
    Mechanism mechanism;
  };

  static const LessonStep& stepNamed(const std::string& title) {
    for (const Lesson& lesson : course()) {
      for (const LessonStep& step : lesson.steps) {
        if (step.title == title) return step;
      }
    }
    qFatal("no step %s", title.c_str());
  }
  static Mechanism solutionOf(const std::string& title) {
    const auto& task = std::get<DrawTask>(stepNamed(title).task);
    return *mechanismOf(task.solution, bundledExample, "").value();
  }
  static TurningJoint& joint(Mechanism& mechanism, const char* id) {
    return *std::find_if(mechanism.turningJoints.begin(), mechanism.turningJoints.end(),
                         [&](const TurningJoint& each) { return each.id == JointId(id); });
  }
  static GearMesh& mesh(Mechanism& mechanism, const char* id) {
    return *std::find_if(mechanism.gearMeshes.begin(), mechanism.gearMeshes.end(),
                         [&](const GearMesh& each) { return each.id == MeshId(id); });
  }
  static void setTeeth(Mechanism& mechanism, const char* id, int tail, int head) {
    mesh(mechanism, id).tailTeeth = tail;
    mesh(mechanism, id).headTeeth = head;
  }
  static void drive(Mechanism& mechanism, const char* id, const Rational& speed) {
    mechanism.inputs = {{JointId(id), Number(speed), {}}};
  }
  static void remove(Mechanism& mechanism, const ElementId& element) {
    mechanism = withoutElements(mechanism, std::vector<ElementId>{element}).value();
  }
  /// A gear on its own joint in the ground, in mesh with this link.
  static void attach(Mechanism& mechanism, const char* gear) {
    mechanism = withGearAttached(mechanism, LinkId(gear), mechanism.links.front().id, std::nullopt).value();
  }
  /// The solution after a change.
  template <class Change>
  static Drawing changed(const std::string& title, const char* what, const Change& change) {
    Drawing drawing{what, solutionOf(title)};
    change(drawing.mechanism);
    return drawing;
  }

  static void verifyRejected(const std::string& title, const std::vector<Drawing>& drawings) {
    const auto& task = std::get<DrawTask>(stepNamed(title).task);
    const auto verdictOf = [&](const Mechanism& mechanism) {
      return checkDrawing(task, std::make_shared<const Mechanism>(mechanism)).verdict;
    };
    const Verdict right = verdictOf(solutionOf(title));
    QVERIFY2(right.isRight, (title + ": " + right.reason).c_str());
    QVERIFY(drawings.size() >= 10);
    for (const Drawing& drawing : drawings) {
      const Verdict verdict = verdictOf(drawing.mechanism);
      QVERIFY2(!verdict.isRight && !verdict.reason.empty(), (title + " accepts: " + drawing.what).c_str());
    }
  }

 private slots:
  void everyDrawingTaskIsTriedHere() {
    std::vector<std::string> titles;
    for (const Lesson& lesson : course()) {
      for (const LessonStep& step : lesson.steps) {
        if (std::holds_alternative<DrawTask>(step.task)) titles.push_back(step.title);
      }
    }
    QCOMPARE(titles,
             (std::vector<std::string>{"Change the pair", "Draw an idler", "Design a set", "Mend it"}));
  }

  void changeThePair() {
    const std::string title = "Change the pair";
    const auto with = [&](const char* what, const auto& change) { return changed(title, what, change); };
    verifyRejected(title,
                   {{"the pair as it was", test::example("spur-pair")},
                    with("ratio upside down", [](Mechanism& m) { setTeeth(m, "5", 34, 17); }),
                    with("nearly half", [](Mechanism& m) { setTeeth(m, "5", 17, 33); }),
                    with("internal mesh", [](Mechanism& m) { mesh(m, "5").kind = MeshKind::internal; }),
                    with("internal mesh and an arrow turned round",
                         [](Mechanism& m) {
                           mesh(m, "5").kind = MeshKind::internal;
                           flip(joint(m, "4"));
                         }),
                    with("half the input",
                         [](Mechanism& m) {
                           setTeeth(m, "5", 20, 20);
                           drive(m, "3", Rational(1, 2));
                         }),
                    with("input turned round",
                         [](Mechanism& m) {
                           mesh(m, "5").kind = MeshKind::internal;
                           drive(m, "3", Rational(-1));
                         }),
                    with("driven from the other side",
                         [](Mechanism& m) {
                           setTeeth(m, "5", 20, 20);
                           drive(m, "4", Rational(-1, 2));
                         }),
                    with("two meshes", [](Mechanism& m) { attach(m, "2"); }),
                    with("an idle link",
                         [](Mechanism& m) {
                           attach(m, "2");
                           remove(m, m.gearMeshes.back().id);
                         }),
                    with("no mesh", [](Mechanism& m) { remove(m, m.gearMeshes.back().id); })});
  }

  void drawAnIdler() {
    const std::string title = "Draw an idler";
    const auto with = [&](const char* what, const auto& change) { return changed(title, what, change); };
    verifyRejected(
        title,
        {{"the pair alone", test::example("spur-pair")},
         with("a planet on gear 2", [](Mechanism& m) { joint(m, "7").tail = LinkId("2"); }),
         with("the new gear in mesh with gear 1", [](Mechanism& m) { mesh(m, "8").tail = LinkId("1"); }),
         with("gears 1 and 2 in mesh twice",
              [](Mechanism& m) { mesh(m, "8").tail = LinkId("1"), mesh(m, "8").head = LinkId("2"); }),
         with("the new gear between gears 1 and 2",
              [](Mechanism& m) {
                mesh(m, "5").head = LinkId("6");
                mesh(m, "8").tail = LinkId("6");
                mesh(m, "8").head = LinkId("2");
              }),
         with("an internal mesh",
              [](Mechanism& m) {
                mesh(m, "8").kind = MeshKind::internal;
                mesh(m, "8").headTeeth = 90;
              }),
         with("two gears of different size on link 2", [](Mechanism& m) { mesh(m, "8").tailTeeth = 45; }),
         with("the pair changed",
              [](Mechanism& m) {
                mesh(m, "5").headTeeth = 40;
                mesh(m, "8").tailTeeth = 40;
              }),
         with("the new gear about the axis of gear 1",
              [](Mechanism& m) { joint(m, "7").axis = AxisId("a"); }),
         with("the new gear without a mesh", [](Mechanism& m) { remove(m, MeshId("8")); }),
         with("a fourth gear", [](Mechanism& m) { attach(m, "6"); }),
         with("driven at the idler", [](Mechanism& m) { drive(m, "4", Rational(1)); }),
         with("the given mesh deleted", [](Mechanism& m) { remove(m, MeshId("5")); })});
  }

  void designASet() {
    const std::string title = "Design a set";
    const auto with = [&](const char* what, const auto& change) { return changed(title, what, change); };
    const auto teeth = [](Mechanism& m, int sun, int planet, int ring) {
      setTeeth(m, "7", sun, planet);
      setTeeth(m, "8", planet, ring);
    };
    verifyRejected(
        title,
        {{"the set as it was", test::example("planetary-ring-held")},
         with("sun too large", [&](Mechanism& m) { teeth(m, 30, 15, 60); }),
         with("ring too small", [&](Mechanism& m) { teeth(m, 20, 10, 40); }),
         with("a planet that does not fit", [&](Mechanism& m) { teeth(m, 20, 10, 60); }),
         with("two sizes of gear on the planet",
              [](Mechanism& m) {
                setTeeth(m, "7", 20, 30);
                setTeeth(m, "8", 20, 40);
              }),
         with("the carrier driven",
              [&](Mechanism& m) {
                teeth(m, 24, 18, 60);
                drive(m, "5", Rational(1, 4));
              }),
         with("the sun driven more slowly",
              [&](Mechanism& m) {
                teeth(m, 24, 18, 60);
                drive(m, "4", Rational(7, 8));
              }),
         with("both meshes external", [](Mechanism& m) { mesh(m, "8").kind = MeshKind::external; }),
         with("a gear more", [](Mechanism& m) { attach(m, "1"); }),
         with("the planet in the ground", [](Mechanism& m) { joint(m, "6").tail = LinkId("0"); }),
         with("the planet without the ring", [](Mechanism& m) { remove(m, MeshId("8")); }),
         with("the sun in mesh with the ring", [](Mechanism& m) { mesh(m, "8").tail = LinkId("1"); })});
  }

  void mendIt() {
    const std::string title = "Mend it";
    const auto with = [&](const char* what, const auto& change) { return changed(title, what, change); };
    const auto meshBetween = [](Mechanism& m, const LinkId& a, const LinkId& b) -> GearMesh& {
      return *std::find_if(m.gearMeshes.begin(), m.gearMeshes.end(), [&](const GearMesh& each) {
        return (each.tail == a && each.head == b) || (each.tail == b && each.head == a);
      });
    };
    const auto planet = [](const Mechanism& m, std::size_t place) { return m.links[3 + place].id; };
    const LinkId sun("1");
    const LinkId ground("0");
    verifyRejected(title, {{"as it was", test::example("cannot-be-assembled")},
                           {"one planet", test::example("planetary-ring-held")},
                           {"another train", test::example("spur-pair")},
                           {"a robot", test::example("robot")},
                           with("planets without the sun",
                                [&](Mechanism& m) {
                                  for (const std::size_t i : {0U, 1U})
                                    remove(m, meshBetween(m, sun, planet(m, i)).id);
                                }),
                           with("planets without the ring",
                                [&](Mechanism& m) {
                                  for (const std::size_t i : {0U, 1U})
                                    remove(m, meshBetween(m, planet(m, i), ground).id);
                                }),
                           with("all planets in the ground",
                                [&](Mechanism& m) {
                                  for (TurningJoint& each : m.turningJoints) {
                                    if (each.tail == LinkId("2")) each.tail = ground;
                                  }
                                }),
                           with("two suns",
                                [&](Mechanism& m) {
                                  GearMesh& each = meshBetween(m, sun, planet(m, 0));
                                  each.tailTeeth += each.tail == sun ? 2 : 0;
                                  each.headTeeth += each.head == sun ? 2 : 0;
                                }),
                           with("two rings",
                                [&](Mechanism& m) {
                                  GearMesh& each = meshBetween(m, planet(m, 0), ground);
                                  each.tailTeeth += each.tail == ground ? 2 : 0;
                                  each.headTeeth += each.head == ground ? 2 : 0;
                                }),
                           with("one planet left",
                                [&](Mechanism& m) {
                                  const std::vector<LinkId> gone{planet(m, 1), planet(m, 2)};
                                  for (const LinkId& each : gone) remove(m, each);
                                }),
                           with("a gear more in the ground", [](Mechanism& m) { attach(m, "1"); })});
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::LessonDrawingsTest)
#include "test_lesson_drawings.moc"
