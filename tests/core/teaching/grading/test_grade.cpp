#include <QTest>
#include <set>

#include "core/teaching/grading/conditions.h"
#include "core/teaching/grading/grade.h"
#include "core/teaching/grading/mistake_names.h"
#include "core/teaching/grading/question_json.h"

namespace geargraph {

using Texts = std::vector<std::string>;

class GradeTest : public QObject {
  Q_OBJECT

  /// Two numbers, a choice and a set; three mistakes.
  static Question question() {
    Question q;
    q.kind = "example";
    q.prompt = "Say $a$, \"b\" & <c>.";
    q.formula = "a = b";
    q.points = 5;
    q.elements = {MeshId("16")};
    q.fields = {{"a", FieldKind::integer, {}, {JointId("8")}, false},
                {"b", FieldKind::number, {}, {}, false},
                {"c", FieldKind::choice, {"x", "y z"}, {}, false},
                {"d", FieldKind::set, {"8", "9", "10"}, {}, true}};
    q.accepted = {{Test::values, {0, 1, 2}, {{"1", "1/3", "x"}, {"-1", "-1/3", "y z"}}},
                  {Test::fewer, {3}, {{"3"}}}};
    q.solution = {"1", "1/3", "x", "8"};
    q.rule = "The rule.";
    q.mistakes = {{"transposed", {{Test::values, {0, 1}, {{"3", "1"}}}}, {}, {LinkId("2")}, "Exchanged."},
                  {"sign-lost", {{Test::values, {0}, {{"-1"}}}}, {0}, {}, "Sign."},
                  {"too-many-inputs", {{Test::more, {3}, {{"2"}}}}, {3}, {}, "Too many."}};
    return q;
  }
  static Verdict graded(const Texts& answer) { return grade(question(), answer); }
  static QString name(const Verdict& verdict) {
    return verdict.isRight   ? "right"
           : verdict.mistake ? QString::fromStdString(verdict.mistake->name)
                             : "unnamed";
  }
  static bool test(Test test, const Texts& options, const std::vector<Texts>& values, const Texts& answer) {
    Question q;
    for (std::size_t i = 0; i < answer.size(); ++i) {
      const FieldKind kind = options.empty() ? FieldKind::number : FieldKind::set;
      q.fields.push_back({"f" + std::to_string(i), kind, options, {}, true});
    }
    return holds({test, {}, values}, readAnswer(q, answer));
  }

 private slots:
  void everyAlternativeIsRight() {
    for (const Texts& answer : {Texts{"1", "1/3", "x", "8"}, Texts{"-1", "-0,333", "y z", ""},
                                Texts{"+1", "2:6", " x ", "{10; 9}"}, Texts{"2/2", "0.3333", "x", "9 9 9"}}) {
      const Verdict verdict = graded(answer);
      QVERIFY2(verdict.isRight, answer[1].c_str());
      QCOMPARE(verdict.points, 5);
      QCOMPARE(verdict.reason, std::string("The rule."));
      QVERIFY(verdict.wrongFields.empty() && !verdict.mistake);
    }
    QVERIFY(!graded({"1", "1/3", "y z", "8"}).isRight);  // of two alternatives
    QVERIFY(!graded({"1", "0.335", "x", "8"}).isRight);
  }

  void aMistakeOfTheWholeExplainsAll() {
    const Verdict verdict = graded({"3", "1", "x", "8,9,10"});
    QCOMPARE(name(verdict), QString("transposed"));
    QCOMPARE(verdict.reason, std::string("Exchanged."));
    QVERIFY(verdict.others.empty());
    QCOMPARE(verdict.mistake->elements, std::vector<ElementId>{LinkId("2")});
    QCOMPARE(verdict.points, 1);  // for the choice
  }

