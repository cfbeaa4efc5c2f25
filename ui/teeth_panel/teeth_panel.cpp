#include "ui/teeth_panel/teeth_panel.h"

#include <QBoxLayout>
#include <QClipboard>
#include <QCoreApplication>
#include <QFile>
#include <QFileDialog>
#include <QGuiApplication>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QScrollArea>
#include <QScrollBar>
#include <QSplitter>
#include <QStackedWidget>
#include <QToolButton>
#include <algorithm>

#include "core/design/teeth_search/teeth_certificate.h"
#include "core/design/teeth_search/teeth_json.h"
#include "core/foundations/files/file.h"
#include "core/mechanism/model/difference.h"
#include "ui/models/printed_number.h"
#include "ui/models/term_tips.h"
#include "ui/teeth_panel/choices_table.h"
#include "ui/teeth_panel/wish_form.h"
#include "ui/theme/control_button.h"
#include "ui/theme/empty_label.h"
#include "ui/theme/looks.h"
#include "ui/theme/sideways_scroll.h"
#include "ui/theme/theme_colors.h"

namespace geargraph {
namespace {

constexpr int kPause = 150;    // ms
constexpr int kSilence = 200;  // ms
constexpr int kTelling = 100;  // ms
constexpr int kSteps = 1000;
constexpr int kFormWidth = 300;
constexpr int kLeastFormWidth = 230;

QString countedChoices(std::int64_t number) {
  return QLocale().toString(static_cast<qlonglong>(number));
}

QString conditionText(const std::string& name, std::int64_t count) {
  const QString number = countedChoices(count);
  if (name == "turns") return TeethPanel::tr("%1 turn").arg(number);
  if (name == "clears") return TeethPanel::tr("%1 with planets that clear each other").arg(number);
  if (name == "assembles") return TeethPanel::tr("%1 with equal planets that go in").arg(number);
  if (name == "hunting") return TeethPanel::tr("%1 with hunting teeth only").arg(number);
  if (name == "undercut") return TeethPanel::tr("%1 without undercut").arg(number);
  return TeethPanel::tr("%1 within the tolerance").arg(number);
}

}  // namespace

TeethPanel::TeethPanel(Document* document, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_service(new TeethService(this)),
      m_model(new ChoicesModel(this)),
      m_table(new ChoicesTable(m_model, this)),
      m_form(new TeethWishForm(this)),
      m_whole(new QStackedWidget(this)),
      m_empty(emptyLabel(this, tr("Draw a train with gear pairs; then say which ratio it should have, and "
                                  "every choice of whole teeth within your limits is tried."))) {
  auto* parts = new QSplitter(this);
  parts->addWidget(makeLeft());
  parts->addWidget(makeRight());
  parts->setStretchFactor(1, 1);
  parts->setChildrenCollapsible(false);
  parts->setSizes({scaledPixels(kFormWidth), 4 * scaledPixels(kFormWidth)});
  m_whole->addWidget(parts);
  m_whole->addWidget(m_empty);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_whole);
  setBackgroundRole(QPalette::Base);
  setAutoFillBackground(true);

  m_pause.setSingleShot(true);
  m_pause.setInterval(kPause);
  connect(&m_pause, &QTimer::timeout, this, &TeethPanel::search);
  m_silence.setSingleShot(true);
  m_silence.setInterval(kSilence);
  connect(&m_silence, &QTimer::timeout, this, [this] {
    m_telling.start(kTelling);
    showRunning();
  });
  connect(&m_telling, &QTimer::timeout, this, &TeethPanel::showRunning);
  connect(m_form, &TeethWishForm::edited, this, &TeethPanel::searchSoon);
  m_service->onAnswer(this, [this](const TeethResultPtr&) { showResult(); });
  connect(m_service, &TeethService::failed, this, [this](const QString& why) {
    showResult();
    m_hint->setText(tr("The teeth could not be searched: %1").arg(why));
    m_pages->setCurrentWidget(m_hint);
  });
  connect(document, &Document::changed, this, &TeethPanel::onDocument);
  connect(document, &Document::replaced, this, &TeethPanel::onReplaced);
  connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this, &TeethPanel::onRow);
  connect(m_table, &ChoicesTable::taken, this, &TeethPanel::take);
  connect(m_table, &ChoicesTable::putBack, m_table, &QTableView::clearSelection);
  connect(m_table, &ChoicesTable::copyWanted, this, &TeethPanel::copy);
  m_whole->setCurrentIndex(hasMeshes() ? 0 : 1);
  m_form->setMechanism(document->mechanism());
  showResult();
}

