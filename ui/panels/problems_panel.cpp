#include "ui/panels/problems_panel.h"

#include <QBoxLayout>
#include <QEvent>
#include <QHash>
#include <QLabel>
#include <QListView>
#include <QPainter>
#include <QPushButton>
#include <QStackedWidget>
#include <QStyledItemDelegate>
#include <QToolButton>
#include <algorithm>

#include "core/design/collision/motion_diagnostics.h"
#include "ui/models/term_tips.h"
#include "ui/panels/fix_row.h"
#include "ui/theme/application_theme.h"
#include "ui/theme/empty_label.h"
#include "ui/theme/icons.h"
#include "ui/workbench/views.h"
#include "ui/workbench/workbench.h"

namespace geargraph {
namespace {

constexpr int kIconRoom = 38;
constexpr int kRight = 14;
/// Rows that are measured in one event: the wrapped text of thousands would hold up the window.
constexpr int kRowsAtOnce = 50;
constexpr int kMaxHeights = 20'000;  ///< that are kept

/// An icon, the sentence, and below it the place in a file, in secondary ink.
class DiagnosticDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    painter->save();
    const Theme theme = themeOf(option.palette);
    const bool over = option.state.testFlag(QStyle::State_MouseOver);
    if (over) {
      QColor band = qColor(ColorRole::halo, theme);
      band.setAlphaF(0.35F);
      painter->fillRect(option.rect, band);
    }
    const auto severity = static_cast<Severity>(index.data(DiagnosticModel::SeverityRole).toInt());
    const bool isUnfinished = index.data(DiagnosticModel::UnfinishedRole).toBool();
    const ColorRole role = isUnfinished ? ColorRole::secondary : severityRole(severity);
    const QPixmap icon =
        iconPixmap(severityIconName(severity), role, theme, 16, painter->device()->devicePixelRatio());
    painter->drawPixmap(option.rect.left() + 14, option.rect.top() + 9, icon);

    QRect room = option.rect.adjusted(kIconRoom, 8, -kRight, -6);
    painter->setPen(qColor(isUnfinished ? ColorRole::secondary : ColorRole::ink, theme));
    QRect used;
    painter->drawText(room, Qt::TextWordWrap, index.data().toString(), &used);
    room.setTop(used.bottom() + 3);
    painter->setPen(qColor(ColorRole::secondary, theme));
    painter->setFont(smallFont(option.font));
    painter->drawText(room, Qt::AlignLeft | Qt::AlignTop, placeOf(index));
    painter->restore();
  }

  [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const auto* list = qobject_cast<const QListView*>(option.widget);
    const int width = (list != nullptr ? list->viewport()->width() : 400) - kIconRoom - kRight;
    const int text = wrappedHeight(index.data().toString(), width, option.font);
    const int small = placeOf(index).isEmpty() ? 0 : QFontMetrics(smallFont(option.font)).height() + 3;
    const auto* fixes = list != nullptr ? qobject_cast<FixRow*>(list->indexWidget(index)) : nullptr;
    return {width, text + small + 16 + (fixes != nullptr ? fixes->heightFor(width) : 0)};
  }

 private:
  static QFont smallFont(QFont font) {
    font.setPixelSize(smallPixels());
    return font;
  }
  static QString placeOf(const QModelIndex& index) {
    return index.data(DiagnosticModel::PlaceRole).toString();
  }

  /// The list asks for all rows whenever it is laid out, as when it is shown or its sheet is set.
  [[nodiscard]] int wrappedHeight(const QString& text, int width, const QFont& font) const {
    if (width != m_width || font != m_font || m_heights.size() > kMaxHeights) m_heights.clear();
    m_width = width;
    m_font = font;
    const auto known = m_heights.constFind(text);
    if (known != m_heights.constEnd()) return *known;
    const QRect room(0, 0, width, 10'000);
    return *m_heights.insert(text, QFontMetrics(font).boundingRect(room, Qt::TextWordWrap, text).height());
  }

  mutable int m_width = 0;  ///< that the heights are for
  mutable QFont m_font;
  mutable QHash<QString, int> m_heights;
};

}  // namespace

