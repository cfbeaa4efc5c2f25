#include <zlib.h>

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTest>
#include <set>

#include "core/foundations/base/locale.h"
#include "core/presentation/drawing/svg_writer.h"
#include "core/presentation/export_api/levers_json.h"
#include "core/presentation/export_api/named_drawings.h"
#include "core/presentation/handout/handout.h"
#include "core/presentation/handout/page_scene.h"
#include "core/presentation/handout/script_texts.h"
#include "core/presentation/mechanism_scene/mechanism_scene.h"
#include "core/teaching/exercises/variant_source.h"
#include "core/teaching/grading/question_json.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/pseudo_language.h"

namespace geargraph {
namespace {

/// What stands between the first `begin` and the next `end`.
QString between(const QString& text, const QString& begin, const QString& end) {
  const qsizetype from = text.indexOf(begin);
  const qsizetype to = text.indexOf(end, from);
  if (from < 0 || to < 0) return {};
  return text.mid(from + begin.size(), to - from - begin.size());
}

QString pageOf(Mechanism mechanism, const std::optional<HandoutExercises>& exercises = {}) {
  const SnapshotPtr snapshot = analyze(std::make_shared<const Mechanism>(std::move(mechanism)));
  const auto svg = [&](const char* name) {
    return svgOf(drawingNamed(name)->draw(*snapshot, nullptr, {}), SheetStyle());
  };
  GearCache cache;
  const HandoutTrain train{mechanismScene(*snapshot, cache), "a picture"};
  return QString::fromStdString(*handoutHtml(snapshot, {svg("schematic"), svg("digraph"), svg("ttgraph")},
                                             train, HandoutUse::alone, exercises));
}

/// The bytes that a script element of this id holds, packed.
QByteArray unpacked(const QString& page, const QString& id) {
  const QByteArray packed = QByteArray::fromBase64(
      between(page, "<script type=\"application/octet-stream\" id=\"" + id + "\">", "</script>").toLatin1());
  QByteArray bytes(16'000'000, '\0');
  z_stream stream{};
  inflateInit2(&stream, MAX_WBITS + 16);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_out = static_cast<uInt>(bytes.size());
  const int status = inflate(&stream, Z_FINISH);
  bytes.resize(static_cast<qsizetype>(stream.total_out));
  inflateEnd(&stream);
  return status == Z_STREAM_END ? bytes : QByteArray();
}

QString hashed(const QString& text) {
  return "'sha256-" + QCryptographicHash::hash(text.toUtf8(), QCryptographicHash::Sha256).toBase64() + "'";
}

QJsonObject dataOf(const QString& page) {
  return QJsonDocument::fromJson(
             between(page, "<script type=\"application/json\" id=\"mechanism\">", "</script>").toUtf8())
      .object();
}

/// What a page shows without scripts, in text and attributes, apart from drawings and formulas.
QString frameOf(QString page) {
  static const QRegularExpression hidden("<(style|script|svg|math)\\b.*?</\\1>",
                                         QRegularExpression::DotMatchesEverythingOption);
  static const QRegularExpression told("(?:aria-label|alt|data-title|title)=\"([^\"]*)\"");
  static const QRegularExpression tag("<[^>]*>");
  page.remove(hidden);
  QString text;
  for (auto each = told.globalMatch(page); each.hasNext();) text += each.next().captured(1) + '\n';
  text += page.replace(tag, " ");
  return text.replace("&quot;", "\"");
}

QString english(const QString& text, const std::vector<std::string>& names) {
  QStringList words;
  for (const std::string& word : test::PseudoLanguage::english(text.toStdString(), names))
    words << QString::fromStdString(word);
  return words.join(' ');
}

/// The files of the page's script by name, without the library.
std::vector<std::pair<QString, QString>> scripts() {
  const QDir folder(QString::fromStdString(test::sourcePath("resources/handout")));
  std::vector<std::pair<QString, QString>> all;
  for (const QString& name : folder.entryList({"*.js"})) {
    QFile file(folder.filePath(name));
    if (!name.startsWith("three.") && file.open(QIODevice::ReadOnly))
      all.emplace_back(name, QString::fromUtf8(file.readAll()));
  }
  return all;
}

/// The literals of a script that are texts for people: words in a row, one with a capital letter, or one that
/// is joined with something. Selectors, classes, keys and fonts are none.
QStringList textsIn(const QString& script) {
  static const QRegularExpression tokens(R"re(//[^\n]*|'((?:\\.|[^'\\\n])*)'|`((?:\\.|[^`\\])*)`)re");
  static const QRegularExpression place(R"re(\$\{[^}]*\})re");
  static const QRegularExpression words(
      "[A-Za-z]{2,} [A-Za-z]{2,}|[A-Za-z]{2,} $|^ [A-Za-z]{2,}|^[A-Z][a-z]+");
  static const QRegularExpression noText(
      R"re((querySelector(All)?\(|matches\(|class: |className = |\.key [!=]== |font(-family)?'?(:| =) |)re"
      R"re(dataset\.name === |RangeError\()$)re");
  QStringList texts;
  for (auto each = tokens.globalMatch(script); each.hasNext();) {
    const QRegularExpressionMatch token = each.next();
    if (!token.hasCaptured(1) && !token.hasCaptured(2)) continue;
    const QString literal = token.captured(token.hasCaptured(2) ? 2 : 1);
    const bool isUnitOrClass = literal == " rad/s" || literal == " here" || literal == "use strict";
    if (isUnitOrClass || !words.match(QString(literal).remove(place)).hasMatch()) continue;
    if (!noText.match(script.left(token.capturedStart()).right(40)).hasMatch()) texts << literal;
  }
  return texts;
}

}  // namespace

class HandoutTest : public QObject {
  Q_OBJECT

