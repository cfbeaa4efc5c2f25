#include "ui/theme/icons.h"

#include <QCoreApplication>
#include <QFile>
#include <QPainter>
#include <QPixmapCache>
#include <QSvgRenderer>
#include <map>
#include <tuple>

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

QIcon madeIcon(const QString& name, ColorRole role, Theme theme) {
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

/// All icons that were asked for, by name, role and theme: about 100 kB each. QPixmapCache drops what nothing
/// has shown for a while, such as those of the other themes.
class KeptIcons {
 public:
  using Key = std::tuple<QString, ColorRole, Theme>;

  static KeptIcons& instance() {
    static KeptIcons icons;
    return icons;
  }

  QIcon operator()(const QString& name, ColorRole role, Theme theme) {
    const auto [place, isNew] = m_icons.try_emplace(Key(name, role, theme));
    if (isNew) place->second = madeIcon(name, role, theme);
    return place->second;
  }

 private:
  // Pixmaps go before the application does.
  KeptIcons() {
    qAddPostRoutine([] { instance().m_icons.clear(); });
  }

  std::map<Key, QIcon> m_icons;
};

}  // namespace

QIcon icon(const QString& name, ColorRole role, Theme theme) {
  return KeptIcons::instance()(name, role, theme);
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