ProblemsPanel::ProblemsPanel(Selection* selection, QWidget* parent)
    : QWidget(parent),
      m_selection(selection),
      m_model(new DiagnosticModel(this)),
      m_list(new QListView(this)),
      m_pages(new QStackedWidget(this)),
      m_motionNote(new QLabel(this)),
      m_fixFinder(new FixFinder(
          [](const FixRequest& request, const FixFinder::Responder& respond) {
            std::vector<std::vector<Fix>> found;
            for (const Diagnostic& diagnostic : request.diagnostics) {
              found.push_back(fixesFor(diagnostic, *request.snapshot));
              if (respond.stop().stop_requested()) return;
            }
            respond(std::move(found));
          },
          this)) {
  m_list->setModel(m_model);
  m_list->setObjectName(QStringLiteral("problemList"));
  m_list->setAccessibleName(tr("Problems"));
  m_list->setItemDelegate(new DiagnosticDelegate(m_list));
  m_list->setMouseTracking(true);
  m_list->setSelectionMode(QAbstractItemView::NoSelection);
  m_list->setResizeMode(QListView::Adjust);
  m_list->setLayoutMode(QListView::Batched);
  m_list->setBatchSize(kRowsAtOnce);
  m_list->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  m_list->setFrameShape(QFrame::NoFrame);
  m_list->viewport()->installEventFilter(this);
  connect(m_list, &QListView::entered, this,
          [this](const QModelIndex& index) { m_selection->hover(m_model->elementsOf(index)); });
  connect(m_list, &QListView::clicked, this, [this](const QModelIndex& index) {
    m_selection->select(m_model->elementsOf(index));
    const auto time = m_model->diagnostics()[static_cast<std::size_t>(index.row())].time;
    if (time) emit momentWanted(*time);
    if (m_list->indexWidget(index) != nullptr) return;
    offerFixes(index);
    requestFixes();
    m_list->doItemsLayout();
  });

  m_motionNote->setObjectName(QStringLiteral("motionNote"));
  m_motionNote->setProperty("look", "hint");
  m_motionNote->setWordWrap(true);
  m_motionNote->setContentsMargins(kIconRoom, 6, kRight, 8);
  auto* fine =
      emptyLabel(this, tr("No problems. Every link is tied to the ground, and the turning joints make a "
                          "spanning tree."));
  m_pages->addWidget(m_list);
  m_pages->addWidget(fine);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(makeBanner());
  layout->addWidget(m_pages, 1);
  layout->addWidget(m_motionNote);
  setBackgroundRole(QPalette::Base);
  setAutoFillBackground(true);
  m_fixFinder->onAnswer(this, [this](const std::vector<std::vector<Fix>>& found) {
    for (std::size_t i = 0; i < found.size(); ++i) showFixes(m_rowsAsked[i], found[i]);
    m_list->doItemsLayout();
    emit fixesOffered();
  });
  renew();
}

QFrame* ProblemsPanel::makeBanner() {
  m_banner = new QFrame(this);
  m_banner->setProperty("look", "banner");
  m_banner->setObjectName(QStringLiteral("fileBanner"));
  m_bannerText = new QLabel(m_banner);
  m_bannerText->setWordWrap(true);
  auto* dismiss = new QToolButton(m_banner);
  dismiss->setText(tr("Dismiss"));
  dismiss->setProperty("look", "flat");
  dismiss->setToolTip(tr("Show the problems of the open document again"));
  connect(dismiss, &QToolButton::clicked, this, &ProblemsPanel::clearFileProblems);
  auto* layout = new QHBoxLayout(m_banner);
  layout->setContentsMargins(12, 6, 6, 6);
  layout->addWidget(m_bannerText, 1);
  layout->addWidget(dismiss);
  return m_banner;
}

void ProblemsPanel::setSnapshot(const SnapshotPtr& snapshot) {
  m_snapshot = snapshot;
  renew();
}

void ProblemsPanel::setMotionDiagnostics(const Diagnostics& diagnostics, const QString& note) {
  if (diagnostics == m_motionDiagnostics && note == m_motionNote->text()) return;
  m_motionDiagnostics = diagnostics;
  m_motionNote->setText(note);
  renew();
}

void ProblemsPanel::setLoadDiagnostics(const Diagnostics& diagnostics) {
  if (diagnostics == m_loadDiagnostics) return;
  m_loadDiagnostics = diagnostics;
  renew();
}

void ProblemsPanel::setShapeDiagnostics(const Diagnostics& diagnostics) {
  if (diagnostics == m_shapeDiagnostics) return;
  m_shapeDiagnostics = diagnostics;
  renew();
}

void ProblemsPanel::offerFixes() {
  for (int row = 0; row < m_model->rowCount(); ++row) m_list->setIndexWidget(m_model->index(row), nullptr);
  m_rowsAsked.clear();
  const bool fixes =
      m_fileName.isEmpty() && m_snapshot && m_snapshot->mechanism->n() <= kMaxLinksWithImmediateFixes;
  for (int row = 0; fixes && row < std::min(m_model->rowCount(), kMaxImmediateFixes); ++row) {
    offerFixes(m_model->index(row));
  }
  requestFixes();
  m_list->doItemsLayout();
}

void ProblemsPanel::offerFixes(const QModelIndex& index) {
  if (!m_fileName.isEmpty() || !m_snapshot || !index.isValid()) return;
  const Diagnostic& diagnostic = m_model->diagnostics()[static_cast<std::size_t>(index.row())];
  if (triesBodies(diagnostic)) return m_rowsAsked.push_back(index.row());
  showFixes(index.row(), fixesFor(diagnostic, *m_snapshot));
}