 private slots:
  /// One changed byte, and no browser would run the page's script or wear its style.
  void thePolicyNamesWhatThePageHolds() {
    const QString page = pageOf(test::example("robot"));
    const QString policy = between(page, "Content-Security-Policy\" content=\"", "\"");
    QVERIFY(policy.startsWith("default-src 'none';"));
    QStringList scripts = page.split("<script>").mid(1);
    QCOMPARE(scripts.size(), 2);
    for (QString& script : scripts) script = hashed(script.left(script.indexOf("</script>")));
    QVERIFY(policy.contains("script-src " + scripts[1] + " " + scripts[0] + ";"));
    QVERIFY(policy.contains("style-src " + hashed(between(page, "<style>", "</style>")) + ";"));
    QVERIFY(!policy.contains("unsafe"));
  }

  /// All questions can be read without scripts; the key is that of the sheet, and does not meet the eye.
  void exercisesStandInThePageWithTheirKey() {
    const Mechanism robot = test::example("robot");
    const ExerciseSource source(robot);
    const SheetPlan plan{"Second <week>", offeredKinds(source), 3, 30};
    const QString page = pageOf(robot, handoutExercises(source, plan, 12));
    const SheetVariant sheet = makeVariant(variantSource(source, plan, 12), plan, 12);
    QCOMPARE(static_cast<std::size_t>(page.count("<article class=\"question\"")), sheet.questions.size());
    std::size_t fields = 0;
    for (const Question& question : sheet.questions) fields += question.fields.size();
    QCOMPARE(static_cast<std::size_t>(page.count("<td data-field=\"")), fields);
    QVERIFY(page.contains("Second &lt;week&gt;, variant 12") && page.contains("href=\"#exercises\""));
    const QJsonObject key = QJsonDocument::fromJson(unpacked(page, "exercises-key")).object();
    QCOMPARE(key["sheet"].toString().toStdString(), sheetMark({plan, robot}));
    QCOMPARE(key["variant"].toInt(), 12);
    QJsonObject file;
    file["format"] = "geargraph-questions";
    file["version"] = 1;
    file["questions"] = key["questions"];
    const auto read = readQuestions(QJsonDocument(file).toJson().toStdString());
    QVERIFY(read.has_value());
    QVERIFY(*read == sheet.questions);
    for (const Question& question : sheet.questions)
      QVERIFY2(!page.contains("\"" + QString::fromStdString(question.rule) + "\""), question.rule.c_str());
    // A hint for each, without scripts, too; that of a kind is the same everywhere and holds no answer.
    QCOMPARE(static_cast<std::size_t>(page.count("<details class=\"hint\">")), sheet.questions.size());
    QVERIFY(!pageOf(robot).contains("id=\"exercises"));
  }

