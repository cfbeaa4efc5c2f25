#pragma once

#include <QObject>

namespace geargraph {

/// Records the user's actions in actionLog(): commands by object name, presses and drags by button and view,
/// and keys that are no text. Cost: a test of the type of each event.
class ActionRecorder : public QObject {
  Q_OBJECT

 public:
  /// Records from now on, for all windows made later. @pre there is an application
  explicit ActionRecorder(QObject* parent);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void onTriggered();

  quint64 m_lastInput = 0;  ///< time stamp: an event that a widget passes to its parent is recorded once
};

}  // namespace geargraph
