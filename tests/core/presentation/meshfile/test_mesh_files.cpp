#include <QTest>
#include <bit>

#include "core/presentation/meshfile/mesh_reader.h"
#include "core/presentation/meshfile/mesh_writer.h"
#include "tests/core/presentation/meshfile/cogs.h"
#include "tests/core/presentation/meshfile/mesh_formats.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

std::vector<EncodedFile> encoded(const MeshScene& scene, MeshFormat format) {
  const auto result = encodedMesh(scene, format, "train");
  return std::get<std::vector<EncodedFile>>(result);
}

MeshScene reread(const MeshScene& scene, MeshFormat format) {
  const auto result = readMesh(encoded(scene, format)[0].bytes, format);
  if (const auto* error = std::get_if<MeshFileError>(&result)) qFatal("%s", error->message.c_str());
  return std::get<MeshScene>(result);
}

/// All solids of a scene, moved to the world.
Solid everything(const MeshScene& scene) {
  Solid whole;
  const auto world = worldPoses(scene);
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    if (scene.nodes[i].solid) append(whole, *scene.nodes[i].solid, world[i]);
  }
  return whole;
}

const MeshNode* nodeNamed(const MeshScene& scene, const std::string& name) {
  for (const MeshNode& node : scene.nodes) {
    if (node.name == name) return &node;
  }
  return nullptr;
}

}  // namespace

class MeshFilesTest : public QObject {
  Q_OBJECT
 private slots:
  void everyFormatBringsTheSolidsBack_data() { addFormats(); }
  void everyFormatBringsTheSolidsBack() {
    QFETCH(MeshFormat, format);
    const MeshScene scene = movingScene();
    const MeshScene back = reread(scene, format);
    const double scale = format == MeshFormat::glb ? 1e-3 : 1;
    QCOMPARE(triangleCount(back), triangleCount(scene));
    const Solid before = everything(scene);
    const Solid after = everything(back);
    const double volume = signedVolume(before) * scale * scale * scale;
    QVERIFY(std::abs(signedVolume(after) - volume) < 1e-5 * volume);
    const Eigen::AlignedBox3d box = boundsOf(before);
    QVERIFY((boundsOf(after).min() - scale * box.min()).norm() < 1e-5 * scale * box.diagonal().norm());
    QVERIFY((boundsOf(after).max() - scale * box.max()).norm() < 1e-5 * scale * box.diagonal().norm());
  }

  void everyFormatStaysClosedUnderExactWelding_data() { addFormats(); }
  void everyFormatStaysClosedUnderExactWelding() {
    QFETCH(MeshFormat, format);
    const MeshScene scene = movingScene();
    const MeshScene back = reread(scene, format);
    for (const MeshNode& node : back.nodes) {
      if (node.solid) QVERIFY(isClosed(welded(*node.solid)));
    }
    QCOMPARE(welded(everything(flattened(back))).positions.size(),
             welded(everything(flattened(scene))).positions.size());
  }

  void finestDetailSurvivesInMetres() {
    // assimp joins what is nearer than 1e-5; a module of 0.1 mm in metres must not suffer.
    MeshScene scene;
    scene.nodes.push_back({"small",
                           kNoNode,
                           Eigen::Isometry3d::Identity(),
                           std::make_shared<const Solid>(cog(200, 0.05, 0.01)),
                           0,
                           {}});
    const MeshScene back = reread(scene, MeshFormat::glb);
    QCOMPARE(triangleCount(back), triangleCount(scene));
    const Solid solid = everything(back);
    QCOMPARE(welded(solid).positions.size(), welded(*scene.nodes[0].solid).positions.size());
    QVERIFY(isClosed(welded(solid)));
  }

  void sameSceneGivesTheSameBytes_data() { addFormats(); }
  void sameSceneGivesTheSameBytes() {
    QFETCH(MeshFormat, format);
    const auto first = encoded(movingScene(), format);
    const auto second = encoded(movingScene(), format);
    QCOMPARE(first.size(), second.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
      QCOMPARE(first[i].name, second[i].name);
      QVERIFY(!first[i].bytes.empty() && first[i].bytes == second[i].bytes);
    }
  }

  void glbKeepsTheTreeTheNamesAndTheMaterials() {
    const MeshScene back = reread(movingScene(), MeshFormat::glb);
    QCOMPARE(back.name, std::string("Planet & Träger"));
    const MeshNode* planet = nodeNamed(back, "planet");
    QVERIFY(planet != nullptr && nodeNamed(back, "wheel (2)") != nullptr);
    QCOMPARE(back.nodes[planet->parent].name, std::string("carrier <1>"));
    QCOMPARE(back.materials[planet->material].name, std::string("link 1 \"blue\""));
    QVERIFY(std::abs(back.materials[planet->material].colour[1] - 0.2F) < 1e-3F);
    QVERIFY(planet->solid == nodeNamed(back, "planet")->solid);
    QVERIFY(encoded(movingScene(), MeshFormat::glb)[0].bytes.find("\"documentUnit\": \"mm\"") !=
            std::string::npos);
  }

