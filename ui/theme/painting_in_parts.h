#pragma once

#include <QObject>
#include <QPointer>
#include <deque>

#include "ui/service/turns.h"

class QPalette;
class QWidget;

namespace geargraph::inline theme {

/// Changes the palette and the font of the application, and lets its windows follow in turns of the event
/// loop: each gets them in one, and is painted a part (a dock, a bar, the centre) per turn. Four windows have
/// thousands of widgets to tell, and a part takes 5 to 15 ms, where all of a window takes 50.
class PaintingInParts : public QObject {
  Q_OBJECT

 public:
  /// The instance of the application, created by the first call.
  static PaintingInParts& instance();

  /// Gives a main window a palette and a font of its own: those of the application would change in all
  /// windows at once.
  static void dress(QWidget& window);

  /// The active window has them when this returns: who asked may lay it out next.
  void change(const QPalette& palette);
  [[nodiscard]] bool isSettled() const { return m_held.empty() && m_undressed.empty(); }

 private:
  using QObject::QObject;

  void hold(QWidget& window);
  static void follow(QWidget& window);
  void goOn();

  std::deque<QPointer<QWidget>> m_undressed;  ///< windows that have the former palette and font
  std::deque<QPointer<QWidget>> m_held;       ///< parts that are not painted yet
  TurnOf m_turn{this, [this] { goOn(); }};
};

}  // namespace geargraph::inline theme
