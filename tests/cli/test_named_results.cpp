#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>
#include <set>

#include "app/cli/analyze_text.h"
#include "core/foundations/files/csv_records.h"
#include "core/foundations/files/file.h"
#include "core/mechanism/model/load_edits.h"
#include "core/presentation/exporters/exporters.h"
#include "core/presentation/report/report.h"
#include "core/presentation/result_json/analysis_json.h"
#include "core/teaching/derivation/named_results.h"
#include "core/teaching/derivation/result_text.h"
#include "core/teaching/derivation/solved_statics.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/toy_result.h"

namespace geargraph {
namespace {

QString shown(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

/// What the command line, `serve`, Python and the window call for an export.
ExportResult exported(const Mechanism& mechanism, const char* id, const OptionValues& given,
                      const QString& path) {
  const Exporter* found = nullptr;
  for (const Exporter* exporter : allExporters())
    if (exporter->id == std::string_view(id)) found = exporter;
  ExportSource source;
  source.read = [&]() -> std::variant<Mechanism, ExportError> { return mechanism; };
  ExportContext context(std::move(source));
  ExportTarget target;
  target.path = path.toStdString();
  return found->write(context, withImplied(*found, given), target, {});
}

std::vector<std::string> matrixChoices() {
  for (const Exporter* exporter : allExporters())
    for (const ExportOption& option : exporter->options)
      if (option.name == "--matrix") return option.choices();
  return {};
}

QJsonObject matricesOfJson(const SnapshotPtr& snapshot) {
  TextSink text;
  writeAnalysisJson(text, snapshot, {});
  return QJsonDocument::fromJson(QByteArray::fromStdString(text.take())).object()["matrices"].toObject();
}

QString reportOf(const SnapshotPtr& snapshot, ReportForm form) {
  return shown(reportText(derivationReport(snapshot), form, [] { return ReportLists(); }));
}

}  // namespace

/// What is in the catalogue of results is in all that writes results.
class NamedResultsTest : public QObject {
  Q_OBJECT

  QTemporaryDir folder;
  [[nodiscard]] static QString textOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
  }

  /// Exports all results of a mechanism, each alone and together; the files' names.
  std::set<QString> filesOf(const Mechanism& mechanism) {
    std::set<QString> written;
    exportEach(mechanism, written);
    return written;
  }

  void exportEach(const Mechanism& mechanism, std::set<QString>& written) {
    const SnapshotPtr snapshot = analyze(std::make_shared<const Mechanism>(mechanism));
    const ResultSource source{snapshot, solvedStatics(snapshot, {}, true)};
    const QString all = folder.filePath(shown(mechanism.name));
    QVERIFY(std::holds_alternative<ExportOutcome>(exported(mechanism, "csv-all", {}, all)));
    for (const NamedResult* result : namedResults()) {
      const QString name = shown(result->name);
      const ResultTablePtr table = exactTable(*result, source);
      QCOMPARE(table == nullptr, result->forms(source).empty());
      const QString path = folder.filePath(name + ".csv");
      OptionValues given;
      given.options["--matrix"] = {std::string(result->name)};
      const ExportResult one = exported(mechanism, "csv", given, path);
      if (!table) {
        const auto& error = std::get<ExportError>(one);
        QVERIFY2(shown(error.message).contains(shown(result->needs)), error.message.c_str());
        continue;
      }
      QVERIFY2(std::holds_alternative<ExportOutcome>(one), result->name.data());
      written.insert(name + ".csv");
      QCOMPARE(textOf(path), textOf(all + '/' + name + ".csv"));
      QCOMPARE(textOf(path).count('\n'), qsizetype{table->rows() + 1});
      TextSink text;
      writeResultCsv(text, *table, {});
      QCOMPARE(textOf(path), shown(text.take()));
    }
    const QStringList files = QDir(all).entryList(QDir::Files);
    QCOMPARE(std::set<QString>(files.begin(), files.end()), written);
  }

 private slots:
  void everyResultSaysWhatItIs() {
    std::set<std::string_view> names, letters, members;
    for (const NamedResult* result : namedResults()) {
      QVERIFY2(names.insert(result->name).second, result->name.data());
      QCOMPARE(resultNamed(result->name), result);
      QVERIFY2(!result->title.empty() && !result->needs.empty(), result->name.data());
      const bool areRecords = result->asciiName.empty();  // the columns of records have definitions
      QVERIFY2(areRecords || letters.insert(result->asciiName).second, result->name.data());
      QVERIFY2(areRecords || !definitionOf(*result).empty(), result->name.data());
      QVERIFY2(result->jsonName.empty() || members.insert(result->jsonName).second, result->name.data());
      QVERIFY2(result->reportText.empty() == result->reportFormula.empty(), result->name.data());
      QVERIFY2(!result->isPrinted || !result->symbol.empty(), result->name.data());
    }
    for (const ForceTableKind kind : allForceTableKinds())
      QVERIFY2(resultNamed(forceTableCommandName(kind)) != nullptr, forceTableCommandName(kind).data());
    QVERIFY(resultNamed("gamma") == nullptr);
    QCOMPARE(matrixChoices(), resultNames());
  }

