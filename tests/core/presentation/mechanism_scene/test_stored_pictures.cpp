#include <QImage>
#include <QTest>
#include <numbers>

#include "core/machine/body_layout/complete_train.h"
#include "core/machine/solids/gear_solid.h"
#include "core/presentation/drawing/palette.h"
#include "core/presentation/gl_renderer/egl_host.h"
#include "core/theory/analysis/analysis.h"
#include "tests/core/support/example_files.h"

namespace geargraph {
namespace {

constexpr Viewport kView{480, 360};
constexpr int kSeen = 40;       // of 255: what one pixel may differ by
constexpr int kMaxPixels = 60;  // of the 172,800 that may differ by more: rasterizers round edges otherwise

struct Wheels {
  Scene scene;
  std::vector<int> teeth;  ///< by instance
};

/// The wheels of an example without webs, shafts and arms: what only their teeth and places decide.
Wheels wheelsOf(const QString& name) {
  const auto mechanism = std::make_shared<const Mechanism>(test::example(name.toStdString()));
  const SnapshotPtr snapshot = analyzeLive(mechanism);
  Wheels wheels;
  Scene& scene = wheels.scene;
  for (const TrainGear& gear : trainOf(*mechanism, snapshot->kinematics->placement()).gears) {
    Instance instance;
    instance.solid = scene.solids.size();
    instance.pose = gear.pose;
    const Color colour = linkColor(gear.link);
    instance.colour = Rgb::fromHex(static_cast<unsigned>(colour.red << 16 | colour.green << 8 | colour.blue));
    instance.element = mechanism->links[static_cast<std::size_t>(gear.link)].id;
    GearSpec spec = gear.spec;
    spec.body = GearBody::plain;
    spec.bore = spec.hub = spec.rim = 0;
    scene.solids.push_back(std::make_shared<const Solid>(gearSolid(spec, kScreenTolerance).value()));
    scene.instances.push_back(instance);
    wheels.teeth.push_back(gear.spec.teeth);
  }
  return wheels;
}

int differing(const QImage& a, const QImage& b) {
  int count = 0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      const QRgb p = a.pixel(x, y), q = b.pixel(x, y);
      const int most = std::max({std::abs(qRed(p) - qRed(q)), std::abs(qGreen(p) - qGreen(q)),
                                 std::abs(qBlue(p) - qBlue(q)), std::abs(qAlpha(p) - qAlpha(q))});
      count += most > kSeen;
    }
  }
  return count;
}

}  // namespace

/// Pictures against those in pictures/, which somebody has looked at. GEARGRAPH_UPDATE_GOLDEN=1 writes them
/// anew.
class StoredPicturesTest : public QObject {
  Q_OBJECT

  std::unique_ptr<EglHost> m_host;

  /// From where the scene is seen in all of its pictures.
  static Frame frameOf(const Scene& whole, bool dark) {
    Frame frame;
    frame.viewport = kView;
    frame.style = dark ? RenderStyle::dark() : RenderStyle::light();
    frame.style.transparent = true;  // smaller files
    frame.style.discStrength = 0;
    frame.camera = Camera::from(-0.45, 0.6).fitted(cornersOf(whole), kView);
    return frame;
  }
  QImage painted(const Scene& scene, const Frame& frame) {
    m_host->setScene(scene);
    const Image image = m_host->picture(frame);
    return QImage(image.rgba.data(), image.width, image.height, QImage::Format_RGBA8888).copy();
  }
  static void addExamples() {
    QTest::addColumn<bool>("dark");
    for (const char* name : {"robot", "planetary-ring-held", "humpage-reduction", "eight-speed-gearbox"}) {
      QTest::newRow(name) << false;
    }
    QTest::newRow("three-planets") << true;
  }

 private slots:
  void initTestCase() {
    auto host = EglHost::create();
    QVERIFY(host.has_value());
    m_host = std::move(host).value();
  }
  void cleanupTestCase() { m_host.reset(); }

  void theTrainsLookAsTheyDid_data() { addExamples(); }
  void theTrainsLookAsTheyDid() {
    QFETCH(bool, dark);
    const QString name = QString::fromLatin1(QTest::currentDataTag());
    const QString path =
        QString::fromStdString(test::sourcePath("tests/core/presentation/mechanism_scene/pictures/")) + name +
        ".png";
    const Scene scene = wheelsOf(name).scene;
    const QImage now = painted(scene, frameOf(scene, dark));
    if (qEnvironmentVariableIsSet("GEARGRAPH_UPDATE_GOLDEN")) QVERIFY(now.save(path));
    const QImage stored = QImage(path).convertToFormat(QImage::Format_RGBA8888);
    QCOMPARE(stored.size(), now.size());
    const int count = differing(now, stored);
    if (count > kMaxPixels) now.save(QStringLiteral("now-%1.png").arg(name));
    QVERIFY2(count <= kMaxPixels, qPrintable(QString::number(count)));
  }

  // What the comparison is for: each wheel out of phase by half a pitch, missing, or lit from the wrong side.
  void everyWrongWheelWouldBeSeen_data() { addExamples(); }
  void everyWrongWheelWouldBeSeen() {
    QFETCH(bool, dark);
    const Wheels wheels = wheelsOf(QString::fromLatin1(QTest::currentDataTag()));
    const Scene& right = wheels.scene;
    const Frame frame = frameOf(right, dark);
    const QImage good = painted(right, frame);
    for (std::size_t i = 0; i < right.instances.size(); ++i) {
      const Solid& solid = *right.solids[i];
      Scene missing = right;
      missing.instances.erase(missing.instances.begin() + static_cast<std::ptrdiff_t>(i));
      const int covered = differing(painted(missing, frame), good);
      QVERIFY2(covered > kMaxPixels, qPrintable(QString("missing %1: %2").arg(i).arg(covered)));
      Scene shifted = right;
      shifted.instances[i].pose.rotate(
          Eigen::AngleAxisd(std::numbers::pi / wheels.teeth[i], Eigen::Vector3d::UnitZ()));
      const int moved = differing(painted(shifted, frame), good);
      QVERIFY2(moved > kMaxPixels, qPrintable(QString("phase %1: %2").arg(i).arg(moved)));
      Scene flipped = right;
      Solid inverse = solid;
      for (Float3& normal : inverse.normals) normal = {-normal[0], -normal[1], -normal[2]};
      flipped.solids[i] = std::make_shared<const Solid>(std::move(inverse));
      const int unlit = differing(painted(flipped, frame), good);
      QVERIFY2(unlit > kMaxPixels, qPrintable(QString("normals %1: %2").arg(i).arg(unlit)));
    }
  }
};

}  // namespace geargraph

QTEST_GUILESS_MAIN(geargraph::StoredPicturesTest)
#include "test_stored_pictures.moc"
