#pragma once

#include <QObject>
#include <QString>

#include "ui/service/background_work.h"

namespace geargraph::inline ui_service {

/// What every Service tells; a template has no signals of its own.
class ServiceSignals : public QObject, public BackgroundWork {
  Q_OBJECT

 public:
  using QObject::QObject;

 signals:
  /// The service's answer() is another one now.
  void answered();
  /// The newest request cannot be answered; answer() stays as it was.
  void failed(const QString& why);
};

}  // namespace geargraph::inline ui_service
