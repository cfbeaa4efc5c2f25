#include <sys/stat.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <limits>

#include "core/foundations/platform/child_process.h"
#include "core/presentation/meshfile/foreign_mesh.h"
#include "tests/core/support/pseudo_language.h"

using namespace geargraph;

namespace {

const std::filesystem::path kReader = GEARGRAPH_MESH_READER;

MeshScene cubeScene() {
  MeshScene scene;
  scene.name = "cube";
  scene.materials.push_back({"grey", {0.5F, 0.5F, 0.5F}});
  MeshNode node;
  node.name = "cube";
  Solid cube;
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-1.0F, 1.0F}) {
      const auto first = static_cast<std::uint32_t>(cube.positions.size());
      const auto u = static_cast<std::size_t>((axis + 1) % 3), v = static_cast<std::size_t>((axis + 2) % 3);
      for (const auto& [a, b] : {std::pair(-1.0F, -1.0F), {1.0F, -1.0F}, {1.0F, 1.0F}, {-1.0F, 1.0F}}) {
        Float3 point{}, normal{};
        point[static_cast<std::size_t>(axis)] = normal[static_cast<std::size_t>(axis)] = side;
        point[u] = side * a;
        point[v] = b;
        cube.positions.push_back(point);
        cube.normals.push_back(normal);
      }
      cube.triangles.push_back({first, first + 1, first + 2});
      cube.triangles.push_back({first, first + 2, first + 3});
    }
  }
  node.solid = std::make_shared<const Solid>(std::move(cube));
  scene.nodes.push_back(std::move(node));
  return scene;
}

}  // namespace

/// Files from elsewhere: those that are fine, and those that are made to hurt.
class ForeignMeshTest : public QObject {
  Q_OBJECT

  const QTemporaryDir folder;

