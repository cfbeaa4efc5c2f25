#include "ui/teeth_panel/ratio_row.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpression>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>

#include "core/foundations/base/locale.h"
#include "core/foundations/files/json_writer.h"
#include "ui/document/typed_length.h"
#include "ui/models/printed_number.h"
#include "ui/models/term_tips.h"
#include "ui/theme/control_button.h"
#include "ui/theme/looks.h"
#include "ui/theme/theme_colors.h"

namespace geargraph {
namespace {

constexpr int kMaxOffered = 500;  // links in a list; thousands take half a second, and nobody reads them
const QString kEngaged = QStringLiteral("engaged");  // what a condition is, in its list
const QString kHeld = QStringLiteral("held");
const QString kState = QStringLiteral("state:");

QString offeredText(const Mechanism& mechanism, int position) {
  const QString label = QString::number(mechanism.linkLabel(position));
  const QString name = shownText(mechanism.links[static_cast<std::size_t>(position)].name).simplified();
  return name.isEmpty() || name == label ? label : label + QLatin1Char(' ') + name;
}

QComboBox* makeOffer(const QString& name, const QString& tip, QWidget* parent) {
  auto* box = new QComboBox(parent);
  box->setObjectName(name);
  box->setToolTip(tip);
  box->setAccessibleName(tip);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(7);
  return box;
}

QLineEdit* makeTyped(const QString& name, const QString& tip, QWidget* parent) {
  auto* field = new QLineEdit(parent);
  field->setObjectName(name);
  field->setToolTip(tip);
  field->setAccessibleName(tip);
  field->setMaxLength(kMaxTyped);
  return field;
}

void writeLink(JsonWriter& json, std::string_view name, const QComboBox& box) {
  json.member(name, box.currentData().toString().toStdString());
}

}  // namespace

std::string plainNumber(const QString& typed) {
  QString text = typed.trimmed();
  text.replace(QLatin1Char(','), QLatin1Char('.'));
  text.replace(QChar(0x2212), QLatin1Char('-'));
  return text.toStdString();
}

void markField(QLineEdit& field, bool isWrong) {
  QPalette palette;
  if (isWrong) palette.setColor(QPalette::Text, qColor(ColorRole::error, themeOf(field.palette())));
  field.setPalette(palette);
}

RatioRow::RatioRow(int number, QWidget* parent)
    : QWidget(parent),
      m_drive(makeOffer(QStringLiteral("drive.%1").arg(number), tr("The link that drives"), this)),
      m_driven(makeOffer(QStringLiteral("driven.%1").arg(number), tr("The link that is driven"), this)),
      m_condition(makeOffer(QStringLiteral("condition.%1").arg(number),
                            tr("In which state the ratio is wanted, or which links are held"), this)),
      m_held(makeTyped(QStringLiteral("held.%1").arg(number),
                       tr("The numbers of the links that are held, such as 2 4"), this)),
      m_ratio(makeTyped(QStringLiteral("ratio.%1").arg(number),
                        tr("Speed of the drive over that of the driven link: 64, 9/2 or 0.632"), this)),
      m_tolerance(makeTyped(QStringLiteral("tolerance.%1").arg(number),
                            tr("How far the ratio may be missed: 0.5 % of it, or by a number such as 0.01. "
                               "Empty: a decimal is taken as rounded, any other ratio is wanted exactly"),
                            this)),
      m_now(new QLabel(this)),
      m_remove(controlButton(QStringLiteral("removeRatio.%1").arg(number), QStringLiteral("×"),
                             tr("Remove this ratio"), this)),
      m_problem(new QLabel(this)) {
  m_tolerance->setText(shownText(localizedNumber("0.5")) + QStringLiteral(" %"));
  m_ratio->setPlaceholderText(tr("ratio"));
  m_held->setPlaceholderText(tr("such as 2 4"));
  m_held->hide();
  m_now->setProperty("look", "hint");
  m_now->setObjectName(QStringLiteral("now.%1").arg(number));
  m_remove->setAccessibleName(m_remove->toolTip());
  m_problem->setObjectName(QStringLiteral("problem.%1").arg(number));
  m_problem->setProperty("look", "problem");
  m_problem->setWordWrap(true);
  m_problem->hide();

  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 4);
  grid->setHorizontalSpacing(6);
  grid->setVerticalSpacing(4);
  grid->addWidget(m_drive, 0, 0);
  grid->addWidget(new QLabel(tr("over"), this), 0, 1);
  grid->addWidget(m_driven, 0, 2);
  grid->addWidget(m_condition, 1, 0, 1, 3);
  grid->addWidget(m_held, 2, 0, 1, 3);
  grid->addWidget(m_ratio, 3, 0);
  grid->addWidget(new QLabel(QStringLiteral("±"), this), 3, 1, Qt::AlignCenter);
  grid->addWidget(m_tolerance, 3, 2);
  auto* end = new QHBoxLayout;
  end->setContentsMargins(0, 0, 0, 0);
  end->addWidget(m_now, 1);
  end->addWidget(m_remove);
  grid->addLayout(end, 4, 0, 1, 3);
  grid->addWidget(m_problem, 5, 0, 1, 3);
  grid->setColumnStretch(0, 1);
  grid->setColumnStretch(2, 1);

  for (QComboBox* box : {m_drive, m_driven}) connect(box, &QComboBox::activated, this, &RatioRow::edited);
  connect(m_condition, &QComboBox::activated, this, [this] {
    onCondition();
    emit edited();
  });
  for (QLineEdit* field : {m_held, m_ratio, m_tolerance})
    connect(field, &QLineEdit::textEdited, this, &RatioRow::edited);
  connect(m_remove, &QToolButton::clicked, this, &RatioRow::removeWanted);
}

