#pragma once

#include <QObject>
#include <QPointer>
#include <deque>

#include "ui/service/turns.h"

class QPalette;
class QWidget;

namespace geargraph::inline theme {

/// Changes the palette and the font of the application, and lets its windows follow in turns of the event
/// loop: each gets the font in one, and is painted a part (a dock, a bar, the centre) per turn. A part takes
/// 5 to 15 ms, where all of a window takes 50 and several windows as often.
class PaintingInParts : public QObject {
  Q_OBJECT

 public:
  /// The instance of the application, created by the first call.
  static PaintingInParts& instance();

  /// Gives a main window a font of its own, of the size of body text: that of the application would change in
  /// all windows at once.
  static void ownFont(QWidget& window);

  /// The active window has the font when this returns: who asked may lay it out next.
  void change(const QPalette& palette);
  [[nodiscard]] bool isSettled() const { return m_held.empty() && m_otherFont.empty(); }

 private:
  using QObject::QObject;

  void hold(QWidget& window);
  void goOn();

  std::deque<QPointer<QWidget>> m_otherFont;  ///< windows that have the former font
  std::deque<QPointer<QWidget>> m_held;       ///< parts that are not painted yet
  TurnOf m_turn{this, [this] { goOn(); }};
};

}  // namespace geargraph::inline theme
