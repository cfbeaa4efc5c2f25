#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "core/presentation/mechanism_scene/shape_cache.h"

using namespace geargraph;

/// Which files a document's 3D files may be.
class ShapeCacheTest : public QObject {
  Q_OBJECT

  const QTemporaryDir disk;
  ShapeCache cache{std::filesystem::path(GEARGRAPH_MESH_READER)};

  [[nodiscard]] std::filesystem::path folder() const { return disk.filePath("document").toStdString(); }
  std::string why(const std::string& file) {
    const auto found = cache.find(folder(), file, 1, {});
    return std::holds_alternative<std::string>(found) ? std::get<std::string>(found) : "it is shown";
  }

 private slots:
  void initTestCase() {
    QVERIFY(QDir(disk.path()).mkpath("document/parts") && QDir(disk.path()).mkdir("documents"));
    for (const char* name :
         {"secret.obj", "document/arm.obj", "document/parts/arm.obj", "documents/arm.obj"}) {
      QFile file(disk.filePath(QLatin1String(name)));
      QVERIFY(file.open(QIODevice::WriteOnly) && file.write("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n") > 0);
    }
    QVERIFY(QFile::link(disk.filePath("secret.obj"), disk.filePath("document/leak.obj")));
    QVERIFY(QFile::link(disk.path(), disk.filePath("document/up")));
    QVERIFY(QFile::link(disk.filePath("document/arm.obj"), disk.filePath("document/same.obj")));
    QVERIFY(QFile::link(disk.filePath("document"), disk.filePath("other")));
  }

  void filesInTheFolderAreShown() {
    for (const char* file :
         {"arm.obj", "parts/arm.obj", "parts/../arm.obj", "same.obj", "up/document/arm.obj"})
      QCOMPARE(why(file), std::string("it is shown"));
    QVERIFY(std::holds_alternative<std::shared_ptr<const Solid>>(
        cache.find(disk.filePath("other").toStdString(), "arm.obj", 1, {})));
    QCOMPARE(why("none.obj"), std::string("It is not there."));
  }

  void noLinkAndNoPathLeadsOut() {
    for (const char* file :
         {"leak.obj", "up/secret.obj", "../secret.obj", "../documents/arm.obj", "/dev/zero", ".", ""})
      QCOMPARE(why(file), std::string("It is not in the folder of the document: copy it there."));
  }
};

QTEST_GUILESS_MAIN(ShapeCacheTest)
#include "test_shape_cache.moc"
