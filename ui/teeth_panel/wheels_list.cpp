#include "ui/teeth_panel/wheels_list.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QPainter>
#include <QPixmap>
#include <algorithm>

#include "core/presentation/drawing/palette.h"
#include "ui/teeth_panel/wheel_names.h"
#include "ui/theme/theme_colors.h"

namespace geargraph {
namespace {

constexpr int kDotSide = 12;

QPixmap linkDot(int colorNumber, double ratio) {
  QPixmap dot(QSize(kDotSide, kDotSide) * ratio);
  dot.setDevicePixelRatio(ratio);
  dot.fill(Qt::transparent);
  QPainter painter(&dot);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(qColor(linkColor(colorNumber)));
  painter.drawEllipse(QRectF(1, 1, kDotSide - 2, kDotSide - 2));
  return dot;
}

/// Does an equation of centre distances give these teeth once those before are chosen?
bool isDetermined(const TeethProblem& problem, const std::vector<int>& order, int wheel) {
  const auto placeOf = [&](int each) { return std::find(order.begin(), order.end(), each) - order.begin(); };
  return std::any_of(problem.sums.begin(), problem.sums.end(), [&](const SumCondition& sum) {
    const bool isOwn = std::any_of(sum.terms.begin(), sum.terms.end(),
                                   [&](const SumCondition::Term& term) { return term.wheel == wheel; });
    return isOwn && sum.low == sum.high &&
           std::all_of(sum.terms.begin(), sum.terms.end(),
                       [&](const SumCondition::Term& term) { return placeOf(term.wheel) <= placeOf(wheel); });
  });
}

/// What the rows are made of, besides numbers and ticks.
QStringList rowTexts(const TeethProblem& problem, const std::vector<WheelName>& names) {
  QStringList texts;
  for (std::size_t wheel = 0; wheel < names.size(); ++wheel)
    texts << QString::fromStdString(problem.wheels[wheel].name) << names[wheel].text << names[wheel].tip
          << QString::number(names[wheel].color)
          << (names[wheel].isPinned ? QStringLiteral("pinned") : QString());
  return texts;
}

}  // namespace

WheelsList::WheelsList(QWidget* parent) : QWidget(parent) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
}

void WheelsList::clear() {
  delete m_page;
  m_page = nullptr;
  m_rows.clear();
  m_shown.clear();
}

void WheelsList::reset() {
  m_kept.clear();
  clear();
}

void WheelsList::forgetUnknown(const Mechanism& mechanism) {
  const int first = mechanism.meshLabel(0);
  std::erase_if(m_kept, [&](const std::string& name) {
    const int mesh = QString::fromStdString(name).section(QLatin1Char(':'), 0, 0).toInt();
    return mesh < first || mesh >= first + mechanism.c();
  });
}

QLabel* WheelsList::addLabel(int row, int column, const QString& text, const QString& look) {
  auto* label = new QLabel(text, m_page);
  if (!look.isEmpty()) label->setProperty("look", look);
  m_grid->addWidget(label, row, column, column > 2 ? Qt::AlignRight | Qt::AlignVCenter : Qt::AlignVCenter);
  return label;
}

void WheelsList::makeRows(const TeethProblem& problem, const std::vector<WheelName>& names) {
  clear();
  m_shown = rowTexts(problem, names);
  m_page = new QWidget(this);
  m_grid = new QGridLayout(m_page);
  m_grid->setContentsMargins(0, 0, 0, 0);
  m_grid->setHorizontalSpacing(8);
  m_grid->setVerticalSpacing(3);
  m_grid->setColumnStretch(1, 1);
  addLabel(0, 3, tr("drawn"), QStringLiteral("hint"));
  m_title = addLabel(0, 4, {}, QStringLiteral("hint"));
  for (std::size_t wheel = 0; wheel < problem.wheels.size(); ++wheel) {
    const SearchedWheel& of = problem.wheels[wheel];
    const WheelName& name = names[wheel];
    const int line = static_cast<int>(wheel) + 1;
    addLabel(line, 0, {}, {})->setPixmap(linkDot(name.color, devicePixelRatioF()));
    auto* check = new QCheckBox(name.text, m_page);
    check->setObjectName(QStringLiteral("wheel.") + QString::fromStdString(of.name));
    check->setChecked(!of.isKept);
    check->setEnabled(!name.isPinned);
    check->setToolTip(name.isPinned ? tr("%1: pinned, it keeps its teeth").arg(name.tip)
                                    : tr("%1. Ticked: its teeth may change").arg(name.tip));
    connect(check, &QCheckBox::toggled, this, [this, name = of.name](bool isOn) {
      isOn ? void(m_kept.erase(name)) : void(m_kept.insert(name));
      emit edited();
    });
    m_grid->addWidget(check, line, 1);
    Row& row = m_rows.emplace_back(Row{of.name, of.drawn, nullptr, nullptr, nullptr});
    row.follows = addLabel(line, 2, name.isPinned ? tr("pinned") : QString(), QStringLiteral("hint"));
    row.now = addLabel(line, 3, QString::number(of.drawn), {});
    row.chosen = addLabel(line, 4, {}, QStringLiteral("title"));
    row.chosen->setObjectName(QStringLiteral("chosen.") + QString::fromStdString(of.name));
  }
  layout()->addWidget(m_page);
}

void WheelsList::setProblem(const TeethProblem& problem, const std::vector<int>& order) {
  const std::vector<WheelName> names = wheelNames(problem);
  // A box under the mouse is not made anew because it was ticked.
  if (m_page == nullptr || rowTexts(problem, names) != m_shown) makeRows(problem, names);
  for (std::size_t wheel = 0; wheel < m_rows.size(); ++wheel) {
    const SearchedWheel& of = problem.wheels[wheel];
    Row& row = m_rows[wheel];
    row.drawn = of.drawn;
    row.now->setText(QString::number(of.drawn));
    if (names[wheel].isPinned) continue;
    const bool follows =
        !order.empty() && !of.isKept && isDetermined(problem, order, static_cast<int>(wheel));
    row.follows->setText(follows ? QStringLiteral("=") : QString());
    row.follows->setToolTip(follows ? tr("Its teeth follow from the others: one distance between two axes")
                                    : QString());
  }
}

void WheelsList::setChosen(const std::vector<int>& teeth, const QString& title) {
  if (m_page == nullptr) return;
  m_title->setText(title);
  for (std::size_t wheel = 0; wheel < m_rows.size(); ++wheel) {
    const bool isThere = wheel < teeth.size();
    m_rows[wheel].chosen->setText(isThere ? QStringLiteral("→ %1").arg(teeth[wheel]) : QString());
  }
}

}  // namespace geargraph

#include "moc_wheels_list.cpp"
