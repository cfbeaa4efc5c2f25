#include "ui/forces/folding_section.h"

#include <QBoxLayout>
#include <QToolButton>

namespace geargraph {

FoldingSection::FoldingSection(const QString& name, const QString& title, const QString& tip,
                               QWidget* content, QWidget* parent)
    : QWidget(parent), m_title(new QToolButton(this)), m_text(title), m_content(content) {
  m_title->setObjectName(name);
  m_title->setAccessibleName(title);
  m_title->setToolTip(tip);
  m_title->setCheckable(true);
  m_title->setChecked(true);
  m_title->setProperty("look", "flat");
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 0, 8, 0);
  layout->setSpacing(2);
  layout->addWidget(m_title, 0, Qt::AlignLeft);
  layout->addWidget(content);
  connect(m_title, &QToolButton::toggled, this, &FoldingSection::fold);
  fold();
}

void FoldingSection::setOpen(bool isOpen) {
  m_title->setChecked(isOpen);
}

bool FoldingSection::isOpen() const {
  return m_title->isChecked();
}

void FoldingSection::fold() {
  m_title->setText((isOpen() ? QStringLiteral("▾ ") : QStringLiteral("▸ ")) + m_text);
  m_content->setVisible(isOpen());
}

}  // namespace geargraph

#include "moc_folding_section.cpp"
