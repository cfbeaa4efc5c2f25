#pragma once

#include <QWidget>

#include "ui/document/document.h"

namespace geargraph {

class NumberField;

/// The torque at the drive of every state of a gearbox, with its title. An edit can be undone; hidden while
/// the document has no states. An empty field shows the torque that is used then.
class DriveTorqueStrip : public QWidget {
  Q_OBJECT

 public:
  explicit DriveTorqueStrip(Document* document, QWidget* parent = nullptr);

 private:
  void renew();

  Document* m_document;
  NumberField* m_field;
  quint64 m_gesture = 0;
};

}  // namespace geargraph