void ProblemsPanel::requestFixes() {
  if (m_rowsAsked.empty()) return m_fixFinder->cancel();
  FixRequest request{m_snapshot, {}};
  for (const int row : m_rowsAsked)
    request.diagnostics.push_back(m_model->diagnostics()[static_cast<std::size_t>(row)]);
  m_fixFinder->request(std::move(request));
}

void ProblemsPanel::showFixes(int row, const std::vector<Fix>& fixes) {
  if (fixes.empty()) return;
  auto* buttons = new FixRow(kIconRoom, m_list->viewport());
  for (const Fix& fix : fixes) {
    QPushButton* button = buttons->addButton(shownText(fix.text));
    connect(button, &QPushButton::clicked, this, [this, fix] { emit fixWanted(fix); });
  }
  m_list->setIndexWidget(m_model->index(row), buttons);
}

void ProblemsPanel::setFileProblems(const QString& fileName, const Diagnostics& problems) {
  m_fileName = fileName;
  m_fileProblems = problems;
  renew();
}

void ProblemsPanel::clearFileProblems() {
  m_fileName.clear();
  m_fileProblems.clear();
  renew();
}

void ProblemsPanel::renew() {
  const bool ofFile = !m_fileName.isEmpty();
  Diagnostics shown = ofFile ? m_fileProblems : m_snapshot ? m_snapshot->diagnostics : Diagnostics();
  if (!ofFile && m_snapshot) {
    append(shown, m_loadDiagnostics);
    append(shown, m_shapeDiagnostics);
    append(shown, m_motionDiagnostics);
  }
  m_model->setDiagnostics(std::move(shown));
  m_banner->setVisible(ofFile);
  m_motionNote->setVisible(!ofFile && !m_motionNote->text().isEmpty());
  const auto count = m_fileProblems.size();
  const QString problems = count == 1 ? tr("1 problem") : tr("%1 problems").arg(count);
  m_bannerText->setText(
      tr("%1 could not be opened: %2. The document that was open stays open.").arg(m_fileName, problems));
  m_pages->setCurrentIndex(m_model->rowCount() == 0 ? 1 : 0);
  offerFixes();
  int wrong = 0;
  for (int row = 0; row < m_model->rowCount(); ++row)
    wrong += m_model->index(row).data(DiagnosticModel::UnfinishedRole).toBool() ? 0 : 1;
  emit countChanged(wrong);
}

bool ProblemsPanel::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Leave) m_selection->unhover();
  return QWidget::eventFilter(watched, event);
}

ViewEntry problemsView() {
  return {.id = QStringLiteral("problems"),
          .title = ProblemsPanel::tr("Problems"),
          .purpose = ProblemsPanel::tr("What is wrong with the mechanism, and how to mend it."),
          .helpPage = QStringLiteral("problems"),
          .searchWords = QStringLiteral("error warning hint fix diagnostics mistake wrong message"),
          .place = ViewPlace::bottom,
          .servesDrawing = true,
          .make = [](Views& views, QWidget* parent) -> ResultsView* {
            Workbench& workbench = views.workbench();
            auto* panel = new ProblemsPanel(views.selection(), parent);
            QObject::connect(panel, &ProblemsPanel::countChanged, panel, [panel](int count) {
              panel->setWindowTitle(ProblemsPanel::tr("Problems %1").arg(count));
            });
            QObject::connect(panel, &ProblemsPanel::fixesOffered, &views, &Views::settled);
            QObject::connect(panel, &ProblemsPanel::momentWanted, &views, &Views::momentWanted);
            QObject::connect(panel, &ProblemsPanel::fixWanted, &workbench.document(),
                             [document = &workbench.document()](const Fix& fix) {
                               document->apply({shownText(fix.text), fix.edit, 0});
                             });
            workbench.motionCheck().onAnswer(panel, [panel, &workbench](const MotionReportPtr& report) {
              panel->setMotionDiagnostics(
                  report ? report->diagnostics : Diagnostics(),
                  shownText(motionNote(*workbench.analysis().snapshot(), report.get())));
            });
            workbench.forces().onAnswer(panel, [panel](const ForcesPtr& forces) {
              panel->setLoadDiagnostics(forces ? forces->diagnostics : Diagnostics());
            });
            workbench.stages().onAnswer(panel, [panel](const MechanismScenePtr& stage) {
              Diagnostics missing;
              for (const SceneNote& note : stage->notes)
                if (note.isMissingFile) missing.push_back({Code::missingFile, note.text, {note.element}, {}});
              panel->setShapeDiagnostics(missing);
            });
            return panel;
          }};
}

}  // namespace geargraph

#include "moc_problems_panel.cpp"
