#pragma once

#include <QObject>

#include "core/mechanism/model/mechanism.h"
#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/mainwindow/status_line.h"

namespace geargraph {

/// Labels are the paper's numbers and follow the order of the elements, so that deleting one moves those of
/// others: they are marked in all views until the mouse moves on, and the status bar names them.
class RenumberingNotice : public QObject {
  Q_OBJECT

 public:
  /// To be made after what clears the status bar at a change.
  RenumberingNotice(Document* document, Selection* selection, StatusLine* status, QObject* parent);

 private:
  void onChanged();

  Document* m_document;
  Selection* m_selection;
  StatusLine* m_status;
  MechanismPtr m_before;
  bool m_isShown = false;
};

}  // namespace geargraph
