#include <QImage>
#include <QPainter>
#include <QTest>

#include "ui/canvas/mark_painter.h"

namespace geargraph {
namespace {

constexpr int kPaintedSide = 40;

/// A level band through the middle, 10 units wide, on the theme's sheet.
QImage paintedBand(Theme theme, const Tint& tint) {
  QImage image(kPaintedSide, kPaintedSide, QImage::Format_ARGB32);
  image.fill(toQColor(colorOf(Tint(ColorRole::sheet), theme)));
  QPainter painter(&image);
  const Stroke band{Polyline{{{0, kPaintedSide / 2.}, {kPaintedSide, kPaintedSide / 2.}}, false}, tint, 10,
                    Dash::solid};
  Mark mark;
  mark.what = band;
  paintMarks(painter, {mark}, theme, 1);
  return image;
}

}  // namespace

class MarkPainterTest : public QObject {
  Q_OBJECT

 private slots:
  void bandsAreAreas() {
    for (const Theme theme : {Theme::light, Theme::dark}) {
      const Tint tint = Tint::ofLink(1, 1).softened();
      const QImage image = paintedBand(theme, tint);
      QCOMPARE(image.pixelColor(kPaintedSide / 2, kPaintedSide / 2), toQColor(colorOf(tint, theme)));
    }
  }

  /// The area stays black, and its edges have the colour of the link.
  void bandsAreOutlinesAtHighContrast() {
    const Tint full = Tint::ofLink(1, 1);
    const QImage image = paintedBand(Theme::highContrast, full.softened());
    const int middle = kPaintedSide / 2;
    QCOMPARE(image.pixelColor(middle, middle),
             toQColor(colorOf(Tint(ColorRole::sheet), Theme::highContrast)));
    int edges = 0;
    for (int y = 0; y < kPaintedSide; ++y) {
      if (image.pixelColor(middle, y) != toQColor(colorOf(full, Theme::highContrast))) continue;
      QVERIFY(std::abs(y + 0.5 - middle) > 3 && std::abs(y + 0.5 - middle) < 6);
      ++edges;
    }
    QVERIFY2(edges >= 2, qPrintable(QString::number(edges)));
    // What is no band is not touched.
    const QImage line = paintedBand(Theme::highContrast, full);
    QCOMPARE(line.pixelColor(middle, middle), toQColor(colorOf(full, Theme::highContrast)));
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::MarkPainterTest)
#include "test_mark_painter.moc"