QWidget* TeethPanel::makeLeft() {
  auto* scroll = new QScrollArea(this);
  scroll->setWidget(m_form);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setMinimumWidth(
      std::max(scaledPixels(kLeastFormWidth),
               m_form->minimumSizeHint().width() + scroll->verticalScrollBar()->sizeHint().width()));
  return scroll;
}

QWidget* TeethPanel::makeSearchBar() {
  auto* bar = new QWidget(this);
  m_badge = new QLabel(bar);
  m_badge->setObjectName(QStringLiteral("teethBadge"));
  m_badge->setProperty("look", "verdict");
  m_progress = new QProgressBar(bar);
  m_progress->setRange(0, kSteps);
  m_progress->setTextVisible(false);
  m_progress->setFixedSize(scaledPixels(120), 6);
  m_progress->setAccessibleName(tr("How much of the search is done"));
  m_stop = controlButton(QStringLiteral("stopTeeth"), tr("Stop"), {}, bar);
  connect(m_stop, &QToolButton::clicked, this, &TeethPanel::stopOrGoOn);
  auto* layout = new QHBoxLayout(bar);
  layout->setContentsMargins(8, 6, 10, 0);
  layout->setSpacing(8);
  layout->addWidget(m_badge);
  layout->addWidget(m_progress);
  layout->addWidget(m_stop);
  layout->addStretch(1);
  return bar;
}

QWidget* TeethPanel::makeFoot() {
  auto* foot = new QWidget(this);
  m_certificate = controlButton(QStringLiteral("saveCertificate"), tr("Save certificate…"), {}, foot);
  m_copy =
      controlButton(QStringLiteral("copyChoices"), tr("Copy"), tr("Copy the table as CSV (Ctrl+C)"), foot);
  m_csv = controlButton(QStringLiteral("exportChoices"), tr("CSV…"), tr("Save the table as CSV"), foot);
  m_use = controlButton(QStringLiteral("useTeeth"), tr("Use these teeth"), {}, foot);
  connect(m_certificate, &QToolButton::clicked, this, &TeethPanel::chooseCertificate);
  connect(m_copy, &QToolButton::clicked, this, &TeethPanel::copy);
  connect(m_csv, &QToolButton::clicked, this,
          [this] { emit exportWanted(QStringLiteral("teeth.csv"), m_model->csv()); });
  connect(m_use, &QToolButton::clicked, this, [this] { take(m_table->chosenRow()); });
  auto* layout = new QHBoxLayout(foot);
  layout->setContentsMargins(8, 2, 10, 6);
  layout->setSpacing(6);
  layout->addWidget(m_certificate);
  layout->addWidget(m_copy);
  layout->addWidget(m_csv);
  layout->addStretch(1);
  layout->addWidget(m_use);
  return foot;
}

