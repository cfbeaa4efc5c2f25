#include "ui/theme/icons.h"

#include <QCoreApplication>
#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QPixmapCache>
#include <QSvgRenderer>
#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "ui/theme/theme_colors.h"

namespace geargraph {
namespace {

/// @param side in pixels of the device
QPixmap drawnNow(const QString& name, const QColor& color, int side) {
  QFile file(QStringLiteral(":/icons/%1.svg").arg(name));
  if (side <= 0 || !file.open(QIODevice::ReadOnly)) return {};
  QSvgRenderer renderer(file.readAll().replace("currentColor", color.name().toLatin1()));
  QPixmap pixmap(side, side);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  renderer.render(&painter);
  return pixmap;
}

QPixmap drawn(const QString& name, const QColor& color, int pixels, qreal ratio) {
  const QString key = QStringLiteral("geargraph/%1/%2/%3/%4").arg(name, color.name()).arg(pixels).arg(ratio);
  QPixmap pixmap;
  if (QPixmapCache::find(key, &pixmap)) return pixmap;
  pixmap = drawnNow(name, color, qRound(pixels * ratio));
  if (pixmap.isNull()) return {};
  pixmap.setDevicePixelRatio(ratio);
  QPixmapCache::insert(key, pixmap);
  return pixmap;
}

/// Draws an icon when it is first shown, in the size and the state that is shown: all of them would be 18
/// pictures for each of 20 icons, 40 ms when a theme is chosen for the first time.
class IconEngine : public QIconEngine {
 public:
  IconEngine(QString name, ColorRole role, Theme theme)
      : m_name(std::move(name)), m_role(role), m_theme(theme) {}

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    const ColorRole role = mode == QIcon::Disabled ? ColorRole::hairline
                           : state == QIcon::On    ? ColorRole::accent
                                                   : m_role;
    const int side = std::min(size.width(), size.height());
    const auto [place, isNew] = m_pixmaps.try_emplace({side, role});
    if (isNew) place->second = drawnNow(m_name, qColor(role, m_theme), side);
    return place->second;
  }

  /// As high as it is wide.
  QSize actualSize(const QSize& size, QIcon::Mode /*mode*/, QIcon::State /*state*/) override {
    const int side = std::min(size.width(), size.height());
    return {side, side};
  }

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
    const qreal ratio = painter->device()->devicePixelRatio();
    painter->drawPixmap(rect, pixmap((QSizeF(rect.size()) * ratio).toSize(), mode, state));
  }

  [[nodiscard]] QIconEngine* clone() const override { return new IconEngine(*this); }

 private:
  QString m_name;
  ColorRole m_role;
  Theme m_theme;
  std::map<std::pair<int, ColorRole>, QPixmap> m_pixmaps;
};

/// All icons that were asked for, by name, role and theme, with their pictures. QPixmapCache drops what
/// nothing has shown for a while, such as those of the other themes.
class KeptIcons {
 public:
  using Key = std::tuple<QString, ColorRole, Theme>;

  static KeptIcons& instance() {
    static KeptIcons icons;
    return icons;
  }

  QIcon operator()(const QString& name, ColorRole role, Theme theme) {
    const auto [place, isNew] = m_icons.try_emplace(Key(name, role, theme));
    if (isNew) place->second = QIcon(new IconEngine(name, role, theme));
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

}  // namespace geargraph
