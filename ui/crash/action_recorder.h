#pragma once

#include <QObject>

namespace geargraph::inline crash {

/// Notes in actionLog() what the user does: commands by their object names, presses and drags by button and
/// view, keys that are no text. Cost: a look at the type of each event.
class ActionRecorder : public QObject {
  Q_OBJECT

 public:
  /// From now on, for all windows that are made later. @pre there is an application
  explicit ActionRecorder(QObject* parent);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void onTriggered();

  quint64 m_lastInput = 0;  ///< time stamp: an event that a widget leaves to its parent is noted once
};

}  // namespace geargraph::inline crash
