#include <QDir>
#include <QFile>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include "tests/cli/cli_run.h"

using namespace geargraph::test;

namespace {

const QString kGearboxWish = QStringLiteral(SOURCE "/tests/golden/files/gearbox.wish.json");

QString writtenWish(const QTemporaryDir& folder, const QByteArray& json) {
  QFile file(folder.filePath("wish.json"));
  if (!file.open(QIODevice::WriteOnly)) qFatal("no wish");
  file.write(json);
  return file.fileName();
}

/// A six-speed gearbox of a simple and a Ravigneaux set: 480 layouts, two blocks in each of four parts.
const QByteArray kSixSpeedWish = R"({"forward": ["4.171", "2.340", "1.521", "1.143", "0.867", "0.691"],
  "reverse": "3.403", "tolerance": 0.01, "sets": ["simple", "ravigneaux"], "links": 6, "held": 1, "elements": 5,
  "teeth": {"fewest": 15, "mostRing": 110}})";

QByteArray contentsOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// Runs a script of resources/cluster with this program.
void runScript(const char* name, const QStringList& words, const QStringList& variables) {
  QProcess script;
  QStringList environment = QProcess::systemEnvironment() + variables;
  environment << QString("GEARGRAPH_CLI=%1").arg(GEARGRAPH_CLI);
  script.setEnvironment(environment);
  script.start("sh", QStringList{QString(SOURCE "/resources/cluster/") + name} + words);
  QVERIFY(script.waitForFinished(600'000));
  QVERIFY2(script.exitStatus() == QProcess::NormalExit && script.exitCode() == 0,
           script.readAllStandardError().constData());
}

}  // namespace

class GearboxCommandTest : public QObject {
  Q_OBJECT

 private slots:
  /// The documents open by themselves, and their states have the ratios that were told.
  void documentsAreThoseThatWereFound() {
    const QTemporaryDir folder;
    const QString out = folder.filePath("found");
    const Run found = run({"gearbox", kGearboxWish, "--json", "--limit", "3", "-o", out});
    QCOMPARE(found.status, 0);
    const auto answer = parsed(found);
    QCOMPARE(answer.at("gearboxes").size(), 3U);
    QCOMPARE(QDir(out).entryList({"*.geargraph"}).size(), 3);
    for (int i = 0; i < 3; ++i) {
      const QString file = out + QString("/gearbox-%1.geargraph").arg(i + 1);
      const auto states = parsed(run({"states", "--json", file})).at("states");
      const auto expected = answer.at("gearboxes").at(static_cast<std::size_t>(i)).at("states");
      QCOMPARE(states.size(), expected.size());
      for (std::size_t state = 0; state < states.size(); ++state)
        QCOMPARE(states[state].at("ratio"), expected[state].at("ratio"));
      QCOMPARE(run({"validate", file}).status, 0);
    }
  }

  /// Four parts, one of them killed wherever it was and resumed, give the bytes of one run.
  void partsGiveTheBytesOfOneRun() {
    const QTemporaryDir folder;
    const QString wish = writtenWish(folder, kSixSpeedWish);
    const Run whole = run({"gearbox", wish, "--json"});
    QCOMPARE(whole.status, 0);
    QStringList parts;
    for (int part = 0; part < 4; ++part) {
      parts << folder.filePath(QString("part-%1.jsonl").arg(part));
      const QStringList words{"gearbox", wish,       "--jobs", "1", "--shard", QString("%1/4").arg(part),
                              "-o",      parts[part]};
      if (part == 1) {
        QProcess process;
        process.setReadChannel(QProcess::StandardError);
        process.start(GEARGRAPH_CLI, words);
        QVERIFY(process.waitForReadyRead(120'000));  // it tells of its first block
        process.kill();
        QVERIFY(process.waitForFinished());
      }
      QCOMPARE(run(words + QStringList{"--resume"}).status, 0);
      QVERIFY(QFile::exists(parts[part]));
      QVERIFY(!QFile::exists(parts[part] + ".part"));
    }
    const Run merged = run(QStringList{"gearbox", "merge", parts[2], parts[0], parts[3], parts[1], "--json"});
    QCOMPARE(merged.status, 0);
    QCOMPARE(merged.output, whole.output);
    const Run missing = run({"gearbox", "merge", parts[0], parts[3]});
    QCOMPARE(missing.status, 2);
    QVERIFY(missing.output.empty());
    QVERIFY(missing.errors.find("2 of 4 parts are missing, the first is 1/4") != std::string::npos);
    const QString half = folder.filePath("half.jsonl");
    QCOMPARE(run({"gearbox", "merge", parts[0], parts[3], "--parts", half}).status, 0);
    QCOMPARE(run({"gearbox", "merge", half, parts[1], parts[2], "--json"}).output, whole.output);
  }

  /// The script for GNU parallel, of which the second run finishes what a killed one has left.
  void theScriptForParallelGivesTheBytesOfOneRun() {
    if (QStandardPaths::findExecutable("parallel").isEmpty()) QSKIP("GNU parallel is not installed.");
    const QTemporaryDir folder;
    const QString wish = writtenWish(folder, kSixSpeedWish);
    const QString parts = folder.filePath("parts");
    QDir().mkpath(parts);
    QProcess part;  // of another machine, which dies in the middle
    part.setReadChannel(QProcess::StandardError);
    part.start(GEARGRAPH_CLI,
               {"gearbox", wish, "--jobs", "1", "--shard", "2/4", "-o", parts + "/part-2.jsonl"});
    QVERIFY(part.waitForReadyRead(120'000));
    part.kill();
    QVERIFY(part.waitForFinished());
    QVERIFY(!QFile::exists(parts + "/part-2.jsonl") && QFile::exists(parts + "/part-2.jsonl.part"));
    const QByteArray left = contentsOf(parts + "/part-2.jsonl.part");
    QVERIFY(left.contains('\n'));
    runScript("gearbox-parallel.sh", {wish, "4", parts}, {"HOME=" + folder.path()});
    QCOMPARE(contentsOf(parts + "/gearboxes.json").toStdString(), run({"gearbox", wish, "--json"}).output);
    const auto states = contentsOf(parts + "/joblog").split('\n');
    QCOMPARE(states.size(), 6);  // a head, four parts, the end
    runScript("gearbox-parallel.sh", {wish, "4", parts}, {"HOME=" + folder.path()});  // nothing is left
    QCOMPARE(contentsOf(parts + "/gearboxes.json").toStdString(), run({"gearbox", wish, "--json"}).output);
  }

  /// The script for Slurm as its tasks run it: the number of the task is in the environment.
  void theScriptForSlurmGivesTheBytesOfOneRun() {
    const QTemporaryDir folder;
    const QString wish = writtenWish(folder, kSixSpeedWish);
    QStringList merge{"gearbox", "merge", "--json"};
    for (int task = 0; task < 3; ++task) {
      runScript("gearbox-slurm.sh", {wish, "3", folder.filePath("parts")},
                {QString("SLURM_ARRAY_TASK_ID=%1").arg(task)});
      merge << folder.filePath(QString("parts/part-%1.jsonl").arg(task));
    }
    QCOMPARE(run(merge).output, run({"gearbox", wish, "--json"}).output);
  }

  void aFinishedPartIsLeftAlone() {
    const QTemporaryDir folder;
    const QString file = folder.filePath("part.jsonl");
    QFile other(file);
    QVERIFY(other.open(QIODevice::WriteOnly));
    other.write("kept");
    other.close();
    QCOMPARE(run({"gearbox", kGearboxWish, "--shard", "0/1", "--resume", "-o", file}).status, 0);
    QVERIFY(other.open(QIODevice::ReadOnly));
    QCOMPARE(other.readAll(), QByteArray("kept"));
    QCOMPARE(run({"gearbox", "merge", file}).status, 2);  // it is no part
  }

  void wrongUsage() {
    const QTemporaryDir folder;
    QCOMPARE(run({"gearbox"}).status, 2);
    QCOMPARE(run({"gearbox", kGearboxWish, "--shard", "0/2"}).status, 2);
    QCOMPARE(run({"gearbox", kGearboxWish, "--shard", "2/2", "-o", folder.filePath("a")}).status, 2);
    QCOMPARE(run({"gearbox", kGearboxWish, "--resume"}).status, 2);
    QCOMPARE(run({"gearbox", kGearboxWish, "--jobs", "0"}).status, 2);
    QCOMPARE(run({"gearbox", kGearboxWish, "--parts", folder.filePath("a")}).status, 2);
    QCOMPARE(run({"gearbox", "merge"}).status, 2);
    QCOMPARE(run({"gearbox", "merge", "a", "--shard", "0/2"}).status, 2);
    QCOMPARE(run({"hardware"}).status, 2);
    QCOMPARE(run({"hardware", kGearboxWish}).status, 2);  // a wish of another kind
    QVERIFY(QDir(folder.path()).isEmpty());
  }
};

QTEST_GUILESS_MAIN(GearboxCommandTest)
#include "test_gearbox.moc"
