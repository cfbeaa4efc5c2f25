#include <QtTest>
#include <cmath>
#include <set>

#include "core/presentation/drawing/palette.h"

using namespace geargraph;

namespace {

double luminance(Color color) {
  const auto linear = [](std::uint8_t channel) {
    const double c = channel / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(color.red) + 0.7152 * linear(color.green) + 0.0722 * linear(color.blue);
}

/// The contrast ratio of WCAG 2: 1 (equal) to 21 (black on white).
double contrast(Color a, Color b) {
  const auto [low, high] = std::minmax({luminance(a), luminance(b)});
  return (high + 0.05) / (low + 0.05);
}

}  // namespace

class TestPalette : public QObject {
  Q_OBJECT
 private slots:
  void textIsReadableInBothThemes() {
    using R = ColorRole;
    const std::vector<std::pair<R, R>> pairs{{R::ink, R::sheet},
                                             {R::ink, R::panel},
                                             {R::secondary, R::sheet},
                                             {R::accent, R::sheet},
                                             {R::error, R::sheet},
                                             {R::fine, R::sheet},
                                             {R::inputInk, R::inputFill},
                                             {R::positiveInk, R::positiveFill},
                                             {R::negativeInk, R::negativeFill}};
    for (const Theme theme : {Theme::light, Theme::dark}) {
      for (const auto& [text, ground] : pairs) {
        const double ratio = contrast(colorOf(text, theme), colorOf(ground, theme));
        QVERIFY2(ratio >= 4.2,
                 qPrintable(QString::number(ratio) + " " + QString::fromStdString(nameOf(text))));
      }
    }
  }

  void groundAndFirstLinksHaveThePrintedColours() {
    QCOMPARE(hexOf(linkColor(0)), std::string("#8A9099"));
    QCOMPARE(hexOf(linkColor(1)), std::string("#0072B2"));
    QCOMPARE(hexOf(linkColor(8)), std::string("#B5A500"));
  }

  void twentyFourLinksHaveDifferentColours() {
    std::set<std::string> seen;
    for (int label = 0; label <= 24; ++label) seen.insert(hexOf(linkColor(label)));
    QCOMPARE(seen.size(), std::size_t{25});
    QCOMPARE(linkColor(25), linkColor(1));
  }

  void tintOfALinkIsTheSameInBothThemes() {
    const Tint tint = Tint::ofLink(3);
    QCOMPARE(colorOf(tint, Theme::light), linkColor(3));
    QCOMPARE(colorOf(tint, Theme::dark), linkColor(3));
    QCOMPARE(nameOf(tint), std::string("link 3"));
    QCOMPARE(nameOf(ColorRole::inputFill), std::string("input-fill"));
  }
};

QTEST_GUILESS_MAIN(TestPalette)
#include "test_palette.moc"
