#pragma once

#include <QByteArray>
#include <QFile>
#include <QString>

namespace geargraph::test {

/// "unreadable" of a file that cannot be read.
inline QByteArray contents(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("unreadable");
}

}  // namespace geargraph::test
