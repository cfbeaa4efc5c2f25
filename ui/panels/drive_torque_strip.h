#pragma once

#include <QWidget>

#include "ui/document/document.h"

class QLabel;
class QToolButton;

namespace geargraph {

class NumberField;

/// What the torques of all states of a gearbox are under: the torque at the drive, the efficiency of the
/// meshes, how shared loads are divided; and the spread of the ratios. An edit can be undone; hidden while
/// the document has no states. An empty torque shows the one that is used then.
class DriveTorqueStrip : public QWidget {
  Q_OBJECT

 public:
  explicit DriveTorqueStrip(Document* document, QWidget* parent = nullptr);

  /// The largest ratio over the smallest; none: it is not shown.
  void showSpread(const std::optional<double>& spread);
  /// Is there something to be shared in any state?
  void showSharing(bool isShared);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void addPair(const QString& title, const QString& tip, QWidget* field);
  void makeShare();
  void renew();

  Document* m_document;
  NumberField* m_field;
  QToolButton* m_share;
  QLabel* m_spread;
  bool m_isShared = false;
  quint64 m_gesture = 0;
};

}  // namespace geargraph