QWidget* TeethPanel::makeRight() {
  auto* right = new QWidget(this);
  auto* bar = new SidewaysScroll(makeSearchBar(), right);
  m_funnel = new QLabel(right);
  m_funnel->setObjectName(QStringLiteral("teethFunnel"));
  m_funnel->setProperty("look", "hint");
  m_funnel->setWordWrap(true);
  m_funnel->setContentsMargins(8, 0, 10, 0);
  m_table->setObjectName(QStringLiteral("teethChoices"));
  m_table->setAccessibleName(tr("Choices of teeth"));
  m_hint = emptyLabel(right);
  m_pages = new QStackedWidget(right);
  m_pages->addWidget(m_hint);
  m_pages->addWidget(m_table);
  m_pages->setMinimumHeight(scaledPixels(60));
  auto* layout = new QVBoxLayout(right);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(3);
  layout->addWidget(bar);
  layout->addWidget(m_funnel);
  layout->addWidget(m_pages, 1);
  layout->addWidget(new SidewaysScroll(makeFoot(), right));
  return right;
}

void TeethPanel::setAwake(bool awake) {
  if (awake == m_isAwake) return;
  m_isAwake = awake;
  if (awake) return onDocument();
  endPreview();
  if (!m_pause.isActive()) return;
  m_pause.stop();
  if (isSettled()) emit settled();
}

bool TeethPanel::isSettled() const {
  return !m_pause.isActive() && m_service->isComplete();
}

QString TeethPanel::emptyText() const {
  return hasMeshes() ? QString() : m_empty->text();
}

QString TeethPanel::badge() const {
  return m_badge->text();
}

QString TeethPanel::funnel() const {
  return m_funnel->text();
}

/// Out of sight nothing is searched.
void TeethPanel::onDocument() {
  m_isPreviewed = false;  // what is derived follows the document again
  m_whole->setCurrentIndex(hasMeshes() ? 0 : 1);
  if (!m_isAwake) return;
  m_form->setMechanism(m_document->mechanism());
  searchSoon();
}

void TeethPanel::onReplaced() {
  m_pause.stop();
  m_form->reset(m_document->mechanism());
  m_service->forget();
  if (m_isAwake) searchSoon();
}

void TeethPanel::searchSoon() {
  endPreview();
  if (!m_isAwake || !hasMeshes()) {
    m_pause.stop();
    updateButtons();
    return;
  }
  m_pause.start();
  updateButtons();
}

void TeethPanel::search() {
  m_service->search(m_document->placed(), m_form->wish(), m_form->isWhole(), m_form->meant());
  if (m_service->isComplete()) return showResult();  // the last answer is also the one to this
  if (!m_silence.isActive() && !m_telling.isActive()) m_silence.start();
}

void TeethPanel::askForRatio() {
  m_form->askForRatio();
}

void TeethPanel::stopOrGoOn() {
  m_service->isComplete() ? search() : m_service->halt();
}

void TeethPanel::showRunning() {
  setBadge(tr("%1 so far").arg(countedChoices(m_service->found())), false);
  m_progress->setValue(qRound(kSteps * m_service->share()));
  m_progress->show();
  m_stop->setText(tr("Stop"));
  m_stop->setToolTip(tr("End the search; what was found stays"));
  m_stop->show();
}

void TeethPanel::setBadge(const QString& text, bool isFine) {
  m_badge->setText(text);
  setInk(*m_badge, isFine ? ColorRole::fine : ColorRole::ink);
  m_badge->setVisible(!text.isEmpty());
}

void TeethPanel::showResult() {
  m_silence.stop();
  m_telling.stop();
  m_progress->hide();
  m_stop->hide();
  const TeethResultPtr& result = m_service->answer();
  const QString problems = m_form->showProblems(result ? result->problems : Diagnostics());
  m_form->setRatiosNow(result ? result->ratiosNow : std::vector<std::optional<Rational>>());
  const std::vector<int> order = result && result->answer ? result->answer->found.order : std::vector<int>();
  if (result && result->problem) m_form->wheels().setProblem(*result->problem, order);
  const bool isPreviewed = m_isPreviewed;
  m_isFilling = true;
  m_model->setResult(result);
  m_isFilling = false;
  if (isPreviewed) endPreview();
  m_form->wheels().setChosen({}, {});
  m_funnel->clear();
  setBadge({}, false);
  if (result && result->meant) {
    showMeant(*result);
  } else if (result && result->answer) {
    showFound(*result->answer);
  } else if (!problems.isEmpty()) {
    m_hint->setText(problems);
  } else if (result && !result->problems.empty()) {
    m_hint->setText(tr("The wish cannot be met as it is: see beside its fields."));
  } else {
    m_hint->setText(tr("Type the ratio that you want: every choice of whole teeth is tried."));
  }
  m_funnel->setVisible(!m_funnel->text().isEmpty());
  m_pages->setCurrentIndex(m_model->rowCount() > 0 ? 1 : 0);
  updateButtons();
  if (isSettled()) emit settled();
}