  void nothingIsFetchedAndNoStyleStandsInAnElement() {
    static const QRegularExpression outside("\\b(?:src|href|action)=\"(?!#|data:)[^\"]*\"");
    static const QRegularExpression style("<[^>]*\\sstyle=");
    static const QRegularExpression handler("<[^>]*\\son[a-z]+=");
    int pages = 0;
    for (const std::string& name : test::exampleNames()) {
      QString page = pageOf(test::example(name));
      page.truncate(page.indexOf("<script>"));
      for (const QRegularExpression& wrong : {outside, style, handler}) {
        const auto match = wrong.match(page);
        QVERIFY2(!match.hasMatch(), qPrintable(QString::fromStdString(name) + ": " + match.captured()));
      }
      ++pages;
    }
    QVERIFY(pages > 10);
  }

  /// What can be clicked has a name and sentences for the card.
  void everyElementThatIsShownIsTold() {
    static const QRegularExpression shown(
        "(?:data-list=\"(\\w+)\" data-id=\"([^\"]*)\"|data-el=\"(\\w+)/([^\"]*)\")");
    for (const std::string& name : test::exampleNames()) {
      const QString page = pageOf(test::example(name));
      std::set<QString> told;
      for (const QJsonValue& each : dataOf(page)["elements"].toArray())
        told.insert(each["list"].toString() + "/" + each["id"].toString());
      int found = 0;
      for (auto it = shown.globalMatch(page); it.hasNext(); ++found) {
        const auto match = it.next();
        const QString list = match.captured(1) + match.captured(3);
        if (list == "axes" || list == "states" || list == "loads" || list == "wheels" || list == "couplings")
          continue;
        if (match.captured(2).isEmpty() && match.captured(4).isEmpty()) continue;  // a note on the sheet
        const QString key = list + "/" + match.captured(2) + match.captured(4);
        QVERIFY2(told.count(key) == 1, qPrintable(QString::fromStdString(name) + ": " + key));
      }
      QVERIFY(found > 10);
    }
  }

  void theRobot() {
    const QString page = pageOf(test::example("robot"));
    QVERIFY(page.contains("<h1>Geared robotic mechanism</h1>"));
    QVERIFY(page.contains("7 moving links, 7 turning joints, 4 meshes, 3 degrees of freedom"));
    QCOMPARE(page.count("<table class=\"matrix\">"), 7);
    QCOMPARE(page.count("<figure data-name="), 3);
    // (25)
    QVERIFY(page.contains(u"<td>\u22128/27</td><td>\u221216/27</td><td>\u22128/9</td>"));
    const QJsonObject data = dataOf(page);
    QCOMPARE(data["inputs"].toArray(), (QJsonArray{0, 1, 3}));
    QCOMPARE(data["speeds"].toArray(), (QJsonArray{"1", "1/2", "0"}));
    // (18) over the radius of gear 2: 2/3 of joint 9 less that of 10, and joint 12
    QCOMPARE(data["rows"][1].toArray(),
             (QJsonArray{QJsonArray{1, "2/3"}, QJsonArray{2, "-2/3"}, QJsonArray{4, "1"}}));
    const QJsonObject mesh = data["elements"].toArray()[8 + 7 + 1].toObject();
    QCOMPARE(mesh["name"].toString(), "Mesh 16");
    const QJsonArray walk = mesh["walk"].toArray();
    QCOMPARE(walk.size(), 4);
    QCOMPARE(walk[0].toArray(), (QJsonArray{"gearMeshes/16", 1, "Along mesh 16, from link 5 to link 2: 1."}));
    QCOMPARE(walk[2].toArray(),
             (QJsonArray{"turningJoints/10", -1,
                         QString::fromUtf8("Against joint 10, from link 1 to the ground: \u22121.")}));
    QCOMPARE(mesh["lines"].toArray().last().toString(), "Its cycle runs along 9 and against 10 and 12.");
  }

