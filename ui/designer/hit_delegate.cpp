// The cells of the list of gearboxes.

#include <QPainter>
#include <QStyle>
#include <QStyleOptionButton>
#include <QWidget>
#include <algorithm>

#include "ui/designer/hit_words.h"
#include "ui/designer/hits_table.h"
#include "ui/theme/looks.h"
#include "ui/theme/theme_colors.h"

namespace geargraph {
namespace {

constexpr int kGearStep = 14;  // px at the usual size of type
constexpr int kElementStep = 11;
constexpr int kDotsMargin = 8;
constexpr int kTick = 16;
constexpr int kTickTop = 36;
constexpr int kFirstLine = 10;
constexpr int kLineHeight = 18;

const GearboxPtr& hitIn(const QModelIndex& index) {
  return static_cast<const ShownHits*>(index.model())->at(index);
}

}  // namespace

QRect HitDelegate::tickBox(const QRect& cell) {
  const int side = scaledPixels(kTick);
  return {cell.left() + scaledPixels(kDotsMargin), cell.top() + scaledPixels(kTickTop), side, side};
}

void HitDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                        const QModelIndex& index) const {
  const Theme theme = themeOf(option.palette);
  const GearboxPtr& hit = hitIn(index);
  painter->save();
  painter->setLayoutDirection(Qt::LeftToRight);
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setFont(option.font);
  if (option.state & QStyle::State_Selected) painter->fillRect(option.rect, chosenColor(theme));
  switch (index.column()) {
    case HitsModel::number:
      paintNumber(*painter, option, index);
      break;
    case HitsModel::levers:
    case HitsModel::schematic: {
      const auto pictures = m_pictures->of(hit, theme, painter->device()->devicePixelRatioF());
      const QImage& picture = index.column() == HitsModel::levers ? pictures.levers : pictures.schematic;
      QRect place({}, HitPictures::kLevers);
      place.moveCenter(option.rect.center());
      if (!picture.isNull()) painter->drawImage(place, picture);
      break;
    }
    case HitsModel::elements:
      paintDots(*painter, option, *hit);
      break;
    case HitsModel::drawable:
      painter->setPen(qColor(hit->brokenRule ? ColorRole::secondary : ColorRole::fine, theme));
      painter->drawText(option.rect, Qt::AlignCenter, index.data().toString());
      break;
    default:
      paintMeasure(*painter, option, index);
  }
  painter->restore();
}

void HitDelegate::paintNumber(QPainter& painter, const QStyleOptionViewItem& option,
                              const QModelIndex& index) const {
  const Theme theme = themeOf(option.palette);
  QFont bold = option.font;
  bold.setBold(true);
  painter.setFont(bold);
  const bool isChosen = option.state & QStyle::State_Selected;
  painter.setPen(qColor(isChosen ? ColorRole::accent : ColorRole::ink, theme));
  const QRect box = tickBox(option.rect);
  painter.drawText(QRect(box.left(), option.rect.top() + scaledPixels(kFirstLine), option.rect.width(),
                         scaledPixels(kLineHeight)),
                   Qt::AlignLeft | Qt::AlignVCenter, index.data().toString());
  QStyleOptionButton tick;
  tick.initFrom(option.widget);
  tick.rect = box;
  const bool isTicked = index.data(Qt::CheckStateRole).toInt() == Qt::Checked;
  tick.state = QStyle::State_Enabled | (isTicked ? QStyle::State_On : QStyle::State_Off);
  option.widget->style()->drawPrimitive(QStyle::PE_IndicatorCheckBox, &tick, &painter, option.widget);
}

