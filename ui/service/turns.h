#pragma once

#include <QObject>
#include <QPointer>
#include <QTimer>
#include <deque>
#include <functional>

namespace geargraph::inline ui_service {

/// Pieces of work on the GUI thread, such as showing an answer, one per turn of the event loop: what the user
/// does is handled between two of them, even if many are there at once.
class Turns : public QObject {
  Q_OBJECT

 public:
  /// The instance of the application, created by the first call. @pre the thread is the application's
  static Turns& instance();

  /// Runs the piece in a later turn, in the order of the calls. It is dropped if its context is destroyed
  /// before.
  void later(QObject* context, std::function<void()> piece);

 private:
  struct Waiting {
    QPointer<QObject> context;
    std::function<void()> piece;
  };

  explicit Turns(QObject* application);

  void runNext();

  std::deque<Waiting> m_waiting;
  QTimer m_turn;
};

}  // namespace geargraph::inline ui_service
