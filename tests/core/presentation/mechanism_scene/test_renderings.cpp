#include <QDir>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "core/presentation/cairo_output/picture.h"
#include "core/presentation/mechanism_scene/scene_labels.h"
#include "core/presentation/mechanism_scene/scene_picture.h"
#include "core/presentation/meshfile/mesh_reader.h"
#include "core/presentation/meshfile/mesh_writer.h"
#include "tests/ui/view3d/toy_stage.h"

using namespace geargraph;

namespace {

SceneRendering toyRendering(std::optional<Animation> animation = {}) {
  SceneRendering rendering;
  rendering.stage = test::toyStage();
  rendering.view.style = pictureStyle(Theme::light, true);
  rendering.view.style.triad = rendering.view.style.contactShadow = false;
  rendering.size = {160, 120};
  rendering.animation = animation;
  return rendering;
}

QImage shown(const Image& image) {
  return QImage(image.rgba.data(), image.width, image.height, QImage::Format_RGBA8888).copy();
}

struct Chunk {
  QByteArray type;
  QByteArray content;
};

quint32 numberAt(const QByteArray& bytes, int at) {
  quint32 value = 0;
  for (int i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

QByteArray fromNumber(quint32 value) {
  QByteArray bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 255);
  return bytes;
}

std::vector<Chunk> chunksOf(const QByteArray& png) {
  std::vector<Chunk> chunks;
  for (int at = 8; at + 12 <= png.size();) {
    const int length = static_cast<int>(numberAt(png, at));
    chunks.push_back({png.mid(at + 4, 4), png.mid(at + 8, length)});
    at += length + 12;
  }
  return chunks;
}

QByteArray chunk(const QByteArray& type, const QByteArray& content) {
  quint32 sum = 0xFFFFFFFFU;  // CRC-32 bit by bit: independent of the writer's
  for (const char byte : type + content) {
    sum ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) sum = sum >> 1 ^ (0xEDB88320U & (0U - (sum & 1)));
  }
  return fromNumber(static_cast<quint32>(content.size())) + type + content + fromNumber(~sum);
}

/// The pictures of an animated PNG as a reader of APNG composes them, each made a PNG of its own for Qt.
std::vector<QImage> composed(const QByteArray& file) {
  std::vector<QImage> pictures;
  const std::vector<Chunk> chunks = chunksOf(file);
  const QByteArray head = chunks.front().content;
  QImage canvas(static_cast<int>(numberAt(head, 0)), static_cast<int>(numberAt(head, 4)),
                QImage::Format_RGBA8888);
  quint32 sequence = 0;
  QByteArray control, data;
  const auto finish = [&] {
    if (control.isEmpty()) return;
    QByteArray ownHead = control.mid(4, 8) + head.mid(8);
    const QByteArray png = file.left(8) + chunk("IHDR", ownHead) + chunk("IDAT", data) + chunk("IEND", {});
    const QImage part = QImage::fromData(png, "PNG").convertToFormat(QImage::Format_RGBA8888);
    const int left = static_cast<int>(numberAt(control, 12)), top = static_cast<int>(numberAt(control, 16));
    for (int y = 0; y < part.height(); ++y) {
      for (int x = 0; x < part.width(); ++x) canvas.setPixelColor(left + x, top + y, part.pixelColor(x, y));
    }
    pictures.push_back(canvas);
    data.clear();
  };
  for (const Chunk& each : chunks) {
    if (each.type == "fcTL" || each.type == "fdAT") {
      if (numberAt(each.content, 0) != sequence++) return {};
    }
    if (each.type == "fcTL" || each.type == "IEND") finish();
    if (each.type == "fcTL") control = each.content;
    if (each.type == "IDAT") data += each.content;
    if (each.type == "fdAT") data += each.content.mid(4);
  }
  return pictures;
}

QByteArray contentsOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// How many pixels on the picture's edge show something.
int coveredEdge(const Image& image) {
  int count = 0;
  for (int x = 0; x < image.width; ++x)
    count += (image.at(x, 0)[3] > 0) + (image.at(x, image.height - 1)[3] > 0);
  for (int y = 0; y < image.height; ++y)
    count += (image.at(0, y)[3] > 0) + (image.at(image.width - 1, y)[3] > 0);
  return count;
}

}  // namespace

class RenderingsTest : public QObject {
  Q_OBJECT

  const QTemporaryDir folder;
  std::filesystem::path path(const char* name) const {
    return folder.filePath(QLatin1String(name)).toStdString();
  }

