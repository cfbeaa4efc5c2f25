#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include "tests/cli/cli_run.h"
#include "tests/core/support/example_files.h"

using geargraph::test::kRobot;
using geargraph::test::Run;
using geargraph::test::run;

namespace {

/// Width and height as a PNG's head tells them.
std::pair<int, int> sizeOf(std::string_view png) {
  const auto number = [&](int at) {
    int value = 0;
    for (int i = 0; i < 4; ++i)
      value = value << 8 | static_cast<unsigned char>(png[static_cast<std::size_t>(at + i)]);
    return value;
  };
  if (!png.starts_with("\x89PNG") || png.size() < 24) return {0, 0};
  return {number(16), number(20)};
}

}  // namespace

class ExportPictureTest : public QObject {
  Q_OBJECT

 private slots:
  void aPictureIsWrittenWithoutADisplay() {
    QTemporaryDir folder;
    const QString file = folder.filePath("robot.png");
    const Run made = run({"export", kRobot, "--to", "png", "--view", "3d", "--size", "320x200", "-o", file});
    QCOMPARE(made.status, 0);
    QFile picture(file);
    QVERIFY(picture.open(QIODevice::ReadOnly));
    QCOMPARE(sizeOf(picture.readAll().toStdString()), std::pair(320, 200));
  }

  void theDashIsStandardOutputAndOptionsChangeThePicture() {
    const QStringList words = {"export", kRobot,   "--to",    "png", "--view",
                               "3d",     "--size", "160x100", "-o",  "-"};
    const Run plain = run(words);
    QCOMPARE(sizeOf(plain.output), std::pair(160, 100));
    QCOMPARE(run(words).output, plain.output);
    for (const QStringList& more : {QStringList{"--dark"},
                                    {"--transparent"},
                                    {"--from", "top"},
                                    {"--camera", "30,-20"},
                                    {"--time", "2.5"},
                                    {"--section", "y:0.4"},
                                    {"--explode", "1"},
                                    {"--faces", "lines"},
                                    {"--show", "pitch-circles,velocities"},
                                    {"--show", "labels"},
                                    {"--show", "joint-labels"},
                                    {"--show", "axis-labels"},
                                    {"--show", "scale"},
                                    {"--hide", "1,3"},
                                    {"--ride", "1", "--time", "2.5"}}) {
      const Run other = run(words + more);
      QCOMPARE(other.status, 0);
      QVERIFY(other.output != plain.output);
    }
  }

  void namesAndTeethAreWrittenWhereTheyAreAskedFor() {
    for (const char* view : {"digraph", "ttgraph", "schematic"}) {
      const QStringList words = {"export", kRobot, "--to", "svg", "--view", view, "-o", "-"};
      const Run plain = run(words), captioned = run(words + QStringList{"--captions"});
      QCOMPARE(captioned.status, 0);
      QVERIFY2(captioned.output.size() > plain.output.size(), view);  // the drawing, and words in it
    }
    const Run levers = run({"export", kRobot, "--to", "svg", "--view", "levers", "--captions", "-o", "-"});
    QCOMPARE(levers.status, 2);
    QVERIFY(levers.errors.find("--captions") != std::string::npos);
  }

  void wrongUsageIsSaid() {
    const QStringList words = {"export", kRobot, "--to", "png", "-o", "-"};
    QCOMPARE(run(words).status, 2);
    for (const QStringList& more : {QStringList{"--size", "10x10"},
                                    {"--size", "99999x100"},
                                    {"--size", "wide"},
                                    {"--from", "nowhere"},
                                    {"--time", "soon"},
                                    {"--time", "inf"},
                                    {"--camera", "30"},
                                    {"--camera", "0,91"},
                                    {"--section", "w"},
                                    {"--section", "x:2"},
                                    {"--explode", "far"},
                                    {"--faces", "round"},
                                    {"--show", "everything"},
                                    {"--show", "labels,"},
                                    {"--frames", "10"},
                                    {"--fps", "10"},
                                    {"--all"},
                                    {"--frames", "1", "--turntable"},
                                    {"--motion", "--turntable"}}) {
      const Run made = run(words + QStringList{"--view", "3d"} + more);
      QCOMPARE(made.status, 2);
      QVERIFY2(made.errors.find(more.front().toStdString()) != std::string::npos, made.errors.c_str());
      QVERIFY(made.output.empty());
    }
  }

