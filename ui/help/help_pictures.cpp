#include "ui/help/help_pictures.h"

#include <QCoreApplication>
#include <QDir>
#include <QPainter>
#include <algorithm>
#include <array>

#include "core/presentation/manual/manual_picture.h"
#include "ui/canvas/mark_painter.h"

namespace geargraph {
namespace {

constexpr QSize kDrawing{540, 300};
constexpr double kPictureMargin = 12;  ///< sheet units round the drawing
constexpr double kLargestScale = 1.0;  ///< small drawings are not blown up

QImage painted(const QString& name, Theme theme, QSize size, double pixelRatio) {
  QImage image(size * pixelRatio, QImage::Format_ARGB32_Premultiplied);
  image.setDevicePixelRatio(pixelRatio);
  image.fill(Qt::transparent);
  const auto list = manualPicture(name.toStdString());
  if (!list) return image;
  const QRectF all =
      toQRect(extentOf(*list)).adjusted(-kPictureMargin, -kPictureMargin, kPictureMargin, kPictureMargin);
  const double scale = std::min({size.width() / all.width(), size.height() / all.height(), kLargestScale});
  QPainter painter(&image);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
  painter.translate(QPointF(size.width(), size.height()) / 2);
  painter.scale(scale, scale);
  painter.translate(-all.center());
  paintMarks(painter, list->marks, theme, scale * pixelRatio);
  return image;
}

/// Beside the program in a build, or where it is installed.
QString pictureFile(const QString& name) {
  const QDir program(QCoreApplication::applicationDirPath());
  static constexpr std::array kFolders = {"manual/pictures", "../share/geargraph/manual/pictures"};
  for (const char* folder : kFolders) {
    const QString path = program.filePath(QLatin1String(folder) + QLatin1Char('/') + name);
    if (QFile::exists(path)) return path;
  }
  return {};
}

}  // namespace

HelpPictures::HelpPictures(QObject* parent) : QObject(parent) {
  m_pool.setMaxThreadCount(1);
}

HelpPictures::~HelpPictures() {
  m_pool.clear();
  m_pool.waitForDone();
}

QSize HelpPictures::drawingSize(int width) {
  const int fitting = std::min(kDrawing.width(), width);
  return {fitting, kDrawing.height() * fitting / kDrawing.width()};
}

QImage HelpPictures::drawing(const QString& name, Theme theme, QSize size, double pixelRatio) {
  const QString key =
      QStringLiteral("%1 %2 %3 %4").arg(name).arg(static_cast<int>(theme)).arg(size.width()).arg(pixelRatio);
  if (const auto made = m_made.constFind(key); made != m_made.constEnd()) return *made;
  QImage clear(size * pixelRatio, QImage::Format_ARGB32_Premultiplied);
  clear.setDevicePixelRatio(pixelRatio);
  clear.fill(Qt::transparent);
  m_made.insert(key, clear);
  ++m_underWay;
  m_pool.start([this, key, name, theme, size, pixelRatio] {
    const QImage picture = painted(name, theme, size, pixelRatio);
    // The destructor waits for this function, and with the object go the calls that are queued for it.
    QMetaObject::invokeMethod(this, [this, key, name, picture] { keep(key, name, picture); });
  });
  return clear;
}

void HelpPictures::keep(const QString& key, const QString& name, const QImage& picture) {
  --m_underWay;
  m_made.insert(key, picture);
  emit drawn(name);
}

QImage HelpPictures::ofWindow(const QString& name, Theme theme, int width, double pixelRatio) {
  const QLatin1String look(theme == Theme::light ? "light" : "dark");
  const QString file = pictureFile(QStringLiteral("window-%1-%2.png").arg(name, look));
  if (file.isEmpty()) return {};
  QImage picture(file);
  if (picture.isNull()) return {};
  const int pixels = std::min(picture.width(), qRound(width * pixelRatio));
  picture = picture.scaledToWidth(pixels, Qt::SmoothTransformation);
  picture.setDevicePixelRatio(pixelRatio);
  return picture;
}

}  // namespace geargraph

#include "moc_help_pictures.cpp"
