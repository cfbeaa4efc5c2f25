#include "ui/mainwindow/thumbnails.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QPointer>
#include <QStandardPaths>
#include <QThreadPool>

#include "ui/canvas/thumbnail.h"
#include "ui/mainwindow/document_files.h"

namespace geargraph {
namespace {
constexpr int kFineness = 2;
}

QString Thumbnails::keptPath(const QString& filePath, Theme theme) {
  const QDir cache(QStandardPaths::writableLocation(QStandardPaths::CacheLocation));
  const QByteArray key =
      QCryptographicHash::hash(QFileInfo(filePath).absoluteFilePath().toUtf8(), QCryptographicHash::Sha1);
  return cache.filePath(QStringLiteral("thumbnails/%1-%2.png")
                            .arg(QString::fromLatin1(key.toHex().left(16)),
                                 theme == Theme::dark ? QStringLiteral("dark") : QStringLiteral("light")));
}

QImage Thumbnails::kept(const QString& filePath, Theme theme) {
  return QImage(keptPath(filePath, theme));
}

void Thumbnails::keep(const QString& filePath, const MechanismPtr& mechanism) {
  QThreadPool::globalInstance()->start([filePath, mechanism] {
    for (const Theme theme : {Theme::light, Theme::dark}) {
      const QString path = keptPath(filePath, theme);
      QDir().mkpath(QFileInfo(path).path());
      const auto picture = digraphThumbnail(*mechanism, theme, kSize * kFineness);
      // A list without a picture is no failure worth a word.
      if (!picture || !picture->save(path)) QFile::remove(path);
    }
  });
}

void Thumbnails::draw(const QString& path, Theme theme) {
  QThreadPool::globalInstance()->start([self = QPointer<Thumbnails>(this), path, theme] {
    const Expected<Mechanism> mechanism = readDocument(path);
    if (!mechanism) return;
    const auto picture = digraphThumbnail(*mechanism, theme, kSize * kFineness);
    if (!picture) return;
    QMetaObject::invokeMethod(qApp, [self, path, theme, image = *picture] {
      if (self) emit self->drawn(path, theme, image);
    });
  });
}

}  // namespace geargraph

#include "moc_thumbnails.cpp"
