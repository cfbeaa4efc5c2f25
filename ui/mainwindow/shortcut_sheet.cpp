#include "ui/mainwindow/shortcut_sheet.h"

#include <QAbstractTextDocumentLayout>
#include <QAction>
#include <QBoxLayout>
#include <QDialogButtonBox>
#include <QGuiApplication>
#include <QMenu>
#include <QMenuBar>
#include <QPrintDialog>
#include <QPrinter>
#include <QPushButton>
#include <QRegularExpression>
#include <QScreen>
#include <QScrollArea>
#include <QShowEvent>
#include <QTextBrowser>
#include <QTextDocument>
#include <QtMath>
#include <algorithm>
#include <vector>

#include "ui/help/search_entries.h"

namespace geargraph {
namespace {

/// In percent. All of it can be seen without scrolling on a screen of 1366 by 768; the last are sentences.
constexpr std::array kWidths{22, 22, 23, 33};
constexpr int kMargin = 8;

struct Row {
  QString what;
  QString keys;
};

struct Group {
  QString title;
  std::vector<Row> rows;
};

void addRows(const QMenu& menu, std::vector<Row>& rows) {
  static const QRegularExpression count(QStringLiteral(" \\d+$"));  // how many problems there are now
  for (const QAction* action : menu.actions()) {
    if (action->menu() != nullptr) {
      addRows(*action->menu(), rows);
      continue;
    }
    QStringList keys;
    for (const QKeySequence& key : action->shortcuts()) keys << key.toString(QKeySequence::NativeText);
    const QString named = action->text().section(QLatin1Char('\t'), 1);
    if (keys.isEmpty() && !named.isEmpty()) keys << named;
    QString what = plainText(action->text());
    what.remove(count);
    if (!keys.isEmpty()) rows.push_back({what, keys.join(QStringLiteral(", "))});
  }
}

std::vector<Group> groupsOf(const QMenuBar& menus) {
  std::vector<Group> groups;
  for (const QAction* top : menus.actions()) {
    if (top->menu() == nullptr) continue;
    Group group{plainText(top->text()), {}};
    addRows(*top->menu(), group.rows);
    if (!group.rows.empty()) groups.push_back(std::move(group));
  }
  const auto tr = [](const char* text) { return ShortcutSheet::tr(text); };
  groups.push_back({tr("In a drawing"),
                    {{tr("Play, pause"), tr("Space")},
                     {tr("Move the sheet"), tr("Space or middle button, and drag")},
                     {tr("Zoom at the mouse"), tr("Wheel")},
                     {tr("Fit"), tr("F")},
                     {tr("Fit what is selected"), tr("Shift+F")},
                     {tr("Nudge; finer"), tr("Arrow keys; with Shift")},
                     {tr("Add to the selection"), tr("Shift or Ctrl, and click")},
                     {tr("Drag without snapping"), tr("Alt")},
                     {tr("Rename a link, change a note"), tr("Double click")},
                     {tr("Next, last element; besides"), tr("Page down, up; with Shift")},
                     {tr("The nearest element that way"), tr("Ctrl and arrow key")},
                     {tr("Along a lever, to the next one"), tr("Up and Down, Tab")},
                     {tr("As a click on the element"), tr("Return")},
                     {tr("In the gearbox designer: search"), tr("Ctrl+Return")},
                     {tr("Give up, deselect, back to Select"), tr("Esc")}}});
  groups.push_back({tr("In the 3D view"),
                    {{tr("Play, pause"), tr("Space")},
                     {tr("Step back, step on"), tr("Comma, point")},
                     {tr("Fit"), tr("F, Home")},
                     {tr("Isometric, front, right, top"), tr("0, 1, 2, 3")},
                     {tr("Turn the train"), tr("Drag a gear")},
                     {tr("Turn a part by hand"), tr("Ctrl, and drag")},
                     {tr("Orbit"), tr("Drag elsewhere, arrow keys")},
                     {tr("Pan"), tr("Shift with drag or arrow keys")},
                     {tr("Zoom"), tr("Wheel, + and −")},
                     {tr("Next, last link"), tr("Page down, Page up")}}});
  return groups;
}

QString htmlOf(const Group& group) {
  QString html = QStringLiteral("<h4>%1</h4><table width='100%' cellspacing='0' cellpadding='2'>")
                     .arg(group.title.toHtmlEscaped());
  for (const Row& row : group.rows) {
    html += QStringLiteral("<tr><td>%1</td><td align='right'><b>%2</b></td></tr>")
                .arg(row.what.toHtmlEscaped(), row.keys.toHtmlEscaped());
  }
  return html + QStringLiteral("</table>");
}

/// As high as its text: the sheet scrolls its columns together.
class SheetColumn : public QTextBrowser {
 public:
  explicit SheetColumn(QWidget* parent) : QTextBrowser(parent) {
    setFrameShape(QFrame::NoFrame);
    setFocusPolicy(Qt::ClickFocus);  // the keys scroll the sheet
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    connect(document()->documentLayout(), &QAbstractTextDocumentLayout::documentSizeChanged, this,
            [this](const QSizeF& size) { setFixedHeight(qCeil(size.height())); });
  }
};

}  // namespace

std::array<QString, ShortcutSheet::kColumns> ShortcutSheet::columnsFor(const QMenuBar& menus) {
  static_assert(kWidths.size() == kColumns);
  const std::vector<Group> groups = groupsOf(menus);
  std::size_t all = 0;
  for (const Group& group : groups) all += group.rows.size() + 2;
  std::array<QString, kColumns> columns;
  std::size_t placed = 0;
  for (const Group& group : groups) {
    const std::size_t size = group.rows.size() + 2;
    columns[std::min(kColumns - 1, kColumns * (placed + size) / all)] += htmlOf(group);
    placed += size;
  }
  return columns;
}

std::unique_ptr<QTextDocument> ShortcutSheet::pageFor(const QMenuBar& menus, const QSizeF& page) {
  constexpr double kLargest = 11, kSmallest = 4, kStep = 0.5;
  QString html = QStringLiteral("<h3>%1</h3><table width='100%' cellspacing='0' cellpadding='3'><tr>")
                     .arg(tr("GearGraph: keyboard shortcuts").toHtmlEscaped());
  const std::array<QString, kColumns> columns = columnsFor(menus);
  for (std::size_t i = 0; i < kColumns; ++i)
    html += QStringLiteral("<td width='%1%' valign='top'>%2</td>").arg(kWidths[i]).arg(columns[i]);
  html += QStringLiteral("</tr></table>");
  auto document = std::make_unique<QTextDocument>();
  document->setDocumentMargin(0);
  QFont font = document->defaultFont();
  for (double size = kLargest; size >= kSmallest; size -= kStep) {
    font.setPointSizeF(size);
    document->setDefaultFont(font);
    document->setHtml(html);
    document->setPageSize(page);
    if (document->pageCount() == 1) break;
  }
  return document;
}

void ShortcutSheet::printOn(QPrinter& printer, const QMenuBar& menus) {
  constexpr double kPoints = 72;
  const double screen = QGuiApplication::primaryScreen()->logicalDotsPerInchY();
  const QSizeF page = printer.pageLayout().paintRect(QPageLayout::Point).size() * screen / kPoints;
  pageFor(menus, page)->print(&printer);
}

void ShortcutSheet::choosePrinter() {
  const auto printer = std::make_shared<QPrinter>(QPrinter::HighResolution);
  printer->setPageOrientation(QPageLayout::Landscape);
  printer->setDocName(windowTitle());
  auto* dialog = new QPrintDialog(printer.get(), this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, printer] { printOn(*printer, *m_menus); });
  dialog->open();
}