  /// The script adds up the rates of the terms; the nomogram has a line for each state that runs.
  void leversFollowTheRatesOfTheirTerms() {
    const Mechanism simpson = test::example("simpson");
    const QString page = pageOf(simpson);
    QVERIFY(page.contains("<figure data-name=\"Levers\"") && page.contains("<figure data-name=\"Nomogram\""));
    const SnapshotPtr snapshot = analyze(std::make_shared<const Mechanism>(simpson));
    const LeverPicture picture = *leverPictureOf(*snapshot);
    const QJsonObject data = dataOf(page);
    int points = 0;
    for (const QJsonValue& bar : data["levers"].toArray()) {
      for (const QJsonValue& point : bar.toArray()) {
        Rational speed;
        for (const QJsonValue& term : point["terms"].toArray())
          speed += Rational(term[1].toInt()) *
                   snapshot->solved->exact->rates[static_cast<JointOrdinal>(term[0].toInt())];
        const QString id = point["element"].toString().mid(6);
        for (const LinkOrdinal link : picture.plan.links) {
          if (QString::fromStdString(simpson.links[link].id.text()) != id) continue;
          QVERIFY(speed == picture.speeds[static_cast<std::size_t>(picture.plan.positionOf(link))]);
          ++points;
        }
      }
    }
    QCOMPARE(points, 4);
    std::set<int> states;
    for (const QJsonValue& line : data["nomogram"]["lines"].toArray()) states.insert(line[0].toInt());
    QCOMPARE(states, (std::set<int>{0, 1, 2, 3}));
    QVERIFY(!pageOf(test::example("planetary-ring-held")).contains("data-name=\"Nomogram\""));
    QVERIFY(!pageOf(test::example("robot")).contains("data-name=\"Levers\""));
  }

  /// Edge by edge a walk is closed, and its signs are the row of C.
  void walksAreTheRowsOfC() {
    int walks = 0;
    for (const std::string& name : test::exampleNames()) {
      const Mechanism mechanism = test::example(name);
      const SnapshotPtr snapshot = analyze(std::make_shared<const Mechanism>(mechanism));
      if (!snapshot->tree) continue;
      const Digraph& graph = *snapshot->graph;
      const IntegerMatrix& matrix = *snapshot->matrix(MatrixKind::cycleBasis);
      const QJsonArray elements = dataOf(pageOf(mechanism))["elements"].toArray();
      for (int mesh = 0; mesh < graph.c(); ++mesh, ++walks) {
        std::vector<int> row(static_cast<std::size_t>(matrix.columns()));
        int node = graph.meshEdge(mesh).tail;
        for (const QJsonValue& step :
             elements[graph.n() + 1 + graph.t() + mesh].toObject()["walk"].toArray()) {
          const std::string key = step.toArray()[0].toString().toStdString();
          int edge = 0;
          while (key != std::string(listName(graph.edgeId(edge).kind)) + "/" + graph.edgeId(edge).id.text())
            ++edge;
          const int sign = step.toArray()[1].toInt();
          QCOMPARE(sign > 0 ? graph.edge(edge).tail : graph.edge(edge).head, node);
          node = sign > 0 ? graph.edge(edge).head : graph.edge(edge).tail;
          row[static_cast<std::size_t>(edge)] += sign;
        }
        QCOMPARE(node, graph.meshEdge(mesh).tail);
        for (int edge = 0; edge < matrix.columns(); ++edge)
          QCOMPARE(row[static_cast<std::size_t>(edge)], matrix.entry(mesh, edge));
      }
    }
    QVERIFY(walks > 40);
  }

