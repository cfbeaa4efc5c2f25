#include "ui/mainwindow/start_page.h"

#include <QBoxLayout>
#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QLabel>
#include <QListView>
#include <QMainWindow>
#include <QPushButton>
#include <QStandardItemModel>
#include <QStatusBar>
#include <QTabBar>
#include <QToolBar>

#include "ui/mainwindow/document_card.h"
#include "ui/mainwindow/document_files.h"
#include "ui/mainwindow/recent_files.h"
#include "ui/mainwindow/thumbnails.h"
#include "ui/models/term_tips.h"
#include "ui/theme/application_theme.h"

namespace geargraph {
namespace {

constexpr int kSideWidth = 320;
constexpr int kMargin = 28;
constexpr int kGroupRole = Qt::UserRole + 100;  ///< of an example: the tab of its group

/// What the notes of an example say first.
QString firstSentence(const QString& notes) {
  for (qsizetype i = notes.indexOf(QLatin1Char('.')); i >= 0; i = notes.indexOf(QLatin1Char('.'), i + 1)) {
    // A full stop with a capital behind it; "L.-W. Tsai" and "Eq. (5)" go on.
    const bool ends = i + 1 == notes.size() || (i + 2 < notes.size() && notes[i + 1].isSpace() &&
                                                notes[i + 2].isUpper() && i > 1 && !notes[i - 1].isUpper());
    if (ends) return notes.left(i + 1);
  }
  return notes;
}

QLabel* heading(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setProperty("look", "heading");
  return label;
}

}  // namespace

StartPage::StartPage(QWidget* parent)
    : QWidget(parent),
      m_thumbnails(new Thumbnails(this)),
      m_recentModel(new QStandardItemModel(this)),
      m_exampleModel(new QStandardItemModel(this)) {
  setObjectName(QStringLiteral("startPage"));
  setAutoFillBackground(true);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(makeSide());
  layout->addWidget(makeExamples(), 1);
  parent->installEventFilter(this);
  connect(m_thumbnails, &Thumbnails::drawn, this, [this](const QString& path, Theme, const QImage& picture) {
    for (int i = 0; i < m_exampleModel->rowCount(); ++i) {
      QStandardItem* item = m_exampleModel->item(i);
      if (item->data(kPathRole).toString() == path) item->setData(picture, kPictureRole);
    }
  });
  hide();
}

QListView* StartPage::makeList(const char* name, QStandardItemModel* model) {
  auto* list = new QListView(this);
  list->setObjectName(QLatin1String(name));
  list->setModel(model);
  list->setProperty("look", "cards");
  list->viewport()->setAutoFillBackground(false);
  list->setEditTriggers(QAbstractItemView::NoEditTriggers);
  list->setSelectionMode(QAbstractItemView::SingleSelection);
  list->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list->setMouseTracking(true);
  const auto choose = [this](const QModelIndex& index) { emit chosen(index.data(kPathRole).toString()); };
  connect(list, &QListView::clicked, this, choose);
  connect(list, &QListView::activated, this, choose);
  return list;
}

QWidget* StartPage::makeSide() {
  auto* side = new QWidget(this);
  side->setFixedWidth(kSideWidth);
  auto* layout = new QVBoxLayout(side);
  layout->setContentsMargins(kMargin, kMargin, kMargin / 2, kMargin / 2);
  layout->setSpacing(10);
  layout->addWidget(heading(tr("Start"), side));
  auto* anew = new QPushButton(tr("New mechanism"), side);
  anew->setObjectName(QStringLiteral("startNew"));
  anew->setToolTip(tr("An empty sheet with the ground on it"));
  anew->setDefault(true);
  auto* open = new QPushButton(tr("Open…"), side);
  open->setObjectName(QStringLiteral("startOpen"));
  open->setToolTip(tr("Open a document; it can be dropped on the window, too"));
  auto* design = new QPushButton(tr("Gearbox from ratios…"), side);
  design->setObjectName(QStringLiteral("startDesign"));
  design->setToolTip(tr("Search for planetary sets, brakes and clutches that have the ratios you want"));
  connect(design, &QPushButton::clicked, this, &StartPage::designWanted);
  connect(anew, &QPushButton::clicked, this, &StartPage::newWanted);
  connect(open, &QPushButton::clicked, this, &StartPage::openWanted);
  layout->addWidget(anew);
  layout->addWidget(open);
  layout->addWidget(design);
  layout->addSpacing(14);
  layout->addWidget(heading(tr("Recent"), side));
  m_noRecent = new QLabel(tr("Documents that you open or save are listed here."), side);
  m_noRecent->setProperty("look", "hint");
  m_noRecent->setWordWrap(true);
  layout->addWidget(m_noRecent);
  m_recent = makeList("startRecent", m_recentModel);
  m_recent->setItemDelegate(new DocumentCard(DocumentCard::Form::row, m_recent));
  layout->addWidget(m_recent, 1);
  return side;
}

QWidget* StartPage::makeExamples() {
  auto* right = new QWidget(this);
  auto* layout = new QVBoxLayout(right);
  layout->setContentsMargins(kMargin, kMargin, kMargin / 2, 0);
  layout->setSpacing(10);
  layout->addWidget(heading(tr("Examples"), right));
  m_groups = new QTabBar(right);
  m_groups->setObjectName(QStringLiteral("startGroups"));
  m_groups->setAccessibleName(tr("Kinds of examples"));
  m_groups->setDrawBase(false);
  m_groups->setExpanding(false);
  m_groups->addTab(tr("All"));
  for (const ExampleGroup& group : exampleGroups()) m_groups->addTab(group.title);
  connect(m_groups, &QTabBar::currentChanged, this, &StartPage::showGroup);
  layout->addWidget(m_groups);
  m_examples = makeList("startExamples", m_exampleModel);
  m_examples->setItemDelegate(new DocumentCard(DocumentCard::Form::upright, m_examples));
  m_examples->setViewMode(QListView::IconMode);
  m_examples->setResizeMode(QListView::Adjust);
  m_examples->setMovement(QListView::Static);
  m_examples->setUniformItemSizes(true);
  layout->addWidget(m_examples, 1);
  return right;
}

void StartPage::dismiss(QWidget* below) {
  if (isHidden()) return;
  hide();
  below->setFocus();
}

void StartPage::open(bool withRecent) {
  m_withRecent = withRecent;
  fill();
  fitWindow();
  show();
  raise();
}

void StartPage::fill() {
  fillRecent();
  const Theme theme = themeOf(palette());
  if (m_exampleModel->rowCount() == 0) {
    int number = 0;
    for (const ExampleGroup& group : exampleGroups()) {
      ++number;
      for (const QString& path : group.paths) addExample(path, number);
    }
    showGroup(m_groups->currentIndex());
  }
  for (int i = 0; i < m_exampleModel->rowCount(); ++i) {
    m_thumbnails->draw(m_exampleModel->item(i)->data(kPathRole).toString(), theme);
  }
}

void StartPage::addExample(const QString& path, int group) {
  const Expected<Mechanism> mechanism = readDocument(path);
  if (!mechanism) return;  // tests read every one
  auto* item = new QStandardItem(shownText(mechanism->name));
  const QString note = firstSentence(shownText(mechanism->notes));
  item->setData(path, kPathRole);
  item->setData(note, kNoteRole);
  item->setData(group, kGroupRole);
  item->setToolTip(QStringLiteral("%1\n%2").arg(item->text(), note));
  m_exampleModel->appendRow(item);
}

void StartPage::showGroup(int group) {
  for (int i = 0; i < m_exampleModel->rowCount(); ++i) {
    const bool isOfIt = group == 0 || m_exampleModel->item(i)->data(kGroupRole).toInt() == group;
    m_examples->setRowHidden(i, !isOfIt);
  }
  m_examples->clearSelection();
  m_examples->scrollToTop();
}

void StartPage::fillRecent() {
  m_recentModel->clear();
  const Theme theme = themeOf(palette());
  for (const QString& path : m_withRecent ? RecentFiles::paths() : QStringList()) {
    const QFileInfo file(path);
    auto* item = new QStandardItem(file.fileName());
    QString folder = QDir::toNativeSeparators(file.path());
    if (folder.startsWith(QDir::homePath())) folder.replace(0, QDir::homePath().size(), QStringLiteral("~"));
    item->setData(path, kPathRole);
    item->setData(folder, kNoteRole);
    item->setData(Thumbnails::kept(path, theme), kPictureRole);
    item->setToolTip(path);
    m_recentModel->appendRow(item);
  }
  m_noRecent->setVisible(m_recentModel->rowCount() == 0);
}

void StartPage::fitWindow() {
  auto* window = static_cast<QMainWindow*>(parentWidget());
  int top = 0;
  for (const QToolBar* bar : window->findChildren<QToolBar*>(QString(), Qt::FindDirectChildrenOnly)) {
    if (bar->isVisible() && !bar->isFloating()) top = std::max(top, bar->geometry().bottom() + 1);
  }
  const int bottom = window->statusBar()->isVisible() ? window->statusBar()->y() : window->height();
  setGeometry(0, top, window->width(), bottom - top);
}

bool StartPage::eventFilter(QObject* watched, QEvent* event) {
  const auto type = event->type();
  if (type == QEvent::Resize || type == QEvent::LayoutRequest || type == QEvent::Show) {
    if (!isHidden()) QMetaObject::invokeMethod(this, &StartPage::fitWindow, Qt::QueuedConnection);
  }
  return QWidget::eventFilter(watched, event);
}

void StartPage::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && !isHidden()) fill();
}

}  // namespace geargraph

#include "moc_start_page.cpp"
