#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <nlohmann/json.hpp>

#include "core/foundations/files/file.h"
#include "core/teaching/grading/question_json.h"
#include "tests/cli/cli_run.h"
#include "tests/core/support/example_files.h"

namespace geargraph {

using test::kRobot;
using test::Run;
using test::run;

/// `geargraph-cli exercises`, as a teacher would use it.
class CliExercisesTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;

  [[nodiscard]] QString path(const QString& name) const { return m_folder.filePath(name); }
  [[nodiscard]] std::string contents(const QString& name) const {
    QFile file(path(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
  }
  void save(const QString& name, const std::string& bytes) const {
    QVERIFY(!writeFile(path(name).toStdString(), bytes));
  }
  [[nodiscard]] Run make(const QString& folder, const QStringList& more = {}) const {
    return run(QStringList{"exercises", "make", kRobot, "-o", path(folder)} + more);
  }
  /// The answers file of a variant, filled with the solutions of its questions.
  [[nodiscard]] AnswerSheet solved(const QString& folder, const QString& number) const {
    auto answers = readAnswers(contents(folder + "/answers-" + number + ".json")).value();
    const auto questions = readQuestions(contents(folder + "/solution-" + number + ".json")).value();
    for (std::size_t i = 0; i < questions.size(); ++i) {
      for (std::size_t field = 0; field < questions[i].fields.size(); ++field)
        answers.answers[static_cast<int>(i) + 1][questions[i].fields[field].name] =
            questions[i].solution[field];
    }
    return answers;
  }
  static QStringList lines(const std::string& csv) {
    return QString::fromStdString(csv).split('\n', Qt::SkipEmptyParts);
  }

 private slots:
  /// The page's key is that of the sheet that the same options make; what the browser does with it is tested
  /// there (tests/handout).
  void aHandoutAsksTheQuestionsOfASheet() {
    const QString page = path("page.html");
    const auto exported = [&](const QStringList& more) {
      return run(QStringList{"export", kRobot, "--to", "handout", "-o", page} + more);
    };
    const Run made = exported({"--exercises", "--kinds", "freedom,speed,freedom", "--seed", "5", "--variants",
                               "9", "--variant", "9", "--title", "Week 3"});
    QVERIFY2(made.status == 0, made.errors.c_str());
    const QString text = QString::fromStdString(contents("page.html"));
    QCOMPARE(text.count("<article class=\"question\""), qsizetype{3});
    QVERIFY(text.contains("Week 3, variant 9"));
    const std::vector<QStringList> rejected{{"--kinds", "freedom"},
                                            {"--exercises", "--kinds", "nothing"},
                                            {"--exercises", "--variant", "2"},
                                            {"--exercises", "--variants", "0"},
                                            {"--exercises", "--seed", "-1"},
                                            {"--exercises", "--inputs", "8,9,11"}};
    for (const QStringList& words : rejected) {
      const Run run = exported(words);
      QVERIFY2(run.status == 2 && !run.errors.empty(), qPrintable(words.join(' ')));
    }
  }

  void aSheetIsMadeAndGraded() {
    const Run made = make("class", {"--variants", "12", "--seed", "2026", "--to", "html,json", "--kinds",
                                    "cycle-basis,terminal,inputs,speed,cycle-basis"});
    QVERIFY2(made.status == 0, made.errors.c_str());
    QCOMPARE(QDir(path("class")).entryList(QDir::Files | QDir::Hidden).size(), 1 + 12 * 5);
    AnswerSheet right = solved("class", "03");
    right.student = "Ada";
    save("a.json", answersJson(right));
    AnswerSheet wrong = solved("class", "04");
    for (auto& [name, text] : wrong.answers[1]) text = text == "-1" ? "1" : text;
    wrong.answers[2]["f"] = "";
    wrong.answers[2]["k"] = "";
    wrong.student = "=Bob, \"B.\"";
    QVERIFY(QDir().mkpath(path("answers")));
    save("answers/b.json", answersJson(wrong));
    save("answers/notes.txt", "no answers");
    save("answers/sheet.json", contents("class/sheet.json"));
    const Run graded = run({"exercises", "grade", path("class/sheet.json"), path("a.json"), path("answers"),
                            "-o", path("out.csv")});
    QVERIFY2(graded.status == 0, graded.errors.c_str());
    const QStringList table = lines(contents("out.csv"));
    QCOMPARE(table.size(), 1 + 2 * 6);
    QCOMPARE(table.first(),
             QString("file,student,variant,question,kind,points,of,result,mistake,fields,reason"));
    QCOMPARE(table[1], QString("a.json,Ada,3,1,cycle-basis,4,4,right,,,"));
    QCOMPARE(table[6], QString("a.json,Ada,3,total,,20,20,,,,"));
    QVERIFY2(table[7].startsWith("b.json,\"'=Bob, \"\"B.\"\"\",4,1,cycle-basis,2,4,wrong,signs-left-out,"),
             qPrintable(table[7]));
    QVERIFY2(table[8].endsWith("terminal,0,4,unanswered,unanswered,,The question is not answered."),
             qPrintable(table[8]));
    QVERIFY(table[12].startsWith("b.json,") && table[12].contains(",total,,14,20,"));
    QCOMPARE(run({"exercises", "grade", path("class/sheet.json"), path("a.json")}).output.substr(0, 5),
             std::string("file,"));
  }

  void aSheetHoldsNoAnswers() {
    QCOMPARE(make("hidden", {"--to", "html,latex,json", "--kinds", "freedom,wrong-entry"}).status, 0);
    for (const char* name : {"hidden/sheet.json", "hidden/sheet-1.html", "hidden/sheet-1.tex",
                             "hidden/sheet-1.json", "hidden/answers-1.json"}) {
      const std::string text = contents(name);
      QVERIFY2(!text.empty(), name);
      for (const char* secret :
           {"independent: r", "\"solution\"", "\"accepted\"", "\"mistakes\"", "not −1.", "not 1."})
        QVERIFY2(text.find(secret) == std::string::npos, name);
    }
    QVERIFY(contents("hidden/solution-1.html").find("independent: r") != std::string::npos);
  }

  void theSameSeedMakesTheSameFiles() {
    for (const char* folder : {"one", "two"})
      QCOMPARE(make(folder, {"--variants", "3", "--seed", "5", "--to", "json,latex"}).status, 0);
    QCOMPARE(make("three", {"--variants", "3", "--seed", "6", "--to", "json,latex"}).status, 0);
    QCOMPARE(contents("one/solution-2.json"), contents("two/solution-2.json"));
    QCOMPARE(contents("one/sheet.json"), contents("two/sheet.json"));
    QVERIFY(contents("one/solution-2.json") != contents("one/solution-3.json"));
    QVERIFY(contents("one/solution-2.json") != contents("three/solution-2.json"));
  }

  void foldersAreNotOverwrittenUnlessForced() {
    QCOMPARE(make("kept", {"--to", "html"}).status, 0);
    save("kept/sheet-1.html", "mine");
    QFile::remove(path("kept/sheet.json"));
    const Run rejected = make("kept", {"--to", "html"});
    QCOMPARE(rejected.status, 2);
    QVERIFY(rejected.errors.find("--force") != std::string::npos);
    QCOMPARE(contents("kept/sheet-1.html"), std::string("mine"));
    QVERIFY(!QFile::exists(path("kept/sheet.json")));
    QCOMPARE(make("kept", {"--to", "html", "--force"}).status, 0);
    QVERIFY(contents("kept/sheet-1.html") != "mine");
    save("file", "mine");
    QCOMPARE(make("file").status, 2);
    QCOMPARE(contents("file"), std::string("mine"));
  }

  void nothingIsWrittenWithoutTime() {
    const Run late = make("late", {"--variants", "1000", "--limit-seconds", "0.2"});
    QCOMPARE(late.status, 3);
    QVERIFY(QDir(path("late")).entryList(QDir::Files).isEmpty());
  }

  void namesMakeVariants() {
    save("names.txt", "Ada Lovelace\r\n\nÉvariste Galois\n");
    QCOMPARE(make("named", {"--names", path("names.txt"), "--to", "html", "--title", "Sheet 3"}).status, 0);
    QVERIFY(nlohmann::json::parse(contents("named/answers-2.json"))["student"] == "Évariste Galois");
    QVERIFY(contents("named/sheet-1.html").find("Name: Ada Lovelace") != std::string::npos);
    QVERIFY(contents("named/sheet-1.html").find("<title>Sheet 3, variant 1</title>") != std::string::npos);
    QVERIFY(nlohmann::json::parse(contents("named/sheet.json"))["variants"] == 2);
  }

  /// A page and a package for each student, all found from one page.
  void aClassGetsPagesAndAnIndex() {
    save("class.txt", "Ada <b>\nEmmy Noether\n");
    const Run made = make("pages", {"--names", path("class.txt"), "--to", "handout,scorm", "--kinds",
                                    "freedom,speed", "--title", "Week 3", "--seed", "4"});
    QVERIFY2(made.status == 0, made.errors.c_str());
    QCOMPARE(QDir(path("pages")).entryList(QDir::Files),
             QStringList({"answers-1.json", "answers-2.json", "handout-1.html", "handout-2.html",
                          "index.html", "scorm-1.zip", "scorm-2.zip", "sheet.json"}));
    const QString index = QString::fromStdString(contents("pages/index.html"));
    QVERIFY(index.contains("<td>Ada &lt;b&gt;</td>") && index.contains("<td>Emmy Noether</td>"));
    for (const char* file :
         {"handout-1.html", "handout-2.html", "scorm-1.zip", "scorm-2.zip", "answers-2.json"})
      QVERIFY2(index.contains(QString("<a href=\"%1\">").arg(file)), file);
    const QString page = QString::fromStdString(contents("pages/handout-2.html"));
    QCOMPARE(page.count("<article class=\"question\""), qsizetype{2});
    QVERIFY(page.contains("Week 3, variant 2"));
    QVERIFY(contents("pages/handout-1.html") != contents("pages/handout-2.html"));
    QCOMPARE(contents("pages/scorm-1.zip").substr(0, 2), std::string("PK"));
    QCOMPARE(make("pages", {"--to", "handout", "--kinds", "freedom"}).status, 2);  // is not overwritten
  }

  /// Which mistake, how often, by whom.
  void theSummaryNamesMistakesAndStudents() {
    QCOMPARE(make("summed",
                  {"--variants", "3", "--seed", "2026", "--to", "json", "--kinds", "cycle-basis,freedom"})
                 .status,
             0);
    QVERIFY(QDir().mkpath(path("summed/in")));
    const auto hand = [&](const QString& variant, const std::string& student, const auto& change) {
      AnswerSheet answers = solved("summed", variant);
      answers.student = student;
      change(answers.answers);
      save("summed/in/" + QString::fromStdString(student) + ".json", answersJson(answers));
    };
    const auto unsigned_ = [](auto& answers) {
      for (auto& [name, text] : answers[1]) text = text == "-1" ? "1" : text;
    };
    hand("1", "Ada", [](auto&) {});
    hand("3", "Cleo", [&](auto& answers) {
      unsigned_(answers);
      answers[2].clear();
    });
    hand("3", "Bob", unsigned_);
    const auto graded = [&](const QString& out) {
      return run(
          {"exercises", "grade", path("summed/sheet.json"), path("summed/in"), "--summary", path(out)});
    };
    QCOMPARE(graded("sum.csv").status, 0);
    QCOMPARE(lines(contents("sum.csv")),
             QStringList({"question,kind,result,mistake,times,of,students", "1,cycle-basis,right,,1,3,Ada",
                          "1,cycle-basis,wrong,cycle-backwards,2,3,Bob; Cleo",
                          "2,freedom,right,,2,3,Ada; Bob", "2,freedom,unanswered,,1,3,Cleo"}));
    QCOMPARE(graded("sum.html").status, 0);
    const QString page = QString::fromStdString(contents("sum.html"));
    QVERIFY(page.contains("<h2>Question 1: Fill in a row of C</h2>"));
    QVERIFY(page.contains(
        "cycle walked against its mesh</th><td class=\"bar\"><span class=\"wrong\" style=\"width:67%\">"));
    QVERIFY(page.contains("2 of 3</td><td>Bob; Cleo</td>"));
    QCOMPARE(graded("sum.txt").status, 2);
    QVERIFY(!QFile::exists(path("sum.txt")));
  }

  /// Who hands in twice is graded once: by the file with the most points, the last of equal ones.
  void aStudentCountsOnce() {
    QCOMPARE(make("twice", {"--seed", "2026", "--to", "json", "--kinds", "cycle-basis,freedom"}).status, 0);
    QVERIFY(QDir().mkpath(path("twice/in")));
    const auto hand = [&](const QString& file, const std::string& student, bool isWhole) {
      AnswerSheet answers = solved("twice", "1");
      answers.student = student;
      if (!isWhole) answers.answers[2].clear();
      save("twice/in/" + file, answersJson(answers));
    };
    hand("answers-1 (1).json", " Ada", true);
    hand("answers-1.json", "Ada ", false);
    hand("b.json", "Bob", false);
    hand("c.json", "Bob", false);
    hand("d.json", "", false);
    hand("e.json", "", false);
    const Run graded = run(
        {"exercises", "grade", path("twice/sheet.json"), path("twice/in"), "--summary", path("twice.csv")});
    QCOMPARE(graded.status, 0);
    const QStringList table = lines(graded.output);
    QCOMPARE(table.size(), 1 + 4 * 3 + 2);
    QCOMPARE(table[4], QString("answers-1.json,Ada,1,total,,,,superseded,,,\"Of the files of Ada, answers-1 "
                               "(1).json counts.\""));
    QCOMPARE(table[5], QString("b.json,Bob,1,total,,,,superseded,,,\"Of the files of Bob, c.json counts.\""));
    QVERIFY(graded.errors.find("answers-1.json: Of the files of Ada") != std::string::npos);
    const QStringList summed = lines(contents("twice.csv"));
    QCOMPARE(summed[1], QString("1,cycle-basis,right,,4,4,Ada; Bob; d.json; e.json"));
    QCOMPARE(run({"exercises", "grade", path("twice/sheet.json"), path("twice/in"), "--summary",
                  path("twice.html")})
                 .status,
             0);
    const QString page = QString::fromStdString(contents("twice.html"));
    QVERIFY(page.contains("<h2>Students</h2>"));
    QCOMPARE(page.count("<th scope=\"row\">Ada</th>"), 1);
    QVERIFY(page.contains("6 of 6</td><td></td>") || page.contains("7 of 7</td><td></td>"));
    QVERIFY(page.contains("not right: 2"));
  }

  void wrongUsageIsToldWithItsReason_data() {
    QTest::addColumn<QStringList>("words");
    QTest::addColumn<QString>("reason");
    const auto add = [](const char* reason, const QStringList& words) {
      QTest::newRow(reason) << words << reason;
    };
    add("kinds, make or grade", {"mark"});
    add("make needs a folder", {"make", kRobot});
    add("no brakes or clutches", {"make", kRobot, "-o", "x", "--kinds", "brakes"});
    add("There is no kind of question \"riddle\"", {"make", kRobot, "-o", "x", "--kinds", "cycle,riddle"});
    add("--seed is a whole number", {"make", kRobot, "-o", "x", "--seed", "-1"});
    add("from 1 to 1000", {"make", kRobot, "-o", "x", "--variants", "1001"});
    add("a name is a variant", {"make", kRobot, "-o", "x", "--variants", "3", "--names", "n.txt"});
    add("not \"doc\"", {"make", kRobot, "-o", "x", "--to", "html,doc"});
    add("grade needs a sheet and answers", {"grade", kRobot});
    add("--seed has no meaning for exercises grade", {"grade", kRobot, "a", "--seed", "1"});
    add("not there.geargraph", {"make", "not there.geargraph", "-o", "x"});
    add("format", {"grade", kRobot, "a.json"});
  }
  void wrongUsageIsToldWithItsReason() {
    QFETCH(QStringList, words);
    QFETCH(QString, reason);
    const Run result = run(QStringList{"exercises"} + words);
    QCOMPARE(result.status, 2);
    QVERIFY2(result.errors.find(reason.toStdString()) != std::string::npos, result.errors.c_str());
    QVERIFY(result.output.empty());
  }

  void answersThatCannotBeGradedAreTold() {
    QCOMPARE(make("mixed", {"--to", "json", "--kinds", "freedom", "--variants", "2"}).status, 0);
    AnswerSheet answers = solved("mixed", "2");
    QVERIFY(QDir().mkpath(path("in")));
    save("in/right.json", answersJson(answers));
    save("in/broken.json", "{\"format\": ");
    answers.variant = 3;
    save("in/variant.json", answersJson(answers));
    answers.variant = 2;
    answers.sheet = "0000000000000000";
    save("in/other.json", answersJson(answers));
    save("in/empty.json", "");
    save("in/list.json", "[]");
    save("in/null.json", "null");
    save("in/own.json", "{\"format\": \"my-answers\"}");
    save("in/sheet.json", contents("mixed/sheet.json"));  // is passed over, as its questions are
    save("in/solution.json", contents("mixed/solution-1.json"));
    save("in/large.json", '"' + std::string(10'000'000, '7') + '"');
    QCOMPARE(QProcess::execute("mkfifo", {path("in/pipe.json")}), 0);
    const Run graded = run({"exercises", "grade", path("mixed/sheet.json"), path("in"), path("gone.json")});
    QCOMPARE(graded.status, 2);
    QCOMPARE(run({"exercises", "grade", path("in/pipe.json"), path("in/right.json")}).status, 2);
    const QStringList table = lines(graded.output);
    QCOMPARE(table.size(), 3 + 10);  // the others are graded
    for (const char* row :
         {"broken.json,,,total,,,,rejected,syntax,,", "empty.json,,,total,,,,rejected,syntax,,",
          "gone.json,,,total,,,,rejected,no-file,,", "large.json,,,total,,,,rejected,too-large,,",
          "list.json,,,total,,,,rejected,format,,", "null.json,,,total,,,,rejected,format,,",
          "other.json,,,total,,,,rejected,other-sheet,,", "own.json,,,total,,,,rejected,format,,",
          "pipe.json,,,total,,,,rejected,no-file,,", "variant.json,,,total,,,,rejected,no-variant,,"}) {
      QVERIFY2(graded.output.find(row) != std::string::npos, (row + graded.output).c_str());
    }
    for (const char* reason : {"broken.json", "syntax", "no variant 3", "another sheet", "gone.json"})
      QVERIFY2(graded.errors.find(reason) != std::string::npos, (reason + graded.errors).c_str());
  }

  void whatCannotBeReadIsNotWrong() {
    QCOMPARE(make("read", {"--to", "json", "--kinds", "speed,freedom,p", "--seed", "4"}).status, 0);
    AnswerSheet answers = solved("read", "1");
    answers.student = std::string(300, 'x');
    for (auto& [name, text] : answers.answers[1]) text += " rpm";
    for (auto& [name, text] : answers.answers[2]) text = text == "3" ? "three" : text;
    answers.answers[3].clear();
    save("read.json", answersJson(answers));
    const Run graded = run({"exercises", "grade", path("read/sheet.json"), path("read.json")});
    QCOMPARE(graded.status, 0);
    const QStringList table = lines(graded.output);
    QCOMPARE(table.size(), 5);
    QVERIFY2(table[1].contains(",1,speed,0,5,unreadable,other-unit,"), qPrintable(table[1]));
    QVERIFY2(table[2].contains(",unreadable,not-a-number,"), qPrintable(table[2]));
    QVERIFY2(table[3].contains(",3,p,0,5,unanswered,unanswered,,"), qPrintable(table[3]));
    QVERIFY2(table[4].contains(",unreadable,,,Answers that cannot be read: 2."), qPrintable(table[4]));
    QVERIFY(table[4].size() < 200);  // the name is cut
  }

  /// "-2,667" in a sheet that was made in German.
  void commasAreThoseOfTheSheetsLanguage() {
    QCOMPARE(make("deutsch", {"--to", "json", "--kinds", "speed", "--seed", "4", "--language", "de"}).status,
             0);
    QCOMPARE(make("english", {"--to", "json", "--kinds", "speed", "--seed", "4"}).status, 0);
    const auto resultOf = [&](const QString& folder, const std::string& text) {
      AnswerSheet answers = solved(folder, "1");
      for (auto& [name, answer] : answers.answers[1]) answer = text;
      save("comma.json", answersJson(answers));
      const Run graded = run({"exercises", "grade", path(folder + "/sheet.json"), path("comma.json")});
      return lines(graded.output).at(1).section(',', 7, 7);
    };
    const std::string exact = solved("deutsch", "1").answers[1].begin()->second;
    const double value = Rational::fromText(exact)->toDouble();
    const auto decimal = [&](char mark) {
      std::string text = QString::number(value, 'f', 3).toStdString();
      std::replace(text.begin(), text.end(), '.', mark);
      return text;
    };
    QCOMPARE(resultOf("deutsch", decimal(',')), QString("right"));
    QCOMPARE(resultOf("deutsch", decimal('.')), QString("right"));
    QCOMPARE(resultOf("english", decimal('.')), QString("right"));
  }

  void aSeedIsRandomUnlessGiven() {
    for (const char* folder : {"first", "second"})
      QCOMPARE(make(folder, {"--to", "json", "--kinds", "incidence,p"}).status, 0);
    QVERIFY(contents("first/sheet.json") != contents("second/sheet.json"));
    const Run made = make("third", {"--to", "json", "--kinds", "incidence,p"});
    const auto seed = nlohmann::json::parse(contents("third/sheet.json"))["seed"].get<std::string>();
    QVERIFY2(made.errors.find("--seed " + seed) != std::string::npos, made.errors.c_str());
    QCOMPARE(make("again", {"--to", "json", "--kinds", "incidence,p", "--seed", QString::fromStdString(seed)})
                 .status,
             0);
    QCOMPARE(contents("again/sheet.json"), contents("third/sheet.json"));
  }

  void kindsAreListedWithReasons() {
    const Run listed = run({"exercises", "kinds", kRobot});
    QCOMPARE(listed.status, 0);
    QCOMPARE(lines(listed.output).first(), QString("medium: 4 cycles, 3 inputs"));
    QVERIFY(listed.output.find("Brakes for a gear (not offered: no brakes or clutches)") !=
            std::string::npos);
    const QString broken = QString::fromStdString(test::sourcePath("tests/golden/files/loose.geargraph"));
    const Run loose = run({"exercises", "make", broken, "-o", path("loose"), "--to", "html"});
    QCOMPARE(loose.status, 1);
    QVERIFY(loose.errors.find("disconnected") != std::string::npos);
    QVERIFY(contents("loose/sheet-1.html").find("Fill in") != std::string::npos);
  }
};

}  // namespace geargraph

QTEST_GUILESS_MAIN(geargraph::CliExercisesTest)
#include "test_cli_exercises.moc"
