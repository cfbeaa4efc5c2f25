#include "ui/help/help_window.h"

#include <QBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QShortcut>
#include <QSplitter>
#include <QToolButton>
#include <QTreeWidget>
#include <algorithm>

#include "core/presentation/manual/manual.h"
#include "ui/document/typed_length.h"
#include "ui/help/help_browser.h"
#include "ui/theme/theme_colors.h"

namespace geargraph {
namespace {

constexpr int kContentsWidth = 240;
constexpr int kFindWidth = 220;
constexpr int kPlaceRole = Qt::UserRole;

QString shown(const std::string& text) {
  return QString::fromStdString(text);
}

QString pageIn(const QString& place) {
  return place.section(QLatin1Char('#'), 0, 0);
}

const ManualPage* pageAt(const QString& place) {
  return manualPage(pageIn(place).toStdString());
}

bool holdsWords(const ManualPage& page, const QString& words) {
  return std::any_of(page.sections.begin(), page.sections.end(), [&](const ManualSection& section) {
    return shown(section.title).contains(words, Qt::CaseInsensitive) ||
           shown(section.words).contains(words, Qt::CaseInsensitive);
  });
}

}  // namespace

HelpWindow::HelpWindow(QWidget* parent)
    : QDialog(parent, Qt::Window),
      m_browser(new HelpBrowser(this)),
      m_contents(new QTreeWidget(this)),
      m_find(new QLineEdit(this)),
      m_found(new QLabel(this)) {
  setObjectName(QStringLiteral("helpWindow"));
  setWindowTitle(tr("Manual"));
  m_contents->setObjectName(QStringLiteral("helpContents"));
  m_contents->setAccessibleName(tr("Contents of the manual"));
  m_contents->setHeaderHidden(true);
  m_contents->setFrameShape(QFrame::NoFrame);
  auto* split = new QSplitter(this);
  split->addWidget(m_contents);
  split->addWidget(m_browser);
  split->setStretchFactor(1, 1);
  split->setSizes({kContentsWidth, 3 * kContentsWidth});
  split->setChildrenCollapsible(false);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(makeBar());
  layout->addWidget(split, 1);
  resize(980, 680);
  fillContents();
  connect(m_contents, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
    if (item != nullptr) open(item->data(0, kPlaceRole).toString());
  });
  connect(m_browser, &HelpBrowser::pageWanted, this, &HelpWindow::open);
  connect(m_browser, &HelpBrowser::commandWanted, this, &HelpWindow::commandWanted);
  connect(m_browser, &HelpBrowser::lessonWanted, this, &HelpWindow::lessonWanted);
  open(shown(manualPages().front().id));
}

QToolButton* HelpWindow::makeButton(const char* name, const QString& text, const QString& tip) {
  auto* button = new QToolButton(this);
  button->setObjectName(QLatin1String(name));
  button->setProperty("look", "control");
  button->setText(text);
  button->setToolTip(tip);
  button->setAccessibleName(tip);
  return button;
}

QWidget* HelpWindow::makeBar() {
  auto* bar = new QWidget(this);
  auto* layout = new QHBoxLayout(bar);
  layout->setContentsMargins(10, 8, 10, 8);
  m_back = makeButton("helpBack", QStringLiteral("‹"), tr("Back (Alt+Left)"));
  m_forward = makeButton("helpForward", QStringLiteral("›"), tr("Forward (Alt+Right)"));
  connect(m_back, &QToolButton::clicked, this, [this] { go(-1); });
  connect(m_forward, &QToolButton::clicked, this, [this] { go(1); });
  connect(new QShortcut(QKeySequence(Qt::ALT | Qt::Key_Left), this), &QShortcut::activated, this,
          [this] { go(-1); });
  connect(new QShortcut(QKeySequence(Qt::ALT | Qt::Key_Right), this), &QShortcut::activated, this,
          [this] { go(1); });
  connect(new QShortcut(QKeySequence::Find, this), &QShortcut::activated, this, [this] {
    m_find->setFocus();
    m_find->selectAll();
  });
  m_find->setObjectName(QStringLiteral("helpFind"));
  m_find->setMaxLength(kMaxSearched);
  m_find->setPlaceholderText(tr("Find in the manual  Ctrl+F"));
  m_find->setAccessibleName(tr("Find in the manual"));
  m_find->setToolTip(tr("Return goes to the next place, through all pages (Ctrl+F)"));
  m_find->setFixedWidth(scaledPixels(kFindWidth));
  m_found->setObjectName(QStringLiteral("helpFound"));
  m_found->setProperty("look", "hint");
  connect(m_find, &QLineEdit::textEdited, m_found, &QLabel::clear);
  connect(m_find, &QLineEdit::returnPressed, this, &HelpWindow::findNext);
  layout->addWidget(m_back);
  layout->addWidget(m_forward);
  layout->addStretch(1);
  layout->addWidget(m_found);
  layout->addWidget(m_find);
  return bar;
}

