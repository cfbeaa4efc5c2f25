#include "ui/reading/derivation_panel.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QLabel>
#include <QStackedWidget>
#include <QToolButton>

#include "ui/theme/empty_label.h"
#include "ui/workbench/views.h"

namespace geargraph {

DerivationPanel::DerivationPanel(Selection* selection, QWidget* parent)
    : QWidget(parent), m_service(new DerivationService(this)), m_view(new DerivationView(selection, this)) {
  m_view->setObjectName(QStringLiteral("derivationView"));
  m_empty = emptyLabel(this);
  m_pages = new QStackedWidget(this);
  m_pages->addWidget(m_view);
  m_pages->addWidget(m_empty);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(makeBar());
  layout->addWidget(m_pages, 1);
  m_service->onAnswer(this, [this](const DerivationPtr& derivation) { showDerivation(*derivation); });
  connect(m_service, &DerivationService::failed, this, [this](const QString& why) {
    showText(tr("The derivation could not be worked out: %1").arg(why));
  });
  connect(m_view, &DerivationView::headingChanged, m_sections, &QComboBox::setCurrentIndex);
  connect(m_sections, &QComboBox::activated, m_view, &DerivationView::showHeading);
  connect(m_export, &QToolButton::clicked, this, &DerivationPanel::exportWanted);
  connect(m_handout, &QToolButton::clicked, this, &DerivationPanel::handoutWanted);
  showText(tr("The derivation appears here, both methods step by step."));
}

QWidget* DerivationPanel::makeBar() {
  auto* bar = new QWidget(this);
  auto* layout = new QHBoxLayout(bar);
  layout->setContentsMargins(8, 4, 8, 4);
  m_sections = new QComboBox(bar);
  m_sections->setObjectName(QStringLiteral("derivationSections"));
  m_sections->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  m_sections->setMinimumContentsLength(16);
  m_sections->setToolTip(tr("The sections of the derivation"));
  m_export = new QToolButton(bar);
  m_export->setText(tr("Export…"));
  m_export->setToolTip(tr("Write the derivation as a web page, PDF, LaTeX or Markdown"));
  m_export->setProperty("look", "control");
  layout->addWidget(m_sections);
  layout->addStretch(1);
  m_handout = new QToolButton(bar);
  m_handout->setObjectName(QStringLiteral("handoutNow"));
  m_handout->setText(tr("Handout"));
  m_handout->setToolTip(
      tr("Writes a page for any browser beside the document, at once: drawings, matrices, derivation and "
         "the train in 3D, with inputs that move"));
  m_handout->setProperty("look", "control");
  layout->addWidget(m_handout);
  layout->addWidget(m_export);
  return bar;
}

void DerivationPanel::setSnapshot(const SnapshotPtr& snapshot, const QString& whyNot) {
  m_whyNot = whyNot;
  if (!snapshot->isComplete && whyNot.isEmpty()) return;
  m_snapshot = snapshot;
  renew();
}

void DerivationPanel::setAwake(bool awake) {
  m_isAwake = awake;
  renew();
}

void DerivationPanel::showSection(const QString& heading) {
  m_section = heading;
  if (m_view->report() != nullptr && isUpToDate()) showWantedSection();
}

void DerivationPanel::showWantedSection() {
  if (m_section.isEmpty()) return;
  int section = 0;
  for (std::size_t i = 0; i < m_view->headings().size(); ++i) {
    const auto& block = m_view->report()->report().blocks[m_view->headings()[i]];
    if (QString::fromStdString(std::get<ReportHeading>(block).text) == m_section)
      section = static_cast<int>(i);
  }
  m_section.clear();
  m_view->showHeading(section);
}

void DerivationPanel::renew() {
  if (!m_whyNot.isEmpty()) return showText(m_whyNot);
  if (!m_isAwake || m_snapshot == nullptr || m_wanted == m_snapshot) return;
  if (m_view->report() == nullptr) showText(tr("The derivation is being worked out…"));
  m_wanted = m_snapshot;
  m_shown = nullptr;
  m_service->request({m_snapshot, m_view->currentLayout()});
}

void DerivationPanel::showDerivation(const Derivation& derivation) {
  if (!m_whyNot.isEmpty()) return;
  m_shown = m_wanted;
  m_view->setDerivation(derivation);
  fillSections();
  m_pages->setCurrentWidget(m_view);
  m_sections->setEnabled(true);
  m_export->setEnabled(true);
  m_handout->setEnabled(true);
  showWantedSection();
  emit reportShown();
}

void DerivationPanel::showText(const QString& text) {
  m_empty->setText(text);
  m_pages->setCurrentWidget(m_empty);
  m_sections->clear();
  m_sections->setEnabled(false);
  m_export->setEnabled(false);
  m_handout->setEnabled(false);
  m_view->setReport(nullptr);
  m_wanted = nullptr;
  m_shown = m_snapshot;
}

QString DerivationPanel::emptyText() const {
  return m_pages->currentWidget() == m_empty ? m_empty->text() : QString();
}

void DerivationPanel::fillSections() {
  QStringList names;
  for (const std::size_t block : m_view->headings()) {
    const auto& heading = std::get<ReportHeading>(m_view->report()->report().blocks[block]);
    names += (heading.level > 1 ? QStringLiteral("    ") : QString()) + QString::fromStdString(heading.text);
  }
  QStringList there;
  for (int i = 0; i < m_sections->count(); ++i) there += m_sections->itemText(i);
  if (names != there) {
    m_sections->clear();
    m_sections->addItems(names);
  }
  m_sections->setCurrentIndex(m_view->currentHeading());
}

QString whyNoDerivation(const Mechanism& mechanism) {
  if (mechanism.n() == 0) return DerivationPanel::tr("There is nothing drawn to derive anything for.");
  if (mechanism.n() <= kMaxReportLinks) return {};
  return DerivationPanel::tr(
             "A derivation of more than %1 links is not written: it would be too long to read.")
      .arg(kMaxReportLinks);
}

void DerivationPanel::setSnapshot(const SnapshotPtr& snapshot) {
  setSnapshot(snapshot, whyNoDerivation(*snapshot->mechanism));
}

ViewEntry derivationView() {
  return {.id = QStringLiteral("derivation"),
          .title = DerivationPanel::tr("Derivation"),
          .purpose = DerivationPanel::tr("Both methods worked out step by step for this mechanism."),
          .helpPage = QStringLiteral("matroid-method"),
          .searchWords = QStringLiteral("proof steps explanation equations report"),
          .place = ViewPlace::bottom,
          .make = [](Views& views, QWidget* parent) -> ResultsView* {
            return new DerivationPanel(views.selection(), parent);
          }};
}

}  // namespace geargraph

#include "moc_derivation_panel.cpp"