  void mistakesInFieldsAreToldTogether() {
    const Verdict verdict = graded({"-1", "1/3", "x", "8,9,10"});
    QCOMPARE(name(verdict), QString("sign-lost"));
    QCOMPARE(verdict.others.size(), std::size_t{1});
    QCOMPARE(verdict.others.front().name, std::string("too-many-inputs"));
    QCOMPARE(verdict.wrongFields, (std::vector<int>{0, 3}));
    QCOMPARE(verdict.points, 2);                           // two of four cells
    QCOMPARE(graded({"-1", "1/3", "x", "8"}).points, 3);   // three of them
    QCOMPARE(graded({"-1", "-1/3", "x", "8"}).points, 3);  // of the nearest right answer
  }

  void whatCannotBeReadIsNamed() {
    QCOMPARE(name(graded({"", "1/3", "x", "8"})), QString("unanswered"));
    QCOMPARE(name(graded({"1", "1,250", "x", "8"})), QString("ambiguous-number"));
    QCOMPARE(name(graded({"one", "1/3", "x", "8"})), QString("not-a-number"));
    QCOMPARE(name(graded({"1", "1/3", "w", "8"})), QString("not-a-choice"));
    QCOMPARE(name(graded({"1", "1/3", "x", "8, 11"})), QString("not-a-choice"));
    const Verdict two = graded({"", "1/3", "", "8"});
    QCOMPARE(two.wrongFields, (std::vector<int>{0, 2}));
    QVERIFY(two.others.empty() && !two.isUnreadable && !two.isBlank);
    QCOMPARE(two.reason, std::string("2 fields are empty: a; c."));
    QCOMPARE(two.points, 2);
    QCOMPARE(graded({"7", "1/3", "x", "8"}).wrongFields, std::vector<int>{0});
    QCOMPARE(name(graded({"7", "1/3", "x", "8"})), QString("unnamed"));
    QCOMPARE(graded({"7", "1/3", "x", "8"}).reason, std::string("The rule."));
  }

  void unreadableFieldsAreNotWrong() {
    const Verdict verdict = graded({"1", "2/3x", "x", "8"});
    QVERIFY(verdict.isUnreadable && !verdict.isRight && !verdict.isBlank);
    QCOMPARE(verdict.points, 3);
    QCOMPARE(verdict.wrongFields, std::vector<int>{1});
    QVERIFY(verdict.reason.find("from “x” on") != std::string::npos);
    const Verdict large = graded({"1", std::string(10'000'000, '7'), "x", "8"});
    QVERIFY(large.isUnreadable && large.reason.size() < 300);
    QVERIFY(!graded({"1", "2/3", "x", "8"}).isUnreadable);
  }

  void aBlankAnswerIsOneLine() {
    Question whole = question();
    whole.fields[3].mayBeEmpty = false;
    for (const Texts& answer : {Texts{"", "", "", ""}, Texts{" ", "\t", "", "{}"}}) {
      const Verdict verdict = grade(whole, answer);
      QVERIFY(verdict.isBlank && verdict.others.empty() && verdict.wrongFields.empty());
      QCOMPARE(verdict.points, 0);
      QCOMPARE(name(verdict), QString("unanswered"));
    }
  }

  /// A mistake marks those of its fields that differ; the zeros of a table earn nothing.
  void cellsOfATableAreMarked() {
    Question table;
    table.points = 4;
    table.rule = "The rule.";
    for (int i = 0; i < 8; ++i)
      table.fields.push_back({"f" + std::to_string(i), FieldKind::integer, {}, {}, false});
    table.table = {{"1", "2", "3", "4"}, {"8", "9"}, {}};
    table.solution = {"-1", "0", "1", "0", "0", "-1", "0", "1"};
    table.accepted = {{Test::values, {}, {table.solution}}};
    table.mistakes = {
        {"arrow-reversed", {{Test::values, {0, 2, 4, 6}, {{"1", "-1", "0", "0"}}}}, {0, 2, 4, 6}, {}, "A."}};
    const Verdict turned = grade(table, {"1", "0", "-1", "0", "0", "-1", "0", "1"});
    QCOMPARE(name(turned), QString("arrow-reversed"));
    QCOMPARE(turned.mistake->fields, (std::vector<int>{0, 2}));
    QCOMPARE(turned.wrongFields, (std::vector<int>{0, 2}));
    QCOMPARE(turned.points, 2);
    QCOMPARE(grade(table, {"0", "0", "0", "0", "0", "0", "0", "0"}).points, 0);
    QCOMPARE(grade(table, {"-1", "", "1", "", "", "-1", "", "1"}).points, 2);
    QCOMPARE(grade(table, {"-1", "1", "1", "0", "0", "-1", "0", "1"}).points, 3);
  }

