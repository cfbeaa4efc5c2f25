#pragma once

#include <QObject>
#include <QPointer>
#include <deque>

#include "ui/service/turns.h"

class QPalette;
class QWidget;

namespace geargraph {

/// Changes the palette and the font of the application, and lets the parts of its windows (docks, bars, the
/// centre) follow one per turn of the event loop: 5 to 20 ms each for the events, the layout and the
/// painting, where all of a window takes 50, and four windows as often. So parts have a palette and a font of
/// their own: those of the application would change in all at once.
class IncrementalRestyle : public QObject {
  Q_OBJECT

 public:
  /// The instance of the application, created by the first call.
  static IncrementalRestyle& instance();

  /// Gives a widget the palette of the application and the font of body text if it is a main window or a part
  /// of one.
  static void dressPart(QWidget& widget);

  /// @param isLaidOutNext the parts of the active window have them when this returns, because the window gets
  ///   another layout next; they are painted in their turns
  void change(const QPalette& palette, bool isLaidOutNext);
  [[nodiscard]] bool isSettled() const { return m_waiting.empty(); }

 private:
  using QObject::QObject;

  void hold(QWidget& part);
  void goOn();

  std::deque<QPointer<QWidget>> m_waiting;  ///< parts that have not followed or are not painted
  CoalescedTask m_turn{this, [this] { goOn(); }};
};

}  // namespace geargraph
