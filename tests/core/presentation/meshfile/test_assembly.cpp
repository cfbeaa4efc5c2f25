#include <QTest>
#include <set>

#include "core/presentation/meshfile/assembly.h"
#include "core/presentation/meshfile/mesh_reader.h"
#include "tests/core/presentation/meshfile/cogs.h"
#include "tests/core/support/file_contents.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

Assembly twoGears() {
  Assembly assembly;
  AssemblyGear& pinion = assembly.gears.emplace_back();
  pinion.name = "15:tail";
  pinion.teeth = 12;
  pinion.module = 1;
  pinion.pressureAngle = 20 * M_PI / 180;
  pinion.width = 5;
  pinion.backlashAllowance = 0.02;
  pinion.solid = std::make_shared<const Solid>(cog(12, 6, 5));
  AssemblyGear& bevel = assembly.gears.emplace_back(pinion);
  bevel.name = "15:head";
  bevel.kind = GearKind::bevel;
  bevel.teeth = 30;
  bevel.coneAngle = M_PI / 3;
  bevel.addendum = 0.9;
  bevel.tipCircle = 15.9;
  bevel.solid = std::make_shared<const Solid>(cog(30, 15, 5));
  bevel.pose.translate(Eigen::Vector3d(21, 0, 0))
      .rotate(Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ()));
  assembly.meshes = {{0, 1}};
  for (int i = 0; i < 12; ++i) {
    Eigen::Isometry3d turned = assembly.gears[0].pose;
    turned.rotate(Eigen::AngleAxisd(0.1 * i, Eigen::Vector3d::UnitZ()));
    assembly.frames.push_back({turned, bevel.pose});
  }
  return assembly;
}

QJsonObject index(const QString& folder) {
  return QJsonDocument::fromJson(contents(folder + "/assembly.json")).object();
}

QStringList entries(const QString& folder) {
  return QDir(folder).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot, QDir::Name);
}

}  // namespace

class AssemblyTest : public QObject {
  Q_OBJECT
 private slots:
  void theIndexHasTheMembersOfTheManual() {
    const QTemporaryDir folder;
    const QString out = folder.filePath("deep/out");
    QVERIFY(!writeAssembly(twoGears(), out.toStdString(), false));
    QCOMPARE(entries(out), QStringList({"15-head.stl", "15-tail.stl", "assembly.json"}));
    const QJsonArray gears = index(out)["gears"].toArray();
    QCOMPARE(gears.size(), 2);
    const QJsonObject pinion = gears[0].toObject();
    QCOMPARE(pinion.keys(), QStringList({"alpha_deg", "bore", "file", "module", "name", "pose", "thinning",
                                         "type", "width", "x", "z"}));
    QCOMPARE(pinion["name"].toString(), QString("15:tail"));
    QCOMPARE(pinion["type"].toString(), QString("external"));
    QCOMPARE(pinion["file"].toString(), QString("15-tail.stl"));
    QVERIFY(std::abs(pinion["alpha_deg"].toDouble() - 20) < 1e-12);
    const QJsonObject bevel = gears[1].toObject();
    QCOMPARE(bevel.keys(), QStringList({"alpha_deg", "bore", "delta_deg", "face", "file", "flank", "ha",
                                        "module", "name", "pose", "ra", "thinning", "type", "x", "z"}));
    QVERIFY(std::abs(bevel["delta_deg"].toDouble() - 60) < 1e-12);
    const QJsonObject pair = index(out)["meshes"].toArray()[0].toObject();
    QCOMPARE(pair["a"].toString() + pair["b"].toString(), QString("15:tail15:head"));
  }

  void posesAreRowsOfAMatrix() {
    const QJsonObject json =
        QJsonDocument::fromJson(QByteArray::fromStdString(assemblyJson(twoGears()))).object();
    const QJsonArray rows = json["gears"].toArray()[1].toObject()["pose"].toArray();
    QCOMPARE(rows.size(), 4);
    QCOMPARE(rows[0].toArray()[3].toDouble(), 21.0);
    QCOMPARE(rows[1].toArray()[0].toDouble(), 1.0);
    QCOMPARE(rows[3].toArray()[3].toDouble(), 1.0);
    const QJsonArray frames = json["frames"].toArray();
    QCOMPARE(frames.size(), 12);
    const QJsonObject frame = frames[3].toObject();
    QCOMPARE(frame.keys(), QStringList({"15:head", "15:tail"}));
    QCOMPARE(frame["15:tail"].toArray()[1].toArray()[0].toDouble(), std::sin(0.1 * 3));
  }