void TeethPanel::showFound(const TeethAnswer& answer) {
  const TeethCounts& counts = answer.found.counts;
  setBadge(answer.found.isComplete
               ? tr("All %1 choices tried: complete").arg(countedChoices(counts.tried))
               : tr("Stopped after %1 choices: not complete").arg(countedChoices(counts.tried)),
           answer.found.isComplete);
  if (!answer.found.isComplete) offerNewSearch();
  QStringList steps;
  for (const auto& [name, count] : filtersOf(*answer.problem, counts)) steps << conditionText(name, count);
  steps << tr("%1 meet the wish").arg(countedChoices(counts.accepted));
  if (counts.accepted > static_cast<std::int64_t>(answer.choices.size()) && !answer.choices.empty())
    steps << tr("the best %1 are shown").arg(answer.choices.size());
  QString line = steps.join(QStringLiteral(" · "));
  if (answer.choices.empty() && answer.nearest) {
    QStringList misses;
    for (std::size_t ratio = 0; ratio < answer.nearest->found.ratios.size(); ++ratio)
      misses << tr("%1, off by %2")
                    .arg(withPrintedMinus(
                             QString::fromStdString(answer.nearest->found.ratios[ratio].toString())),
                         errorText(answer.nearest->found.errors[ratio]));
    line += QLatin1Char('\n') + tr("None. Nearest: %1").arg(misses.join(QStringLiteral("; ")));
  }
  for (const std::string& conflict : conflictSentences(answer))
    line += QLatin1Char('\n') + QString::fromStdString(conflict);
  if (std::any_of(answer.choices.begin(), answer.choices.end(),
                  [](const TeethChoice& choice) { return !choice.undercut.empty(); }))
    line += QStringLiteral(" · ") + tr("u: undercut; a profile shift mends it");
  m_funnel->setText(line);
  if (answer.choices.empty() && !answer.nearest)
    m_hint->setText(
        answer.found.isComplete
            ? tr("No choice of teeth is left: the line above says where they end. Wider limits, or "
                 "more wheels that may change, give more.")
            : tr("Nothing was found yet."));
}

void TeethPanel::showMeant(const TeethResult& result) {
  const MeantTeeth& meant = *result.meant;
  const bool isComplete = result.answer->found.isComplete;
  setBadge(isComplete
               ? tr("All %1 choices near the drawn teeth tried: complete").arg(countedChoices(meant.tried))
               : tr("Stopped after %1 choices: not complete").arg(countedChoices(meant.tried)),
           isComplete);
  if (!isComplete) offerNewSearch();
  QStringList lines;
  for (std::size_t ratio = 0; ratio < meant.drawn.size(); ++ratio) {
    const auto& drawn = meant.drawn[ratio];
    const QString text = drawn ? withPrintedMinus(QString::fromStdString(drawn->toString())) : tr("none");
    const QString number = QString::number(ratio + 1);
    lines << (meant.fits[ratio] != 0
                  ? tr("Ratio %1 of the drawn teeth: %2, as stated").arg(number, text)
                  : tr("Ratio %1 of the drawn teeth: %2, not the stated one").arg(number, text));
  }
  if (meant.changed > 0) {
    lines << tr("Wheels that differ: %1, choices: %2")
                 .arg(meant.changed)
                 .arg(countedChoices(static_cast<std::int64_t>(meant.choices.size())));
  }
  m_funnel->setText(lines.join(QLatin1Char('\n')));
  if (meant.choices.empty())
    m_hint->setText(isComplete
                        ? tr("No teeth near the drawn ones have all stated ratios. More wheels that may "
                             "differ, or by more teeth, give more.")
                        : tr("Nothing was found yet."));
}

