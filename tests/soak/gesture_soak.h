#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QPointer>
#include <QStringList>
#include <QTemporaryDir>
#include <map>
#include <memory>
#include <random>
#include <vector>

#include "tests/soak/soak_options.h"
#include "tests/soak/stall_watchdog.h"
#include "ui/mainwindow/main_window.h"
#include "ui/mainwindow/window_set.h"

namespace geargraph::soak {

// Making a window and taking it apart are measured and not checked: nothing could be done in it meanwhile.
const QString kOpening = QStringLiteral("opening");
const QString kClosing = QStringLiteral("closing");

/// What the program holds while nothing goes on: compared between rounds, it shows leaks.
struct AtRest {
  long objects = 0;   ///< QObjects alive
  double memory = 0;  ///< MB that the program has allocated
};

/// Random gestures on the windows of the program, one event after another in the real event loop. A round
/// opens a document in a window, works on it and closes it; between two rounds no window is open.
class GestureSoak : public QObject {
  Q_OBJECT

 public:
  explicit GestureSoak(const SoakOptions& options);
  ~GestureSoak() override;

  /// The number of findings; each is printed. Runs the event loop of the application.
  int run();

  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void next();
  void step();
  [[nodiscard]] bool isOpening();
  void act();
  void beginRound();
  void endRound();
  [[noreturn]] void giveUp();
  void closeAll();
  void begin(const QString& gesture, std::vector<std::function<void()>> steps);

  // The gestures; each is some steps, an event each.
  using KindOfGesture = void (GestureSoak::*)();
  struct TooLong {
    test::StallWatchdog::Stall stall;
    int links = 0;
    double limit = 0;  ///< ms
  };
  void chooseGesture();
  [[nodiscard]] KindOfGesture kindOfGesture();
  void answerPopup(QWidget* popup);
  void dragOver(QWidget* widget, QPoint from, QPoint to);
  void gestureOnDrawing();
  void gestureOnView3D();
  void gestureAnywhere();
  void wheel();
  void pressKey();
  void typeText();
  void triggerAction();
  void triggerOneOf(const QList<QAction*>& actions);
  void undoOrRedo();
  void switchDockOrDrawing();
  void dragDock();
  void arrangeWindow();
  void playOrStop();
  void closeAndReopen();

  [[nodiscard]] int below(int limit) {
    return static_cast<int>(m_random() % static_cast<std::uint64_t>(limit));
  }
  [[nodiscard]] bool oneIn(int count) { return below(count) == 0; }
  [[nodiscard]] QPoint within(const QWidget* widget);
  [[nodiscard]] QPoint onDrawing();
  [[nodiscard]] Qt::KeyboardModifiers modifiers();
  [[nodiscard]] MainWindow* window();
  [[nodiscard]] QString documentFile(const std::string& name);
  [[nodiscard]] AtRest atRest() const;
  [[nodiscard]] long gesturesOfRound() const;
  [[nodiscard]] bool isLastRound() const;
  [[nodiscard]] bool isTimeOver() const;
  void countLinks();
  void checkStalls();
  void reportStalls();
  [[nodiscard]] int linksOfLate() const;
  [[nodiscard]] double limitOfStall() const;
  void finding(const QString& what);
  void checkLeaks();
  void printStalls();

  SoakOptions m_options;
  std::mt19937_64 m_random;
  QTemporaryDir m_folder;
  std::unique_ptr<WindowSet> m_windows;
  std::unique_ptr<test::StallWatchdog> m_watchdog;
  QElapsedTimer m_time;
  QElapsedTimer m_sinceGesture;
  QPointer<QWidget> m_opening;                 ///< the latest window
  int m_openingSteps = 0;                      ///< until a gesture may begin in it
  std::vector<std::function<void()>> m_steps;  ///< of the gesture that goes on, the next one last
  std::vector<AtRest> m_rests;                 ///< by round
  std::map<QString, test::StallWatchdog::Stall> m_longest;  ///< by document and gesture
  KindOfGesture m_favourite = nullptr;                      ///< of this round
  std::map<QString, TooLong> m_tooLong;                     ///< of this round, by gesture
  QString m_document;
  int m_links = 0;        ///< the most that a document had during the gesture
  int m_linksBefore = 0;  ///< during the gesture before
  int m_round = 0;
  long m_gestures = 0;
  long m_gesturesBefore = 0;  ///< this round
  int m_findings = 0;
  int m_waited = 0;       ///< events since no window is open
  bool m_ending = false;  ///< the windows of the round are being closed
};

}  // namespace geargraph::soak