  std::filesystem::path written(const char* name, const QByteArray& bytes) const {
    QFile file(folder.filePath(QLatin1String(name)));
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size()) qFatal("not written");
    return file.fileName().toStdString();
  }
  QByteArray contents(const char* name) const {
    QFile file(folder.filePath(QLatin1String(name)));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }
  static MeshFileError rejection(const std::filesystem::path& path, ForeignLimits limits = {}) {
    limits.mostSeconds = 2;
    const auto read = readForeignMesh(kReader, path, limits);
    const auto* error = std::get_if<MeshFileError>(&read);
    return error != nullptr ? *error : MeshFileError{MeshFileError::Kind::stopped, "it was read"};
  }

 private slots:
  void everyFormIsRead_data() {
    QTest::addColumn<int>("format");
    for (const MeshFormat format : {MeshFormat::stl, MeshFormat::obj, MeshFormat::ply, MeshFormat::glb})
      QTest::addRow("%s", std::string(meshFormatName(format)).c_str()) << static_cast<int>(format);
  }
  void everyFormIsRead() {
    QFETCH(int, format);
    const auto form = static_cast<MeshFormat>(format);
    const std::filesystem::path path =
        folder.filePath("cube." + QString::fromStdString(std::string(meshFormatName(form)))).toStdString();
    QVERIFY(!writeMesh(cubeScene(), form, path));
    const auto read = readForeignMesh(kReader, path);
    QVERIFY2(std::holds_alternative<Solid>(read),
             std::holds_alternative<Solid>(read) ? "" : std::get<MeshFileError>(read).message.c_str());
    const Solid& solid = std::get<Solid>(read);
    QCOMPARE(solid.triangles.size(), std::size_t{12});
    const double metres = form == MeshFormat::glb ? 1e-3 : 1;
    QVERIFY(std::abs(signedVolume(solid) - 8 * metres * metres * metres) < 1e-5 * metres * metres * metres);
    for (const Float3& n : solid.normals) {
      const float largest = std::max({std::abs(n[0]), std::abs(n[1]), std::abs(n[2])});
      QVERIFY(std::abs(largest - 1) < 1e-4F);  // edges of 90 degrees stay edges
    }
  }

  void truncatedFilesAreRejected() {
    for (const MeshFormat form : {MeshFormat::stl, MeshFormat::ply, MeshFormat::glb}) {
      const std::string name = "whole." + std::string(meshFormatName(form));
      QVERIFY(!writeMesh(cubeScene(), form, folder.filePath(QString::fromStdString(name)).toStdString()));
      const QByteArray whole = contents(name.c_str());
      for (const double part : {0.0, 0.05, 0.3, 0.7, 0.95}) {
        const std::string cut = "cut." + std::string(meshFormatName(form));
        const auto path = written(
            cut.c_str(), whole.left(static_cast<qsizetype>(part * static_cast<double>(whole.size()))));
        const auto read = readForeignMesh(kReader, path);  // rejected, or less: never a crash here
        if (const auto* solid = std::get_if<Solid>(&read)) QVERIFY(solid->triangles.size() < 12);
      }
    }
  }

  void hugeCountsCostAnErrorAndNothingElse() {
    QByteArray stl(80, ' ');
    stl += QByteArray("\xff\xff\xff\xff", 4) + QByteArray(50, '\0');
    QVERIFY(!rejection(written("huge.stl", stl)).message.empty());
    const QByteArray ply =
        "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float x\n"
        "property float y\nproperty float z\nelement face 4000000000\n"
        "property list uchar int vertex_indices\nend_header\n";
    QVERIFY(rejection(written("huge.ply", ply)).message != "it was read");
    ForeignLimits narrow;
    narrow.mostMemory = std::size_t{64} << 20U;
    QByteArray many = "solid\n";
    for (int i = 0; i < 200'000; ++i)
      many += "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
    const auto path = written("many.stl", many + "endsolid\n");
    if (confinesChildren())
      QCOMPARE(static_cast<int>(rejection(path, narrow).kind), static_cast<int>(MeshFileError::Kind::limit));
    ForeignLimits few;
    few.mostTriangles = 1000;
    QCOMPARE(static_cast<int>(rejection(path, few).kind), static_cast<int>(MeshFileError::Kind::limit));
    few.mostBytes = 1000;
    QVERIFY(rejection(path, few).message.find("bytes") != std::string::npos);
  }

  void whatIsNoFileIsNotWaitedFor() {
    const std::string pipe = folder.filePath("endless.stl").toStdString();
    QCOMPARE(::mkfifo(pipe.c_str(), 0600), 0);
    QCOMPARE(rejection(pipe).message, std::string("It is no file."));
    QCOMPARE(rejection(folder.filePath("none.stl").toStdString()).message, std::string("It is not there."));
    QVERIFY(QDir(folder.path()).mkdir("folder.stl"));
    QCOMPARE(rejection(folder.filePath("folder.stl").toStdString()).message, std::string("It is no file."));
    QCOMPARE(rejection("/dev/zero").message, std::string("It is none of STL, OBJ, PLY and GLB."));
    QFile::link("/dev/zero", folder.filePath("zero.stl"));
    QCOMPARE(rejection(folder.filePath("zero.stl").toStdString()).message, std::string("It is no file."));
  }

  void aReaderThatHangsOrLiesIsGivenUp() {
    const auto path = written("any.stl", "solid\nendsolid\n");
    const auto program = [&](const char* name, const QByteArray& script) {
      const auto place = written(name, "#!/bin/sh\n" + script + "\n");
      QFile(QString::fromStdString(place.string()))
          .setPermissions(QFile::ReadOwner | QFile::ExeOwner | QFile::WriteOwner);
      return place;
    };
    ForeignLimits brief;
    brief.mostSeconds = 0.3;
    const auto hung = readForeignMesh(program("hangs", "exec /bin/sleep 1000"), path, brief);
    QCOMPARE(static_cast<int>(std::get<MeshFileError>(hung).kind),
             static_cast<int>(MeshFileError::Kind::limit));
    const auto endless = readForeignMesh(program("pours", "exec /bin/cat /dev/zero"), path, brief);
    QVERIFY(std::holds_alternative<MeshFileError>(endless));
    const auto lied =
        readForeignMesh(program("lies", "printf 'GGM1\\377\\377\\377\\377\\001\\000\\000\\000'"), path);
    QVERIFY(std::holds_alternative<MeshFileError>(lied));
    const auto crashed = readForeignMesh(program("crashes", "kill -SEGV $$"), path);
    QVERIFY(std::get<MeshFileError>(crashed).message.find(confinesChildren()
                                                              ? "crashed, and was confined"
                                                              : "does not confine it") != std::string::npos);
    const auto silent = readForeignMesh(program("silent", "exit 0"), path);
    QVERIFY(std::get<MeshFileError>(silent).message.find("is no solid") != std::string::npos);
    const auto busy = readForeignMesh(program("busy", "kill -XCPU $$"), path, brief);
    QCOMPARE(std::get<MeshFileError>(busy).kind == MeshFileError::Kind::limit, confinesChildren());
    QVERIFY(std::holds_alternative<MeshFileError>(readForeignMesh("/nowhere/at/all", path)));
    QVERIFY(std::holds_alternative<MeshFileError>(readForeignMesh({}, path)));
    std::stop_source stop;
    stop.request_stop();
    const auto stopped =
        readForeignMesh(program("waits", "exec /bin/sleep 1000"), path, {}, stop.get_token());
    QCOMPARE(static_cast<int>(std::get<MeshFileError>(stopped).kind),
             static_cast<int>(MeshFileError::Kind::stopped));
  }

  void theReportOfTheReaderIsOneLine() {
    const auto path = written("any.stl", "solid\nendsolid\n");
    const auto said = [&](const QByteArray& script) {
      const auto place = written("says", "#!/bin/sh\n" + script + "\nexit 2\n");
      QFile(QString::fromStdString(place.string()))
          .setPermissions(QFile::ReadOwner | QFile::ExeOwner | QFile::WriteOwner);
      return std::get<MeshFileError>(readForeignMesh(place, path)).message;
    };
    QCOMPARE(said("printf 'a\\n\\n\\033[31mb\\303\\251\\302\\205\\377c' >&2"),
             std::string("a [31mb\xC3\xA9 c"));
    const std::string longest = said("head -c 100000 /dev/zero | tr '\\0' x >&2");
    QCOMPARE(longest, std::string(300, 'x') + "...");
  }

  /// The reader's process has no catalogue: what it reports is translated where it is shown.
  void whatTheReaderReportsIsTranslated() {
    const auto broken = written("broken.ply", "ply\nformat ascii 1.0\n");
    const auto empty = written("empty.stl", "solid\nendsolid\n");
    const auto two = written("two.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 3 2\n");
    ForeignLimits few;
    few.mostTriangles = 1;
    QCOMPARE(rejection(broken).message, std::string("It is damaged: its header has no end."));
    QCOMPARE(rejection(two, few).message, std::string("The 3D file has 2 faces, more than the limit of 1."));
    const std::string english = rejection(empty).message;
    const test::PseudoLanguage pseudo;
    QCOMPARE(rejection(broken).message,
             test::PseudoLanguage::accented("It is damaged: its header has no end."));
    QCOMPARE(rejection(two, few).message,
             test::PseudoLanguage::accented("The 3D file has 2 faces, more than the limit of 1."));
    QVERIFY(rejection(empty).message != english);
  }

  /// A hostile file can have written any report.
  void aReportWithTooFewOrTooManyPartsIsASentence() {
    const auto path = written("any.stl", "solid\nendsolid\n");
    const auto said = [&](const QByteArray& text) {
      const auto place = written("says", "#!/bin/sh\nprintf '" + text + "' >&2\nexit 2\n");
      QFile(QString::fromStdString(place.string()))
          .setPermissions(QFile::ReadOwner | QFile::ExeOwner | QFile::WriteOwner);
      return std::get<MeshFileError>(readForeignMesh(place, path)).message;
    };
    QCOMPARE(said("%%1 of %%2\\037a\\037b"), std::string("a of b"));
    QCOMPARE(said("%%1 of %%2\\037%%2"), std::string("%2 of %2"));
    QCOMPARE(said("%%1 of %%2\\037a\\037b\\037c\\037"), std::string("a of b"));
    QCOMPARE(said("a\\037"), std::string("a"));
  }

  void noOtherFileIsRead() {
    written("other.mtl", "newmtl red\nKd 1 0 0\n");
    const auto path =
        written("other.obj", "mtllib other.mtl\nusemtl red\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const auto read = readForeignMesh(kReader, path);
    QVERIFY(std::holds_alternative<Solid>(read));
    QCOMPARE(std::get<Solid>(read).triangles.size(), std::size_t{1});
    const QByteArray json =
        R"({"asset":{"version":"2.0"},"buffers":[{"uri":"/etc/passwd","byteLength":36}],"bufferViews":[{"buffer":0,"byteLength":36}],"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"nodes":[{"mesh":0}],"scenes":[{"nodes":[0]}],"scene":0})";
    const auto word = [](quint32 number) {
      return QByteArray(reinterpret_cast<const char*>(&number), sizeof number);  // NOLINT: little-endian
    };
    const QByteArray text = json + QByteArray((4 - json.size() % 4) % 4, ' ');
    const auto size = static_cast<quint32>(text.size());
    const QByteArray glb = "glTF" + word(2) + word(20 + size) + word(size) + "JSON" + text;
    QCOMPARE(static_cast<int>(rejection(written("other.glb", glb)).kind),
             static_cast<int>(MeshFileError::Kind::file));
  }

  void aCrashIsOneClearSentence() {
    // assimp 5.2 reads beyond the end of this one, and dies by it.
    const QByteArray ply =
        "ply\nformat binary_little_endian 1.0\nelement vertex 24\nproperty float x\nproperty float y\n"
        "property float z\nelement face 12\nproperty list uchar uint vertex_indices\nend_header\n";
    for (const int length : {0, 1, 3, 100}) {
      const MeshFileError why = rejection(written("dies.ply", ply + QByteArray(length, '\x01')));
      QVERIFY2(why.message.rfind("It is damaged", 0) == 0, why.message.c_str());
    }
  }

  void facesOfVerticesThatAreNotThereAreRejected() {
    const QByteArray ply =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 77\n";
    QCOMPARE(rejection(written("far.ply", ply)).message,
             std::string("It is damaged: a face names a vertex that is not there."));
  }

  void theBytesBetweenTheProcessesAreChecked() {
    const Solid cube = *cubeScene().nodes.front().solid;
    const std::string bytes = packedSolid(cube);
    QVERIFY(*unpackedSolid(bytes, 12) == cube);
    QVERIFY(!unpackedSolid(bytes, 11));
    QVERIFY(!unpackedSolid(bytes.substr(0, bytes.size() - 1), 12));
    QVERIFY(!unpackedSolid(bytes + "x", 12));
    QVERIFY(!unpackedSolid(packedSolid(Solid{{}, {}, {{0, 0, 0}}}), 12));
    Solid wrong = cube;
    wrong.triangles[3][1] = 24;
    QVERIFY(!unpackedSolid(packedSolid(wrong), 12));
    wrong = cube;
    wrong.positions[0][0] = std::numeric_limits<float>::quiet_NaN();
    QVERIFY(!unpackedSolid(packedSolid(wrong), 12));
  }
};

QTEST_GUILESS_MAIN(ForeignMeshTest)
#include "test_foreign_mesh.moc"