void HelpWindow::fillContents() {
  for (const ManualPage& page : manualPages()) {
    auto* top = new QTreeWidgetItem(m_contents, {shown(page.title)});
    top->setData(0, kPlaceRole, shown(page.id));
    for (const ManualSection& section : page.sections) {
      if (section.level != 2) continue;
      auto* item = new QTreeWidgetItem(top, {shown(section.title)});
      item->setData(0, kPlaceRole, shown(page.id) + QLatin1Char('#') + shown(section.anchor));
    }
  }
}

bool HelpWindow::open(const QString& pageAndAnchor) {
  const QString place = pageAndAnchor.startsWith(QLatin1Char('#')) && !m_places.empty()
                            ? pageIn(m_places[m_at]) + pageAndAnchor
                            : pageAndAnchor;
  if (pageAt(place) == nullptr) return false;
  if (m_places.empty() || m_places[m_at] != place) {
    if (!m_places.empty()) m_places.resize(m_at + 1);
    m_places.push_back(place);
    m_at = m_places.size() - 1;
  }
  display(place);
  return true;
}

void HelpWindow::display(const QString& place) {
  const ManualPage* page = pageAt(place);
  m_browser->showPage(page, place.section(QLatin1Char('#'), 1));
  setWindowTitle(tr("Manual: %1").arg(shown(page->title)));
  for (QTreeWidgetItemIterator item(m_contents); *item != nullptr; ++item) {
    if ((*item)->data(0, kPlaceRole).toString() != place) continue;
    const QSignalBlocker blocked(m_contents);
    m_contents->collapseAll();
    // A tree moves from what is folded away to what is seen.
    ((*item)->parent() != nullptr ? (*item)->parent() : *item)->setExpanded(true);
    m_contents->setCurrentItem(*item);
  }
  updateButtons();
}

void HelpWindow::go(int steps) {
  const auto to = static_cast<std::ptrdiff_t>(m_at) + steps;
  if (to < 0 || to >= static_cast<std::ptrdiff_t>(m_places.size())) return;
  m_at = static_cast<std::size_t>(to);
  display(m_places[m_at]);
}

void HelpWindow::updateButtons() {
  m_back->setEnabled(m_at > 0);
  m_back->setToolTip(m_at > 0 ? tr("Back (Alt+Left)") : tr("This is the first page that you opened."));
  const bool hasNext = m_at + 1 < m_places.size();
  m_forward->setEnabled(hasNext);
  m_forward->setToolTip(hasNext ? tr("Forward (Alt+Right)") : tr("This is the last page that you opened."));
}

/// The next place in this page, else the first in the next page that has one.
void HelpWindow::findNext() {
  const QString words = m_find->text().trimmed();
  if (words.isEmpty()) return;
  m_found->clear();
  if (m_browser->find(words)) return;
  const auto& pages = manualPages();
  const auto current = static_cast<std::size_t>(m_browser->page() - pages.data());
  for (std::size_t i = 1; i <= pages.size(); ++i) {
    const ManualPage& page = pages[(current + i) % pages.size()];
    if (!holdsWords(page, words)) continue;
    open(shown(page.id));
    m_browser->moveCursor(QTextCursor::Start);
    if (m_browser->find(words)) return;
  }
  m_found->setText(tr("Not found"));
}

/// Return is the field's: it closes no window.
void HelpWindow::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) return event->accept();
  QDialog::keyPressEvent(event);
}

}  // namespace geargraph

#include "moc_help_window.cpp"