ShortcutSheet::ShortcutSheet(const QMenuBar& menus, QWidget* parent) : QDialog(parent), m_menus(&menus) {
  setObjectName(QStringLiteral("shortcutSheet"));
  setWindowTitle(tr("Keyboard shortcuts"));
  setAttribute(Qt::WA_DeleteOnClose);
  auto* sheet = new QWidget;
  sheet->setBackgroundRole(QPalette::Base);
  auto* columns = new QHBoxLayout(sheet);
  columns->setContentsMargins(kMargin, 0, kMargin, 0);
  columns->setSpacing(kMargin);
  for (std::size_t i = 0; i < kColumns; ++i) {
    m_columns[i] = new SheetColumn(sheet);
    columns->addWidget(m_columns[i], kWidths[i], Qt::AlignTop);
  }
  auto* scroll = new QScrollArea(this);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidgetResizable(true);
  scroll->setWidget(sheet);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(scroll);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  buttons->setContentsMargins(kMargin, 0, kMargin, kMargin);
  QPushButton* print = buttons->addButton(tr("Print…"), QDialogButtonBox::ActionRole);
  print->setObjectName(QStringLiteral("printKeys"));
  print->setToolTip(tr("On one page, also into a PDF file"));
  connect(print, &QPushButton::clicked, this, &ShortcutSheet::choosePrinter);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  layout->addWidget(buttons);
  resize(1330, 690);
}

/// Not before: at each change of its size all of the text would be laid out again.
void ShortcutSheet::showEvent(QShowEvent* event) {
  if (!event->spontaneous() && m_waiting.empty()) {
    const std::array<QString, kColumns> columns = columnsFor(*m_menus);
    m_waiting.assign(columns.begin(), columns.end());
    m_turn.request();
  }
  QDialog::showEvent(event);
}

void ShortcutSheet::fillNext() {
  m_columns[kColumns - m_waiting.size()]->setHtml(m_waiting.front());
  m_waiting.pop_front();
  if (!m_waiting.empty()) m_turn.request();
}

}  // namespace geargraph

#include "moc_shortcut_sheet.cpp"
