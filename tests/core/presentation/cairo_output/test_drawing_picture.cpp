#include <QImage>
#include <QRegularExpression>
#include <QTest>

#include "core/presentation/cairo_output/picture.h"
#include "core/presentation/drawing/digraph_drawing.h"
#include "tests/core/support/example_files.h"
#include "tests/support/pdf_streams.h"

using namespace geargraph;

namespace {

DisplayList robot() {
  const Mechanism mechanism = test::example("robot");
  return digraphDrawing(mechanism, mechanism.view.nodes, {});
}

QByteArray bytesOf(const DrawingPicture& picture, const DisplayList& list = robot()) {
  return QByteArray::fromStdString(pictureOf(list, picture).value());
}

QImage png(SheetStyle style, double scale = 2) {
  return QImage::fromData(bytesOf({.form = PictureForm::png, .style = style, .scale = scale}));
}

/// The letters that the page shows, of the strings that its font names by their codes.
QString shownText(const QByteArray& contents) {
  QString text;
  static const QRegularExpression strings(QStringLiteral("\\(([^)]*)\\)|\\](?:\\s*)TJ|Tj"));
  auto match = strings.globalMatch(QString::fromLatin1(contents));
  while (match.hasNext()) {
    const QRegularExpressionMatch found = match.next();
    text += found.captured(0).startsWith('(') ? found.captured(1) : QStringLiteral(" ");
  }
  return text;
}

}  // namespace

class DrawingPictureTest : public QObject {
  Q_OBJECT
 private slots:
  void pdfIsWholeAndItsTextIsText() {
    const QByteArray pdf = bytesOf({.form = PictureForm::pdf, .scale = 1, .title = "A robot of (two) arms"});
    QVERIFY(pdf.startsWith("%PDF-1."));
    QVERIFY(pdf.trimmed().endsWith("%%EOF"));
    QVERIFY(test::pdfText(pdf).contains("/ToUnicode"));
    const QString text = shownText(test::pdfStreams(pdf).join('\n'));
    QVERIFY2(text.contains("motor"), qPrintable(text));
    for (int label = 0; label <= 18; ++label)
      QVERIFY2(text.contains(QString::number(label)), qPrintable(text));
  }

  void pdfIsAsLargeAsTheDrawingInPoints() {
    const Extent sheet = sheetOf(robot(), {});
    const QByteArray pdf = bytesOf({.form = PictureForm::pdf});
    static const QRegularExpression box(QStringLiteral("/MediaBox \\[ 0 0 ([0-9.]+) ([0-9.]+) \\]"));
    const QRegularExpressionMatch found = box.match(QString::fromLatin1(test::pdfText(pdf)));
    QVERIFY(found.hasMatch());
    QVERIFY(std::abs(found.captured(1).toDouble() - 2 * sheet.halfWidth * 0.75) < 0.01);
    QVERIFY(std::abs(found.captured(2).toDouble() - 2 * sheet.halfHeight * 0.75) < 0.01);
  }

  void pngIsPaintedInTheSizeAsked() {
    const QImage own = png({});
    const Extent sheet = sheetOf(robot(), {});
    QCOMPARE(own.width(), qRound(4 * sheet.halfWidth));
    QCOMPARE(own.height(), qRound(4 * sheet.halfHeight));
    const QImage asked = png({.size = SheetStyle::Size{300, 500}});
    QCOMPARE(asked.size(), QSize(300, 500));
    int dark = 0;
    for (int y = 0; y < own.height(); ++y) {
      for (int x = 0; x < own.width(); ++x) dark += qGray(own.pixel(x, y)) < 100 ? 1 : 0;
    }
    QVERIFY2(dark > 2000, qPrintable(QString::number(dark)));
  }

  void groundIsThatOfTheThemeOrNone() {
    const auto corner = [](SheetStyle style) { return png(style).pixel(0, 0); };
    QCOMPARE(corner({}), qRgb(0xFF, 0xFF, 0xFF));
    QCOMPARE(corner({.theme = Theme::dark}), qRgb(0x1E, 0x22, 0x27));
    QCOMPARE(qAlpha(corner({.transparent = true})), 0);
    const auto svg = [](SheetStyle style) { return bytesOf({.form = PictureForm::svg, .style = style}); };
    QVERIFY(svg({}).contains("fill=\"#FFFFFF\"/>\n<g"));
    QVERIFY(!svg({.transparent = true}).contains("fill=\"#FFFFFF\"/>\n<g"));
    QVERIFY(bytesOf({.form = PictureForm::pdf}) !=
            bytesOf({.form = PictureForm::pdf, .style = {.transparent = true}}));
  }

  void drawingIsWhereItIsOnEverySheet() {
    // The same line, found in all four corners of the sheet's middle.
    DisplayList list;
    list.marks.push_back({{}, MarkRole::line, 0, Fill{Box{{{500, -200}, 50, 10}, 0}, ColorRole::ink}});
    const QImage image = QImage::fromData(bytesOf(
        {.form = PictureForm::png, .style = {.margin = 10, .size = SheetStyle::Size{240, 240}}}, list));
    const auto isInk = [&](int x, int y) { return qGray(image.pixel(x, y)) < 100; };
    QVERIFY(isInk(120, 120) && isInk(22, 120) && isInk(218, 120) && isInk(120, 102) && isInk(120, 138));
    QVERIFY(!isInk(17, 120) && !isInk(223, 120) && !isInk(120, 97) && !isInk(120, 143));
  }

  void hugePngIsRejectedAndHugePdfFits() {
    DisplayList list;
    for (const double x : {0.0, 1e6}) {
      list.marks.push_back({{}, MarkRole::line, 0, Fill{Circle{{x, 0}, 5}, ColorRole::ink}});
    }
    const Expected<std::string> rejected = pictureOf(list, {.form = PictureForm::png});
    QVERIFY(!rejected.has_value());
    QCOMPARE(rejected.error().front().code, Code::graphics);
    QVERIFY(pictureOf(list, {.form = PictureForm::pdf}).has_value());
  }

  void emptyDrawingIsAnEmptySheet() {
    for (const PictureForm form : {PictureForm::svg, PictureForm::pdf, PictureForm::png}) {
      QVERIFY(!pictureOf({}, {.form = form}).value().empty());
    }
  }
};

QTEST_GUILESS_MAIN(DrawingPictureTest)
#include "test_drawing_picture.moc"
