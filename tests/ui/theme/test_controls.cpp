#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenuBar>
#include <QPushButton>
#include <QRadioButton>
#include <QScrollBar>
#include <QSlider>
#include <QSpinBox>
#include <QTabBar>
#include <QTest>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <map>

#include "ui/theme/application_theme.h"

namespace geargraph {
namespace {

constexpr double kText = 4.5, kControl = 3;  // WCAG 2.2, 1.4.3 and 1.4.11
constexpr int kLeastPixels = 8;              // that have the contrast: strokes, not one corner

double luminance(QRgb color) {
  const auto linear = [](int channel) {
    const double c = channel / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(qRed(color)) + 0.7152 * linear(qGreen(color)) + 0.0722 * linear(qBlue(color));
}

double contrast(QRgb a, QRgb b) {
  const auto [low, high] = std::minmax({luminance(a), luminance(b)});
  return (high + 0.05) / (low + 0.05);
}

/// The contrast that at least kLeastPixels pixels of the picture have to its most frequent colour.
double contrastIn(const QImage& image) {
  std::map<QRgb, int> counts;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) ++counts[image.pixel(x, y)];
  }
  const auto byCount = [](const auto& a, const auto& b) { return a.second < b.second; };
  const QRgb ground = std::max_element(counts.begin(), counts.end(), byCount)->first;
  std::vector<double> contrasts;
  for (const auto& [color, count] : counts)
    contrasts.insert(contrasts.end(), static_cast<std::size_t>(count), contrast(color, ground));
  if (contrasts.size() <= kLeastPixels) return 1;
  std::nth_element(contrasts.begin(), contrasts.begin() + kLeastPixels, contrasts.end(), std::greater<>());
  return contrasts[kLeastPixels];
}

using Maker = QWidget* (*)();

QWidget* looking(QWidget* widget, const char* look) {
  widget->setProperty("look", look);
  return widget;
}

QToolButton* toolButton(const char* look) {
  auto* button = new QToolButton;
  button->setText(QStringLiteral("Text"));
  button->setProperty("look", look);
  return button;
}

QToolButton* chosenButton(const char* look) {
  QToolButton* button = toolButton(look);
  button->setCheckable(true);
  button->setChecked(true);
  return button;
}

template <class Button>
QWidget* indicator(bool isOn) {
  auto* button = new Button;
  button->setChecked(isOn);
  return button;
}

template <class Bar>
QWidget* ranged() {
  auto* bar = new Bar(Qt::Horizontal);
  bar->setRange(0, 100);
  bar->setPageStep(30);
  bar->setValue(50);
  return bar;
}

QWidget* list() {
  auto* items = new QListWidget;
  items->addItem(QStringLiteral("Text"));
  items->setCurrentRow(0);
  return items;
}

QWidget* tabs(int current) {
  auto* bar = new QTabBar;
  bar->addTab(QStringLiteral("Text"));
  bar->addTab(QStringLiteral(" "));
  bar->setCurrentIndex(current);
  return bar;
}

QWidget* menuBar() {
  auto* bar = new QMenuBar;
  bar->addMenu(QStringLiteral("Text"));
  return bar;
}

struct Row {
  const char* name;
  double least;
  Maker make;
};

const Row kRows[] = {
    {"label", kText, [] { return static_cast<QWidget*>(new QLabel("Text")); }},
    {"hint", kText, [] { return looking(new QLabel("Text"), "hint"); }},
    {"problem", kText, [] { return looking(new QLabel("Text"), "problem"); }},
    {"empty", kText, [] { return looking(new QLabel("Text"), "empty"); }},
    {"note on the picture", kText, [] { return looking(new QLabel("Text"), "note3d"); }},
    {"toast", kText, [] { return looking(new QLabel("Text"), "toast"); }},
    {"chip", kText, [] { return static_cast<QWidget*>(toolButton("chip")); }},
    {"symbol", kText, [] { return static_cast<QWidget*>(toolButton("symbol")); }},
    {"chosen symbol", kText, [] { return static_cast<QWidget*>(chosenButton("symbol")); }},
    {"chosen chip", kText, [] { return static_cast<QWidget*>(chosenButton("chip")); }},
    {"control", kText, [] { return static_cast<QWidget*>(toolButton("control")); }},
    {"chosen control", kText, [] { return static_cast<QWidget*>(chosenButton("control")); }},
    {"flat", kText, [] { return static_cast<QWidget*>(toolButton("flat")); }},
    {"count", kText, [] { return static_cast<QWidget*>(toolButton("count")); }},
    {"strong count", kText, [] { return static_cast<QWidget*>(toolButton("strongCount")); }},
    {"push button", kText, [] { return static_cast<QWidget*>(new QPushButton("Text")); }},
    {"check box with text", kText, [] { return static_cast<QWidget*>(new QCheckBox("Text")); }},
    {"tab", kText, [] { return tabs(0); }},
    {"other tab", kText, [] { return tabs(1); }},
    {"menu bar", kText, [] { return menuBar(); }},
    {"chosen item", kText, [] { return list(); }},
    {"text of a field", kText, [] { return static_cast<QWidget*>(new QLineEdit("Text")); }},
    {"text of a choice", kText,
     [] {
       auto* box = new QComboBox;
       box->addItem("Text");
       return static_cast<QWidget*>(box);
     }},
    {"field", kControl, [] { return static_cast<QWidget*>(new QLineEdit); }},
    {"number", kControl, [] { return looking(new QSpinBox, "number"); }},
    {"choice", kControl, [] { return static_cast<QWidget*>(new QComboBox); }},
    {"check box", kControl, [] { return indicator<QCheckBox>(false); }},
    {"ticked check box", kControl, [] { return indicator<QCheckBox>(true); }},
    {"radio button", kControl, [] { return indicator<QRadioButton>(false); }},
    {"chosen radio button", kControl, [] { return indicator<QRadioButton>(true); }},
    {"slider", kControl, [] { return ranged<QSlider>(); }},
    {"scroll bar", kControl, [] { return ranged<QScrollBar>(); }},
    {"buttons of a dock", kControl, [] { return static_cast<QWidget*>(new QDockWidget); }},
};

}  // namespace

class ControlsTest : public QObject {
  Q_OBJECT

 private slots:
  void everyControlIsVisibleInEveryTheme_data() {
    QTest::addColumn<int>("theme");
    QTest::addColumn<int>("row");
    constexpr std::pair<Theme, const char*> kThemes[] = {
        {Theme::light, "light"}, {Theme::dark, "dark"}, {Theme::highContrast, "high contrast"}};
    for (const auto& [theme, name] : kThemes) {
      for (std::size_t i = 0; i < std::size(kRows); ++i) {
        QTest::addRow("%s, %s", kRows[i].name, name) << static_cast<int>(theme) << static_cast<int>(i);
      }
    }
  }
  void everyControlIsVisibleInEveryTheme() {
    QFETCH(int, theme);
    QFETCH(int, row);
    applyTheme(*qApp, static_cast<Theme>(theme));
    const Row& tried = kRows[row];
    QWidget page;
    auto* layout = new QVBoxLayout(&page);
    QWidget* control = tried.make();
    control->setFocusPolicy(Qt::NoFocus);
    layout->addWidget(control);
    layout->addStretch(1);
    page.resize(200, 120);
    page.show();
    QVERIFY(QTest::qWaitForWindowExposed(&page));
    const QRect place = control->geometry().adjusted(-2, -2, 2, 2);
    const double measured = contrastIn(page.grab(place).toImage());
    QVERIFY2(measured >= tried.least, qPrintable(QString::number(measured)));
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::ControlsTest)
#include "test_controls.moc"
