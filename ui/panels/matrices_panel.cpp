#include "ui/panels/matrices_panel.h"

#include <QApplication>
#include <QBoxLayout>
#include <QButtonGroup>
#include <QClipboard>
#include <QFrame>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QRegularExpression>
#include <QStackedWidget>
#include <QToolButton>
#include <QToolTip>
#include <algorithm>

#include "core/foundations/base/contract.h"
#include "core/foundations/base/locale.h"
#include "core/foundations/base/translation.h"
#include "core/teaching/derivation/result_text.h"
#include "ui/models/term_tips.h"
#include "ui/panels/matrix_view.h"
#include "ui/theme/application_theme.h"
#include "ui/theme/control_button.h"
#include "ui/theme/empty_label.h"
#include "ui/theme/folding_bar.h"
#include "ui/workbench/views.h"

namespace geargraph {
namespace {

constexpr int kCardWidth = 176;
constexpr int kWidthForCard = 630;  // beside the matrices of a small train

/// A chip with a rate on it: few text fonts place a dot on a θ, so it is painted.
class RateChip : public QToolButton {
 public:
  using QToolButton::QToolButton;

 protected:
  void paintEvent(QPaintEvent* event) override {
    QToolButton::paintEvent(event);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(qColor(isChecked() ? ColorRole::accent : ColorRole::ink, themeOf(palette())));
    const QFontMetricsF metrics(font());
    const double radius = metrics.height() * 0.06;
    const double top = rect().center().y() - metrics.ascent() / 2 + 0.5;
    painter.drawEllipse(QPointF(rect().center().x() + 0.5, top), radius, radius);
  }
};

/// "C" of "C = [T | U]".
QString withoutParts(const NamedResult& result) {
  return shownText(result.symbol).section(QLatin1Char('='), 0, 0).trimmed();
}

/// Name and definition as a tooltip.
QString tipOf(const NamedResult& result) {
  if (result.term) return tipOf(*result.term);
  return QStringLiteral("<p style='white-space:normal'><b>%1 %2</b><br>%3</p>")
      .arg(shownText(translated(result.title)).toHtmlEscaped(), shownText(result.symbol).toHtmlEscaped(),
           shownText(definitionOf(result)).toHtmlEscaped());
}

/// @pre it is among them
int placeOf(const std::vector<const NamedResult*>& results, const NamedResult& result) {
  const auto at = std::find(results.begin(), results.end(), &result);
  GEARGRAPH_REQUIRE(at != results.end());
  return static_cast<int>(at - results.begin());
}

QString formName(EntryForm form) {
  switch (form) {
    case EntryForm::decimals:
      return MatricesPanel::tr("decimals");
    case EntryForm::fractions:
      return MatricesPanel::tr("fractions");
    case EntryForm::symbols:
      return MatricesPanel::tr("symbols");
  }
  return {};
}

}  // namespace

MatricesPanel::MatricesPanel(Selection* selection, QWidget* parent)
    : QWidget(parent),
      m_model(new MatrixModel(this)),
      m_view(new MatrixView(m_model, selection, this)),
      m_writer([this](const std::function<std::string()>& write, const std::stop_token& stop) {
        QString text = shownText(write());
        if (stop.stop_requested()) return;
        QMetaObject::invokeMethod(
            this,
            [this, text = std::move(text)] {
              QApplication::clipboard()->setText(text);
              emit copied();
            },
            Qt::QueuedConnection);
      }) {
  m_view->setObjectName(QStringLiteral("matrixView"));
  m_view->setAccessibleName(tr("Matrix"));
  m_view->setTabKeyNavigation(false);  // arrow keys move in it, Tab leaves it
  m_empty = emptyLabel(this);
  m_pages = new QStackedWidget(this);
  m_pages->addWidget(m_view);
  m_pages->addWidget(m_empty);

  auto* lower = new QHBoxLayout;
  lower->setContentsMargins(12, 0, 10, 8);
  lower->addWidget(m_pages, 1);
  lower->addWidget(makeCard(), 0, Qt::AlignTop);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  layout->addWidget(makeBar());
  layout->addLayout(lower, 1);
  setBackgroundRole(QPalette::Base);
  setAutoFillBackground(true);

  connect(m_view, &MatrixView::restedOn, this, &MatricesPanel::explain);
  connect(m_model, &MatrixModel::matrixChanged, this, &MatricesPanel::renew);
  renew();
}

QWidget* MatricesPanel::makeBar() {
  const auto group = [this] {
    auto* layout = new QHBoxLayout(new QWidget(this));
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    return layout;
  };
  auto* chips = group();
  m_chips = new QButtonGroup(this);
  for (const NamedResult* result : namedResults())
    if (!result->symbol.empty()) addChip(chips, *result);
  connect(m_chips, &QButtonGroup::idToggled, this, &MatricesPanel::nameChip);
  m_chips->button(placeOf(m_results, m_model->result()))->setChecked(true);
  connect(m_chips, &QButtonGroup::idClicked, this,
          [this](int id) { showResult(*m_results[static_cast<std::size_t>(id)]); });
  chips->addStretch(1);

  auto* controls = group();
  controls->addStretch(1);
  m_form = makeFormButton();
  controls->addWidget(m_form);
  m_copy = makeCopyButton();
  controls->addWidget(m_copy);
  m_export = controlButton(QStringLiteral("exportCsv"), tr("CSV…"),
                           tr("Export the matrix with its labels to a CSV file"), this);
  connect(m_export, &QToolButton::clicked, this, &MatricesPanel::wantExport);
  controls->addWidget(m_export);
  auto* zeros = controlButton(QStringLiteral("zerosAsDots"), tr("zeros ·"),
                              tr("Show zeros as faint dots, or as 0"), this);
  connect(zeros, &QToolButton::clicked, this, [this, zeros] {
    m_view->setZerosAsDots(!m_view->zerosAsDots());
    zeros->setText(m_view->zerosAsDots() ? tr("zeros ·") : tr("zeros 0"));
  });
  controls->addWidget(zeros);
  return new FoldingBar(chips->parentWidget(), controls->parentWidget(), this);
}

QToolButton* MatricesPanel::makeCopyButton() {
  auto* button =
      controlButton(QStringLiteral("copyMatrix"), tr("Copy ▾"), tr("Copy the matrix with its labels"), this);
  button->setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(button);
  const std::pair<QString, TableFormat> formats[] = {{tr("Table (TSV)"), TableFormat::tsv},
                                                     {QStringLiteral("CSV"), TableFormat::csv},
                                                     {QStringLiteral("LaTeX"), TableFormat::latex},
                                                     {QStringLiteral("MATLAB"), TableFormat::matlab},
                                                     {QStringLiteral("NumPy"), TableFormat::numpy}};
  for (const auto& [name, format] : formats) {
    menu->addAction(name, this, [this, form = format] {
      if (const ResultTablePtr table = m_model->table())
        copy([table, form] {
          const EnglishScope english;  // for other programs
          return resultText(*table, form);
        });
    });
  }
  button->setMenu(menu);
  return button;
}

/// Large matrices are written beside the window's thread; what would take long is no text for a clipboard.
void MatricesPanel::copy(std::function<std::string()> write) {
  constexpr qint64 kMaxEntries = 4'000'000;  // some 0.1 s and 16 MB
  const qint64 entries = qint64{m_model->rowCount()} * m_model->columnCount();
  if (entries > kMaxEntries) {
    return emit rejected(
        tr("A matrix of %1 entries is too large to be copied. Export it as CSV.").arg(entries));
  }
  m_writer.request(std::move(write));
}

void MatricesPanel::addChip(QLayout* layout, const NamedResult& result) {
  const bool isRate = result.term == Term::solution;
  QToolButton* chip = isRate ? new RateChip(this) : new QToolButton(this);
  const QString tip = tipOf(result);
  chip->setText(isRate ? QStringLiteral("θ") : withoutParts(result));
  chip->setAccessibleName(
      QString(tip).section(QLatin1String("<br>"), 0, 0).remove(QRegularExpression("<[^>]*>")));
  chip->setObjectName(QStringLiteral("chip.") + shownText(result.name));
  chip->setToolTip(tip);
  chip->setCheckable(true);
  chip->setProperty("look", "symbol");
  m_chips->addButton(chip, static_cast<int>(m_results.size()));
  m_results.push_back(&result);
  layout->addWidget(chip);
}

/// The chosen one has room to tell its parts, "C=[T|U]".
void MatricesPanel::nameChip(int id, bool isChosen) {
  const NamedResult& result = *m_results[static_cast<std::size_t>(id)];
  const QString symbol = shownText(result.symbol);
  if (!symbol.contains(QLatin1Char('='))) return;
  // Those that are not in the paper are told by the card.
  const bool hasParts = isChosen && result.equation(EntryForm::fractions) != PaperEquation::none;
  m_chips->button(id)->setText(hasParts ? QString(symbol).remove(QLatin1Char(' ')) : withoutParts(result));
}

QToolButton* MatricesPanel::makeFormButton() {
  auto* button = controlButton(QStringLiteral("entryForm"), {},
                               tr("How the entries are shown: decimals, fractions or symbols"), this);
  button->setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(button);
  for (const EntryForm form : {EntryForm::decimals, EntryForm::fractions, EntryForm::symbols}) {
    QAction* action = menu->addAction(formName(form), this, [this, form] { chooseForm(form); });
    action->setData(static_cast<int>(form));
  }
  button->setMenu(menu);
  return button;
}

void MatricesPanel::chooseForm(EntryForm form) {
  m_model->setWantedForm(form);
}

QFrame* MatricesPanel::makeCard() {
  m_card = new QFrame(this);
  m_card->setProperty("look", "card");
  m_card->setFixedWidth(kCardWidth);
  m_card->installEventFilter(this);
  m_cardTitle = new QLabel(m_card);
  m_cardTitle->setProperty("look", "title");
  m_cardTitle->setWordWrap(true);
  m_cardTitle->setObjectName(QStringLiteral("cellTitle"));
  m_cardText = new QLabel(m_card);
  m_cardText->setProperty("look", "hint");
  m_cardText->setWordWrap(true);
  m_cardText->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  m_cardText->setObjectName(QStringLiteral("cellText"));
  auto* layout = new QVBoxLayout(m_card);
  layout->setContentsMargins(11, 8, 9, 9);
  layout->setSpacing(4);
  layout->addWidget(m_cardTitle);
  layout->addWidget(m_cardText);
  return m_card;
}

void MatricesPanel::setSnapshot(const SnapshotPtr& snapshot) {
  m_model->setSnapshot(snapshot);
}

void MatricesPanel::setPreview(std::optional<PreviewSnapshot> preview) {
  m_model->setPreview(std::move(preview));
}

void MatricesPanel::wantExport() {
  if (m_model->table()) emit exportWanted(m_model->table());
}

void MatricesPanel::showResult(const NamedResult& result) {
  m_chips->button(placeOf(m_results, result))->setChecked(true);
  m_model->setResult(result);
}

/// The card tells what the cell under the mouse means; without one, what the matrix is.
void MatricesPanel::explain(const QModelIndex& index) {
  const bool onCell = index.isValid() && m_model->checkIndex(index);
  if (onCell) {
    const CellExplanation cell = m_model->explanation(index);
    m_cardTitle->setText(shownText(cell.title));
    m_cardText->setText(shownText(cell.text));
    if (m_card->isHidden()) {
      const QString tip = QStringLiteral("<b>%1</b><br>%2").arg(m_cardTitle->text(), m_cardText->text());
      QToolTip::showText(QCursor::pos(), tip, m_view);
    }
    return;
  }
  const NamedResult& result = m_model->result();
  const PaperEquation equation = result.term ? definitionOf(*result.term).equation : PaperEquation::none;
  m_cardTitle->setText(shownText(translated(result.term ? definitionOf(*result.term).name : result.title)));
  m_cardText->setText(shownText(definitionOf(result)) + (equation != PaperEquation::none
                                                             ? tr(" Eq. (%1)").arg(numberOf(equation))
                                                             : QString()));
}

void MatricesPanel::fitCard() {
  const int most = width() * 2 / 5, height = m_pages->height();
  int fitting = scaledPixels(kCardWidth);
  for (const int wider : {kCardWidth, kCardWidth * 4 / 3, kCardWidth * 5 / 3}) {
    if (scaledPixels(wider) > std::max(most, fitting)) break;
    fitting = scaledPixels(wider);
    const bool isWideEnough = m_card->layout()->minimumSize().width() <= fitting;
    if (isWideEnough && m_card->layout()->totalHeightForWidth(fitting) <= height) break;
  }
  m_card->setFixedWidth(fitting);
}

void MatricesPanel::renew() {
  const bool there = m_model->isThere();
  const bool empty = !there || m_model->rowCount() == 0 || m_model->columnCount() == 0;
  m_copy->setEnabled(there);
  m_export->setEnabled(there);
  const QString why = whyEmpty();
  m_export->setToolTip(there ? tr("Export the matrix with its labels to a CSV file") : why);
  m_copy->setToolTip(there ? tr("Copy the matrix with its labels") : why);
  m_empty->setText(why);
  updateForm();
  m_pages->setCurrentWidget(empty ? static_cast<QWidget*>(m_empty) : m_view);
  explain({});
}

void MatricesPanel::updateForm() {
  const NamedResult& result = m_model->result();
  const ResultTablePtr& table = m_model->table();
  m_form->setVisible(!result.isWhole);
  m_form->setEnabled(!result.isWhole && table);
  if (!m_form->isEnabled()) return;
  m_form->setText(formName(table->form()) + QStringLiteral(" ▾"));
  const std::vector<EntryForm> forms = result.forms({m_model->snapshot()});
  for (QAction* action : m_form->menu()->actions()) {
    const auto form = static_cast<EntryForm>(action->data().toInt());
    action->setEnabled(std::find(forms.begin(), forms.end(), form) != forms.end());
  }
}

/// Of a result that is not of the graph alone.
QString MatricesPanel::whyNoTable() const {
  for (const Diagnostic& diagnostic : m_model->snapshot()->diagnostics) {
    if (diagnostic.severity() == Severity::error) return shownText(diagnostic.message);
  }
  if (m_model->result().isWhole)
    return tr("A mesh has no carrier in the T–T graph, or its kind is not known.");
  return tr("The equations are too many to be written out.");
}

QString MatricesPanel::whyEmpty() const {
  const SnapshotPtr& snapshot = m_model->snapshot();
  if (!snapshot) return tr("The matrices appear as soon as the mechanism is analysed.");
  const bool isOfGraph = m_model->result().of == ResultOf::graph;
  if (!isOfGraph && !m_model->isThere() && snapshot->mechanism->t() > 0) return whyNoTable();
  if (!m_model->isThere()) {
    QString why;
    for (const Diagnostic& diagnostic : snapshot->diagnostics) {
      const bool treeless = diagnostic.code == Code::disconnected || diagnostic.code == Code::turningLoop;
      if (treeless && why.isEmpty()) why = shownText(diagnostic.message);
    }
    return tr("This matrix needs the turning joints to be a spanning tree.") + QStringLiteral("\n") + why;
  }
  if (snapshot->mechanism->n() == 0) return tr("Draw the first link: L, then click.");
  if (snapshot->mechanism->t() == 0) return tr("Draw a turning joint: T, then drag from a link to another.");
  return tr("Draw a gear mesh: G, then drag from a gear to the one it drives.");
}

/// Its text, or the type it is set in, has changed.
bool MatricesPanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched == m_card && event->type() == QEvent::LayoutRequest) fitCard();
  return QWidget::eventFilter(watched, event);
}

void MatricesPanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fitCard();
  m_card->setVisible(width() >= kWidthForCard);
}

QString MatricesPanel::emptyText() const {
  return m_pages->currentWidget() == m_empty ? m_empty->text() : QString();
}

ViewEntry matricesView() {
  return {.id = QStringLiteral("matrices"),
          .title = MatricesPanel::tr("Matrices"),
          .purpose = MatricesPanel::tr(
              "Every matrix of the Matroid method. Rest the mouse on an entry to have it explained."),
          .helpPage = QStringLiteral("digraph-and-matrices"),
          .searchWords = QStringLiteral("matrix table incidence path cycle"),
          .place = ViewPlace::bottom,
          .isPresented = true,
          .make = [](Views& views, QWidget* parent) -> ResultsView* {
            auto* panel = new MatricesPanel(views.selection(), parent);
            QObject::connect(panel, &MatricesPanel::rejected, &views, &Views::rejected);
            QObject::connect(&panel->view(), &MatrixView::menuWanted, &views, &Views::menuWanted);
            return panel;
          }};
}

}  // namespace geargraph

#include "moc_matrices_panel.cpp"
