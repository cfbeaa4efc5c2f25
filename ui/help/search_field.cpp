#include "ui/help/search_field.h"

#include <QAction>
#include <QApplication>
#include <QKeyEvent>
#include <QMenuBar>
#include <algorithm>

#include "core/presentation/manual/manual.h"
#include "ui/document/typed_length.h"
#include "ui/help/help_page_of.h"
#include "ui/help/search_answers.h"

namespace geargraph {
namespace {

constexpr int kWidth = 266;
constexpr int kPopupWidth = 520;
constexpr int kPopupHeight = 400;
constexpr int kPage = 10;

/// The inset of the text on both sides.
constexpr int kInset = 24;

/// What the field is for, with its key where it fits.
QString placeholderFor(const QLineEdit& field) {
  const QString whole = SearchField::tr("Search a command or a term  Ctrl+K");
  const QString key = whole.section(QStringLiteral("  "), -1);
  const QString word = SearchField::tr("Search");
  const int room = field.width() - kInset;
  for (const QString& text : {whole, word + QStringLiteral("  ") + key}) {
    if (field.fontMetrics().horizontalAdvance(text) <= room) return text;
  }
  return word;
}

}  // namespace

SearchField::SearchField(const Document* document, Selection* selection, QMenuBar* menus, QWidget* parent)
    : QLineEdit(parent),
      m_document(document),
      m_selection(selection),
      m_menus(menus),
      m_elements(new Service<MechanismPtr, ElementEntries>(
          [](const MechanismPtr& mechanism, const auto& respond) {
            respond(std::make_shared<const std::vector<SearchEntry>>(elementEntries(*mechanism)));
          },
          this, {.same = [](const MechanismPtr& before, const MechanismPtr& now) { return before == now; }})),
      m_model(new SearchModel(this)),
      m_popup(new SearchPopup(m_model, menus->window())) {
  setObjectName(QStringLiteral("search"));
  setMaxLength(kMaxSearched);
  setToolTip(tr("Find a command, an element, a term or a page of the manual (Ctrl+K)"));
  setAccessibleName(tr("Search"));
  setMinimumWidth(kWidth / 3);
  setMaximumWidth(kWidth);
  setFocusPolicy(Qt::ClickFocus);
  menus->window()->installEventFilter(this);
  connect(qApp, &QApplication::focusChanged, this, [this](QWidget* before, QWidget* now) {
    if (now == this && before != nullptr) m_before = before;
  });
  m_elements->onAnswer(this, [this](const ElementEntries&) {
    if (m_popup->isVisible()) fill();
  });
  connect(this, &QLineEdit::textEdited, this, &SearchField::query);
  connect(m_popup, &SearchPopup::currentChanged, this, &SearchField::highlight);
  connect(m_popup, &SearchPopup::chosen, this, &SearchField::choose);
}

QSize SearchField::sizeHint() const {
  return {kWidth, QLineEdit::sizeHint().height()};
}

void SearchField::begin(Scope scope) {
  m_scope = scope;
  clear();
  if (hasFocus()) {
    gather();
  } else {
    setFocus(Qt::ShortcutFocusReason);
  }
}

/// The elements of a large document follow as soon as they are there.
void SearchField::gather() {
  constexpr std::chrono::milliseconds kMoment{10};
  if (m_scope == Scope::everything) {
    m_elements->request(m_document->mechanism());
    m_elements->await(kMoment);
  }
  fill();
}

void SearchField::fill() {
  std::vector<SearchEntry> entries = termEntries();
  if (m_scope == Scope::everything) {
    std::vector<SearchEntry> terms = std::move(entries);
    entries = commandEntries(*m_menus);
    if (m_elements->isComplete() && m_elements->answer())
      entries.insert(entries.end(), m_elements->answer()->begin(), m_elements->answer()->end());
    std::move(terms.begin(), terms.end(), std::back_inserter(entries));
    std::vector<SearchEntry> pages = pageEntries();
    std::move(pages.begin(), pages.end(), std::back_inserter(entries));
  }
  m_model->setEntries(std::move(entries));
  query();
}

void SearchField::query() {
  const bool isAsked = m_scope == Scope::everything;
  m_model->setQuery(text(), isAsked ? answersTo(text(), {m_document->mechanism(), m_snapshot,
                                                         m_selection->selected(), m_areAnswersOpen})
                                    : std::vector<SearchEntry>());
  m_popup->showList(tr("No command or term matches “%1”.").arg(text()));
  place();
  m_popup->show();
  m_popup->raise();
}

void SearchField::place() {
  const QWidget* owner = m_popup->parentWidget();
  const QPoint corner = mapTo(owner, QPoint(width(), height() + 3));
  const int wide = std::min(kPopupWidth, owner->width() - 16);
  const int high = std::min(m_popup->heightForResults(kPopupHeight), owner->height() - corner.y() - 16);
  m_popup->setGeometry(std::max(8, corner.x() - wide), corner.y(), wide, high);
}

void SearchField::highlight(int row) {
  const SearchEntry* entry = row >= 0 ? &m_model->entryAt(row) : nullptr;
  // F1 then tells more than the tip: with a picture, the equation and the lesson.
  setProperty(kHelpPage, entry != nullptr && entry->term
                             ? QStringLiteral("glossary#") + QString::fromStdString(anchorOf(*entry->term))
                             : QString());
  if (!m_popup->isVisible()) return;
  if (row >= 0 && m_model->entryAt(row).element) {
    m_selection->hover(*m_model->entryAt(row).element);
  } else if (row >= 0 && !m_model->entryAt(row).elements.empty()) {
    const std::vector<ElementId>& about = m_model->entryAt(row).elements;
    m_selection->hover({about.begin(), about.end()});
  } else {
    m_selection->unhover();
  }
}

void SearchField::choose(int row) {
  if (row < 0) return;
  const SearchEntry entry = m_model->entryAt(row);
  if (entry.term) return m_popup->showDefinition(*entry.term);
  end();
  if (entry.element) return emit elementChosen(*entry.element);
  if (entry.edit) return emit editChosen(*entry.edit);
  if (entry.isAnswer) return emit elementsChosen(entry.elements);
  if (!entry.page.isEmpty()) return emit pageChosen(entry.page);
  if (entry.action == nullptr) return;
  if (!entry.action->isEnabled()) return emit rejected(entry.action->toolTip());
  const bool isShown = entry.action->property(kRevealsPanel).toBool() && entry.action->isChecked();
  if (!isShown) entry.action->trigger();
}

void SearchField::end() {
  QWidget* before = m_before;
  m_popup->hide();
  m_selection->unhover();
  m_scope = Scope::everything;
  clear();
  if (!hasFocus()) return;
  if (before != nullptr && before->isVisible()) {
    before->setFocus();
  } else {
    clearFocus();
  }
}

bool SearchField::event(QEvent* event) {
  if (event->type() == QEvent::Resize || event->type() == QEvent::FontChange)
    setPlaceholderText(placeholderFor(*this));
  if (event->type() == QEvent::ShortcutOverride) {
    // While something is typed, single-letter commands rest.
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->key() == Qt::Key_Escape || key->key() == Qt::Key_Return || key->key() == Qt::Key_Delete) {
      event->accept();
      return true;
    }
  }
  return QLineEdit::event(event);
}

bool SearchField::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize && m_popup->isVisible()) place();
  return QLineEdit::eventFilter(watched, event);
}

void SearchField::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Escape:
      return end();
    case Qt::Key_Return:
    case Qt::Key_Enter:
      return m_popup->isDefinition() ? query() : choose(m_popup->currentRow());
    case Qt::Key_Down:
      return m_popup->moveCurrent(1);
    case Qt::Key_Up:
      return m_popup->moveCurrent(-1);
    case Qt::Key_PageDown:
      return m_popup->moveCurrent(kPage);
    case Qt::Key_PageUp:
      return m_popup->moveCurrent(-kPage);
    default:
      QLineEdit::keyPressEvent(event);
  }
}

void SearchField::focusInEvent(QFocusEvent* event) {
  QLineEdit::focusInEvent(event);
  gather();
}

void SearchField::focusOutEvent(QFocusEvent* event) {
  QLineEdit::focusOutEvent(event);
  if (event->reason() == Qt::PopupFocusReason || event->reason() == Qt::ActiveWindowFocusReason) return;
  if (m_popup->isVisible()) end();
}

}  // namespace geargraph

#include "moc_search_field.cpp"