  /// Of a row up to a factor: with the factor that most cells agree with.
  void multiplesAreMarkedCellByCell() {
    Question row;
    row.points = 6;
    row.rule = "The rule.";
    for (const char* field : {"8", "9", "10", "11"})
      row.fields.push_back({field, FieldKind::number, {}, {}, false});
    row.table = {{"C15"}, {"8", "9", "10", "11"}, {}};
    row.solution = {"2", "0", "-3", "5"};
    row.accepted = {{Test::multiple, {}, {row.solution}}};
    const Verdict verdict = grade(row, {"4", "0", "6", "10"});
    QCOMPARE(verdict.wrongFields, std::vector<int>{2});
    QCOMPARE(verdict.points, 4);
    QCOMPARE(grade(row, {"1", "1", "1", "1"}).points, 0);
    row.symbols = {{"i15", "-2/3"}};
    QVERIFY(grade(row, {"i15,0,1,-5/3", "", "", ""}).isRight);
    QVERIFY(grade(row, {"2; 0; -3; 5", "", " ", ""}).isRight);
    QVERIFY(grade(row, {"i15,0,1", "", "", ""}).isUnreadable);
    QVERIFY(grade(row, {"i15,0,1,-5/3", "0", "", ""}).isUnreadable);
    row.comma = CommaUse::decimal;
    QVERIFY(grade(row, {"0,4;0;-0,6;1", "", "", ""}).isRight);
  }

  /// Users name couplings and axes as they like.
  void optionsMayHaveOddNames() {
    const std::vector<std::string> odd{"B1", "brake 1", "brake", "A, B", "a\u22121", "{x}", "1"};
    const auto set = [&](const char* text) {
      const ReadField read = readField({"f", FieldKind::set, odd, {}, true}, text);
      return read.fault == AnswerFault::none ? setText(read.elements) : std::string("?");
    };
    QCOMPARE(set("brake 1; B1"), std::string("B1,brake 1"));
    QCOMPARE(set("brake, 1"), std::string("brake,1"));
    QCOMPARE(set("A, B"), std::string("A, B"));
    QCOMPARE(set("{a-1 {x}}"), std::string("a\u22121,{x}"));
    QCOMPARE(set("brake 2"), std::string("?"));
    QCOMPARE(set("B12"), std::string("?"));
    for (std::size_t i = 0; i < odd.size(); ++i) {
      for (std::size_t j = i; j < odd.size(); ++j) {
        if (odd[i] == "brake" && odd[j] == "1") continue;  // with a blank between them the name of another
        const std::string both = i == j ? odd[i] : odd[i] + ',' + odd[j];
        QCOMPARE(set(both.c_str()), both);
      }
      QVERIFY(readField({"f", FieldKind::choice, odd, {}, false}, " " + odd[i]).readsLike(odd[i]));
    }
  }

