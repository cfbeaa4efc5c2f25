#include "ui/designer/hit_pictures.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPointer>
#include <QThreadPool>
#include <algorithm>

#include "core/presentation/diagrams/lever_layout.h"
#include "core/presentation/export_api/levers_json.h"
#include "core/presentation/schematic/schematic.h"
#include "core/theory/analysis/analysis.h"
#include "ui/canvas/mark_painter.h"
#include "ui/theme/theme_colors.h"

namespace geargraph {
namespace {

constexpr double kRoomBeside = 8;  // px
constexpr double kDisc = 3.5;
constexpr double kBarWidth = 3;
constexpr double kBandWidth = 3;

QColor colorOfLink(const Mechanism& mechanism, LinkOrdinal link) {
  return toQColor(linkColor(mechanism.colorNumber(link)));
}

/// The levers without numbers: bars, ties in the colours of their links, input and output filled.
void paintLevers(QPainter& painter, const Mechanism& mechanism, const LeverPicture& picture,
                 const QRectF& area, Theme theme) {
  const LeverLayout layout = leverLayout(mechanism, picture.plan);
  if (layout.bars.empty()) return;
  const QRectF room = area.adjusted(kRoomBeside, kRoomBeside, -kRoomBeside, -kRoomBeside);
  const double height = std::max(layout.height.toDouble(), 1e-9);
  const double step = layout.bars.size() > 1 ? room.width() / static_cast<double>(layout.bars.size() - 1) : 0;
  const auto spot = [&](std::size_t bar, const Rational& at) {
    const double x =
        layout.bars.size() > 1 ? room.left() + step * static_cast<double>(bar) : room.center().x();
    return QPointF(x, room.bottom() - room.height() * at.toDouble() / height);
  };
  const auto leverOf = [&](std::size_t bar) -> const Lever& {
    return picture.plan.levers[static_cast<std::size_t>(layout.bars[bar].lever)];
  };
  const auto spotOf = [&](int bar, LinkOrdinal link) -> std::optional<QPointF> {
    const auto position = static_cast<std::size_t>(bar);
    const LeverPoint* const point = leverOf(position).pointOf(link);
    if (point == nullptr) return std::nullopt;
    return spot(position, layout.bars[position].heightOf(*point));
  };
  for (const BarTie& tie : layout.ties) {
    const auto from = spotOf(tie.from, tie.link);
    const auto to = spotOf(tie.to, tie.link);
    QColor color = colorOfLink(mechanism, tie.link);
    color.setAlphaF(0.6F);
    painter.setPen(QPen(color, kBandWidth));
    if (from && to) painter.drawLine(*from, *to);
  }
  painter.setPen(QPen(qColor(theme == Theme::light ? ColorRole::ink : ColorRole::secondary, theme), kBarWidth,
                      Qt::SolidLine, Qt::RoundCap));
  for (std::size_t bar = 0; bar < layout.bars.size(); ++bar) {
    const BarPlace& place = layout.bars[bar];
    painter.drawLine(spot(bar, place.bottom), spot(bar, place.bottom + place.length));
  }
  for (std::size_t bar = 0; bar < layout.bars.size(); ++bar) {
    for (const LeverPoint& point : leverOf(bar).points) {
      const LinkOrdinal link = point.links.front();
      const bool isInput = std::any_of(point.links.begin(), point.links.end(), [&](LinkOrdinal each) {
        return std::find(picture.inputs.begin(), picture.inputs.end(), each) != picture.inputs.end();
      });
      const bool isOutput = picture.output && std::find(point.links.begin(), point.links.end(),
                                                        *picture.output) != point.links.end();
      const QPointF center = spot(bar, layout.bars[bar].heightOf(point));
      const bool isGround = link == LinkOrdinal(0);
      painter.setPen(QPen(isGround ? qColor(ColorRole::ink, theme) : colorOfLink(mechanism, link), 1.8));
      painter.setBrush(isInput    ? qColor(ColorRole::input, theme)
                       : isOutput ? qColor(ColorRole::ink, theme)
                                  : qColor(ColorRole::sheet, theme));
      isGround ? painter.drawRect(QRectF(center - QPointF(kDisc, kDisc), QSizeF(2 * kDisc, 2 * kDisc)))
               : painter.drawEllipse(center, kDisc, kDisc);
    }
  }
}

QImage emptyImage(QSize size, qreal ratio) {
  QImage image(size * ratio, QImage::Format_ARGB32_Premultiplied);
  image.setDevicePixelRatio(ratio);
  image.fill(Qt::transparent);
  return image;
}

HitPictures::Pair drawnPictures(const GearboxWish& wish, const Gearbox& gearbox, Theme theme, qreal ratio) {
  const auto document = std::make_shared<const Mechanism>(gearboxDocument(wish, gearbox));
  HitPictures::Pair pictures{emptyImage(HitPictures::kLevers, ratio),
                             emptyImage(HitPictures::kSchematic, ratio)};
  {
    QPainter painter(&pictures.levers);
    painter.setRenderHint(QPainter::Antialiasing);
    if (const auto levers = leverPictureOf(*analyze(document)))
      paintLevers(painter, *document, *levers, QRectF({}, QSizeF(HitPictures::kLevers)), theme);
  }
  QPainter painter(&pictures.schematic);
  painter.setRenderHint(QPainter::Antialiasing);
  const DisplayList drawing = schematicDrawing(schematicGeometry(*document), {});
  paintFitted(painter, drawing, QRectF({}, QSizeF(HitPictures::kSchematic)), theme, 1);
  return pictures;
}

}  // namespace

void HitPictures::startAnew(GearboxWishPtr wish) {
  m_wish = std::move(wish);
  m_pictures.clear();
  m_waiting.clear();
}

HitPictures::Pair HitPictures::of(const GearboxPtr& gearbox, Theme theme, qreal devicePixelRatio) {
  const Look look{theme, devicePixelRatio};
  if (!(look == m_look)) {
    m_look = look;
    m_pictures.clear();
    m_waiting.clear();
  }
  if (const auto found = m_pictures.find(gearbox); found != m_pictures.end()) return found->second;
  if (!m_waiting.insert(gearbox).second) return {};
  QThreadPool::globalInstance()->start([self = QPointer<HitPictures>(this), wish = m_wish, gearbox, look] {
    const Pair pictures = drawnPictures(*wish, *gearbox, look.theme, look.ratio);
    QMetaObject::invokeMethod(qApp, [self, gearbox, look, pictures] {
      if (self) self->take(gearbox, look, pictures);
    });
  });
  return {};
}

/// One that belongs to an earlier list or another look is dropped.
void HitPictures::take(const GearboxPtr& gearbox, const Look& look, const Pair& pictures) {
  if (!(look == m_look) || m_waiting.erase(gearbox) == 0) return;
  m_pictures[gearbox] = pictures;
  emit drawn();
}

}  // namespace geargraph

#include "moc_hit_pictures.cpp"
