#include <QTest>
#include <cmath>
#include <set>
#include <tuple>
#include <vector>

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

class PaletteTest : public QObject {
  Q_OBJECT
 private slots:
  /// WCAG 2.2: 4.5 for text, 3 for what makes a control visible.
  void textAndControlsAreVisibleInAllThemes() {
    using R = ColorRole;
    std::vector<std::tuple<R, R, double>> pairs{{R::inputInk, R::inputFill, 4.5},
                                                {R::positiveInk, R::positiveFill, 4.5},
                                                {R::negativeInk, R::negativeFill, 4.5},
                                                {R::ink, R::halo, 4.5}};
    for (const R ground : {R::sheet, R::panel}) {
      for (const R text : {R::ink, R::secondary, R::accent, R::error, R::warning, R::fine})
        pairs.emplace_back(text, ground, 4.5);
      pairs.emplace_back(R::control, ground, 3);
    }
    for (const Theme theme : {Theme::light, Theme::dark, Theme::highContrast}) {
      for (const auto& [text, ground, least] : pairs) {
        const double ratio = contrast(colorOf(text, theme), colorOf(ground, theme));
        QVERIFY2(ratio >= least,
                 qPrintable(QString::number(ratio) + " " + QString::fromStdString(nameOf(text)) + " on " +
                            QString::fromStdString(nameOf(ground))));
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
    const Tint tint = Tint::ofLink(3, 3);
    QCOMPARE(colorOf(tint, Theme::light), linkColor(3));
    QCOMPARE(colorOf(tint, Theme::dark), linkColor(3));
    QCOMPARE(nameOf(tint), std::string("link 3"));
    QCOMPARE(nameOf(ColorRole::inputFill), std::string("input-fill"));
  }
};

QTEST_GUILESS_MAIN(PaletteTest)
#include "test_palette.moc"