  void testsOfNumbers() {
    QVERIFY(test(Test::multiple, {}, {{"2", "0", "-1"}}, {"-1", "0", "1/2"}));
    QVERIFY(!test(Test::multiple, {}, {{"2", "0", "-1"}}, {"0", "0", "0"}));
    QVERIFY(!test(Test::multiple, {}, {{"2", "0", "-1"}}, {"2", "1", "-1"}));
    QVERIFY(!test(Test::multiple, {}, {{"2", "0", "-1"}}, {"2", "", "-1"}));
    const std::vector<Texts> rows{{"1", "-1", "0"}, {"0", "1", "1"}};
    QVERIFY(test(Test::rows, {}, rows, {"0", "-1", "-1", "1", "-1", "0"}));
    QVERIFY(!test(Test::rows, {}, rows, {"1", "-1", "0", "-1", "1", "0"}));  // one row twice
    QVERIFY(!test(Test::rows, {}, rows, {"1", "-1", "0", "0", "1", "-1"}));
    QVERIFY(test(Test::quotient, {}, {{"3/2"}}, {"45", "30"}));
    QVERIFY(!test(Test::quotient, {}, {{"3/2"}}, {"30", "45"}));
    QVERIFY(!test(Test::quotient, {}, {{"3/2"}}, {"30", "0"}));
    QVERIFY(test(Test::within, {}, {{"15", "30"}}, {"15", "30"}));
    QVERIFY(!test(Test::within, {}, {{"15", "30"}}, {"15", "31"}));
    QVERIFY(test(Test::outside, {}, {{"15", "30"}}, {"15", "20.5"}));
    QVERIFY(!test(Test::outside, {}, {{"15", "30"}}, {"15", ""}));
    QVERIFY(test(Test::differs, {}, {{"1"}, {"2"}}, {"3"}));
    QVERIFY(!test(Test::differs, {}, {{"1"}, {"2"}}, {"4/2"}));
    QVERIFY(!test(Test::differs, {}, {{"1"}}, {"x"}));
  }

  void testsOfSets() {
    const Texts options{"a", "b", "c", "d"};
    const std::vector<Texts> edges{{"a", "0", "1"}, {"b", "1", "2"}, {"c", "2", "0"}, {"d", "2", "3"}};
    QVERIFY(test(Test::spanningTree, options, edges, {"a,b,d"}));
    QVERIFY(!test(Test::spanningTree, options, edges, {"a,b,c"}));
    QVERIFY(!test(Test::spanningTree, options, edges, {"a,b"}));
    QVERIFY(test(Test::hasLoop, options, edges, {"a,b,c"}));
    QVERIFY(!test(Test::hasLoop, options, edges, {"a,c,d"}));
    const std::vector<Texts> named{{"a", "1", "0"}, {"b", "2", "0"}, {"c", "1/3", "1"}, {"d", "0", "0"}};
    QVERIFY(test(Test::basis, options, named, {"b,c"}));
    QVERIFY(!test(Test::basis, options, named, {"a,b"}));
    QVERIFY(!test(Test::basis, options, named, {"a"}));
    QVERIFY(test(Test::dependent, options, named, {"a,b"}));
    QVERIFY(test(Test::dependent, options, named, {"d"}));
    QVERIFY(!test(Test::dependent, options, named, {"a,c"}));
    QVERIFY(test(Test::fewer, options, {{"2"}}, {"a"}) && !test(Test::fewer, options, {{"1"}}, {"a"}));
    QVERIFY(test(Test::more, options, {{"0"}}, {"a"}) && !test(Test::more, options, {{"1"}}, {"a"}));
    QVERIFY(test(Test::includes, options, {{"a", "b"}}, {"b,a,c"}));
    QVERIFY(!test(Test::includes, options, {{"a", "b"}}, {"a,c"}));
    QVERIFY(test(Test::lacks, options, {{"a", "b"}}, {"a,c"}) &&
            !test(Test::lacks, options, {{"a"}}, {"a,c"}));
    QVERIFY(test(Test::touches, options, {{"a", "b"}}, {"a,c"}) &&
            !test(Test::touches, options, {{"b"}}, {"a,c"}));
  }