  void glbCarriesTheMotion() {
    const MeshScene scene = movingScene();
    const MeshScene back = reread(scene, MeshFormat::glb);
    QVERIFY(std::abs(durationOf(back) - 4) < 1e-6);
    QCOMPARE(nodeNamed(back, "planet")->keys.size(), scene.nodes[4].keys.size());
    for (int i = 0; i <= 40; ++i) {
      const double time = 0.1 * i + 0.013;
      const auto expected = worldPosesAt(scene, time);
      const auto poses = worldPosesAt(back, time);
      for (std::size_t k = 3; k < scene.nodes.size(); ++k) {
        const auto place = static_cast<std::size_t>(nodeNamed(back, scene.nodes[k].name) - back.nodes.data());
        QVERIFY((poses[place].linear() - expected[k].linear()).norm() < 2e-6);
        QVERIFY((poses[place].translation() - 1e-3 * expected[k].translation()).norm() < 1e-7);
      }
    }
  }

  void glbIsBuiltAsTheSpecificationSays() {
    const QByteArray bytes = QByteArray::fromStdString(encoded(movingScene(), MeshFormat::glb)[0].bytes);
    const auto word = [&](qsizetype at) {
      std::uint32_t value = 0;
      std::memcpy(&value, bytes.constData() + at, 4);
      return qsizetype(value);
    };
    QCOMPARE(bytes.left(4), QByteArray("glTF"));
    QCOMPARE(word(4), qsizetype(2));
    QCOMPARE(word(8), bytes.size());
    const qsizetype text = word(12);
    QVERIFY(text % 4 == 0 && bytes.mid(16, 4) == "JSON");
    const QByteArray binary = bytes.mid(20 + text + 8);
    QVERIFY(word(20 + text) == binary.size() && bytes.mid(20 + text + 4, 4) == QByteArray("BIN\0", 4));
    const QJsonObject gltf = QJsonDocument::fromJson(bytes.mid(20, text)).object();
    QCOMPARE(gltf["buffers"].toArray()[0].toObject()["byteLength"].toInteger(), qint64(binary.size()));

    const QJsonArray views = gltf["bufferViews"].toArray();
    const QJsonArray accessors = gltf["accessors"].toArray();
    const auto numbers = [&](int place) {  // of floats, flat
      const QJsonObject view = views[accessors[place].toObject()["bufferView"].toInt()].toObject();
      std::vector<float> values(std::size_t(view["byteLength"].toInt()) / 4);
      std::memcpy(values.data(), binary.constData() + view["byteOffset"].toInt(), 4 * values.size());
      return values;
    };
    qint64 end = 0;
    for (const QJsonValue& value : views) {
      const QJsonObject view = value.toObject();
      QVERIFY(view["byteOffset"].toInteger() == end && end % 4 == 0);
      end += view["byteLength"].toInteger();
    }
    QCOMPARE(end, qint64(binary.size()));
    for (const QJsonValue& value : gltf["meshes"].toArray()) {
      const QJsonObject primitive = value.toObject()["primitives"].toArray()[0].toObject();
      const int position = primitive["attributes"].toObject()["POSITION"].toInt();
      const QJsonObject accessor = accessors[position].toObject();
      const std::vector<float> points = numbers(position);
      QCOMPARE(points.size(), std::size_t(3 * accessor["count"].toInt()));
      for (std::size_t k = 0; k < 3; ++k) {
        float least = points[k];
        float most = points[k];
        for (std::size_t i = k; i < points.size(); i += 3) {
          least = std::min(least, points[i]);
          most = std::max(most, points[i]);
        }
        QCOMPARE(float(accessor["min"].toArray()[qsizetype(k)].toDouble()), least);
        QCOMPARE(float(accessor["max"].toArray()[qsizetype(k)].toDouble()), most);
      }
      for (const float raw : numbers(primitive["indices"].toInt())) {
        QVERIFY(std::bit_cast<std::uint32_t>(raw) < std::uint32_t(accessor["count"].toInt()));
      }
    }
    const QJsonObject animation = gltf["animations"].toArray()[0].toObject();
    QCOMPARE(gltf["animations"].toArray().size(), 1);  // players show one
    for (const QJsonValue& value : animation["samplers"].toArray()) {
      const std::vector<float> times = numbers(value.toObject()["input"].toInt());
      const std::vector<float> rotations = numbers(value.toObject()["output"].toInt());
      QVERIFY(rotations.size() == 4 * times.size() && times.front() == 0 && times.back() == 4);
      QVERIFY(std::adjacent_find(times.begin(), times.end(), std::greater_equal<>()) == times.end());
      for (std::size_t i = 0; i < rotations.size(); i += 4) {
        QVERIFY(std::abs(std::hypot(std::hypot(rotations[i], rotations[i + 1]),
                                    std::hypot(rotations[i + 2], rotations[i + 3])) -
                         1) < 1e-6F);
      }
    }
    for (const QJsonValue& value : gltf["nodes"].toArray()) QVERIFY(!value.toObject().contains("matrix"));
  }

