#include <QDir>
#include <QTemporaryDir>
#include <QTest>
#include <nlohmann/json.hpp>
#include <numbers>

#include "core/presentation/meshfile/mesh_reader.h"
#include "tests/cli/cli_run.h"
#include "tests/core/presentation/meshfile/assembly_check.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/file_contents.h"

using namespace geargraph;
using namespace geargraph::test;
using nlohmann::json;

namespace {

/// `export robot.geargraph --to FORM -o OUT ...`
Run exported(const QString& form, const QString& out, const QStringList& more = {}) {
  return run(QStringList{"export", kRobot, "--to", form, "-o", out} + more);
}

MeshScene sceneIn(const std::string& bytes, MeshFormat format) {
  const auto read = readMesh(bytes, format);
  if (const auto* error = std::get_if<MeshFileError>(&read)) qFatal("%s", error->message.c_str());
  return std::get<MeshScene>(read);
}

bool hasNode(const MeshScene& scene, const std::string& name) {
  return std::any_of(scene.nodes.begin(), scene.nodes.end(),
                     [&](const MeshNode& node) { return node.name == name; });
}

/// Wheels with these teeth in a row on the ground, each meshing with the next.
QByteArray rowOfWheels(const std::vector<int>& teeth) {
  json document{{"format", "geargraph"}, {"version", 1}, {"links", {{{"id", "0"}}}}};
  for (std::size_t i = 0; i < teeth.size(); ++i) {
    const std::string id = std::to_string(i + 1);
    document["links"].push_back({{"id", id}});
    document["axes"].push_back({{"id", id}});
    document["turningJoints"].push_back({{"id", "j" + id}, {"tail", "0"}, {"head", id}, {"axis", id}});
    if (i == 0) continue;
    document["gearMeshes"].push_back({{"id", "m" + id},
                                      {"tail", std::to_string(i)},
                                      {"head", id},
                                      {"tailTeeth", teeth[i - 1]},
                                      {"headTeeth", teeth[i]}});
  }
  document["inputs"] = {{{"joint", "j1"}, {"speed", 1}}};
  return QByteArray::fromStdString(document.dump());
}

}  // namespace

