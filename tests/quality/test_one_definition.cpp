#include <QDirIterator>
#include <QFile>
#include <QTest>

#include "tests/core/support/example_files.h"
#include "tests/quality/definition_scanner.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

QStringList names(const char* source) {
  QStringList all;
  for (const Definition& definition : definitionsIn(source)) all << QString::fromStdString(definition.name);
  return all;
}

}  // namespace

/// The rule of one definition, which neither compiler nor linker checks: two types of one qualified name in
/// different files, or two inline functions of one signature, are undefined behaviour. Tests count, too:
/// those of a group may share a program.
class OneDefinitionTest : public QObject {
  Q_OBJECT
 private slots:
  void typesAreFoundUnderTheirQualifiedNames() {
    QCOMPARE(names("namespace a::b { struct X { int y; }; class [[nodiscard]] Y final : public X {}; }\n"
                   "namespace a { enum class E : int { one }; union U { int i; }; struct b::X::Z {}; }"),
             (QStringList{"a::b::X", "a::b::Y", "a::E", "a::U", "a::b::X::Z"}));
    QCOMPARE(names("template <class T> struct P {}; template <> struct P<int> {}; struct alignas(8) A {};"),
             (QStringList{"P", "P<int>", "A"}));
  }

  void declarationsAndUnnamedNamespacesAreLeftOut() {
    QCOMPARE(
        names(
            "struct X; class Y; enum class E : int; namespace { struct X {}; inline int f() { return 1; } }"),
        QStringList());
    QCOMPARE(names("namespace a { namespace { struct X {}; } struct X {}; }"), (QStringList{"a::X"}));
    QCOMPARE(names("struct X* f() { struct Local {}; return nullptr; } int g() { return 2; }"),
             QStringList());
    QCOMPARE(names("// struct A {};\n/* struct B {}; */ const char* s = \"struct C {};\";\n"
                   "auto r = R\"x(struct D {};)x\"; char q = '{'; struct E {};"),
             (QStringList{"E"}));
    QCOMPARE(names("#define M struct F { \\\n }\nstruct G {};"), (QStringList{"G"}));
  }

  void inlineFunctionsAreFoundWithTheirParameterTypes() {
    QCOMPARE(names("inline int f(int a, const X& b = {}) { return a; }"),
             (QStringList{"f(int ,const X & )"}));
    QCOMPARE(names("constexpr bool operator==(X a, X) { return true; }"), (QStringList{"operator==(X ,X )"}));
    QCOMPARE(names("template <class T> T g(std::vector<T> v) { return v[0]; }"),
             (QStringList{"g(std :: vector < T > ) template <class>"}));
    QCOMPARE(names("[[nodiscard]] inline std::vector<int> X::h() { return {1, 2}; } inline int k = 3;"),
             (QStringList{"X::h()", "k"}));
    QCOMPARE(names("static inline int f(int a) { return a; } constexpr int kLocal = 2;"), QStringList());
  }

  /// The check has to be able to fail: the pairs that were found by reading, in small.
  void repeatedDefinitionsAreNamedWithTheirPlaces() {
    const std::map<std::string, std::string> sources{
        {"gears/shell.h", "#pragma once\nnamespace geargraph {\nstruct Circle { double radius; };\n}"},
        {"drawing/list.h",
         "namespace geargraph { struct Circle {\n double x; }; inline int f(int a) { return a; } }"},
        {"drawing/other.cpp", "namespace geargraph { inline int f(int other) { return 2; } }"},
        {"drawing/third.cpp",
         "namespace geargraph { namespace { struct Circle {}; } inline int f(long a) { return 3; } }"},
        {"other.h", "namespace other { struct Circle {}; }"}};
    QCOMPARE(repeatedDefinitions(sources),
             (std::vector<std::string>{"geargraph::Circle: drawing/list.h:1, gears/shell.h:3",
                                       "geargraph::f(int ): drawing/list.h:2, drawing/other.cpp:1"}));
  }

  void noNameOfTheProgramIsDefinedTwice() {
    std::map<std::string, std::string> sources;
    std::size_t types = 0;
    for (const char* part : {"core", "ui", "app", "tests"}) {
      const QString folder = QString::fromStdString(sourcePath(part));
      QDirIterator files(folder, {"*.h", "*.cpp"}, QDir::Files, QDirIterator::Subdirectories);
      while (files.hasNext()) {
        QFile file(files.next());
        if (file.fileName().endsWith("_portable.cpp")) continue;  // in place of another, never beside it
        QVERIFY(file.open(QIODevice::ReadOnly));
        std::string text = file.readAll().toStdString();
        types += definitionsIn(text).size();
        sources[part + file.fileName().mid(folder.size()).toStdString()] = std::move(text);
      }
    }
    QStringList repeated;
    for (const std::string& line : repeatedDefinitions(sources)) repeated << QString::fromStdString(line);
    QVERIFY2(repeated.isEmpty(), qPrintable(repeated.join("\n")));
    QVERIFY2(sources.size() > 400 && types > 600,
             qPrintable(QString("%1 in %2").arg(types).arg(sources.size())));
  }
};

QTEST_APPLESS_MAIN(OneDefinitionTest)
#include "test_one_definition.moc"