void HitDelegate::paintMeasure(QPainter& painter, const QStyleOptionViewItem& option,
                               const QModelIndex& index) const {
  const Theme theme = themeOf(option.palette);
  const QRect line(option.rect.left(), option.rect.top() + scaledPixels(kFirstLine),
                   option.rect.width() - scaledPixels(kDotsMargin), scaledPixels(kLineHeight));
  QFont font = option.font;
  font.setBold(index.column() == HitsModel::error || index.column() == HitsModel::efficiency);
  painter.setFont(font);
  const bool isWarning = index.data(HitsModel::WarningRole).toBool();
  painter.setPen(qColor(isWarning ? ColorRole::warning : ColorRole::ink, theme));
  painter.drawText(line, Qt::AlignRight | Qt::AlignVCenter, index.data(HitsModel::ValueRole).toString());
  font.setBold(false);
  font.setPixelSize(smallPixels());
  painter.setFont(font);
  painter.setPen(qColor(isWarning ? ColorRole::warning : ColorRole::secondary, theme));
  painter.drawText(line.translated(0, line.height()), Qt::AlignRight | Qt::AlignVCenter,
                   index.data(HitsModel::GearRole).toString());
}

void HitDelegate::paintDots(QPainter& painter, const QStyleOptionViewItem& option, const Gearbox& hit) const {
  const Theme theme = themeOf(option.palette);
  const int gearStep = scaledPixels(kGearStep);
  const int elementStep = scaledPixels(kElementStep);
  QFont small = option.font;
  small.setPixelSize(smallPixels() - 2);
  painter.setFont(small);
  const int left = option.rect.left() + kDotsMargin;
  const int top = option.rect.top() + kDotsMargin / 2;
  const auto elements = static_cast<int>(hit.elements.size());
  for (std::size_t g = 0; g < hit.gears.size(); ++g) {
    const GearState& gear = hit.gears[g];
    const int x = left + static_cast<int>(g) * gearStep;
    painter.setPen(qColor(ColorRole::secondary, theme));
    painter.drawText(QRect(x, top, gearStep, elementStep), Qt::AlignCenter,
                     QString::fromStdString(gear.name));
    painter.setPen(Qt::NoPen);
    for (int element = 0; element < elements; ++element) {
      const bool isEngaged =
          std::find(gear.engaged.begin(), gear.engaged.end(), element) != gear.engaged.end();
      const QPointF center(x + gearStep / 2.0, top + (element + 1.5) * elementStep);
      const double radius = isEngaged ? elementStep * 0.36 : elementStep * 0.1;
      painter.setBrush(qColor(isEngaged ? ColorRole::ink : ColorRole::secondary, theme));
      painter.drawEllipse(center, radius, radius);
    }
  }
  painter.setPen(qColor(ColorRole::secondary, theme));
  const int letters = left + static_cast<int>(hit.gears.size()) * gearStep + 3;
  for (int element = 0; element < elements; ++element) {
    painter.drawText(QRect(letters, top + (element + 1) * elementStep, gearStep, elementStep),
                     Qt::AlignCenter, elementLetter(element));
  }
}

QSize HitDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
  const QFontMetrics metrics(option.font);
  switch (index.column()) {
    case HitsModel::number:
      return {scaledPixels(kTick + 2 * kDotsMargin + 4), scaledPixels(kTickTop + kTick)};
    case HitsModel::levers:
      return HitPictures::kLevers;
    case HitsModel::schematic:
      return HitPictures::kSchematic;
    case HitsModel::elements: {
      const Gearbox& hit = *hitIn(index);
      return {2 * kDotsMargin + (static_cast<int>(hit.gears.size()) + 1) * scaledPixels(kGearStep),
              kDotsMargin + (static_cast<int>(hit.elements.size()) + 1) * scaledPixels(kElementStep) + 4};
    }
    case HitsModel::drawable:
      return {scaledPixels(kTick + kDotsMargin), scaledPixels(kTick)};
    default: {
      QFont bold = option.font;
      bold.setBold(true);
      const int value = QFontMetrics(bold).horizontalAdvance(index.data(HitsModel::ValueRole).toString());
      const int gear = metrics.horizontalAdvance(index.data(HitsModel::GearRole).toString());
      return {std::max(value, gear) + scaledPixels(2 * kDotsMargin), scaledPixels(3 * kLineHeight)};
    }
  }
}

}  // namespace geargraph
