#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include "app/cli/command.h"
#include "core/presentation/exporters/exporters.h"

namespace geargraph::cli {
namespace {

const QString kTrain = SOURCE "/resources/examples/spur-pair.geargraph";  // one input, for URDF

struct Answered {
  int status = -1;
  QByteArray output, messages;
};

Answered ran(const QStringList& words, const QByteArray& input = {}) {
  QProcess program;
  program.start(GEARGRAPH_CLI, words);
  program.write(input);
  program.closeWriteChannel();
  if (!program.waitForFinished(60'000)) return {};
  return {program.exitCode(), program.readAllStandardOutput(), program.readAllStandardError()};
}

QByteArray bytesOf(std::string_view text) {
  return {text.data(), static_cast<qsizetype>(text.size())};
}

/// The words of an exporter with what it needs.
QStringList wordsOf(const Exporter& exporter, const QString& path) {
  QStringList words{"export", kTrain, "--to", bytesOf(exporter.form), "-o", path};
  for (const auto& [name, value] : exporter.implied) {
    words << bytesOf(name);
    if (!value.empty()) words << bytesOf(value);
  }
  for (const ExportOption& option : exporter.options) {
    if (option.isNeeded) words << bytesOf(option.name) << QString::fromStdString(option.choices().front());
    if (option.name == "--tolerance")
      words << "--tolerance"
            << "0.2";
    if (option.name == "--size")
      words << "--size"
            << "64x48";
    if (option.name == "--frames") words << "--frames" << QString::number(option.least);
  }
  return words;
}

}  // namespace

/// The command line says and takes what the registry of exporters has.
class ExportRegistryTest : public QObject {
  Q_OBJECT

 private slots:
  void theHelpListsEveryExporterAndOption() {
    const QByteArray help = ran({"export", "--help"}).output;
    const qsizetype begin = help.indexOf("\n  --to FORM") + 1;
    QByteArrayList listed;
    for (const QByteArray& group : help.mid(begin, help.indexOf('\n', begin) - begin).mid(28).split(';')) {
      for (QByteArray& form : group.left(group.lastIndexOf(':')).split(',')) {
        form = form.trimmed();
        listed << (form.endsWith(" with --view") ? form.chopped(12) : form);
      }
    }
    QByteArrayList forms;
    for (const std::string& form : exportForms()) forms << bytesOf(form);
    listed.removeAll("pdf");  // of derivations and of drawings
    forms.removeAll("pdf");
    QCOMPARE(listed, forms);
    for (const OptionText& option : exportOptionTexts())
      QVERIFY2(help.contains("\n  " + bytesOf(option.name)), option.name.data());
  }

  void aWrongFormIsAnsweredWithAll() {
    const Answered answered = ran({"export", kTrain, "--to", "none", "-o", "-"});
    QCOMPARE(answered.status, 2);
    QByteArrayList forms;
    for (const std::string& form : exportForms()) forms << bytesOf(form);
    QVERIFY2(answered.messages.contains("--to is one of " + forms.join(", ") + "."), answered.messages);
  }

  void everyExporterIsReached() {
    const QTemporaryDir folder;
    for (const Exporter* exporter : allExporters()) {
      if (exporter->missing != nullptr && !exporter->missing().empty())
        continue;  // a program that was not built
      const bool isFolder = exporter->files == ExportFiles::folder;
      const QString path = isFolder ? folder.filePath(bytesOf(exporter->id)) : "-";
      const Answered answered = ran(wordsOf(*exporter, path));
      QVERIFY2(answered.status == 0, (bytesOf(exporter->id) + ": " + answered.messages).constData());
      const bool isThere = isFolder ? !QDir(path).isEmpty() : !answered.output.isEmpty();
      QVERIFY2(isThere, exporter->id.data());
    }
  }

  void serveListsEveryOption() {
    const Answered answered =
        ran({"serve", "--stdio"}, "{\"id\": 1, \"method\": \"help\", \"params\": {}}\n");
    const QJsonObject help = QJsonDocument::fromJson(answered.output).object()["result"].toObject();
    QByteArrayList listed, options;
    for (const QJsonValue& method : help["methods"].toArray()) {
      if (method["method"].toString() != "export") continue;
      for (const QJsonValue& option : method["options"].toArray())
        listed << option["name"].toString().toUtf8();
    }
    for (const OptionText& option : exportOptionTexts()) options << bytesOf(option.name);
    options << "--limit-seconds";
    QCOMPARE(listed, options);
  }
};

}  // namespace geargraph::cli

QTEST_GUILESS_MAIN(geargraph::cli::ExportRegistryTest)
#include "test_export_registry.moc"
