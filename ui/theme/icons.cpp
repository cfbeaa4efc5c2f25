#include "ui/theme/icons.h"

#include <QFile>
#include <QPainter>
#include <QPixmapCache>
#include <QSvgRenderer>

#include "ui/theme/theme_colors.h"

namespace geargraph::inline theme {
namespace {

QPixmap drawn(const QString& name, const QColor& color, int pixels, qreal ratio) {
  const QString key = QStringLiteral("geargraph/%1/%2/%3/%4").arg(name, color.name()).arg(pixels).arg(ratio);
  QPixmap pixmap;
  if (QPixmapCache::find(key, &pixmap)) return pixmap;
  QFile file(QStringLiteral(":/icons/%1.svg").arg(name));
  if (!file.open(QIODevice::ReadOnly)) return {};
  QSvgRenderer renderer(file.readAll().replace("currentColor", color.name().toLatin1()));
  const int side = qRound(pixels * ratio);
  pixmap = QPixmap(side, side);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  renderer.render(&painter);
  painter.end();
  pixmap.setDevicePixelRatio(ratio);
  QPixmapCache::insert(key, pixmap);
  return pixmap;
}

}  // namespace

QIcon icon(const QString& name, ColorRole role, Theme theme) {
  QIcon result;
  for (const int pixels : {16, 20, 32}) {
    for (const qreal ratio : {1.0, 2.0}) {
      result.addPixmap(drawn(name, qColor(role, theme), pixels, ratio), QIcon::Normal, QIcon::Off);
      result.addPixmap(drawn(name, qColor(ColorRole::accent, theme), pixels, ratio), QIcon::Normal,
                       QIcon::On);
      result.addPixmap(drawn(name, qColor(ColorRole::hairline, theme), pixels, ratio), QIcon::Disabled);
    }
  }
  return result;
}

QPixmap iconPixmap(const QString& name, ColorRole role, Theme theme, int pixels, qreal devicePixelRatio) {
  return drawn(name, qColor(role, theme), pixels, devicePixelRatio);
}

QString severityIconName(Severity severity) {
  switch (severity) {
    case Severity::error:
      return QStringLiteral("error");
    case Severity::warning:
      return QStringLiteral("warning");
    case Severity::info:
      break;
  }
  return QStringLiteral("info");
}

ColorRole severityRole(Severity severity) {
  switch (severity) {
    case Severity::error:
      return ColorRole::error;
    case Severity::warning:
      return ColorRole::warning;
    case Severity::info:
      break;
  }
  return ColorRole::accent;
}

QIcon applicationIcon() {
  QIcon result;
  for (const int pixels : {16, 32, 64, 128}) {
    result.addPixmap(drawn(QStringLiteral("geargraph"), qColor(linkColor(1)), pixels, 1.0));
  }
  return result;
}

}  // namespace geargraph::inline theme