  /// Each mesh has its row of P as an equation, and each line of a formula its element.
  void equationsTellTheirElements() {
    const QString page = pageOf(test::example("robot"));
    const QString rows = between(page, "Rows of P times the rates", "</section>");
    for (const char* mesh : {"15", "16", "17", "18"})
      QVERIFY(rows.contains(QString("<div class=\"equation\" data-el=\"gearMeshes/") + mesh + "\""));
    // (20), a ratio a line, and the rates of three inputs and four outputs
    QCOMPARE(page.count("<mtr data-el=\"gearMeshes/"), 4);
    QCOMPARE(page.count("<mtr data-el=\"turningJoints/"), 7);
  }

  void theSolidsAreAsTheDataSay() {
    for (const char* name : {"robot", "eight-speed-gearbox"}) {
      const QString page = pageOf(test::example(name));
      const QJsonObject data = dataOf(page);
      const QJsonObject scene = data["scene"].toObject();
      const auto whole = [](qsizetype bytes) { return (bytes + 3) / 4 * 4; };
      qsizetype bytes = 0, largest = 0;
      for (const QJsonValue& solid : scene["solids"].toArray()) {
        const qsizetype vertices = solid["vertices"].toInt(), triangles = solid["triangles"].toInt();
        QVERIFY(vertices > 3 && triangles > 3);
        bytes += whole(6 * vertices) + whole(2 * vertices) + whole((vertices > 65'536 ? 12 : 6) * triangles);
        largest = std::max(largest, vertices);
      }
      QVERIFY(largest > 100);
      QCOMPARE(unpacked(page, "geometry").size(), bytes);
      QCOMPARE(data["movers"].toArray().size(), test::example(name).n() + 1);
      std::set<int> links;
      for (const QJsonValue& part : scene["parts"].toArray()) {
        QCOMPARE(part["pose"].toArray().size(), 12);
        links.insert(part["link"].toInt());
      }
      QVERIFY(static_cast<int>(links.size()) >= test::example(name).n());
    }
  }

  /// Unpacked as the page's script does it, a wheel is where the exporter of meshes has it.
  void positionsAndNormalsSurviveTheirSteps() {
    Solid solid;
    solid.positions = {{-3, 0, 2}, {5, 1, 2}, {0.123F, 0.5F, 2}};
    solid.normals = {{0, 0, 1}, {0.6F, 0, -0.8F}, {-0.48F, 0.6F, -0.64F}};
    solid.triangles = {{0, 1, 2}};
    Scene scene;
    scene.solids.push_back(std::make_shared<const Solid>(solid));
    const QString page = "<script type=\"application/octet-stream\" id=\"geometry\">" +
                         QString::fromStdString(pageGeometry(scene, kFarTolerance)) + "</script>";
    const QByteArray bytes = unpacked(page, "geometry");
    QCOMPARE(bytes.size(), 20 + 8 + 8);
    const auto* steps = reinterpret_cast<const quint16*>(bytes.constData());
    QCOMPARE(int(steps[0]), 0);
    QCOMPARE(int(steps[3]), 65535);
    QCOMPARE(int(steps[2]), 0);  // all in one plane
    QVERIFY(std::abs(-3 + 8.0 * steps[6] / 65535 - 0.123) < 8.0 / 131'070 + 1e-6);
    const auto* folded = reinterpret_cast<const qint8*>(bytes.constData() + 20);
    for (int i = 0; i < 3; ++i) {
      double x = folded[2 * i] / 127.0, y = folded[2 * i + 1] / 127.0;
      const double z = 1 - std::abs(x) - std::abs(y);
      if (z < 0) {
        const double old = x;
        x = std::copysign(1 - std::abs(y), x);
        y = std::copysign(1 - std::abs(old), y);
      }
      const double length = std::sqrt(x * x + y * y + z * z);
      const Float3& normal = solid.normals[static_cast<std::size_t>(i)];
      QVERIFY((x * normal[0] + y * normal[1] + z * normal[2]) / length > 0.9998);
    }
  }

  void statesHaveTheirRowsAndInputs() {
    const QString page = pageOf(test::example("eight-speed-gearbox"));
    const QJsonArray states = dataOf(page)["states"].toArray();
    QCOMPARE(states.size(), test::example("eight-speed-gearbox").states.size());
    QCOMPARE(page.count("<tr data-state="), states.size());
    for (const QJsonValue& state : states) {
      QCOMPARE(state["inputs"].toArray().size(), 1);
      QVERIFY(!state["rows"].toArray().isEmpty());
    }
  }

  void whatIsTooLargeNamesItsLargestPart() {
    const SnapshotPtr snapshot = analyze(std::make_shared<const Mechanism>(test::example("robot")));
    GearCache cache;
    const auto page =
        handoutHtml(snapshot, {}, {mechanismScene(*snapshot, cache), std::string(kMaxHandoutBytes, 'x')});
    QVERIFY(!page);
    QVERIFY(page.error().front().message.find("the still picture") != std::string::npos);
  }

  void namesCannotLeaveTheirPlace() {
    Mechanism mechanism = test::example("robot");
    mechanism.name = "</title><script>alert(1)</script>";
    mechanism.links[3].name = "</script><b>\"'&";
    const QString page = pageOf(mechanism);
    QVERIFY(!page.contains("<script>alert"));
    QVERIFY(!page.contains("</script><b>"));
    QCOMPARE(page.count("</script>"), 4);
    QVERIFY(dataOf(page)["elements"].toArray()[3].toObject()["name"].toString().contains("</script><b>\"'&"));
  }

  /// Nothing of the frame, of what the script shows, or of the exercises stays English.
  void everyTextIsInTheLanguageOfThePage() {
    Mechanism gearbox = test::example("eight-speed-gearbox");
    Mechanism open = test::example("robot");
    open.turningJoints.pop_back();
    for (const Mechanism& mechanism : {test::example("robot"), gearbox, open}) {
      std::vector<std::string> names{mechanism.name, mechanism.notes, mechanism.unit, "rad"};
      for (const Link& link : mechanism.links) names.push_back(link.name);
      for (const ShiftElement& coupling : mechanism.couplings) names.push_back(coupling.id.text());
      for (const ShiftState& state : mechanism.states) names.push_back(state.name);
      const test::PseudoLanguage pseudo;
      const QString page = pageOf(mechanism);
      QCOMPARE(english(frameOf(page), names), QString());
      const QString code = QString::fromStdString(test::PseudoLanguage::accented("en"));
      QVERIFY(page.contains("<html lang=\"" + code + "\">"));
      const QJsonObject data = dataOf(page);
      for (const QJsonValue& text : data["texts"].toObject())
        QCOMPARE(english(text.toString(), {}), QString());
      for (const QJsonValue& value : data["elements"].toArray()) {
        const QJsonObject element = value.toObject();
        QString told = element["name"].toString() + '\n' + element["mention"].toString();
        for (const QJsonValue& line : element["lines"].toArray()) told += '\n' + line.toString();
        for (const QJsonValue& step : element["walk"].toArray()) told += '\n' + step.toArray()[2].toString();
        QCOMPARE(english(told, names), QString());
      }
    }
  }

  void exercisesAreInTheLanguageOfThePage() {
    const Mechanism robot = test::example("robot");
    const test::PseudoLanguage pseudo;
    const ExerciseSource source(robot);
    const SheetPlan plan{"Title", offeredKinds(source), 3, 30};
    const HandoutExercises exercises = handoutExercises(source, plan, 12);
    const QString page = pageOf(robot, exercises);
    std::vector<std::string> names{robot.name, robot.notes, robot.unit, "rad", "Title"};
    for (const Link& link : robot.links) names.push_back(link.name);
    for (const Question& question : exercises.sheet.questions) {
      for (const AnswerField& field : question.fields) {
        names.insert(names.end(), field.options.begin(), field.options.end());
        if (field.title.empty()) names.push_back(field.name);
      }
    }
    QCOMPARE(english(frameOf(page), names), QString());
    const QJsonArray shown =
        QJsonDocument::fromJson(unpacked(page, "exercises-key")).object()["shown"].toArray();
    QCOMPARE(static_cast<std::size_t>(shown.size()), exercises.sheet.questions.size());
    for (qsizetype i = 0; i < shown.size(); ++i) {
      const Question& question = exercises.sheet.questions[static_cast<std::size_t>(i)];
      for (std::size_t field = 0; field < question.fields.size(); ++field)
        QCOMPARE(shown[i].toObject()["fields"].toArray()[static_cast<int>(field)].toString().toStdString(),
                 question.fields[field].shownName());
    }
  }

  void thePageHasTheCurrentDecimalSign() {
    QCOMPARE(dataOf(pageOf(test::example("robot")))["decimal"].toString(), ".");
    setDecimalSign(',');
    const QString page = pageOf(test::example("robot"));
    setDecimalSign('.');
    QCOMPARE(dataOf(page)["decimal"].toString(), ",");
  }

  void textsOfScriptsAreFound() {
    QCOMPARE(textsIn("make('button', {'aria-label': 'To the start'}, 'Print'); // 'a note'\n"),
             (QStringList{"To the start", "Print"}));
    QCOMPARE(textsIn("name + ' of the train'; `${n} points`; 'It\\'s '"),
             (QStringList{" of the train", "${n} points", "It\\'s "}));
    QCOMPARE(textsIn("find.querySelector('nav a'); make('p', {class: 'bar keys'}); event.key === 'Escape'"),
             QStringList());
  }

  /// Texts of the script come from its table, and the table has no others.
  void theScriptHasNoTextsOfItsOwn() {
    static const QRegularExpression asked(R"re(\bsay\((?:[\w.]+ === 1 \? '(\w+)' : )?'(\w+)')re");
    std::set<QString> used;
    for (const auto& [name, script] : scripts()) {
      const QStringList texts = textsIn(script);
      QVERIFY2(texts.isEmpty(), qPrintable(name + ": " + texts.join(" | ")));
      QCOMPARE(script.count(QRegularExpression("\\bsay\\(")), script.count(asked));
      for (auto each = asked.globalMatch(script); each.hasNext();) {
        const auto match = each.next();
        for (const int group : {1, 2})
          if (match.hasCaptured(group)) used.insert(match.captured(group));
      }
    }
    used.erase(QString());
    std::set<QString> known;
    for (const ScriptText& text : scriptTexts()) known.insert(text.name);
    QCOMPARE(known.size(), scriptTexts().size());
    QCOMPARE(QStringList(used.begin(), used.end()), QStringList(known.begin(), known.end()));
  }

  /// Matrices and drawings of what cannot be solved are shown all the same.
  void withoutASolution() {
    Mechanism open = test::example("robot");
    open.turningJoints.pop_back();
    for (const Mechanism& each : {open, test::example("locked-train")}) {
      const QString page = pageOf(each);
      QVERIFY(page.contains("</html>"));
      QVERIFY(page.contains("Incidence matrix"));
    }
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::HandoutTest)
#include "test_handout.moc"
