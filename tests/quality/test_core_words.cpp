#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QTest>
#include <algorithm>
#include <vector>

#include "tests/core/support/example_files.h"

using namespace geargraph::test;

namespace {

struct Literal {
  qsizetype start = 0;
  qsizetype end = 0;
  QString text;
};

/// The string literals of C++ source, those that the compiler joins as one; raw strings (formats and programs
/// in other languages), characters and comments are left out.
std::vector<Literal> literalsOf(const QString& source) {
  static const QRegularExpression kTokens(
      R"lex(//[^\n]*|/\*.*?\*/|#include[^\n]*|R"([^(]*)\(.*?\)\1"|)lex"
      "(?<![0-9A-Za-z])'(?:\\\\.|[^'\\\\\\n])*'|\"((?:\\\\.|[^\"\\\\\\n])*)\"",
      QRegularExpression::DotMatchesEverythingOption);
  std::vector<Literal> literals;
  for (auto found = kTokens.globalMatch(source); found.hasNext();) {
    const QRegularExpressionMatch token = found.next();
    if (!token.hasCaptured(2)) continue;
    const bool continues =
        !literals.empty() && QStringView(source)
                                 .mid(literals.back().end, token.capturedStart() - literals.back().end)
                                 .trimmed()
                                 .isEmpty();
    if (!continues) literals.push_back({token.capturedStart(), 0, {}});
    literals.back().end = token.capturedEnd();
    literals.back().text += token.captured(2);
  }
  return literals;
}

/// Whether a text is for people: two words in a row, or one to be joined with something, beside markup.
bool speaks(QString text) {
  static const QRegularExpression kMarkup(R"re(\\?<[^>]*>|\\\\[A-Za-z]+|[\w-]+=\\".*?(\\"|$))re");
  static const QRegularExpression kWords(R"re([A-Za-z]{2,} [A-Za-z]{2,}|[A-Za-z]{3,} $|^ [A-Za-z]{3,})re");
  text.replace(kMarkup, "|");
  return kWords.match(text).hasMatch();
}

bool isMarked(const QString& source, qsizetype literal) {
  // Words to search with are English in every language, beside the text that is found by its own words.
  static const QRegularExpression kMark(
      R"re((?:^|[^A-Za-z0-9_])(?:(?:translated|toTranslate|tr|words)\(|(?:translate|QT_TRANSLATE_NOOP)\(\s*"\w+",)\s*$|\.searchWords =[^\x22;]*$)re");
  return kMark.match(source.mid(std::max<qsizetype>(literal - 200, 0), std::min<qsizetype>(literal, 200)))
      .hasMatch();
}

/// "line: text" of each text for people that is not handed to the words mechanism (words.h).
QStringList bypassingIn(const QString& source) {
  QStringList found;
  for (const Literal& literal : literalsOf(source)) {
    if (!speaks(literal.text) || isMarked(source, literal.start)) continue;
    found << QString("%1: %2").arg(source.left(literal.start).count('\n') + 1).arg(literal.text);
  }
  return found;
}

/// What speaks no language of its reader, and why.
const std::vector<std::pair<const char*, const char*>> kEnglishOnly{
    {"core/teaching/derivation/comparison_families.cpp", "names of documents"},
    {"core/teaching/derivation/result_text.cpp", "comments of formats"},
    {"core/mechanism/document_format/graph_text.cpp", "formats"},
    {"core/mechanism/model/fields.h", "the page of the format and its schema, which are English"},
    {"core/design/atlas/canonical_graph.cpp", "for developers"},
    {"core/design/gearboxes/hub_search.cpp", "names of questions in JSON"},
    {"core/design/teeth_check/teeth_check.cpp", "names of states that it makes"},
    {"core/design/teeth_search/wished_states.cpp", "names of states in JSON"},
    {"core/foundations/base/contract.cpp", "for developers"},
    {"core/foundations/base/kind_table.h", "for developers"},
    {"core/foundations/sandbox/", "for developers"},
    {"core/presentation/brep/flaws.cpp", "for developers"},
    {"core/presentation/drawing/", "formats"},
    {"core/presentation/manual/", "the manual, which is English"},
    {"core/presentation/handout/page_policy.cpp", "a policy for browsers"},
    {"core/presentation/meshfile/binary_encoders.cpp", "formats"},
    {"core/presentation/meshfile/encoders.h", "a format"},
    {"core/presentation/meshfile/mesh_reader.cpp", "for tests"},
    {"core/presentation/meshfile/obj_encoder.cpp", "a format"},
    {"core/presentation/meshfile/three_mf_encoder.cpp", "a format"},
    {"core/presentation/gl_renderer/", "for developers"},
    {"core/presentation/scene/", "for developers"},
    {"core/presentation/cairo_output/", "names of fonts"},
    {"core/presentation/report/mathml.cpp", "a format"},
    {"core/presentation/step/step_model.cpp", "a format"},
    {"core/presentation/step/step_process.cpp", "a word of another program"},
    {"core/presentation/report/html_report.cpp", "a format"},
    {"core/presentation/simulators/mjcf.cpp", "a format, with comments for users of other programs"},
    {"core/presentation/dxf/dxf_file.cpp", "a format"},
    {"core/presentation/simulators/controller_coupling.cpp",
     "formats, with comments for users of other programs"},
    {"core/presentation/simulators/modelica.cpp", "a format, with comments for users of other programs"},
    {"core/presentation/simulators/urdf.cpp", "a format, with comments for users of other programs"},
    {"core/presentation/typeset/", "commands of TeX"},
    {"core/presentation/requests/", "the protocol of programs"},
    {"app/cli/serve", "the protocol of programs"},
    {"ui/recovery/", "reports for developers"},
    {"ui/mainwindow/about_dialog.cpp", "what developers ask for"},
};

/// Names in files and of notices, which stay as they are, heads of a command's options, style sheets, and
/// words that English alone needs.
const QRegularExpression kNames(
    "^(joint |link |body of link |cycle |torque on link |speed of joint |level of link |the | rad/s| rpm| "
    "part|"
    "mesh |coupling |link world|geargraph-cli.*|file,status,.*|--(to|view|show)\\b.*| --view |"
    "((kinds|check) )?FILE\\b.*|WISH \\[.*|not saved|open elsewhere|DejaVu Serif|QLabel \\{.*| "
    "(style|bgcolor)='.*)$");

}  // namespace

/// A sentence that is written into the program without the words mechanism stays English in every language.
class CoreWordsTest : public QObject {
  Q_OBJECT
 private slots:
  /// The check has to be able to fail.
  void textsBesideTheMechanismAreFound() {
    QCOMPARE(
        bypassingIn("fail(\"This is wrong.\");\nauto a = \"link \" + label;\nb = name + \" is missing\";"),
        (QStringList{"1: This is wrong.", "2: link ", "3:  is missing"}));
    QCOMPARE(bypassingIn("fail(other(\"One \"\n    \"sentence of two.\"));"),
             (QStringList{"1: One sentence of two."}));
    QCOMPARE(bypassingIn("x = \"<p class=\\\"a\\\">Your answer here</p>\";"),
             (QStringList{"1: <p class=\\\"a\\\">Your answer here</p>"}));
    QCOMPARE(bypassingIn("write(isFirst ? \"No link moves.\" : translated(\"No joint moves.\"));"),
             (QStringList{"1: No link moves."}));
  }

  void whatIsMarkedOrNoTextPasses() {
    QCOMPARE(
        bypassingIn("fail(translated(\"This is wrong.\"));\nk{toTranslate(\n  \"One is \"\n  \"two.\")};"),
        QStringList());
    QCOMPARE(
        bypassingIn("// a note: \"one of two\"\n/* \"one of two\" */\n#include \"one of two\"\n"
                    "x = R\"js(return one two)js\"; y = '\"'; z = \"turningJoints\"; w = \"\\\\quad \";"),
        QStringList());
  }

  void noTextBypassesTheMechanism() {
    QStringList found;
    int files = 0;
    for (const char* part : {"core", "ui", "app/cli", "app/mesh"}) {
      const QString folder = QString::fromStdString(sourcePath(part));
      QDirIterator sources(folder, {"*.h", "*.cpp"}, QDir::Files, QDirIterator::Subdirectories);
      while (sources.hasNext()) {
        QFile file(sources.next());
        const QString name = part + file.fileName().mid(folder.size());
        if (std::any_of(kEnglishOnly.begin(), kEnglishOnly.end(),
                        [&](const auto& each) { return name.startsWith(each.first); }))
          continue;
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QString source = QString::fromUtf8(file.readAll());
        ++files;
        for (const QString& place : bypassingIn(source)) {
          if (!kNames.match(place.section(": ", 1)).hasMatch()) found << name + ':' + place;
        }
      }
    }
    found.sort();
    QVERIFY2(found.isEmpty(),
             qPrintable("Not handed to translated() or toTranslate():\n" + found.join('\n')));
    QVERIFY2(files > 300, qPrintable(QString::number(files)));
  }
};

QTEST_APPLESS_MAIN(CoreWordsTest)
#include "test_core_words.moc"
