// The gestures: each is some steps, and each step is one event that the window system could send.

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QDockWidget>
#include <QFileDialog>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QTabBar>
#include <QTest>
#include <QUndoStack>
#include <QWheelEvent>
#include <QWindow>

#include "tests/soak/gesture_soak.h"
#include "ui/canvas/digraph_view.h"
#include "ui/mainwindow/window_files.h"
#include "ui/view3d/view3d.h"

namespace geargraph::soak {
namespace {

constexpr int kFewLinks = 100;  // whose outlines are looked up to hit them

QWindow* handleOf(const QWidget* widget) {
  return widget->window()->windowHandle();
}

QPoint inWindow(const QWidget* widget, QPoint at) {
  return widget->mapTo(widget->window(), at);
}

/// A position that the window has: QTest warns of others.
bool hits(const QWidget* widget, QPoint at) {
  const QWindow* handle = handleOf(widget);
  return handle != nullptr && widget->isVisible() && QRect({}, handle->size()).contains(inWindow(widget, at));
}

void press(const QPointer<QWidget>& widget, Qt::MouseButton button, Qt::KeyboardModifiers keys, QPoint at) {
  if (widget && hits(widget, at)) QTest::mousePress(handleOf(widget), button, keys, inWindow(widget, at));
}

/// A press is always followed by its release: a dock that is being dragged has it wherever it is by then.
void release(const QPointer<QWidget>& widget, Qt::MouseButton button, Qt::KeyboardModifiers keys, QPoint at) {
  if (const QWidget* dragged = QWidget::mouseGrabber(); dragged != nullptr && hits(dragged, {})) {
    QTest::mouseRelease(handleOf(dragged), button, keys, inWindow(dragged, {}));
  } else if (widget && hits(widget, at)) {
    QTest::mouseRelease(handleOf(widget), button, keys, inWindow(widget, at));
  }
}

void move(const QPointer<QWidget>& widget, QPoint at) {
  if (widget && hits(widget, at)) QTest::mouseMove(handleOf(widget), inWindow(widget, at));
}

/// Each event may be the end of the window. With modifiers QTest sends several, whatever has become of it.
void key(const QPointer<QWidget>& widget, int code, Qt::KeyboardModifiers keys = {}) {
  const QPointer<QWindow> handle(widget ? handleOf(widget) : nullptr);
  if (keys == Qt::NoModifier) {
    if (handle) QTest::keyPress(handle, static_cast<Qt::Key>(code));
    if (handle) QTest::keyRelease(handle, static_cast<Qt::Key>(code));
    return;
  }
  if (handle) qt_handleKeyEvent(handle, QEvent::KeyPress, code, keys);
  if (handle) qt_handleKeyEvent(handle, QEvent::KeyRelease, code, keys);
}

/// What would end the round, or the program.
bool isLeftAlone(const QAction* action) {
  static const QStringList kLeftAlone{QStringLiteral("file.quit"), QStringLiteral("file.close"),
                                      QStringLiteral("file.newWindow")};
  return action->menu() != nullptr || action->isSeparator() || kLeftAlone.contains(action->objectName());
}

}  // namespace

MainWindow* GestureSoak::window() {
  for (MainWindow* each : m_windows->windows()) {
    if (each->isActiveWindow()) return each;
  }
  return m_windows->windows().front();
}

QPoint GestureSoak::within(const QWidget* widget) {
  return {below(std::max(1, widget->width())), below(std::max(1, widget->height()))};
}

Qt::KeyboardModifiers GestureSoak::modifiers() {
  constexpr std::array<Qt::KeyboardModifier, 4> kAll{Qt::NoModifier, Qt::ShiftModifier, Qt::ControlModifier,
                                                     Qt::AltModifier};
  return oneIn(3) ? kAll[static_cast<std::size_t>(below(4))] : Qt::NoModifier;
}

/// The steps of a gesture in their order.
void GestureSoak::begin(const QString& gesture, std::vector<std::function<void()>> steps) {
  m_watchdog->setActivity(gesture);
  m_linksBefore = std::exchange(m_links, 0);
  countLinks();
  m_sinceGesture.start();
  ++m_gestures;
  std::reverse(steps.begin(), steps.end());
  m_steps = std::move(steps);
}

/// Half of a round's gestures are of its favourite kind: some faults need many of one kind in a row.
void GestureSoak::chooseGesture() {
  if (m_favourite == nullptr) m_favourite = kindOfGesture();
  const KindOfGesture kind = oneIn(2) ? m_favourite : kindOfGesture();
  (this->*kind)();
}

GestureSoak::KindOfGesture GestureSoak::kindOfGesture() {
  switch (below(22)) {
    case 0:
    case 1:
    case 2:
    case 3:
    case 4:
      return &GestureSoak::gestureOnDrawing;
    case 5:
    case 6:
      return &GestureSoak::gestureOnView3D;
    case 7:
    case 8:
    case 9:
    case 10:
      return &GestureSoak::gestureAnywhere;
    case 11:
      return &GestureSoak::wheel;
    case 12:
    case 13:
      return &GestureSoak::pressKey;
    case 14:
      return &GestureSoak::typeText;
    case 15:
      return &GestureSoak::triggerAction;
    case 16:
    case 17:
      return &GestureSoak::undoOrRedo;
    case 18:
      return &GestureSoak::switchDockOrDrawing;
    case 19:
      return &GestureSoak::dragDock;
    case 20:
      return &GestureSoak::arrangeWindow;
    default:
      return &GestureSoak::playOrStop;
  }
}

// --- mouse ------------------------------------------------------------------------------------------------

/// A place on the drawing in front: on a link or an arrow, mostly, where they are few enough to look up.
QPoint GestureSoak::onDrawing() {
  MainWindow* const front = window();
  DrawingView& drawing = front->drawing();
  if (front->document().mechanism()->n() <= kFewLinks && !oneIn(4)) {
    const DisplayList list = drawing.displayList();
    if (!list.outlines.empty()) {
      const Outline& outline =
          list.outlines[static_cast<std::size_t>(below(static_cast<int>(list.outlines.size())))];
      const CanvasPoint center = extentOf(outline.shape).center;
      return drawing.mapFromScene(QPointF(center.x, center.y));
    }
  }
  return within(drawing.viewport());
}

void GestureSoak::dragOver(QWidget* widget, QPoint from, QPoint to) {
  const QPointer<QWidget> on(widget);
  const Qt::MouseButton button = oneIn(5) ? Qt::MiddleButton : Qt::LeftButton;
  const Qt::KeyboardModifiers keys = modifiers();
  std::vector<std::function<void()>> steps{[=] { move(on, from); }, [=] { press(on, button, keys, from); }};
  const int count = 1 + below(8);
  for (int i = 1; i <= count; ++i) {
    const QPoint at = from + (to - from) * i / count;
    steps.emplace_back([=] { move(on, at); });
  }
  if (oneIn(8)) steps.emplace_back([=] { key(on, Qt::Key_Escape); });
  if (oneIn(8)) steps.emplace_back([=] { key(on, Qt::Key_Z, Qt::ControlModifier); });
  steps.emplace_back([=] { release(on, button, keys, to); });
  begin(
      QStringLiteral("dragging on ") + QLatin1String(widget->parentWidget() == nullptr
                                                         ? widget->metaObject()->className()
                                                         : widget->parentWidget()->metaObject()->className()),
      std::move(steps));
}

void GestureSoak::gestureOnDrawing() {
  DrawingView& drawing = window()->drawing();
  const QPointer<QWidget> sheet(drawing.viewport());
  const QPoint at = onDrawing();
  switch (below(6)) {
    case 0: {
      constexpr std::array<int, 5> kTools{Qt::Key_V, Qt::Key_L, Qt::Key_T, Qt::Key_G, Qt::Key_I};
      const int tool = kTools[static_cast<std::size_t>(below(kTools.size()))];
      const QPointer<QWidget> view(&drawing);
      return begin(QStringLiteral("choosing a tool"), {[view] {
                                                         if (view) view->setFocus();
                                                       },
                                                       [=] { key(view, tool); }});
    }
    case 1: {
      const Qt::KeyboardModifiers keys = modifiers();
      return begin(QStringLiteral("clicking on a drawing"),
                   {[=] { move(sheet, at); }, [=] { press(sheet, Qt::LeftButton, keys, at); },
                    [=] { release(sheet, Qt::LeftButton, keys, at); }});
    }
    case 2:
      return begin(QStringLiteral("opening a menu on a drawing"),
                   {[=] { move(sheet, at); }, [=] { press(sheet, Qt::RightButton, {}, at); },
                    [=] { release(sheet, Qt::RightButton, {}, at); }});
    case 3: {
      const QPoint over = onDrawing();
      return begin(QStringLiteral("hovering over a drawing"),
                   {[=] { move(sheet, at); }, [=] { move(sheet, over); }});
    }
    default:
      return dragOver(sheet, at, onDrawing());
  }
}

void GestureSoak::gestureOnView3D() {
  QWidget* view = &window()->view3d();
  const QPoint at = within(view);
  QWidget* hit = view->childAt(at);
  dragOver(hit != nullptr ? hit : view, hit != nullptr ? hit->mapFrom(view, at) : at,
           within(hit != nullptr ? hit : view));
}

/// On any widget of any window: docks, tabs, bars, panels, dialogs.
void GestureSoak::gestureAnywhere() {
  QList<QWidget*> shown;
  for (QWidget* each : QApplication::topLevelWidgets()) {
    if (each->isVisible() && each->windowHandle() != nullptr) shown << each;
  }
  if (shown.isEmpty()) return;
  QWidget* top = shown[below(static_cast<int>(shown.size()))];
  if (shown.size() > 5 && qobject_cast<MainWindow*>(top) == nullptr) {
    return begin(QStringLiteral("closing a dialog"), {[on = QPointer<QWidget>(top)] {
                   if (on) on->close();
                 }});
  }
  const QPoint at = within(top);
  QWidget* hit = top->childAt(at);
  const QPointer<QWidget> on(hit != nullptr ? hit : top);
  const QPoint place = on == top ? at : on->mapFrom(top, at);
  const QString name = QLatin1String(on->metaObject()->className());
  if (oneIn(4)) return dragOver(on, place, within(on));
  const Qt::MouseButton button = oneIn(6) ? Qt::RightButton : Qt::LeftButton;
  begin(QStringLiteral("clicking on ") + name,
        {[=] { move(on, place); }, [=] { press(on, button, {}, place); },
         [=] { release(on, button, {}, place); }});
}

void GestureSoak::wheel() {
  QWidget* top = window();
  const QPoint at = within(top);
  QWidget* hit = oneIn(3)   ? top->childAt(at)
                 : oneIn(2) ? window()->drawing().viewport()
                            : &window()->view3d();
  if (hit == nullptr) return;
  const QPointer<QWidget> on(hit);
  const QPoint place = within(hit);
  const int angle = oneIn(2) ? 120 : -120;
  const Qt::KeyboardModifiers keys = modifiers();
  const auto turn = [=] {
    if (!on) return;
    QWheelEvent event(place, on->mapToGlobal(place), {}, {0, angle}, Qt::NoButton, keys, Qt::NoScrollPhase,
                      false);
    QCoreApplication::sendEvent(on, &event);
  };
  begin(QStringLiteral("turning the wheel on ") + QLatin1String(hit->metaObject()->className()),
        std::vector<std::function<void()>>(static_cast<std::size_t>(1 + below(6)), turn));
}

// --- keys and commands ------------------------------------------------------------------------------------

void GestureSoak::pressKey() {
  constexpr std::array<int, 20> kKeys{
      Qt::Key_Delete, Qt::Key_Up,   Qt::Key_X,   Qt::Key_F2,     Qt::Key_Left, Qt::Key_Down,    Qt::Key_F,
      Qt::Key_Escape, Qt::Key_Home, Qt::Key_Tab, Qt::Key_Return, Qt::Key_Plus, Qt::Key_A,       Qt::Key_C,
      Qt::Key_V,      Qt::Key_D,    Qt::Key_End, Qt::Key_Minus,  Qt::Key_1,    Qt::Key_PageDown};
  const int code = kKeys[static_cast<std::size_t>(below(kKeys.size()))];
  const Qt::KeyboardModifiers keys = modifiers();
  begin(QStringLiteral("pressing ") + QKeySequence(code | keys.toInt()).toString(),
        {[on = QPointer<QWidget>(window()), code, keys] { key(on, code, keys); }});
}

void GestureSoak::typeText() {
  const auto isField = [](const QWidget* each) {
    return qobject_cast<const QLineEdit*>(each) != nullptr ||
           qobject_cast<const QPlainTextEdit*>(each) != nullptr;
  };
  QPointer<QWidget> on(QApplication::focusWidget());
  if (!isField(on)) {
    QList<QWidget*> fields;
    for (QWidget* each : window()->findChildren<QWidget*>()) {
      if (isField(each) && each->isVisible() && each->isEnabled()) fields << each;
    }
    if (fields.isEmpty()) return;
    on = fields[below(static_cast<int>(fields.size()))];
    on->setFocus();  // what was being typed elsewhere counts now, and forms may be made anew
    if (!on) return;
  }
  static const QStringList kTexts{QStringLiteral("12"),   QStringLiteral("22/7"),  QStringLiteral("-0.5 in"),
                                  QStringLiteral("name"), QStringLiteral("1e300"), QStringLiteral("gear"),
                                  QStringLiteral(""),     QStringLiteral("0"),     QStringLiteral("齿轮")};
  std::vector<std::function<void()>> steps{[on] {
    if (on) QMetaObject::invokeMethod(on, "selectAll");
  }};
  for (const QChar character : kTexts[below(static_cast<int>(kTexts.size()))]) {
    steps.emplace_back([on, character] {
      const QPointer<QWindow> handle(on ? handleOf(on) : nullptr);
      for (const QTest::KeyAction action : {QTest::Press, QTest::Release}) {
        if (handle) QTest::sendKeyEvent(action, handle, Qt::Key_unknown, QString(character), {});
      }
    });
  }
  const int end = oneIn(3) ? Qt::Key_Escape : Qt::Key_Return;
  steps.emplace_back([on, end] { key(on.data(), end); });
  begin(QStringLiteral("typing into ") + on->objectName(), std::move(steps));
}

void GestureSoak::triggerAction() {
  QList<QAction*> actions;
  for (QAction* each : window()->findChildren<QAction*>()) {
    if (each->isEnabled() && !isLeftAlone(each) && !each->text().isEmpty()) actions << each;
  }
  triggerOneOf(actions);
}

void GestureSoak::triggerOneOf(const QList<QAction*>& actions) {
  if (actions.isEmpty()) return;
  const QPointer<QAction> action(actions[below(static_cast<int>(actions.size()))]);
  begin(QStringLiteral("the command ") + action->text().remove(u'&'), {[action] {
          if (action) action->trigger();
        }});
}

void GestureSoak::undoOrRedo() {
  const QPointer<MainWindow> on(window());
  const bool undoes = oneIn(2);
  const auto go = [on, undoes] {
    if (on) key(on.data(), undoes ? Qt::Key_Z : Qt::Key_Y, Qt::ControlModifier);
  };
  begin(undoes ? QStringLiteral("undoing") : QStringLiteral("redoing"),
        std::vector<std::function<void()>>(static_cast<std::size_t>(1 + below(6)), go));
}

void GestureSoak::switchDockOrDrawing() {
  const QPointer<MainWindow> on(window());
  if (oneIn(2)) {
    static const QStringList kDrawings{QStringLiteral("digraph"), QStringLiteral("ttgraph"),
                                       QStringLiteral("schematic")};
    const QString name = kDrawings[below(3)];
    return begin(QStringLiteral("showing the ") + name, {[on, name] {
                   if (on) on->showDrawing(name);
                 }});
  }
  const QList<QDockWidget*> docks = on->findChildren<QDockWidget*>();
  const QPointer<QDockWidget> dock(docks[below(static_cast<int>(docks.size()))]);
  const int what = below(6);
  begin((what == 0   ? QStringLiteral("floating ")
         : what == 1 ? QStringLiteral("toggling ")
                     : QStringLiteral("raising ")) +
            dock->objectName(),
        {[dock, what] {
          if (!dock) return;
          if (what == 0) dock->setFloating(!dock->isFloating());
          if (what == 1) dock->toggleViewAction()->trigger();
          if (what > 1) {
            dock->show();
            dock->raise();
          }
        }});
}

/// By its title, onto another dock or anywhere. A dock that floats moves below the pointer: the way is that
/// on the screen.
void GestureSoak::dragDock() {
  const QList<QDockWidget*> docks = window()->findChildren<QDockWidget*>();
  const QDockWidget* other = docks[below(static_cast<int>(docks.size()))];
  const QPointer<QWidget> on(docks[below(static_cast<int>(docks.size()))]);
  const QPoint title(20 + below(60), 8 + below(10));
  const QPoint from = on->mapToGlobal(title);
  const QPoint to = oneIn(2) ? other->mapToGlobal(other->rect().center())
                             : from + QPoint(below(1400) - 700, below(1000) - 500);
  std::vector<std::function<void()>> steps{[=] { move(on, title); },
                                           [=] { press(on, Qt::LeftButton, {}, title); }};
  const int moves = 3 + below(8);
  const int count = moves + below(30);  // the pointer rests above what makes room for the dock
  for (int i = 1; i <= count; ++i) {
    const QPoint at = from + (to - from) * std::min(i, moves) / moves;
    steps.emplace_back([=] {
      if (on) move(on, on->mapFromGlobal(at));
    });
  }
  if (oneIn(10)) steps.emplace_back([=] { key(on, Qt::Key_Escape); });
  steps.emplace_back([=] {
    if (on) release(on, Qt::LeftButton, {}, on->mapFromGlobal(to));
  });
  begin(QStringLiteral("dragging ") + on->objectName(), std::move(steps));
}

/// What changes the whole window: the presentation, the layout of the start, the looks and the languages.
void GestureSoak::arrangeWindow() {
  static const QRegularExpression kNames(
      QStringLiteral("^view\\.(presentation|reset|asSystem|light|dark|highContrast|language)"));
  triggerOneOf(window()->findChildren<QAction*>(kNames));
}

void GestureSoak::playOrStop() {
  if (oneIn(30)) return closeAndReopen();
  const QPointer<MainWindow> on(window());
  std::vector<std::function<void()>> steps{[on] {
    if (on) on->actions()[CommandId::play]->trigger();
  }};
  for (int i = below(40); i > 0; --i) steps.emplace_back([] {});
  begin(QStringLiteral("playing or stopping"), std::move(steps));
}

void GestureSoak::closeAndReopen() {
  const QPointer<MainWindow> on(window());
  begin(QStringLiteral("closing and reopening"), {[on] {
          if (on) on->close();
        }});
}

// --- menus and dialogs ------------------------------------------------------------------------------------

/// A menu or a dialog in front of everything takes some keys and is cancelled, mostly.
void GestureSoak::answerPopup(QWidget* popup) {
  m_steps.clear();
  const QPointer<QWidget> on(popup);
  if (auto* question = qobject_cast<QMessageBox*>(popup)) {
    const QList<QAbstractButton*> buttons = question->buttons();
    if (!buttons.isEmpty()) return buttons[below(static_cast<int>(buttons.size()))]->click();
  }
  const bool isMenu = qobject_cast<QMenu*>(popup) != nullptr;
  switch (below(6)) {
    case 0:
    case 1:
      return key(on, Qt::Key_Down);
    case 2:
      return key(on, isMenu ? Qt::Key_Right : Qt::Key_Tab);
    case 3:
      if (isMenu) return key(on, Qt::Key_Return);
      return key(on, Qt::Key_Up);
    default:
      return key(on, Qt::Key_Escape);
  }
}

void GestureSoak::closeAll() {
  if (QWidget* popup = QApplication::activePopupWidget()) {
    popup->close();
  } else if (auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
    if (QAbstractButton* discard = question->button(QMessageBox::Discard)) {
      discard->click();
    } else {
      question->reject();
    }
  } else if (auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget())) {
    dialog->reject();
  } else if (!m_windows->windows().empty()) {
    m_windows->windows().front()->close();
  }
}

}  // namespace geargraph::soak