 private slots:
  void anAnimatedPictureHoldsTheAnimationsPictures() {
    const SceneRendering rendering = toyRendering(Animation{AnimationKind::motion, 6, 10, 0});
    QVERIFY(!writePicture(rendering, path("film.png")));
    const QByteArray file = contentsOf(folder.filePath("film.png"));
    const std::vector<Chunk> chunks = chunksOf(file);
    QCOMPARE(chunks[1].type, QByteArray("acTL"));
    QCOMPARE(numberAt(chunks[1].content, 0), 6U);
    for (int at = 8; const Chunk& each : chunks) {
      const QByteArray whole = chunk(each.type, each.content);
      QCOMPARE(file.mid(at, whole.size()), whole);
      at += static_cast<int>(whole.size());
    }
    const std::vector<QImage> pictures = composed(file);
    QCOMPARE(pictures.size(), std::size_t{6});
    const auto painter = ScenePainter::create(rendering);
    for (int i = 0; i < 6; ++i) QCOMPARE(pictures[static_cast<std::size_t>(i)], shown((*painter)->paint(i)));
    QVERIFY(pictures[0] != pictures[1]);
  }

  void anAnimationOfALimitedMotionGoesThereAndBack() {
    const Animation animation{AnimationKind::motion, 8, 24, 0};
    const SceneRendering rendering = toyRendering(animation);
    MechanismScene limited = *rendering.stage;
    limited.range = [](std::span<const double>) { return SceneRange{{-1, {}}, {3, {}}}; };
    QCOMPARE(animationSpan(limited, animation), 8.0);
    SceneView view = rendering.view;
    view.time = 0;
    const std::vector<double> expected = {0, 1, 2, 3, 2, 1, 0, -1};
    for (int picture = 0; picture < 8; ++picture)
      QCOMPARE(animationView(limited, view, animation, picture).time,
               expected[static_cast<std::size_t>(picture)]);
  }

  void theAnimationIsClosedAndEvenlySpaced() {
    const Animation animation{AnimationKind::motion, 8, 24, 0};
    const SceneRendering rendering = toyRendering(animation);
    QCOMPARE(animationView(*rendering.stage, rendering.view, animation, 0).time, rendering.view.time);
    QCOMPARE(animationView(*rendering.stage, rendering.view, animation, 2).time,
             rendering.view.time + rendering.stage->period / 4);
    const Animation turn{AnimationKind::turntable, 8, 24, 0};
    const Camera from = animationView(*rendering.stage, rendering.view, turn, 0).camera;
    const Camera half = animationView(*rendering.stage, rendering.view, turn, 4).camera;
    QVERIFY((from.forward().head<2>() + half.forward().head<2>()).norm() < 1e-12);
    QCOMPARE(half.pitch(), from.pitch());
    MechanismScene endless = *rendering.stage;
    endless.period = 0;
    QCOMPARE(animationSpan(endless, animation), 60.0);
  }

  void aFittedAnimationKeepsAllInView() {
    for (const AnimationKind kind : {AnimationKind::turntable, AnimationKind::motion}) {
      for (const double part : {0.0, 1.0}) {
        SceneRendering rendering = toyRendering(Animation{kind, 8, 24, 0});
        rendering.view.explosion = part;
        const auto painter = ScenePainter::create(rendering);
        int largest = 0;
        for (int i = 0; i < 8; ++i) {
          const Image image = (*painter)->paint(i);
          QCOMPARE(coveredEdge(image), 0);
          int covered = 0;
          for (std::size_t at = 3; at < image.rgba.size(); at += 4) covered += image.rgba[at] > 0;
          largest = std::max(largest, covered);
        }
        QVERIFY(largest > 160 * 120 / 12);
      }
    }
  }

  void whatIsHiddenAndFixedAndCutIsSeen() {
    const SceneRendering plain = toyRendering();
    const Image all = *stagePicture(plain);
    for (const auto& change : std::vector<std::function<void(SceneView&)>>{
             [](SceneView& view) { view.hidden = {LinkId("3")}; },
             [](SceneView& view) {
               view.section = SectionChoice{1, 0.4, false};
             },
             [](SceneView& view) { view.time = 0.4; }, [](SceneView& view) { view.explosion = 1; },
             [](SceneView& view) { view.style.faces = Faces::hiddenLine; }}) {
      SceneRendering other = plain;
      change(other.view);
      QVERIFY((*stagePicture(other)).rgba != all.rgba);
    }
  }