  /// The file of a result by its name, the file among all, and the table of core are the same.
  void everyResultIsExported() {
    std::set<QString> written = filesOf(test::example("simpson"));  // its states
    if (QTest::currentTestFailed()) return;
    Mechanism robot = test::example("robot");
    robot = *withLoad(robot, {LoadId("hand"), JointTorque{JointId("14"), Number(10)}});
    written.merge(filesOf(robot));
    if (QTest::currentTestFailed()) return;
    for (const NamedResult* result : namedResults())
      QVERIFY2(written.contains(shown(result->name) + ".csv"), result->name.data());
  }

  void documentsHaveTheResultsThatTheCatalogueSays() {
    const SnapshotPtr snapshot = analyze(std::make_shared<const Mechanism>(test::example("robot")));
    const QJsonObject matrices = matricesOfJson(snapshot);
    const QString text = shown(cli::analysisText(snapshot));
    const QString report = reportOf(snapshot, ReportForm::latex);
    QStringList members;
    for (const NamedResult* result : namedResults()) {
      if (!result->jsonName.empty()) members << shown(result->jsonName);
      const QString heading = '\n' + shown(result->symbol) + "   " + shown(result->title);
      if (!result->symbol.empty()) QCOMPARE(text.contains(heading), result->isPrinted);
      if (!result->reportText.empty())
        QVERIFY2(report.contains(shown(result->reportFormula) + " ="), result->name.data());
    }
    members.sort();
    QStringList keys = matrices.keys();
    keys.sort();
    QCOMPARE(keys, members);
    for (const NamedResult* result : namedResults()) {
      if (result->jsonName.empty()) continue;
      const QJsonObject member = matrices[shown(result->jsonName)].toObject();
      const ResultTablePtr table = exactTable(*result, {snapshot});
      QCOMPARE(member["rows"].toArray().size(), qsizetype{table->rows()});
      const QJsonArray rows = member["entries"].toArray();
      for (int row = 0; row < table->rows(); ++row)
        for (const ResultEntry& entry : table->row(row))
          QCOMPARE(rows[row].toArray()[entry.column].toDouble(), entry.value);
    }
  }

  void aToyResultIsEverywhere() {
    const test::ToyResult toy;
    const Mechanism pair = test::example("spur-pair");  // links 0, 1, 2; joints 0-1, 0-2; mesh 1-2
    const SnapshotPtr of = analyze(std::make_shared<const Mechanism>(pair));
    QCOMPARE(matrixChoices().back(), std::string("toy-degrees"));  // help, completion, serve, File > Export
    const ResultTablePtr table = exactTable(toy.result(), {of});

    OptionValues given;
    given.options["--matrix"] = {"toy-degrees"};
    const QString path = folder.filePath("toy.csv");
    QVERIFY(std::holds_alternative<ExportOutcome>(exported(pair, "csv", given, path)));
    QCOMPARE(textOf(path), QString(",J,M\n0,2,0\n1,1,1\n2,1,1\n"));
    const QString all = folder.filePath("toys");
    QVERIFY(std::holds_alternative<ExportOutcome>(exported(pair, "csv-all", {}, all)));
    QCOMPARE(textOf(all + "/toy-degrees.csv"), textOf(path));

    const QJsonObject json = matricesOfJson(of)["toyDegrees"].toObject();
    QCOMPARE(json["columns"].toArray(), (QJsonArray{1, 2}));
    QCOMPARE(json["entries"].toArray(), (QJsonArray{QJsonArray{2, 0}, QJsonArray{1, 1}, QJsonArray{1, 1}}));

    QVERIFY(shown(cli::analysisText(of))
                .contains("\nD = [J | M]   Degrees of the links\n"
                          "     J    M\n  0  2 |  .\n  1  1 |  1\n  2  1 |  1\n"));
    const QString array =
        "\\begin{array}{c|r|r}\n & J & M \\\\ \\hline\n0 & 2 & 0 \\\\\n1 & 1 & 1 \\\\\n"
        "2 & 1 & 1\n\\end{array}";
    QVERIFY(shown(resultText(*table, TableFormat::latex)).contains(array));
    const QString report = reportOf(of, ReportForm::latex);
    QVERIFY(report.contains("Each link has so many edges.") && report.contains("D =\n" + array));
    QVERIFY(reportOf(of, ReportForm::html).contains("Each link has so many edges."));
    QCOMPARE(shown(resultText(*table, TableFormat::tsv)), QString("D\tJ\tM\n0\t2\t0\n1\t1\t1\n2\t1\t1\n"));
    QCOMPARE(shown(resultText(*table, TableFormat::matlab)),
             QString("% Degrees of the links; rows 0 1 2; columns J M\nD = [\n  2 0\n  1 1\n  1 1\n];\n"));
    QVERIFY(shown(resultText(*table, TableFormat::numpy)).contains("D = np.array([\n    [2, 0],\n"));
    QVERIFY(table->explanation(0, 0).title == "0, J: 2");
    QVERIFY(table->explanation(0, 0).text == "How many joints and meshes each link has.");
  }

  void aToyResultIsGoneAfterwards() {
    QVERIFY(resultNamed("toy-degrees") == nullptr);
    QCOMPARE(matrixChoices(), resultNames());
  }
};

}  // namespace geargraph

QTEST_GUILESS_MAIN(geargraph::NamedResultsTest)
#include "test_named_results.moc"
