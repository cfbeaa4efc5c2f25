#include <QApplication>
#include <QDockWidget>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSlider>
#include <QSpinBox>
#include <QStyle>
#include <QStyleOptionSlider>
#include <QTableView>
#include <QTest>
#include <QToolBar>
#include <QToolButton>
#include <QToolTip>
#include <QVBoxLayout>

#include "ui/theme/application_theme.h"
#include "ui/theme/empty_label.h"
#include "ui/theme/icons.h"
#include "ui/theme/looks.h"
#include "ui/theme/painting_in_parts.h"

namespace geargraph {
namespace {

struct EventCount : QObject {
  explicit EventCount(QEvent::Type counted) : type(counted) {}
  QEvent::Type type;
  int count = 0;
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == type) ++count;
    return QObject::eventFilter(watched, event);
  }
};

QColor middleOf(QWidget& widget) {
  const QImage image = widget.grab().toImage();
  return image.pixelColor(image.rect().center());
}

template <class Widget>
Widget* polished(Widget* widget, const char* look) {
  widget->setProperty("look", look);
  widget->ensurePolished();
  return widget;
}

QStyleOptionSlider optionOf(Qt::Orientation orientation, int length, int page, int value, int most) {
  QStyleOptionSlider option;
  option.rect = orientation == Qt::Horizontal ? QRect(0, 0, length, 10) : QRect(0, 0, 10, length);
  option.orientation = orientation;
  option.minimum = 0;
  option.maximum = most;
  option.pageStep = page;
  option.sliderPosition = option.sliderValue = value;
  return option;
}

QRect partOf(QStyle::ComplexControl control, const QStyleOptionSlider& option, QStyle::SubControl part) {
  return QApplication::style()->subControlRect(control, &option, part, nullptr);
}

}  // namespace

class LooksTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { applyTheme(*qApp, Theme::light); }

  void aLabelHasTheInkOfItsLookInEachTheme() {
    QWidget page;
    page.setBackgroundRole(QPalette::Base);
    auto* verdict = polished(new QLabel(QStringLiteral("x"), &page), "verdict");
    setInk(*verdict, ColorRole::fine);
    auto* problem = polished(new QLabel(QStringLiteral("x"), &page), "problem");
    auto* hint = polished(new QLabel(QStringLiteral("x"), &page), "hint");
    for (const Theme theme : {Theme::dark, Theme::highContrast, Theme::light}) {
      applyTheme(*qApp, theme);
      QTRY_COMPARE(problem->palette().color(problem->foregroundRole()), qColor(ColorRole::error, theme));
      QTRY_COMPARE(hint->palette().color(hint->foregroundRole()), qColor(ColorRole::secondary, theme));
      QTRY_COMPARE(verdict->palette().color(verdict->foregroundRole()), qColor(ColorRole::fine, theme));
    }
  }

  void anEmptyLabelKeepsItsTextFromTheEdges() {
    QWidget page;
    auto* layout = new QVBoxLayout(&page);
    layout->setContentsMargins(0, 0, 0, 0);
    QLabel* label = emptyLabel(&page, QStringLiteral("x"));
    layout->addWidget(label);
    page.show();
    QVERIFY(label->height() >= 48 + label->fontMetrics().height());
    QVERIFY(label->sizeHint().width() >= 48);
  }

  void aLabelThatGetsAnotherLookLosesTheFormer() {
    QWidget page;
    auto* label = polished(new QLabel(QStringLiteral("x"), &page), "problem");
    label->setProperty("look", "hint");
    label->style()->polish(label);
    QCOMPARE(label->palette().color(label->foregroundRole()), qColor(ColorRole::secondary, Theme::light));
    QCOMPARE(label->palette().color(QPalette::WindowText), qColor(ColorRole::ink, Theme::light));
  }

  void boldLabelsGrowWithTheTypeScale() {
    QWidget page;
    auto* title = polished(new QLabel(QStringLiteral("x"), &page), "title");
    auto* count = polished(new QToolButton(&page), "count");
    auto* matrix = polished(new QTableView(&page), "entries");
    QVERIFY(title->font().bold());
    QCOMPARE(title->font().pixelSize(), bodyPixels());
    applyTheme(*qApp, Theme::light, 1.5);
    QTRY_COMPARE(title->font().pixelSize(), bodyPixels());
    QVERIFY(title->font().bold());
    QCOMPARE(count->font().pixelSize(), smallPixels());
    QVERIFY(smallPixels() > 15);
    QCOMPARE(matrix->font().pixelSize(), bodyPixels() + 1);
    QCOMPARE(matrix->horizontalHeader()->font().pixelSize(), bodyPixels() + 1);
  }

  void anotherThemeIsOneChangeAndOnePainting() {
    QMainWindow window;
    auto* dock = new QDockWidget(QStringLiteral("dock"), &window);
    auto* card = polished(new QFrame, "card");
    dock->setWidget(card);
    window.addDockWidget(Qt::RightDockWidgetArea, dock);
    window.resize(300, 200);
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    QCoreApplication::processEvents();
    EventCount paints(QEvent::Paint);
    EventCount restyles(QEvent::StyleChange);
    card->installEventFilter(&paints);
    card->installEventFilter(&restyles);
    applyTheme(*qApp, Theme::dark);
    QVERIFY(!IncrementalRestyle::instance().isSettled());
    QTRY_VERIFY(IncrementalRestyle::instance().isSettled() && paints.count > 0);
    QCoreApplication::processEvents();
    QCOMPARE(paints.count, 1);
    QCOMPARE(restyles.count, 0);
    QCOMPARE(middleOf(*card), qColor(ColorRole::sheet, Theme::dark));
  }

  /// A style sheet would polish all of a dock again when it is taken out of its window.
  void aDockThatIsTakenOutIsNotStyledAgain() {
    QMainWindow window;
    auto* dock = new QDockWidget(QStringLiteral("dock"), &window);
    auto* button = new QPushButton(QStringLiteral("Text"));
    dock->setWidget(button);
    window.addDockWidget(Qt::RightDockWidgetArea, dock);
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    EventCount restyles(QEvent::StyleChange);
    button->installEventFilter(&restyles);
    dock->setFloating(true);
    QCoreApplication::processEvents();
    QCOMPARE(restyles.count, 0);
  }

  void partsFollowOneATurnUnlessTheWindowIsLaidOutNext_data() {
    QTest::addColumn<bool>("isLaidOutNext");
    QTest::addRow("in turns") << false;
    QTest::addRow("laid out next") << true;
  }
  void partsFollowOneATurnUnlessTheWindowIsLaidOutNext() {
    QFETCH(bool, isLaidOutNext);
    QMainWindow window;
    std::vector<QLabel*> labels;
    std::vector<QDockWidget*> docks;
    for (int i = 0; i < 4; ++i) {
      labels.push_back(new QLabel(QStringLiteral("x")));
      docks.push_back(new QDockWidget(QString::number(i), &window));
      docks.back()->setWidget(labels.back());
      window.addDockWidget(Qt::RightDockWidgetArea, docks.back());
    }
    window.show();
    docks[1]->setFloating(true);
    docks[2]->hide();
    QVERIFY(QTest::qWaitForWindowExposed(docks[1]));
    QTRY_COMPARE(QApplication::activeWindow(), docks[1]);
    const int before = bodyPixels();
    const auto followed = [&] {
      return std::count_if(labels.begin(), labels.end(),
                           [&](QLabel* label) { return label->font().pixelSize() == 2 * before; });
    };
    applyTheme(*qApp, Theme::dark, 2, isLaidOutNext);
    QCOMPARE(followed(), isLaidOutNext ? 4 : 0);
    std::ptrdiff_t most = 0;
    for (std::ptrdiff_t last = 0; !IncrementalRestyle::instance().isSettled(); last = followed()) {
      QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
      most = std::max(most, followed() - last);
    }
    QCOMPARE(followed(), 4);
    QVERIFY(isLaidOutNext || most <= 2);
    for (const QLabel* label : labels) {
      QVERIFY(label->updatesEnabled());
      QCOMPARE(label->palette().color(QPalette::Base), qColor(ColorRole::sheet, Theme::dark));
    }
    QMainWindow late;
    late.ensurePolished();
    QCOMPARE(late.font().pixelSize(), 2 * before);
  }

  /// The message of a presentation: its ink is that of its look, not of the window.
  void aLabelThatIsAPartKeepsItsInk() {
    QMainWindow window;
    auto* toast = polished(new QLabel(QStringLiteral("x"), &window), "toast");
    window.show();
    toast->show();
    for (const Theme theme : {Theme::dark, Theme::light}) {
      applyTheme(*qApp, theme);
      QTRY_VERIFY(IncrementalRestyle::instance().isSettled());
      QCOMPARE(toast->palette().color(toast->foregroundRole()), qColor(ColorRole::sheet, theme));
    }
  }

  void anIconIsDrawnForTheSizeAndTheStateThatIsShown() {
    const QIcon play = icon(QStringLiteral("play"), ColorRole::ink, Theme::light);
    const QPixmap sharp = play.pixmap(QSize(20, 20), 2.0);
    QCOMPARE(sharp.size(), QSize(40, 40));
    QCOMPARE(sharp.devicePixelRatio(), 2.0);
    QCOMPARE(play.pixmap(QSize(30, 18), 1.0).size(), QSize(18, 18));
    const auto middle = [&play](QIcon::Mode mode, QIcon::State state) {
      return play.pixmap(QSize(20, 20), 1.0, mode, state).toImage().pixelColor(9, 10);
    };
    QCOMPARE(middle(QIcon::Normal, QIcon::Off), qColor(ColorRole::ink, Theme::light));
    QCOMPARE(middle(QIcon::Active, QIcon::On), qColor(ColorRole::accent, Theme::light));
    QCOMPARE(middle(QIcon::Disabled, QIcon::Off), qColor(ColorRole::hairline, Theme::light));
  }

  void tipsHaveTheColoursOfTheTheme() {
    applyTheme(*qApp, Theme::highContrast);
    QCOMPARE(QToolTip::palette().color(QPalette::ToolTipBase), qColor(ColorRole::sheet, Theme::highContrast));
  }

  void aButtonIsSizedByItsForm() {
    QToolBar bar;
    auto* plain = new QToolButton;
    auto* chip = polished(new QToolButton, "chip");
    for (QToolButton* button : {plain, chip}) {
      bar.addWidget(button);
      button->setText(QStringLiteral("Text"));
    }
    bar.show();
    QCOMPARE(plain->sizeHint().width(), chip->sizeHint().width());
    QCOMPARE(plain->sizeHint().height() - chip->sizeHint().height(), 3);  // the padding above and below
  }

  void aFieldLeavesRoomForWhatIsInIt() {
    QLineEdit field;
    QLineEdit cell;
    polished(&cell, "cell");
    QCOMPARE(field.sizeHint().height(), cell.sizeHint().height());
    QCOMPARE(field.sizeHint().width() - cell.sizeHint().width(), 12);
    QSpinBox number;
    polished(&number, "number");
    number.show();
    const auto* line = number.findChild<QLineEdit*>();
    QCOMPARE(line->geometry(), number.rect().adjusted(7, 4, -17, -4));
  }

  void theHandleOfAScrollBarIsAsLongAsWhatIsSeen() {
    QStyleOptionSlider option = optionOf(Qt::Vertical, 200, 100, 0, 300);
    QCOMPARE(partOf(QStyle::CC_ScrollBar, option, QStyle::SC_ScrollBarSlider), QRect(0, 0, 10, 50));
    option.sliderPosition = 300;
    QCOMPARE(partOf(QStyle::CC_ScrollBar, option, QStyle::SC_ScrollBarSlider), QRect(0, 150, 10, 50));
    QCOMPARE(partOf(QStyle::CC_ScrollBar, option, QStyle::SC_ScrollBarSubPage), QRect(0, 0, 10, 150));
    QVERIFY(partOf(QStyle::CC_ScrollBar, option, QStyle::SC_ScrollBarAddPage).isEmpty());
    QVERIFY(partOf(QStyle::CC_ScrollBar, option, QStyle::SC_ScrollBarAddLine).isEmpty());
    const QStyleOptionSlider nothing = optionOf(Qt::Horizontal, 200, 10, 0, 0);
    QCOMPARE(partOf(QStyle::CC_ScrollBar, nothing, QStyle::SC_ScrollBarSlider), QRect(0, 0, 200, 10));
    const QStyleOptionSlider huge = optionOf(Qt::Horizontal, 200, 10, 0, 2'000'000'000);
    QCOMPARE(partOf(QStyle::CC_ScrollBar, huge, QStyle::SC_ScrollBarSlider).width(), 24);
    const QStyleOptionSlider tiny = optionOf(Qt::Horizontal, 12, 10, 5, 500);
    QCOMPARE(partOf(QStyle::CC_ScrollBar, tiny, QStyle::SC_ScrollBarSlider), QRect(0, 0, 12, 10));
  }

  void aScrollBarIsDragged() {
    QScrollBar bar(Qt::Vertical);
    bar.resize(10, 200);
    bar.setRange(0, 300);
    bar.setPageStep(100);
    bar.show();
    QVERIFY(QTest::qWaitForWindowExposed(&bar));
    QTest::mousePress(&bar, Qt::LeftButton, {}, {5, 10});
    QTest::mouseMove(&bar, {5, 85});
    QTest::mouseRelease(&bar, Qt::LeftButton, {}, {5, 85});
    QCOMPARE(bar.value(), 150);
    QTest::mouseClick(&bar, Qt::LeftButton, {}, {5, 5});
    QCOMPARE(bar.value(), 50);  // a page
  }

  void theHandleOfASliderReachesBothEnds() {
    QStyleOptionSlider option = optionOf(Qt::Horizontal, 116, 10, 0, 100);
    QCOMPARE(partOf(QStyle::CC_Slider, option, QStyle::SC_SliderHandle).left(), 0);
    option.sliderPosition = 100;
    QCOMPARE(partOf(QStyle::CC_Slider, option, QStyle::SC_SliderHandle).right(), 115);
  }

  void aPageStandsOnTheSheet() {
    QScrollArea area;
    auto* page = new QWidget;
    area.setWidget(page);
    area.setWidgetResizable(true);
    area.resize(100, 100);
    area.show();
    for (const Theme theme : {Theme::light, Theme::dark}) {
      applyTheme(*qApp, theme);
      QTRY_COMPARE(middleOf(area), qColor(ColorRole::sheet, theme));
    }
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::LooksTest)
#include "test_looks.moc"