  void questionsSurviveJson() {
    Question table = question();
    table.table = {{"C15"}, {"8", "9", "10", "15"}, 3};
    const std::vector<Question> questions{question(), table};
    const auto read = readQuestions(questionsJson(questions, QuestionPart::withKey));
    QVERIFY(read.has_value());
    QVERIFY(*read == questions);
    const std::string open = questionsJson(questions, QuestionPart::withoutKey);
    for (const char* secret : {"solution", "accepted", "mistakes", "rule", "1/3", "Exchanged"})
      QVERIFY2(open.find(secret) == std::string::npos, secret);
    QVERIFY(!readQuestions(open).has_value());
  }

  void answersSurviveJson() {
    const AnswerSheet answers{
        "0123456789abcdef", 7, "Ada \"L.\"", {{1, {{"C16,8", "1"}, {"r", "−3/4"}}}, {12, {{"k", ""}}}}};
    const auto read = readAnswers(answersJson(answers));
    QVERIFY(read.has_value());
    QVERIFY(*read == answers);
    const auto numbers = readAnswers(
        R"({"format": "geargraph-answers", "version": 1, "sheet": "s", "variant": 1, "answers": {"1": {"r": 0.750}}})");
    QVERIFY(numbers.has_value());
    QCOMPARE(numbers->answers.at(1).at("r"), std::string("0.750"));
  }

  void brokenFilesAreRejected_data() {
    QTest::addColumn<QString>("from");
    QTest::addColumn<QString>("to");
    QTest::addColumn<QString>("code");
    const auto add = [](const char* from, const char* to, const char* code) {
      QTest::newRow(to[0] == '\0' ? from : to) << from << to << code;
    };
    add("{", "", "syntax");
    add("geargraph-questions", "geargraph", "format");
    add("\"version\": 1", "\"version\": 2", "version");
    add("\"version\": 1", "\"version\": \"1\"", "schema");
    add("\"questions\"", "\"asked\"", "schema");
    add("\"spanning\"", "", "schema");
    add("\"kind\": \"integer\"", "\"kind\": \"whole\"", "schema");
    add("\"test\": \"fewer\"", "\"test\": \"less\"", "schema");
    add("\"fields\": [0,1,2]", "\"fields\": [0,1,9]", "schema");
    add("\"fields\": [0,1,2]", "\"fields\": [0,1]", "schema");
    add("[[\"3\"]]", "[[\"three\"]]", "schema");
    add("gearMeshes/16", "gears/16", "schema");
    add("\"points\": 5", "\"points\": 5.5", "schema");
    add("\"solution\": [\"1\"", "\"solution\": [1", "schema");
    add("\"rule\"", "\"Rule\"", "schema");
  }
  void brokenFilesAreRejected() {
    QFETCH(QString, from);
    QFETCH(QString, to);
    QFETCH(QString, code);
    QString text = QString::fromStdString(questionsJson({question()}, QuestionPart::withKey));
    QString compact = text;
    compact.replace(", ", ",");
    if (from == "\"spanning\"") {  // no member at all
      text = "[]";
      code = "format";
    } else if (text.contains(from)) {
      text.replace(text.indexOf(from), from.size(), to);
    } else {
      QVERIFY2(compact.contains(from), qPrintable(compact));
      text = compact.replace(compact.indexOf(from), from.size(), to);
    }
    const auto read = readQuestions(text.toStdString());
    QVERIFY(!read.has_value());
    QCOMPARE(QString::fromUtf8(codeName(read.error().front().code).data()), code);
  }

  void namesAreUnique() {
    std::set<std::string_view> names;
    for (const MistakeName& mistake : mistakeNames()) {
      QVERIFY(names.insert(mistake.name).second);
      QVERIFY(!mistake.title.empty() && mistakeTitle(mistake.name) == mistake.title);
    }
    QVERIFY2(names.size() >= 60, qPrintable(QString::number(names.size())));
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::GradeTest)
#include "test_grade.moc"
