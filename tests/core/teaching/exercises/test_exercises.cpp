#include <QTest>
#include <set>

#include "core/teaching/exercises/question_builder.h"
#include "core/teaching/exercises/variant_source.h"
#include "core/teaching/grading/grade.h"
#include "core/teaching/grading/question_json.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/gearboxes.h"
#include "tests/core/support/train_sketch.h"

namespace geargraph {

class ExercisesTest : public QObject {
  Q_OBJECT

  const ExerciseSource robot{test::example("robot")};

  /// The first question of this kind that is about mesh `label`.
  static Question about(const ExerciseSource& source, ExerciseKind kind, const std::string& label) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
      ExerciseRandom random(seed);
      Question question = makeQuestion(source, kind, random);
      if (!question.elements.empty() && question.elements.front() == ElementId(MeshId(label)))
        return question;
    }
    qFatal("no question about this mesh");
  }
  static QString verdict(const Question& question, const std::vector<std::string>& answer) {
    const Verdict graded = grade(question, answer);
    return graded.isRight   ? "right"
           : graded.mistake ? QString::fromStdString(graded.mistake->name)
                            : "unnamed";
  }
  static QStringList offered(const ExerciseSource& source) {
    QStringList names;
    for (const ExerciseKind kind : offeredKinds(source)) names << QString::fromUtf8(kindName(kind).data());
    return names;
  }

 private slots:
  /// The same on every platform: reference values of splitmix64 for the seed 1234567.
  void generatorIsPinned() {
    ExerciseRandom random(1234567);
    QCOMPARE(random.next(), std::uint64_t{6457827717110365317U});
    QCOMPARE(random.next(), std::uint64_t{3203168211198807973U});
    ExerciseRandom same(7, 2, 3);
    ExerciseRandom again(7, 2, 3);
    ExerciseRandom other(7, 3, 2);
    const std::uint64_t first = same.next();
    QCOMPARE(again.next(), first);
    QVERIFY(other.next() != first);
    std::vector<int> counts(5, 0);
    for (int i = 0; i < 5'000; ++i) ++counts[static_cast<std::size_t>(random.below(5))];
    for (const int count : counts) QVERIFY2(count > 850 && count < 1'150, qPrintable(QString::number(count)));
  }

  void robotOffersWhatItHas() {
    QCOMPARE(offeredKinds(robot).size(), std::size_t{21});
    QCOMPARE(reasonAgainst(robot, ExerciseKind::engagement),
             std::optional<std::string>("no brakes or clutches"));
    QCOMPARE(reasonAgainst(robot, ExerciseKind::redundantMesh),
             std::optional<std::string>("no mesh is redundant"));
    QCOMPARE(reasonAgainst(robot, ExerciseKind::ringTeeth),
             std::optional<std::string>("no planet between a sun and a ring"));
    QCOMPARE(reasonAgainst(robot, ExerciseKind::anyCycles), std::optional<std::string>("too many cycles"));
    QCOMPARE(difficultyOf(robot).text, std::string("medium: 4 cycles, 3 inputs"));
  }

  void halfDrawnMechanismsOfferWhatIsDefined() {
    const ExerciseSource empty(emptyMechanism());
    QVERIFY(offered(empty).isEmpty());
    Mechanism loose = test::example("robot");
    loose.turningJoints.erase(loose.turningJoints.begin() + 2);
    QCOMPARE(offered(ExerciseSource(loose)),
             (QStringList{"incidence", "orientation", "reduced-incidence", "wrong-entry"}));
    Mechanism bare = test::example("robot");
    bare.gearMeshes.clear();
    bare.inputs.reset();
    QVERIFY(offered(ExerciseSource(bare)).contains("path"));
    QVERIFY(!offered(ExerciseSource(bare)).contains("cycle"));
  }

  void everyKindIsOfferedSomewhere() {
    std::set<ExerciseKind> seen;
    for (const std::string& name : test::exampleNames()) {
      const Mechanism mechanism = test::example(name);
      if (mechanism.n() > kMaxExerciseLinks) continue;
      for (const ExerciseKind kind : offeredKinds(ExerciseSource(mechanism))) seen.insert(kind);
    }
    QCOMPARE(seen.size(), allExerciseKinds().size());
    std::set<std::string> hints;
    for (const ExerciseKind kind : allExerciseKinds()) {
      const std::string hint = kindHint(kind);
      QVERIFY2(hint.size() > 60 && (hint.ends_with('.') || hint.ends_with('?')), hint.c_str());
      QCOMPARE(std::count(hint.begin(), hint.end(), '$') % 2, 0);
      hints.insert(hint);
    }
    QCOMPARE(hints.size(), allExerciseKinds().size());
    for (const ExerciseKind kind : allExerciseKinds())
      QCOMPARE(kindFromName(kindName(kind)), std::optional(kind));
  }

  /// Row C16 of the paper, (5), with the mistakes of the design's picture.
  void cycleBasisOfThePaper() {
    const Question question = about(robot, ExerciseKind::cycleBasis, "16");
    const std::vector<std::string> right{"0", "1", "-1", "0", "-1", "0", "0", "0", "1", "0", "0"};
    QCOMPARE(question.solution, right);
    QCOMPARE(verdict(question, right), QString("right"));
    std::vector<std::string> against = right;
    against[4] = "1";
    const Verdict wrong = grade(question, against);
    QCOMPARE(QString::fromStdString(wrong.mistake->name), QString("walked-against-arrow"));
    QCOMPARE(wrong.mistake->elements, std::vector<ElementId>{JointId("12")});
    QCOMPARE(wrong.wrongFields, std::vector<int>{4});
    QCOMPARE(QString::fromStdString(wrong.reason),
             QString("The cycle of mesh 16 runs against the arrow of joint 12: −1, not 1."));
    QCOMPARE(verdict(question, {"0", "0", "0", "1", "-1", "-1", "0", "0", "0", "1", "0"}),
             QString("another-cycle"));
    QCOMPARE(verdict(question, {"0", "-1", "1", "0", "1", "0", "0", "0", "1", "0", "0"}),
             QString("cycle-backwards"));
    QCOMPARE(verdict(question, {"0", "1", "1", "0", "1", "0", "0", "0", "1", "0", "0"}),
             QString("signs-left-out"));
    QCOMPARE(verdict(question, {"0", "1", "-1", "0", "-1", "0", "0", "0", "0", "0", "0"}),
             QString("own-mesh-left-out"));
    QCOMPARE(verdict(question, {"0", "1", "-1", "0", "-1", "0", "0", "1", "1", "0", "0"}),
             QString("another-mesh-in-cycle"));
  }

  /// (28): w51 = -n25 w21 with 20 and 30 teeth; (30) is the mesh with the positive sign.
  void terminalEquationsOfThePaper() {
    const Question bevel = about(robot, ExerciseKind::terminalEquation, "16");
    QCOMPARE(bevel.solution, (std::vector<std::string>{"1", "-3/2"}));
    QCOMPARE(verdict(bevel, {"1", "-1.5"}), QString("right"));
    QCOMPARE(verdict(bevel, {"1", "−30/20"}), QString("right"));
    QCOMPARE(verdict(bevel, {"1", "3/2"}), QString("bevel-sign"));
    QCOMPARE(verdict(bevel, {"1", "-2/3"}), QString("ratio-upside-down"));
    QCOMPARE(verdict(bevel, {"1", "2/3"}), QString("sign-and-ratio"));
    QCOMPARE(verdict(bevel, {"0", "-3/2"}), QString("ground-as-carrier"));
    QCOMPARE(verdict(bevel, {"5", "-3/2"}), QString("gear-as-carrier"));
    QCOMPARE(about(robot, ExerciseKind::terminalEquation, "18").solution,
             (std::vector<std::string>{"2", "3/2"}));
    const Question compound = about(robot, ExerciseKind::terminalEquation, "17");
    QCOMPARE(verdict(compound, {"2", "-2/3"}), QString("teeth-of-another-wheel"));  // 16 of 7'' for 18 of 7'
  }

  void internalMeshesHaveTheirOwnSign() {
    const ExerciseSource set(test::planetary(24, 18));
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
      ExerciseRandom random(seed);
      const Question question = makeQuestion(set, ExerciseKind::terminalEquation, random);
      const Rational right = *Rational::fromText(question.solution[1]);
      const QString name = verdict(question, {question.solution[0], (-right).toString()});
      QCOMPARE(name, right.sign() > 0 ? QString("internal-as-external") : QString("external-as-internal"));
    }
    ExerciseRandom random(5);
    const Question ring = makeQuestion(set, ExerciseKind::ringTeeth, random);
    const int right = QString::fromStdString(ring.solution.front()).toInt();
    QVERIFY2(ring.prompt.find("ring") != std::string::npos && right > 40, ring.prompt.c_str());
  }

  void kutzbachIsNamedWhereAMeshIsRedundant() {
    const ExerciseSource planets(test::planetary(24, 18, 3));
    ExerciseRandom random(1);
    const Question question = makeQuestion(planets, ExerciseKind::freedom, random);
    QCOMPARE(question.solution, (std::vector<std::string>{"4", "2"}));  // theory: r = k + 1, E = 2
    QCOMPARE(verdict(question, {"6", "0"}), QString("kutzbach-with-redundant-mesh"));
    QCOMPARE(verdict(question, {"2", "4"}), QString("rank-and-dof-exchanged"));
    QCOMPARE(verdict(question, {"4", "1"}), QString("not-t-minus-r"));
  }

  void brakesOfTheEightSpeed() {
    const ExerciseSource box(test::eightSpeed());
    std::set<std::string> asked;
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      ExerciseRandom random(seed);
      const Question question = makeQuestion(box, ExerciseKind::engagement, random);
      asked.insert(question.solution.front());
      QCOMPARE(verdict(question, question.solution), QString("right"));
      QCOMPARE(verdict(question, {""}), QString("too-free"));
      QCOMPARE(verdict(question, {"A,B,C,D,E"}),
               QString("unnamed"));  // more than a state engages and one beside
    }
    QCOMPARE(asked.size(), std::size_t{9});
    ExerciseRandom random(3);
    const Question question = makeQuestion(box, ExerciseKind::engagement, random);
    for (const std::string& other : asked) {
      if (other != question.solution.front()) QCOMPARE(verdict(question, {other}), QString("another-gear"));
    }
  }

  void aSeedMakesTheSameSheet() {
    const SheetPlan plan{"Sheet", offeredKinds(robot), 2026, 3};
    const SheetVariant first = makeVariant(robot, plan, 1);
    QVERIFY(makeVariant(ExerciseSource(test::example("robot")), plan, 1).questions == first.questions);
    QVERIFY(makeVariant(robot, plan, 2).questions != first.questions);
    SheetPlan other = plan;
    other.seed = 2027;
    QVERIFY(makeVariant(robot, other, 1).questions != first.questions);
    int points = 0;
    for (const Question& question : first.questions) points += question.points;
    QCOMPARE(first.points(), points);
    // A question does not depend on those beside it.
    SheetPlan prefix = plan;
    prefix.kinds.resize(4);
    QVERIFY(makeVariant(robot, prefix, 1).questions.back() == first.questions[3]);
  }

  /// 30 sheets of three kinds: no two alike, whatever the train.
  void noTwoVariantsAreAlike() {
    for (const char* name :
         {"robot", "spur-pair", "planetary-ring-held", "three-planets", "ravigneaux", "bevel-differential"}) {
      const ExerciseSource source(test::example(name));
      const SheetPlan plan{
          "Sheet", {ExerciseKind::incidence, ExerciseKind::coefficients, ExerciseKind::speed}, 2026, 30};
      std::set<std::string> sheets;
      std::set<std::string> teeth;
      for (int variant = 1; variant <= plan.variants; ++variant) {
        const ExerciseSource varied = variantSource(source, plan, variant);
        QCOMPARE(varied.matroid()->dof, source.matroid()->dof);
        sheets.insert(questionsJson(makeVariant(varied, plan, variant).questions, QuestionPart::withoutKey));
        std::string numbers;
        for (const GearMesh& mesh : varied.mechanism().gearMeshes)
          numbers += std::to_string(mesh.tailTeeth) + ":" + std::to_string(mesh.headTeeth) + " ";
        teeth.insert(numbers);
      }
      QVERIFY2(sheets.size() == 30, (std::string(name) + ": " + std::to_string(sheets.size())).c_str());
      QVERIFY2(teeth.size() >= 10, (std::string(name) + ": " + std::to_string(teeth.size())).c_str());
    }
  }

  void variantsAreReproducible() {
    const SheetPlan plan{"Sheet", offeredKinds(robot), 7, 5};
    const Mechanism first = variantSource(robot, plan, 3).mechanism();
    QVERIFY(variantSource(ExerciseSource(test::example("robot")), plan, 3).mechanism() == first);
    QVERIFY(first != robot.mechanism());
    SheetPlan same = plan;
    same.variants = 1;
    QVERIFY(variantSource(robot, same, 1).mechanism() == robot.mechanism());
    QVERIFY(variantSource(robot, plan, 3).mechanism().links.front() == robot.mechanism().links.front());
  }

  void questionsOfOneKindDiffer() {
    const SheetPlan plan{"Rows", {4, ExerciseKind::cycleBasis}, 11, 1};
    const SheetVariant sheet = makeVariant(robot, plan, 1);
    std::set<std::string> prompts;
    for (const Question& question : sheet.questions) prompts.insert(question.prompt);
    QCOMPARE(prompts.size(), std::size_t{4});
  }

  /// What a seed makes is a promise to sheets that are out: a change of the generator needs a new
  /// kGeneratorVersion.
  void sheetsOfTheSeedArePinned() {
    const auto hashOf = [](const ExerciseSource& source, const SheetPlan& plan) {
      std::uint64_t hash = 0xCBF29CE484222325U;
      for (const char c : questionsJson(makeVariant(source, plan, 1).questions, QuestionPart::withoutKey))
        hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3U;
      return QString::number(hash, 16);
    };
    std::vector<ExerciseKind> first = offeredKinds(robot);  // the later kinds are at their end
    first.resize(20);
    QCOMPARE(hashOf(robot, {"Sheet", first, 2026, 1}), QString("35fdad1c34538ac3"));
    const std::vector<ExerciseKind> forces{ExerciseKind::brakeTorque, ExerciseKind::selfLocking};
    QCOMPARE(hashOf(ExerciseSource(test::eightSpeed()), {"Sheet", forces, 2026, 1}),
             QString("34a1779b97ba175f"));
  }

  void sheetsSurviveJson() {
    const SheetFile sheet{
        {"Sheet 3: \"cycles\"", {ExerciseKind::cycle, ExerciseKind::coefficients}, 18446744073709551615U, 30},
        test::example("robot")};
    const std::string text = sheetJson(sheet);
    const auto read = readSheet(text);
    QVERIFY(read.has_value());
    QVERIFY(read->plan == sheet.plan);
    QVERIFY(read->mechanism == sheet.mechanism);
    QCOMPARE(sheetMark(*read), sheetMark(sheet));
    QVERIFY(text.find("solution") == std::string::npos && text.find("accepted") == std::string::npos);
    SheetFile other = sheet;
    other.plan.seed = 1;
    QVERIFY(sheetMark(other) != sheetMark(sheet));
  }

  void brokenSheetsAreRejected() {
    const std::string text = sheetJson({{"S", {ExerciseKind::cycle}, 5, 2}, test::example("robot")});
    const auto code = [&](const char* from, const char* to) {
      QString broken = QString::fromStdString(text);
      const int at = static_cast<int>(broken.indexOf(from));
      if (at < 0) qFatal("%s is not in the file", from);
      broken.replace(at, static_cast<int>(qstrlen(from)), to);
      const auto read = readSheet(broken.toStdString());
      return read ? std::string("none") : std::string(codeName(read.error().front().code));
    };
    QCOMPARE(code("{", "["), std::string("syntax"));
    QCOMPARE(code("geargraph-sheet", "geargraph"), std::string("format"));
    QCOMPARE(code("\"version\": 1", "\"version\": 9"), std::string("version"));
    QCOMPARE(code("\"generator\": 2", "\"generator\": 9"), std::string("version"));
    QCOMPARE(code("\"seed\": \"5\"", "\"seed\": \"-5\""), std::string("schema"));
    QCOMPARE(code("\"variants\": 2", "\"variants\": 0"), std::string("schema"));
    QCOMPARE(code("\"cycle\"", "\"circle\""), std::string("schema"));
    QCOMPARE(code("\"cycle\"", "\"brakes\""), std::string("schema"));
    QCOMPARE(code("\"tail\": \"0\"", "\"tail\": \"no such link\""), std::string("unknown-id"));
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::ExercisesTest)
#include "test_exercises.moc"
