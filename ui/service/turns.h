#pragma once

#include <QObject>
#include <QPointer>
#include <QTimer>
#include <deque>
#include <functional>
#include <utility>

namespace geargraph {

/// Pieces of work on the GUI thread, such as showing an answer, one per turn of the event loop: what the user
/// does is handled between two of them, even if many are there at once. A piece gives way to all that is
/// waiting when its turn comes.
class GuiTaskQueue : public QObject {
  Q_OBJECT

 public:
  /// The instance of the application, created by the first call. @pre the thread is the application's
  static GuiTaskQueue& instance();

  /// Runs the piece in a later turn, in the order of the calls. It is dropped if its context is destroyed
  /// before.
  void later(QObject* context, std::function<void()> piece);

 protected:
  bool event(QEvent* event) override;

 private:
  struct Waiting {
    QPointer<QObject> context;
    std::function<void()> piece;
  };

  explicit GuiTaskQueue(QObject* application);

  void begin();
  void runNext();

  std::deque<Waiting> m_waiting;
  QTimer m_turn;
  bool m_isUnderWay = false;  ///< a turn is due
};

/// A piece of work that an object asks for again and again and that one later turn does for all of them.
class CoalescedTask {
 public:
  /// @param context the object that owns this
  CoalescedTask(QObject* context, std::function<void()> piece)
      : m_context(context), m_piece(std::move(piece)) {}

  /// Runs the piece in a later turn, unless one is due already. The piece may ask for the next one.
  void request();
  [[nodiscard]] bool isDue() const { return m_isDue; }

 private:
  QObject* m_context;
  std::function<void()> m_piece;
  bool m_isDue = false;
};

}  // namespace geargraph