  void animationsAreWrittenAsOneFileOrAsMany() {
    QTemporaryDir folder;
    const QStringList words = {"export", kRobot,  "--to",  "png", "--view",   "3d",
                               "--size", "64x48", "--fps", "12",  "--frames", "3"};
    QCOMPARE(run(words + QStringList{"--turntable", "-o", folder.filePath("turn.png")}).status, 0);
    QFile animation(folder.filePath("turn.png"));
    QVERIFY(animation.open(QIODevice::ReadOnly));
    const QByteArray bytes = animation.readAll();
    QCOMPARE(sizeOf(bytes.toStdString()), std::pair(64, 48));
    QCOMPARE(bytes.count("fcTL"), qsizetype{3});
    const QStringList many = words + QStringList{"--motion", "--all", "-o", folder.filePath("motion")};
    const Run film = run(many);
    QCOMPARE(film.status, 0);
    QVERIFY2(film.errors.find("within the limits of joints") != std::string::npos, film.errors.c_str());
    QCOMPARE(QDir(folder.filePath("motion")).entryList(QDir::Files).size(), qsizetype{3});
    QCOMPARE(run(many).status, 2);
    QCOMPARE(run(many + QStringList{"--force"}).status, 0);
    QCOMPARE(run(words + QStringList{"--motion", "--hide", "99", "-o", "-"}).status, 2);
  }

  void solidsAreWrittenAsTheViewShowsThem() {
    const QStringList words = {"export", kRobot, "--to", "glb", "--view", "3d", "-o", "-"};
    const Run whole = run(words), less = run(words + QStringList{"--hide", "1", "--explode", "1"});
    QCOMPARE(whole.status, 0);
    QVERIFY(whole.output.starts_with("glTF") && less.output.starts_with("glTF"));
    QVERIFY(less.output.size() < whole.output.size());
    QCOMPARE(run(words + QStringList{"--motion"}).status, 2);
  }

  void drawingsAreWrittenInEveryForm_data() {
    QTest::addColumn<QString>("view");
    QTest::addColumn<QString>("form");
    QTest::addColumn<std::string>("begin");
    for (const char* view : {"digraph", "ttgraph", "schematic"}) {
      QTest::addRow("%s.svg", view) << view << "svg" << std::string("<?xml");
      QTest::addRow("%s.pdf", view) << view << "pdf" << std::string("%PDF-1.");
      QTest::addRow("%s.png", view) << view << "png" << std::string("\x89PNG");
    }
  }
  void drawingsAreWrittenInEveryForm() {
    QFETCH(QString, view);
    QFETCH(QString, form);
    QFETCH(std::string, begin);
    QTemporaryDir folder;
    const QString path = folder.filePath("robot." + form);
    const QStringList words = {"export", kRobot, "--to", form, "--view", view, "-o"};
    QCOMPARE(run(words + QStringList{path}).status, 0);
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const std::string plain = file.readAll().toStdString();
    QVERIFY(plain.starts_with(begin));
    for (const QStringList& more : {QStringList{"--dark"}, {"--transparent"}, {"--size", "400x300"}}) {
      const Run other = run(words + QStringList{"-"} + more);
      QCOMPARE(other.status, 0);
      QVERIFY(other.output.starts_with(begin) && other.output != plain);
      if (form == "png" && more.front() == "--size") QCOMPARE(sizeOf(other.output), std::pair(400, 300));
    }
  }

  void drawingsThatCannotBeAreRejected() {
    const QStringList words = {"export", kRobot, "-o", "-", "--to"};
    for (const QStringList& wrong : {QStringList{"svg"},
                                     {"svg", "--view", "3d"},
                                     {"pdf", "--view", "tree"},
                                     {"png", "--view", "digraph", "--time", "1"},
                                     {"svg", "--view", "digraph", "--from", "top"},
                                     {"png", "--view", "digraph", "--size", "99999x100"}}) {
      const Run made = run(words + wrong);
      QCOMPARE(made.status, 2);
      QVERIFY(made.output.empty() && made.errors.find("--") != std::string::npos);
    }
    QCOMPARE(run({"export", kRobot, "--to", "svg", "--view", "digraph", "-o", "/nowhere/at/all.svg"}).status,
             2);
  }

  void whatHasNoTreeIsDrawnAsFarAsItIs() {
    const QString loose =
        QString::fromStdString(geargraph::test::sourcePath("tests/golden/files/loose.geargraph"));
    const Run made = run({"export", loose, "--to", "svg", "--view", "ttgraph", "-o", "-"});
    QCOMPARE(made.status, 1);
    QVERIFY(made.output.find("</svg>") != std::string::npos);
  }

  void whatHasNoTreeHasNoPicture() {
    QTemporaryDir folder;
    QFile file(folder.filePath("loose.geargraph"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(R"({"format": "geargraph", "version": 1, "links": [{"id": "0"}, {"id": "1"}], "axes": [],
                   "turningJoints": [], "gearMeshes": []})");
    file.close();
    const Run made = run({"export", file.fileName(), "--to", "png", "--view", "3d", "-o", "-"});
    QCOMPARE(made.status, 1);
    QVERIFY(made.output.empty());
  }
};

QTEST_APPLESS_MAIN(ExportPictureTest)
#include "test_export_picture.moc"