void TeethPanel::offerNewSearch() {
  m_stop->setText(tr("Search anew"));
  m_stop->setToolTip(tr("Search from the beginning"));
  m_stop->show();
}

/// Are the choices those of the wish and the train as they are now?
bool TeethPanel::isCurrent() const {
  const TeethResultPtr& result = m_service->answer();
  if (!result || !result->answer || !isSettled()) return false;
  const MechanismPtr& now = m_document->mechanism();
  return result->drawn == now || isSameButForView(*result->drawn, *now);
}

void TeethPanel::updateButtons() {
  const bool isChosen = m_table->chosenRow() >= 0;
  m_use->setEnabled(isChosen && isCurrent());
  m_use->setToolTip(isChosen ? tr("Give the train the teeth of the chosen row (Enter); Ctrl+Z undoes it")
                             : tr("Choose a row first"));
  m_copy->setEnabled(m_model->rowCount() > 0);
  m_csv->setEnabled(m_model->rowCount() > 0);
  m_certificate->setEnabled(mayCertify());
  m_certificate->setToolTip(mayCertify() ? tr("Save what proves that there are no other choices")
                                         : tr("There is a certificate when all choices have been tried"));
}

Edit TeethPanel::editOf(int row) const {
  return {tr("Choose teeth"),
          [choice = m_model->choiceAt(row)](const PlacedMechanism& before) {
            return withTeethChosen(before, choice);
          },
          0};
}

void TeethPanel::onRow() {
  if (m_isFilling) return;
  const int row = m_table->chosenRow();
  updateButtons();
  if (row < 0) {
    m_form->wheels().setChosen({}, {});
    return endPreview();
  }
  const int rank = m_model->rankAt(row);
  m_form->wheels().setChosen(m_model->choiceAt(row).found.teeth,
                             rank > 0 ? tr("choice %1").arg(rank) : tr("nearest"));
  if (!isCurrent()) return;
  m_isPreviewed = true;
  emit previewWanted(editOf(row));
}

void TeethPanel::endPreview() {
  if (!m_isPreviewed) return;
  m_isPreviewed = false;
  emit previewEnded();
}

void TeethPanel::take(int row) {
  if (row < 0 || row >= m_model->rowCount() || !isCurrent()) return;
  const Edit edit = editOf(row);  // before the choices are replaced
  if (!m_document->apply(edit)) endPreview();
}

void TeethPanel::copy() {
  if (m_model->rowCount() > 0) QGuiApplication::clipboard()->setText(m_model->csv());
}

bool TeethPanel::mayCertify() const {
  return isCurrent() && !m_service->answer()->meant && m_service->answer()->answer->found.isComplete;
}

void TeethPanel::chooseCertificate() {
  if (!mayCertify()) return;
  const QString path =
      QFileDialog::getSaveFileName(this, tr("Save certificate"), QStringLiteral("teeth-certificate.json"),
                                   tr("JSON files (*.json);;All files (*)"));
  if (!path.isEmpty() && mayCertify()) saveCertificate(path);
}

void TeethPanel::saveCertificate(const QString& path) {
  const TeethResult& result = *m_service->answer();
  const auto certificate =
      teethCertificate(*result.answer, result.wish, QCoreApplication::applicationVersion().toStdString());
  if (!certificate) return emit rejected(shownText(certificate.error().front().message));
  if (const auto error = writeFile(QFile::encodeName(path).toStdString(), *certificate))
    emit rejected(shownText(error->message));
}

}  // namespace geargraph

#include "moc_teeth_panel.cpp"