  void theFilesHoldTheGearsInTheirOwnFrames() {
    const QTemporaryDir folder;
    QVERIFY(!writeAssembly(twoGears(), folder.path().toStdString(), false));
    const auto read = readMesh(contents(folder.filePath("15-head.stl")).toStdString(), MeshFormat::stl);
    const MeshScene& scene = std::get<MeshScene>(read);
    QCOMPARE(triangleCount(scene), twoGears().gears[1].solid->triangles.size());
    const MeshScene flat = flattened(scene);
    QVERIFY(isClosed(welded(*flat.nodes[0].solid)));
    QVERIFY(std::abs(boundsOf(*flat.nodes[0].solid).max().x() - 15) < 0.1);
  }

  void whatIsThereIsKeptUnlessForced() {
    const QTemporaryDir folder;
    const std::string path = folder.path().toStdString();
    QVERIFY(!writeAssembly(twoGears(), path, false));
    const QByteArray before = contents(folder.filePath("assembly.json"));
    Assembly other = twoGears();
    other.unit = "cm";
    const auto rejected = writeAssembly(other, path, false);
    QVERIFY(rejected.has_value() && rejected->kind == MeshFileError::Kind::file);
    QCOMPARE(contents(folder.filePath("assembly.json")), before);
    QVERIFY(!writeAssembly(other, path, true));
    QVERIFY(contents(folder.filePath("assembly.json")) != before);
  }

  void aNewFolderAppearsWholeOrNotAtAll() {
    const QTemporaryDir folder;
    for (const double part : {0.0, 0.5, 0.8}) {
      std::stop_source source;
      MeshWriteOptions options;
      options.stop = source.get_token();
      options.progress = [&](double done) {
        if (done >= part) source.request_stop();
      };
      const auto error = writeAssembly(twoGears(), folder.filePath("out").toStdString(), false, options);
      QVERIFY(error.has_value() && error->kind == MeshFileError::Kind::stopped);
      QCOMPARE(entries(folder.path()), QStringList());
    }
  }

  void aFileInThePlaceIsAnError() {
    const QTemporaryDir folder;
    QFile file(folder.filePath("taken"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    for (const char* place : {"taken", "taken/below"}) {
      const auto error = writeAssembly(twoGears(), folder.filePath(place).toStdString(), true);
      QVERIFY(error.has_value() && error->kind == MeshFileError::Kind::file);
    }
  }

  void fileNamesAreSafeAndDiffer() {
    Assembly assembly = twoGears();
    assembly.gears[0].name = "7'/..";
    assembly.gears[1].name = "7''..";
    QCOMPARE(gearFiles(assembly), (std::vector<std::string>{"7----.stl", "7----_2.stl"}));
  }

  void theLimitHoldsForAllGearsTogether() {
    MeshWriteOptions options;
    options.mostTriangles = twoGears().gears[0].solid->triangles.size() + 10;
    const QTemporaryDir folder;
    const auto error = writeAssembly(twoGears(), folder.filePath("out").toStdString(), false, options);
    QVERIFY(error.has_value() && error->kind == MeshFileError::Kind::limit);
  }

  void sameAssemblyGivesTheSameText() { QCOMPARE(assemblyJson(twoGears()), assemblyJson(twoGears())); }

  void framesSpanAPitchOfTheSlowestMesh() {
    const std::vector<double> pitches{-3, 0.25, 40, 0};
    const auto times = frameTimes(pitches, 24);
    QCOMPARE(times.size(), std::size_t(24));
    QCOMPARE(times.front(), 0.0);
    QVERIFY(std::is_sorted(times.begin(), times.end()));
    QVERIFY(times.back() * 0.25 > 1.01 && times.back() * 0.25 < 1.6);
  }

  void noMeshIsSeenInOnePositionOnly() {
    // 23 pitches from frame to frame in a span of one pitch of the slow mesh: taken as it comes, the fast
    // mesh would stand in the same position in all 24 frames.
    const std::vector<double> pitches{1, 23 * 23, 46, 11.5};
    const auto times = frameTimes(pitches, 24);
    for (const double rate : pitches) {
      std::set<int> twelfths;
      for (const double time : times) {
        const double position = rate * time - std::floor(rate * time);
        twelfths.insert(static_cast<int>(12 * position));
      }
      QVERIFY2(twelfths.size() >= 10, qPrintable(QString("%1: %2").arg(rate).arg(twelfths.size())));
    }
  }

  void aTrainAtRestStillHasItsFrames() {
    const std::vector<double> pitches{0, 0};
    const auto times = frameTimes(pitches, 12);
    QCOMPARE(times.size(), std::size_t(12));
    QCOMPARE(times.back(), 1.0);
  }
};

QTEST_APPLESS_MAIN(AssemblyTest)
#include "test_assembly.moc"