/// During a drag the texts stay the same, and so does the list.
void RatioRow::offer(QComboBox& box, const Mechanism& mechanism) {
  QStringList texts;
  for (int link = 1; link <= std::min(mechanism.n(), kMaxOffered); ++link)
    texts << offeredText(mechanism, link);
  bool isSame = box.count() == texts.size();
  for (int item = 0; isSame && item < box.count(); ++item) isSame = box.itemText(item) == texts[item];
  if (isSame) return;
  const QVariant chosen = box.currentData();
  box.clear();
  for (int item = 0; item < static_cast<int>(texts.size()); ++item)
    box.addItem(texts[item], QString::number(mechanism.linkLabel(item + 1)));
  box.setCurrentIndex(box.findData(chosen));
}

void RatioRow::setMechanism(const Mechanism& mechanism) {
  const QSignalBlocker quiet[] = {QSignalBlocker(m_drive), QSignalBlocker(m_driven),
                                  QSignalBlocker(m_condition)};
  const QVariant condition = m_condition->currentData();
  m_condition->clear();
  for (const ShiftState& state : mechanism.states)
    m_condition->addItem(tr("in state %1").arg(shownText(state.name)),
                         kState + QString::fromStdString(state.name));
  m_condition->addItem(tr("as engaged now"), kEngaged);
  m_condition->addItem(tr("with links held:"), kHeld);
  m_condition->setCurrentIndex(m_condition->findData(condition));
  offer(*m_drive, mechanism);
  offer(*m_driven, mechanism);
  chooseUsual(mechanism);
  onCondition();
}

/// The first state with its links, or the first input and the link that its joint is not of.
void RatioRow::chooseUsual(const Mechanism& mechanism) {
  if (m_condition->currentIndex() < 0) m_condition->setCurrentIndex(0);
  const auto choose = [&](QComboBox& box, const std::optional<LinkId>& link) {
    if (box.currentIndex() >= 0 || !link) return;
    for (int position = 1; position <= mechanism.n(); ++position)
      if (mechanism.links[static_cast<std::size_t>(position)].id == *link)
        box.setCurrentIndex(box.findData(QString::number(mechanism.linkLabel(position))));
  };
  if (!mechanism.states.empty()) {
    choose(*m_drive, mechanism.states.front().drive);
    choose(*m_driven, mechanism.states.front().driven);
  }
  if (m_drive->currentIndex() < 0) m_drive->setCurrentIndex(0);
  if (m_driven->currentIndex() < 0) {
    const int last = m_driven->count() - 1;
    m_driven->setCurrentIndex(last == m_drive->currentIndex() ? 0 : last);
  }
}

void RatioRow::onCondition() {
  m_held->setVisible(m_condition->currentData().toString() == kHeld);
}

void RatioRow::askForRatio() {
  m_ratio->setFocus();
  m_ratio->selectAll();
}

bool RatioRow::hasRatio() const {
  return !m_ratio->text().trimmed().isEmpty();
}

void RatioRow::write(JsonWriter& json) const {
  json.beginObject(JsonWriter::Layout::row);
  const QString condition = m_condition->currentData().toString();
  if (condition.startsWith(kState)) json.member("state", condition.mid(kState.size()).toStdString());
  writeLink(json, "drive", *m_drive);
  writeLink(json, "driven", *m_driven);
  if (condition == kHeld) {
    json.key("held");
    json.beginArray(JsonWriter::Layout::row);
    static const QRegularExpression between(QStringLiteral("[\\s,;]+"));
    for (const QString& label : m_held->text().split(between, Qt::SkipEmptyParts))
      json.string(label.toStdString());
    json.endArray();
  }
  const std::string typed = plainNumber(m_ratio->text());
  const auto ratio = Rational::fromText(typed);
  std::string tolerance = plainNumber(m_tolerance->text());
  const bool isShare = !tolerance.empty() && tolerance.back() == '%';
  if (isShare) tolerance = plainNumber(QString::fromStdString(tolerance).chopped(1));
  const auto allowed = Rational::fromText(tolerance);
  if (typed.empty()) {
    json.member("ratio", "1");
  } else if (ratio && !ratio->isZero() && allowed && !isShare && allowed->sign() > 0) {
    json.key("between");
    json.beginArray(JsonWriter::Layout::row);
    json.string((*ratio - *allowed).toString());
    json.string((*ratio + *allowed).toString());
    json.endArray();
  } else {
    json.member("ratio", typed);
    if (!tolerance.empty())
      json.member("tolerance", allowed && isShare ? (*allowed / Rational(100)).toString() : tolerance);
  }
  json.endObject();
}

void RatioRow::setRatioNow(const std::optional<Rational>& ratio) {
  m_now->setText(ratio ? tr("now %1").arg(printedFraction(*ratio)) : QString());
}

QLineEdit* RatioRow::fieldOf(const QString& member) const {
  if (member == QLatin1String("ratio")) return m_ratio;
  if (member == QLatin1String("tolerance") || member == QLatin1String("between")) return m_tolerance;
  return member == QLatin1String("held") ? m_held : nullptr;
}

void RatioRow::setProblem(const QString& member, const QString& text) {
  for (QLineEdit* field : {m_held, m_ratio, m_tolerance})
    markField(*field, !text.isEmpty() && field == fieldOf(member));
  m_problem->setText(text);
  m_problem->setVisible(!text.isEmpty());
}

void RatioRow::setRemovable(bool isRemovable) {
  m_remove->setVisible(isRemovable);
}

}  // namespace geargraph

#include "moc_ratio_row.cpp"