  void glbOfAStandingSceneHasNoAnimation() {
    MeshScene scene = movingScene();
    for (MeshNode& node : scene.nodes) node.keys.clear();
    QVERIFY(encoded(scene, MeshFormat::glb)[0].bytes.find("animations") == std::string::npos);
    QVERIFY(encoded(movingScene(), MeshFormat::glb)[0].bytes.find("animations") != std::string::npos);
  }

  void objNamesGroupsAndMaterials() {
    const auto files = encoded(movingScene(), MeshFormat::obj);
    QCOMPARE(files.size(), std::size_t(2));
    QCOMPARE(files[0].name, std::string("train.obj"));
    QCOMPARE(files[1].name, std::string("train.mtl"));
    QVERIFY(files[0].bytes.find("mtllib train.mtl") != std::string::npos);
    QVERIFY(files[0].bytes.find("carrier <1>") != std::string::npos);
    QVERIFY(files[1].bytes.find("newmtl link 1 \"blue\"") != std::string::npos);
    const MeshScene back = reread(movingScene(), MeshFormat::obj);

    QVERIFY(nodeNamed(back, "planet") != nullptr && nodeNamed(back, "wheel (2)") != nullptr);
  }

  void threeMfKeepsNamesColoursAndTheUnit() {
    MeshScene scene = movingScene();
    scene.unit = "in";
    const MeshScene back = reread(scene, MeshFormat::threeMf);
    bool found = false;
    for (const MeshMaterial& material : back.materials) {
      found =
          found || (material.name.ends_with("link 1 \"blue\"") && std::abs(material.colour[2] - 1) < 1e-3F &&
                    std::abs(material.colour[0] - 0.1F) < 3e-3F);
    }
    QVERIFY(found);
    QVERIFY(std::abs(signedVolume(everything(back)) / signedVolume(everything(scene)) - 1) < 1e-5);
  }

  void plyPaintsItsVertices() {
    const std::string bytes = encoded(movingScene(), MeshFormat::ply)[0].bytes;
    const std::size_t body = bytes.find("end_header\n") + 11;
    QVERIFY(bytes.find("comment GearGraph, unit mm") < body);
    const std::string colour = bytes.substr(body + 24, 3);  // behind position and normal of the first vertex
    QCOMPARE(colour, std::string("\x40\x80\xBF"));
  }

  void aFaceWithoutItsVertexIsRejected() {
    std::string bytes = encoded(movingScene(), MeshFormat::ply)[0].bytes;
    bytes.replace(bytes.size() - 4, 4, "\xFF\xFF\xFF\x7F");
    QVERIFY(std::holds_alternative<MeshFileError>(readMesh(bytes, MeshFormat::ply)));
  }

  void stlFacetNormalsAreThoseOfTheirPlanes() {
    const std::string bytes = encoded(movingScene(), MeshFormat::stl)[0].bytes;
    QVERIFY(bytes.rfind("GearGraph, unit mm", 0) == 0);
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + 80, 4);
    QCOMPARE(bytes.size(), std::size_t(84) + 50 * count);
    for (std::uint32_t i = 0; i < count; ++i) {
      std::array<float, 12> facet{};
      std::memcpy(facet.data(), bytes.data() + 84 + std::size_t{50} * i, sizeof facet);
      const auto at = [&](std::size_t k) { return Eigen::Vector3f(facet[k], facet[k + 1], facet[k + 2]); };
      const Eigen::Vector3f normal = (at(6) - at(3)).cross(at(9) - at(3)).normalized();
      QVERIFY((normal - at(0)).norm() < 1e-4F);
    }
  }

  void aBrokenFileIsAnErrorNotAScene() {
    for (const MeshFormat format : allMeshFormats()) {
      const auto result = readMesh("nothing of the kind", format);
      if (const auto* scene = std::get_if<MeshScene>(&result)) {
        QCOMPARE(triangleCount(*scene), std::size_t(0));  // OBJ and STL take any text for an empty scene
      } else {
        QCOMPARE(int(std::get<MeshFileError>(result).kind), int(MeshFileError::Kind::file));
      }
    }
  }

  void readingKeepsToItsLimits() {
    const std::string bytes = encoded(movingScene(), MeshFormat::glb)[0].bytes;
    const auto kindUnder = [&](const MeshReadLimits& limits) {
      const auto result = readMesh(bytes, MeshFormat::glb, limits);
      const auto* error = std::get_if<MeshFileError>(&result);
      return error != nullptr && error->kind == MeshFileError::Kind::limit;
    };
    QVERIFY(!kindUnder({}));
    QVERIFY(kindUnder({bytes.size() - 1, kMaxTriangles, 1000}));
    QVERIFY(kindUnder({bytes.size(), 10, 1000}));
    QVERIFY(kindUnder({bytes.size(), kMaxTriangles, 3}));
  }
};

QTEST_APPLESS_MAIN(MeshFilesTest)
#include "test_mesh_files.moc"