class ExportSolidsTest : public QObject {
  Q_OBJECT
 private slots:
  void everyFormatIsWrittenTheSameToFilesAndToStandardOutput_data() {
    QTest::addColumn<QString>("form");
    for (const MeshFormat format : allMeshFormats()) {
      const std::string name(meshFormatName(format));
      QTest::newRow(name.c_str()) << QString::fromStdString(name);
    }
  }
  void everyFormatIsWrittenTheSameToFilesAndToStandardOutput() {
    QFETCH(QString, form);
    const QTemporaryDir folder;
    const QString path = folder.filePath("mechanism." + form);
    const Run toFile = exported(form, path, {"--tolerance", "0.01"});
    QCOMPARE(toFile.errors.find("within the limits of joints") != std::string::npos, form == "glb");
    QCOMPARE(toFile.errors.empty(), form != "glb");
    QCOMPARE(toFile.status, 0);
    const Run toOutput = exported(form, "-", {"--tolerance", "0.01"});
    QCOMPARE(toOutput.status, 0);
    QVERIFY(toOutput.output == contents(path).toStdString());
    const MeshScene scene = sceneIn(toOutput.output, *meshFormatFromName(form.toStdString()));
    QVERIFY(triangleCount(scene) > 10'000);
  }

  void nodesBearTheNamesOfTheDocument() {
    const Run glb = exported("glb", "-");
    const MeshScene scene = sceneIn(glb.output, MeshFormat::glb);
    QCOMPARE(scene.name, std::string("Geared robotic mechanism"));
    for (const char* name : {"15:tail", "15:head", "18:head"}) QVERIFY(hasNode(scene, name));
    QVERIFY(hasNode(scene, "carrier 1") || hasNode(scene, "link 1"));
  }

  void theAnimationPlaysAsLongAsAsked() {
    const MeshScene scene = sceneIn(exported("glb", "-", {"--animate", "4"}).output, MeshFormat::glb);
    QVERIFY(std::abs(durationOf(scene) - 4) < 1e-5);
    const auto rest = worldPoses(scene);
    const auto end = worldPosesAt(scene, 4);
    const auto between = worldPosesAt(scene, 0.3);
    bool moved = false;
    for (std::size_t i = 0; i < rest.size(); ++i) {
      QVERIFY(end[i].isApprox(rest[i], 1e-5));
      moved = moved || !between[i].isApprox(rest[i], 1e-2);
    }
    QVERIFY(moved);
    QVERIFY(durationOf(sceneIn(exported("glb", "-").output, MeshFormat::glb)) >
            1);  // as long as it really takes
  }

  /// The limited joints of the robot, followed from key to key, stay within their limits and come back.
  void theMotionStaysWithinTheLimitsOfJoints() {
    const Mechanism robot = example("robot");
    const MeshScene scene = sceneIn(exported("glb", "-").output, MeshFormat::glb);
    double nearest = 1;  // of the limits of all joints: the part that is left
    int limited = 0;
    for (const TurningJoint& joint : robot.turningJoints) {
      if (!joint.limits.any()) continue;
      const Link& link = *robot.find(joint.head);
      const std::string name = link.name.empty() ? "link " + link.id.text() : link.name;
      const auto node = std::find_if(scene.nodes.begin(), scene.nodes.end(),
                                     [&](const MeshNode& each) { return each.name == name; });
      QVERIFY(node != scene.nodes.end() && node->keys.size() > 2);
      const Eigen::AngleAxisd first(node->keys[1].rotation * node->keys[0].rotation.conjugate());
      double turned = 0;
      for (std::size_t i = 1; i < node->keys.size(); ++i) {
        const Eigen::AngleAxisd step(node->keys[i].rotation * node->keys[i - 1].rotation.conjugate());
        turned += step.angle() * (step.axis().dot(first.axis()) < 0 ? -1 : 1);
        const double limit = joint.limits.high->value() * std::numbers::pi / 180;  // as far as the low one
        nearest = std::min(nearest, 1 - std::abs(turned) / limit);
      }
      QVERIFY(std::abs(turned) < 1e-3);
      ++limited;
    }
    QCOMPARE(limited, 3);
    QVERIFY2(std::abs(nearest) < 1e-4, qPrintable(QString::number(nearest)));  // one of them is reached
  }

  void oneGearStandsInItsOwnFrame() {
    const Run tail = exported("stl", "-", {"--gear", "15:tail"});
    const Run head = exported("stl", "-", {"--gear", "15:head"});
    QCOMPARE(tail.status + head.status, 0);
    const MeshScene small = flattened(sceneIn(tail.output, MeshFormat::stl));
    const MeshScene large = flattened(sceneIn(head.output, MeshFormat::stl));
    const Eigen::AlignedBox3d box = boundsOf(*small.nodes[0].solid);
    QVERIFY(std::abs(box.center().z()) < 1e-3 && std::abs(box.center().x()) < 0.05 * box.sizes().x());
    QVERIFY(boundsOf(*large.nodes[0].solid).sizes().x() > 1.5 * box.sizes().x());  // 36 teeth against 18
  }

  void oneLinkBringsItsSolidsOnly() {
    const std::string all = exported("stl", "-").output;
    std::size_t sum = 0;
    for (int link = 0; link <= 7; ++link) {
      const Run one = exported("stl", "-", {"--link", QString::number(link)});
      if (one.status == 0) sum += one.output.size() - 84;
    }
    QCOMPARE(sum, all.size() - 84);
  }

  void theAssemblyPassesTheCheck() {
    const QTemporaryDir folder;
    const QString out = folder.filePath("teeth");
    const Run first = exported("assembly", out, {"--frames", "13"});
    QCOMPARE(first.errors, std::string());
    QCOMPARE(first.status, 0);
    const AssemblyMeasurements found = checkedAssembly(out);
    QCOMPARE(found.gears, 8);
    QCOMPARE(found.pairs, 4);
    QCOMPARE(found.frames, 13);
    QVERIFY(found.closed && found.leastTravel > 1);
    QVERIFY(found.phaseError < 0.005 && found.penetration < 0.004);
    const QByteArray before = contents(out + "/assembly.json");
    QCOMPARE(exported("assembly", out).status, 2);  // 24 frames would be another file
    QCOMPARE(contents(out + "/assembly.json"), before);
    QCOMPARE(exported("assembly", out, {"--force"}).status, 0);
    QVERIFY(contents(out + "/assembly.json").size() > before.size());
    QCOMPARE(checkedAssembly(out).frames, 24);
  }

  void wrongUsageIsToldApart() {
    const QTemporaryDir folder;
    const QString out = folder.filePath("out");
    for (const QStringList& more : QList<QStringList>{{"--gear", "99:tail"},
                                                      {"--gear", "15"},
                                                      {"--link", "9"},
                                                      {"--gear", "15:tail", "--link", "1"},
                                                      {"--animate", "4"},
                                                      {"--tolerance", "0"},
                                                      {"--tolerance", "fine"}}) {
      const Run wrong = exported("stl", out, more);
      QVERIFY2(wrong.status == 2 && !wrong.errors.empty(), qPrintable(more.join(' ')));
    }
    QCOMPARE(exported("glb", out, {"--animate", "-1"}).status, 2);
    QCOMPARE(exported("assembly", out, {"--frames", "11"}).status, 2);
    QCOMPARE(exported("assembly", "-").status, 2);
    QCOMPARE(exported("iges", out).status, 2);
    QCOMPARE(run({"export", kRobot, "--to", "stl"}).status, 2);
    QVERIFY(QDir(folder.path()).isEmpty());
  }

  void whatCannotBeReadOrWrittenIsTwo() {
    const QTemporaryDir folder;
    QCOMPARE(run({"export", folder.filePath("none"), "--to", "stl", "-o", folder.filePath("out")}).status, 2);
    QCOMPARE(exported("glb", folder.filePath("no/such/out")).status, 2);
    QVERIFY(QDir(folder.path()).isEmpty());
  }

  void aMechanismWithErrorsIsOne() {
    const QTemporaryDir folder;
    QByteArray loose = rowOfWheels({20, 30});
    loose.replace(R"("tail":"0")", R"("tail":"1")");  // link 1 on itself, link 2 on link 1
    for (const char* form : {"stl", "glb", "assembly"}) {
      const Run rejected = run({"export", "-", "--to", form, "-o", folder.filePath("out")}, loose);
      QCOMPARE(rejected.status, 1);
      QVERIFY(rejected.errors.find("error") != std::string::npos);
    }
    QVERIFY(QDir(folder.path()).isEmpty());
  }

  void aPeriodTooLongForKeysIsShownForAMinuteAndSaidSo() {
    const QByteArray awkward = rowOfWheels({101, 103, 107, 109, 113});
    const Run minute = run({"export", "-", "--to", "glb", "--tolerance", "0.05", "-o", "-"}, awkward);
    QCOMPARE(minute.status, 0);
    QVERIFY(minute.errors.find("first 60 s") != std::string::npos);
    QCOMPARE(durationOf(sceneIn(minute.output, MeshFormat::glb)), 60.0);
    const Run asked =
        run({"export", "-", "--to", "glb", "--tolerance", "0.05", "--animate", "5", "-o", "-"}, awkward);
    QCOMPARE(asked.status, 0);
    QVERIFY(asked.errors.find("first 5 s") != std::string::npos);
    QCOMPARE(durationOf(sceneIn(asked.output, MeshFormat::glb)), 5.0);
    // A short period is shown whole, and there is nothing to say.
    const Run whole =
        run({"export", "-", "--to", "glb", "--tolerance", "0.05", "-o", "-"}, rowOfWheels({20, 40}));
    QVERIFY(whole.status == 0 && whole.errors.find("The file shows") == std::string::npos);
  }

  void moreTrianglesThanTheLimitAreRejectedBeforeTheyAreMade() {
    const Run rejected =
        run({"export", "-", "--to", "stl", "--tolerance", "0.002", "-o", "-"}, rowOfWheels({20, 100'000}));
    QCOMPARE(rejected.status, 3);
    QVERIFY(rejected.output.empty());
    QVERIFY(rejected.errors.find("coarser --tolerance") != std::string::npos);
  }

  void aSmallGearOfATrainBeyondTheLimitIsExported() {
    const Run alone =
        run({"export", "-", "--to", "stl", "--gear", "5:tail", "--tolerance", "0.002", "-o", "-"},
            rowOfWheels({20, 100'000}));
    QCOMPARE(alone.status, 0);
    QVERIFY(!alone.output.empty());
    const Run large =
        run({"export", "-", "--to", "stl", "--gear", "5:head", "--tolerance", "0.002", "-o", "-"},
            rowOfWheels({20, 100'000}));
    QCOMPARE(large.status, 3);
  }

  void withoutAToleranceALargeTrainGetsOneThatFits() {
    const Run fitted = run({"export", "-", "--to", "stl", "-o", "-"}, rowOfWheels({20, 100'000}));
    QCOMPARE(fitted.status, 0);
    QVERIFY(fitted.errors.find(" modules instead of 0.002") != std::string::npos);
    QVERIFY(!fitted.output.empty());
  }
};

QTEST_GUILESS_MAIN(ExportSolidsTest)
#include "test_export_solids.moc"
