#pragma once

#include <QObject>
#include <QString>

#include "ui/service/background_work.h"

namespace geargraph {

/// The signals of every Service, because a class template cannot declare signals.
class ServiceSignals : public QObject, public BackgroundWork {
  Q_OBJECT

 public:
  using QObject::QObject;

 signals:
  /// answer() has changed.
  void answered();
  /// The newest request failed; answer() is unchanged.
  void failed(const QString& why);
};

}  // namespace geargraph
