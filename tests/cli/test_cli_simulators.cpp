#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "tests/cli/cli_run.h"
#include "tests/core/support/example_files.h"

using namespace geargraph;
using test::Run;
using test::run;

namespace {

QString example(const char* name) {
  return QString::fromStdString(test::examplePath(name));
}
bool says(const Run& call, const char* words) {
  return call.errors.find(words) != std::string::npos;
}

}  // namespace

class CliSimulatorsTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_place;
  [[nodiscard]] QString folder(const char* name) const { return m_place.filePath(QString::fromLatin1(name)); }

 private slots:
  void aModelIsAFolderWithItsMeshes() {
    const Run call = run({"export", example("robot"), "--to", "mjcf", "-o", folder("robot")});
    QCOMPARE(call.status, 0);
    QVERIFY(QFile::exists(folder("robot/robot.xml")));
    QCOMPARE(QDir(folder("robot/meshes")).entryList(QDir::Files).size(), 8);
    QVERIFY(
        says(run({"export", example("robot"), "--to", "mjcf", "-o", folder("robot")}), "is there already"));
    QCOMPARE(run({"export", example("robot"), "--to", "mjcf", "--force", "-o", folder("robot")}).status, 0);
  }

  void gravityAndDensityAreWritten() {
    QCOMPARE(run({"export", example("robot"), "--to", "mjcf", "--gravity", "0,0,-9.81", "--density", "2700",
                  "--motor", "torque", "--timestep", "0.0005", "-o", folder("light")})
                 .status,
             0);
    QFile file(folder("light/robot.xml"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray xml = file.readAll();
    QVERIFY(xml.contains("timestep=\"5e-04\""));
    QVERIFY(xml.contains("gravity=\"0 0 -9.81\""));
    QVERIFY(xml.contains("2700 kg/m3") && xml.contains("<motor "));
  }

  void whatCannotBeIsRejected() {
    const Run urdf = run({"export", example("robot"), "--to", "urdf", "-o", folder("urdf")});
    QCOMPARE(urdf.status, 1);
    QVERIFY(says(urdf, "A joint of URDF can follow one other joint.") && !QFile::exists(folder("urdf")));
    const Run sdf = run({"export", example("robot"), "--to", "sdf", "-o", folder("sdf")});
    QCOMPARE(sdf.status, 2);
    QVERIFY(says(sdf, "SDF is not written"));
    for (const QStringList& wrong : {QStringList{"--motor", "fast"},
                                     {"--timestep", "0"},
                                     {"--gravity", "down"},
                                     {"--density", "-1"},
                                     {"--armature", "-1"}}) {
      QCOMPARE(
          run(QStringList{"export", example("robot"), "--to", "mjcf", "-o", folder("wrong")} + wrong).status,
          2);
    }
    QVERIFY(says(run({"export", example("robot"), "--to", "stl", "--motor", "speed", "-o", folder("a.stl")}),
                 "has no meaning"));
    QCOMPARE(run({"export", example("robot"), "--to", "mjcf", "-o", "-"}).status, 2);
    QCOMPARE(run({"export", example("robot-to-mend"), "--to", "mjcf", "-o", folder("broken")}).status, 1);
    const Run state =
        run({"export", example("ravigneaux"), "--to", "mjcf", "--state", "7", "-o", folder("s")});
    QCOMPARE(state.status, 2);
    QVERIFY(says(state, "There is no state \"7\""));
    QVERIFY(QDir(m_place.path()).entryList({QStringLiteral("wrong"), QStringLiteral("broken")}).isEmpty());
  }

  void theFreedomIsTold() {
    const Run locked = run({"export", example("locked-train"), "--to", "mjcf", "-o", folder("locked")});
    QCOMPARE(locked.status, 0);
    QVERIFY(says(locked, "Nothing can move; the model holds still."));
    QFile file(folder("locked/locked-train.xml"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QVERIFY(!file.readAll().contains("<actuator>"));
  }

  void aStateMakesAUrdf() {
    QCOMPARE(
        run({"export", example("ravigneaux"), "--to", "urdf", "--state", "1", "-o", folder("state")}).status,
        0);
    QVERIFY(QFile::exists(folder("state/ravigneaux.urdf")));
    QVERIFY(run({"export", example("ravigneaux"), "--to", "urdf", "-o", folder("free")}).status == 1);
  }
};

QTEST_GUILESS_MAIN(CliSimulatorsTest)
#include "test_cli_simulators.moc"
