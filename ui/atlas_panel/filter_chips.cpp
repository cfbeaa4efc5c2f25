#include "ui/atlas_panel/filter_chips.h"

#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QToolButton>

namespace geargraph {

FilterChips::FilterChips(const QString& name, const QString& title, QWidget* parent)
    : QWidget(parent), m_name(name), m_layout(new QGridLayout(this)) {
  m_layout->setContentsMargins(0, 0, 0, 0);
  m_layout->setHorizontalSpacing(3);
  m_layout->setVerticalSpacing(1);
  auto* heading = new QLabel(title, this);
  heading->setProperty("look", "hint");
  m_layout->addWidget(heading, 0, 0, 1, -1);
}

FilterChips::Chip& FilterChips::chipOf(int choice) {
  Chip& chip = m_chips[choice];
  if (chip.button != nullptr) return chip;
  const auto text = m_texts.find(choice);
  chip.button = new QToolButton(this);
  chip.button->setObjectName(QStringLiteral("%1.%2").arg(m_name).arg(choice));
  chip.button->setText(text == m_texts.end() ? QString::number(choice) : text->second);
  chip.button->setProperty("look", "chip");
  chip.button->setCheckable(true);
  chip.button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  chip.count = new QLabel(this);
  chip.count->setProperty("look", "hint");
  chip.count->setAlignment(Qt::AlignCenter);
  constexpr int kInRow = 4;
  const int place = static_cast<int>(m_chips.size()) - 1;
  m_layout->addWidget(chip.button, 1 + 2 * (place / kInRow), place % kInRow);
  m_layout->addWidget(chip.count, 2 + 2 * (place / kInRow), place % kInRow);
  connect(chip.button, &QToolButton::clicked, this, [this, choice](bool isOn) {
    setChoice(isOn ? std::optional(choice) : std::nullopt);
    emit changed();
  });
  return chip;
}

void FilterChips::setCounts(const std::map<int, int>& counts) {
  m_counts = counts;
  for (const auto& [choice, count] : counts) {
    const Chip& chip = chipOf(choice);
    chip.count->setText(locale().toString(count));
    chip.button->setAccessibleDescription(tr("%1 chains").arg(count));
    // What is chosen stays within reach, to be let go of.
    chip.button->setEnabled(count > 0 || m_choice == choice);
  }
}

void FilterChips::setChoice(const std::optional<int>& choice) {
  m_choice = choice;
  for (const auto& [each, chip] : m_chips) chip.button->setChecked(choice == each);
}

int FilterChips::countOf(int choice) const {
  const auto found = m_counts.find(choice);
  return found == m_counts.end() ? -1 : found->second;
}

}  // namespace geargraph

#include "moc_filter_chips.cpp"