  void aFolderGetsAllPicturesOrNone() {
    const SceneRendering rendering = toyRendering(Animation{AnimationKind::turntable, 4, 24, 0});
    QVERIFY(!writePictures(rendering, path("pictures")));
    QCOMPARE(QDir(folder.filePath("pictures")).entryList(QDir::Files),
             (QStringList{"0001.png", "0002.png", "0003.png", "0004.png"}));
    QCOMPARE(QImage(folder.filePath("pictures/0003.png")).size(), QSize(160, 120));
    const auto rejected = writePictures(rendering, path("pictures"));
    QVERIFY(rejected && rejected->kind == RenderingFailure::Kind::file);
    QVERIFY(!writePictures(rendering, path("pictures"), RenderingRun{{}, {}, {}, true}));

    std::stop_source stop;
    RenderingRun run;
    run.stop = stop.get_token();
    run.progress = [&](int done, int) {
      if (done == 2) stop.request_stop();
    };
    const auto stopped = writePictures(rendering, path("given-up"), run);
    QVERIFY(stopped && stopped->kind == RenderingFailure::Kind::stopped);
    const auto alsoStopped = writePicture(rendering, path("given-up.png"), run);
    QVERIFY(alsoStopped && alsoStopped->kind == RenderingFailure::Kind::stopped);
    QCOMPARE(QDir(folder.path())
                 .entryList({"*given-up*", ".*"}, QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot),
             QStringList());
  }

  void whatCannotBeWrittenIsSaid() {
    const SceneRendering animation = toyRendering(Animation{AnimationKind::turntable, 3, 24, 0});
    QVERIFY(writePicture(animation, "/nowhere/at/all.png").has_value());
    QVERIFY(writePictures(animation, "/dev/null/folder").has_value());
    SceneRendering huge = toyRendering();
    huge.size = {1'000'000, 10};
    QVERIFY(writePicture(huge, path("huge.png"))->kind == RenderingFailure::Kind::graphics);
  }

  void labelsAndTheScaleBarLieOverThePicture() {
    SceneRendering rendering = toyRendering();
    rendering.size = {320, 240};
    rendering.view.hidden = {LinkId("2")};
    auto painter = ScenePainter::create(rendering);
    QVERIFY(painter);
    Image image = (*painter)->paint(0);
    const QImage before = shown(image);
    SceneLabels labels({true, false, false, true});
    const DisplayList list = labels.over(**painter);
    QStringList texts;
    std::optional<CanvasPoint> plate;
    for (const Mark& mark : list.marks) {
      if (const auto* text = std::get_if<Text>(&mark.what)) texts.append(QString::fromStdString(text->text));
      const auto* fill = std::get_if<Fill>(&mark.what);
      if (fill != nullptr && std::holds_alternative<Circle>(fill->shape))
        plate = std::get<Circle>(fill->shape).center;
    }
    QCOMPARE(texts.size(),
             static_cast<qsizetype>(rendering.stage->labels.size()));  // one is hidden, one is the bar's
    QVERIFY(!texts.contains("2") && texts.last().endsWith(" mm"));
    QVERIFY(paintOver(image.rgba, image.width, image.height, list, 1, Theme::light));
    const QImage after = shown(image);
    QVERIFY(plate.has_value());
    const QPoint beside(qRound(plate->x) - 8, qRound(plate->y));  // within the ring, beside the number
    QCOMPARE(after.pixelColor(beside), QColor(Qt::white));
    QCOMPARE(after.pixelColor(2, 2), before.pixelColor(2, 2));  // nothing, as before
    QCOMPARE(after.pixelColor(2, 2).alpha(), 0);
  }

  void halfOfAColourOverAnotherIsTheirMiddle() {
    std::vector<std::uint8_t> pixels{200, 100, 0, 255, 0, 0, 0, 0};
    DisplayList list;
    const Box half{Extent::spanning({0, 0}, {2, 0.5}), 0};
    list.marks.push_back({ElementId(), MarkRole::node, 0, Fill{half, ColorRole::sheet}});
    QVERIFY(paintOver(pixels, 2, 1, list, 1, Theme::light));
    const auto near = [](int a, int b) { return std::abs(a - b) <= 2; };
    QVERIFY(near(pixels[0], 228) && near(pixels[1], 178) && near(pixels[2], 128) && pixels[3] == 255);
    QVERIFY(pixels[4] > 252 && near(pixels[7], 128));  // white, half seen through
  }

  void theSolidsAreWrittenAsTheyAreSeen() {
    SceneRendering rendering = toyRendering();
    rendering.view.hidden = {LinkId("2")};
    rendering.view.time = rendering.stage->period / 3;
    const MeshScene scene = sceneOf(*rendering.stage, rendering.view);
    QCOMPARE(scene.nodes.size(), std::size_t{2});
    QCOMPARE(scene.nodes[1].name, std::string("link 3"));
    SeenStage seen(rendering.stage);
    seen.show(rendering.view);
    QVERIFY(scene.nodes[1].pose.isApprox(seen.poses()[2]));
    QVERIFY(!writeMesh(scene, MeshFormat::glb, path("view.glb")));
    const QByteArray bytes = contentsOf(folder.filePath("view.glb"));
    const auto read = readMesh({bytes.data(), static_cast<std::size_t>(bytes.size())}, MeshFormat::glb);
    QCOMPARE(triangleCount(std::get<MeshScene>(read)), triangleCount(scene));
  }
};

QTEST_GUILESS_MAIN(RenderingsTest)
#include "test_renderings.moc"
