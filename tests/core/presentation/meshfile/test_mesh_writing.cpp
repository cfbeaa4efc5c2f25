#include <QTest>
#include <cmath>
#include <limits>

#include "core/presentation/meshfile/encoders.h"
#include "core/presentation/meshfile/mesh_reader.h"
#include "core/presentation/meshfile/mesh_writer.h"
#include "tests/core/presentation/meshfile/cogs.h"
#include "tests/core/presentation/meshfile/mesh_formats.h"
#include "tests/core/support/aborts.h"
#include "tests/core/support/file_contents.h"
#include "tests/core/support/pseudo_language.h"

using namespace geargraph;
using namespace geargraph::test;

class MeshWritingTest : public QObject {
  Q_OBJECT
 private slots:
  void theFileHoldsTheEncodedBytes_data() { addFormats(); }
  void theFileHoldsTheEncodedBytes() {
    QFETCH(MeshFormat, format);
    const QTemporaryDir folder;
    const QString path =
        folder.filePath("wheels." + QString::fromStdString(std::string(meshFormatName(format))));
    QVERIFY(!writeMesh(movingScene(), format, path.toStdString()));
    const auto files = std::get<std::vector<EncodedFile>>(encodedMesh(movingScene(), format, "wheels"));
    for (const EncodedFile& file : files) {
      QCOMPARE(contents(folder.filePath(QString::fromStdString(file.name))),
               QByteArray::fromStdString(file.bytes));
    }
    QCOMPARE(QDir(folder.path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot).size(),
             int(files.size()));
  }

  void progressGrowsToOne_data() { addFormats(); }
  void progressGrowsToOne() {
    QFETCH(MeshFormat, format);
    const QTemporaryDir folder;
    std::vector<double> seen;
    MeshWriteOptions options;
    options.progress = [&](double part) { seen.push_back(part); };
    QVERIFY(!writeMesh(movingScene(), format, folder.filePath("wheels").toStdString(), options));
    QVERIFY(seen.size() > 4 && std::is_sorted(seen.begin(), seen.end()));
    QVERIFY(seen.front() >= 0 && seen.back() == 1);
  }

  void stoppingLeavesWhatWasThere_data() { addFormats(); }
  void stoppingLeavesWhatWasThere() {
    QFETCH(MeshFormat, format);
    for (const double part : {0.0, 0.3, 0.8}) {
      const QTemporaryDir folder;
      const QString path = folder.filePath("old");
      QFile old(path);
      QVERIFY(old.open(QIODevice::WriteOnly) && old.write("what was there") > 0);
      old.close();
      std::stop_source source;
      MeshWriteOptions options;
      options.stop = source.get_token();
      options.progress = [&](double done) {
        if (done >= part) source.request_stop();
      };
      const auto error = writeMesh(hugeScene(), format, path.toStdString(), options);
      QVERIFY(error.has_value());
      QCOMPARE(int(error->kind), int(MeshFileError::Kind::stopped));
      QCOMPARE(contents(path), QByteArray("what was there"));
    }
  }

  void anUnwritablePlaceIsAnErrorOfTheFile_data() { addFormats(); }
  void anUnwritablePlaceIsAnErrorOfTheFile() {
    QFETCH(MeshFormat, format);
    const QTemporaryDir above;
    const QDir folder(above.filePath("folder"));
    QVERIFY(folder.mkpath("."));
    for (const QString& path : {folder.filePath("no such folder/wheels"), folder.path()}) {
      const auto error = writeMesh(movingScene(), format, path.toStdString());
      QVERIFY(error.has_value());
      QCOMPARE(int(error->kind), int(MeshFileError::Kind::file));
      QVERIFY(error->message.size() > 10);
    }
    QVERIFY(folder.isEmpty());
    QCOMPARE(QDir(above.path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot),
             QStringList("folder"));  // no part of several files either
  }

  void tooManyTrianglesAreRejectedWithTheNumber() {
    MeshWriteOptions options;
    options.mostTriangles = 100;
    const auto result = encodedMesh(movingScene(), MeshFormat::stl, "wheels", options);
    const auto& error = std::get<MeshFileError>(result);
    QCOMPARE(int(error.kind), int(MeshFileError::Kind::limit));
    QVERIFY(error.message.find(std::to_string(triangleCount(movingScene()))) != std::string::npos);
    const PseudoLanguage pseudo;
    const auto there = encodedMesh(movingScene(), MeshFormat::stl, "wheels", options);
    QCOMPARE(std::get<MeshFileError>(there).message, PseudoLanguage::accented(error.message));
  }

  void numbersBeyondFloatsAreRejected_data() { addFormats(); }
  void numbersBeyondFloatsAreRejected() {
    QFETCH(MeshFormat, format);
    const auto kindOf = [&](const MeshScene& scene) {
      const auto result = encodedMesh(scene, format, "wheels");
      const auto* error = std::get_if<MeshFileError>(&result);
      return error != nullptr ? int(error->kind) : -1;
    };
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    QCOMPARE(kindOf(movingScene()), -1);
    for (const double far : {1e39, std::nan("")}) {  // beyond a float, where the vertices themselves are not
      MeshScene scene = movingScene();
      scene.nodes[1].pose.translation().x() = far;
      QCOMPARE(kindOf(scene), int(MeshFileError::Kind::limit));
    }
    for (const float number : {kInfinity, -kInfinity, std::nanf("")}) {
      MeshScene scene = movingScene(), shaded = scene;
      Solid solid = cog(12, 3, 1);
      solid.positions[0][1] = number;
      scene.nodes[3].solid = std::make_shared<const Solid>(solid);
      QCOMPARE(kindOf(scene), int(MeshFileError::Kind::limit));
      solid = cog(12, 3, 1);
      solid.normals[0][1] = number;
      shaded.nodes[3].solid = std::make_shared<const Solid>(solid);
      QCOMPARE(kindOf(shaded), int(MeshFileError::Kind::limit));
    }
  }

  void encodersWriteNoSuchNumbers() {
    MeshScene scene = movingScene();
    Solid solid = cog(12, 3, 1);
    solid.positions[solid.triangles[0][0]][1] = std::numeric_limits<float>::infinity();
    scene.nodes[3].solid = std::make_shared<const Solid>(solid);
    QVERIFY(aborts([&] { (void)stlBytes(scene, {}); }));
    QVERIFY(aborts([&] { (void)plyBytes(scene, {}); }));
    QVERIFY(aborts([&] { (void)objTexts(scene, "wheels.mtl", {}); }));
    QVERIFY(aborts([&] {
      TextSink sink;
      (void)writeGlb(scene, {}, sink);
    }));
    QVERIFY(aborts([&] { (void)threeMfBytes(scene, {}); }));
  }

  void formatNamesGoBothWays() {
    for (const MeshFormat format : allMeshFormats()) {
      QVERIFY(meshFormatFromName(meshFormatName(format)) == format);
    }
    QVERIFY(!meshFormatFromName("step").has_value());
  }

 private:
  /// Several MiB in every format, so that there is something to stop.
  static MeshScene hugeScene() {
    MeshScene scene = movingScene();
    scene.nodes[3].solid = std::make_shared<const Solid>(cog(10'000, 15, 5));
    return scene;
  }
};

QTEST_APPLESS_MAIN(MeshWritingTest)
#include "test_mesh_writing.moc"
