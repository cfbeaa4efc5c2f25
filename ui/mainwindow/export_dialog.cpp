#include "ui/mainwindow/export_dialog.h"

#include <QBoxLayout>
#include <QButtonGroup>
#include <QDialogButtonBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QToolButton>

#include "ui/mainwindow/export_options_form.h"
#include "ui/mainwindow/export_preview_pane.h"
#include "ui/models/term_tips.h"
#include "ui/settings/settings.h"
#include "ui/theme/flow_layout.h"
#include "ui/theme/looks.h"
#include "ui/theme/theme_colors.h"

namespace geargraph {
namespace {

const QString kFormatKey = QStringLiteral("export/format");

/// The options of the last export in this format that mean the same in every document.
QString optionsKey(const Exporter& exporter) {
  return QStringLiteral("export/options/") + shownText(exporter.id);
}

OptionValues rememberedOptions(const Exporter& exporter) {
  OptionValues given;
  for (const QString& each : savedSetting(optionsKey(exporter)).toStringList()) {
    given.options[each.section(QLatin1Char('='), 0, 0).toStdString()] = {
        each.section(QLatin1Char('='), 1).toStdString()};
  }
  return given;
}

/// Texts are left out: they name links and joints of one document.
void rememberOptions(const Exporter& exporter, const OptionValues& given) {
  QStringList kept;
  for (const ExportOption& option : exporter.options) {
    const auto value = given.value(option.name);
    if (value && option.type != OptionType::text)
      kept << shownText(option.name) + QLatin1Char('=') + QString::fromStdString(*value);
  }
  saveSetting(optionsKey(exporter), kept);
}

}  // namespace

ExportDialog::ExportDialog(SnapshotPtr live, ExportedDocument document, QWidget* parent)
    : QDialog(parent),
      m_live(std::move(live)),
      m_document(std::move(document)),
      m_exporter(allExporters().front()),
      m_previews(makeExportPreviewService(this)),
      m_purposes(new QButtonGroup(this)),
      m_formats(new QListWidget(this)),
      m_what(new QLabel(this)),
      m_scroll(new QScrollArea(this)),
      m_usual(new QPushButton(tr("As usual"), this)),
      m_reason(new QLabel(this)),
      m_pane(new ExportPreviewPane(this)) {
  setObjectName(QStringLiteral("exportDialog"));
  setWindowTitle(tr("Export"));
  setAttribute(Qt::WA_DeleteOnClose);
  if (m_document.title.isEmpty()) m_document.title = tr("mechanism");
  m_formats->setObjectName(QStringLiteral("exportFormats"));
  m_formats->setAccessibleName(tr("Format"));
  m_formats->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  m_formats->setSpacing(1);
  m_formats->setWordWrap(true);
  m_reason->setObjectName(QStringLiteral("exportReason"));
  m_reason->setProperty("look", "problem");
  m_reason->setWordWrap(true);
  auto* columns = new QHBoxLayout;
  columns->addWidget(m_formats, 4);
  columns->addWidget(makeDetails(), 5);
  columns->addWidget(m_pane, 6);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(makePurposes());
  layout->addLayout(columns, 1);
  layout->addWidget(m_reason);
  layout->addWidget(makeButtons());
  const QSize room = parent != nullptr ? parent->screen()->availableSize() : QSize(1366, 768);
  resize(std::min(scaledPixels(960), room.width() - 40), std::min(scaledPixels(580), room.height() - 80));

  connect(m_formats, &QListWidget::currentItemChanged, this, [this](const QListWidgetItem* item) {
    const Exporter* chosen =
        item == nullptr ? nullptr : exporterWithId(item->data(Qt::UserRole).toString().toStdString());
    if (chosen == nullptr || chosen == m_exporter) return;
    m_exporter = chosen;
    showFormat();
  });
  connect(m_pane, &ExportPreviewPane::wanted, this, [this] { requestPreview(true); });
  m_previews->onAnswer(this, [this](const ExportPreviewPtr&) { showPreview(); });
  connect(m_previews, &ServiceSignals::failed, this, &ExportDialog::setWhy);
  const std::string last = savedSetting(kFormatKey).toString().toStdString();
  choose(exporterWithId(last) != nullptr ? last : allExporters().front()->id);
}

QWidget* ExportDialog::makePurposes() {
  auto* row = new QWidget(this);
  auto* flow = new FlowLayout(row);
  flow->setContentsMargins(0, 0, 0, 0);
  flow->addWidget(new QLabel(tr("What is it for?"), row));
  for (const ExportPurpose purpose : kExportPurposes) {
    auto* chip = new QToolButton(row);
    chip->setText(QString::fromStdString(exportPurposeTitle(purpose)));
    chip->setProperty("look", "chip");
    chip->setCheckable(true);
    chip->setFocusPolicy(Qt::StrongFocus);
    m_purposes->addButton(chip, static_cast<int>(purpose));
    flow->addWidget(chip);
  }
  connect(m_purposes, &QButtonGroup::idClicked, this, [this](int id) {
    const auto purpose = static_cast<ExportPurpose>(id);
    if (familyOf(*m_exporter).purpose == purpose) return;
    for (const ExportFamily& family : exportFamilies()) {
      if (family.purpose == purpose) return choose(family.exporters.front().id);
    }
  });
  return row;
}

QWidget* ExportDialog::makeDetails() {
  auto* details = new QWidget(this);
  auto* layout = new QVBoxLayout(details);
  layout->setContentsMargins(6, 0, 6, 0);
  m_what->setObjectName(QStringLiteral("exportWhat"));
  m_what->setWordWrap(true);
  m_what->setTextFormat(Qt::PlainText);
  m_usual->setObjectName(QStringLiteral("exportUsual"));
  m_usual->setToolTip(tr("Sets all options of this format back to what holds without them"));
  m_scroll->setWidgetResizable(true);
  m_scroll->setFrameShape(QFrame::NoFrame);
  m_scroll->viewport()->setAutoFillBackground(false);
  m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  layout->addWidget(m_what);
  layout->addWidget(m_scroll, 1);
  layout->addWidget(m_usual, 0, Qt::AlignLeft);
  connect(m_usual, &QPushButton::clicked, this, [this] { m_options->reset(); });
  return details;
}

QWidget* ExportDialog::makeButtons() {
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  m_export = buttons->addButton(tr("Export…"), QDialogButtonBox::AcceptRole);
  m_export->setDefault(true);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(buttons, &QDialogButtonBox::accepted, this, &ExportDialog::accept);
  return buttons;
}

void ExportDialog::accept() {
  saveSetting(kFormatKey, shownText(m_exporter->id));
  rememberOptions(*m_exporter, m_options->options());
  emit wanted(shownText(m_exporter->id), options());
  QDialog::accept();
}

void ExportDialog::setSnapshot(const SnapshotPtr& live) {
  m_live = live;
  updateReasons();
  requestPreview();
}

void ExportDialog::choose(std::string_view id) {
  m_exporter = exporterWithId(id);
  const ExportPurpose purpose = familyOf(*m_exporter).purpose;
  m_purposes->button(static_cast<int>(purpose))->setChecked(true);
  listFormats(purpose);
  showFormat();
}

/// A heading for each family, which cannot be chosen, and its formats below it.
void ExportDialog::listFormats(ExportPurpose purpose) {
  const QSignalBlocker blocker(m_formats);
  m_formats->clear();
  QPixmap indent(scaledPixels(8), 1);  // of all lines of a title that wraps
  indent.fill(Qt::transparent);
  for (const ExportFamily& family : exportFamilies()) {
    if (family.purpose != purpose) continue;
    auto* heading = new QListWidgetItem(spoken(family.title), m_formats);
    heading->setFlags(Qt::NoItemFlags);
    QFont bold = m_formats->font();
    bold.setBold(true);
    heading->setFont(bold);
    for (const Exporter& exporter : family.exporters) {
      auto* item = new QListWidgetItem(QIcon(indent), spoken(exporter.title), m_formats);
      item->setData(Qt::UserRole, shownText(exporter.id));
      if (&exporter == m_exporter) m_formats->setCurrentItem(item);
    }
  }
  // As wide as the longest of them, up to a third of the dialog.
  m_formats->setMinimumWidth(std::min(m_formats->sizeHintForColumn(0) + scaledPixels(24), scaledPixels(300)));
  updateReasons();
}

/// Formats that the document has nothing for are dimmed and say why; they can be chosen, to read it.
void ExportDialog::updateReasons() {
  for (int row = 0; row < m_formats->count(); ++row) {
    QListWidgetItem* item = m_formats->item(row);
    const Exporter* exporter = exporterWithId(item->data(Qt::UserRole).toString().toStdString());
    if (exporter == nullptr) continue;
    const QString why = m_live ? QString::fromStdString(unmetNeed(*exporter, *m_live)) : QString();
    item->setData(Qt::ForegroundRole,
                  why.isEmpty() ? QVariant() : QVariant(disabledColor(themeOf(palette()))));
    item->setToolTip(why.isEmpty() ? item->text() : why);
    item->setData(Qt::AccessibleDescriptionRole, why);
  }
}

void ExportDialog::showFormat() {
  m_what->setText(tr("%1: %2.").arg(spoken(m_exporter->title), spoken(m_exporter->what)));
  m_options = new ExportOptionsForm(*m_exporter, m_scroll);
  m_options->setOptions(rememberedOptions(*m_exporter));
  m_scroll->setWidget(m_options);  // deletes the one before
  m_options->setAutoFillBackground(false);
  connect(m_options, &ExportOptionsForm::changed, this, &ExportDialog::onOptions);
  m_pane->clear();
  onOptions();
}

void ExportDialog::onOptions() {
  m_usual->setVisible(!m_exporter->options.empty());
  m_usual->setEnabled(!m_options->isUsual());
  requestPreview();
}

OptionValues ExportDialog::options() const {
  return withImplied(*m_exporter, m_options->options());
}

ExportPreviewPtr ExportDialog::preview() const {
  const ExportPreviewPtr& newest = m_previews->answer();
  return m_previews->isComplete() && newest && newest->isFinished ? newest : nullptr;
}

void ExportDialog::requestPreview(bool isAsked) {
  const QString why = m_live ? QString::fromStdString(unmetNeed(*m_exporter, *m_live)) : QString();
  setWhy(why);
  if (!m_live || !why.isEmpty()) {
    m_previews->cancel();
    return m_pane->clear();
  }
  const bool isLong = m_exporter->need != ExportNeed::nothing && m_live->mechanism->n() > kQuickLinks;
  if (isLong && !isAsked) {
    m_previews->cancel();
    return m_pane->offer();
  }
  m_previews->request({m_live->mechanism, m_live, m_document, m_exporter, options()});
  m_previews->isComplete() ? showPreview() : m_pane->wait();  // complete: the same as before
}

void ExportDialog::showPreview() {
  const ExportPreviewPtr& preview = m_previews->answer();
  if (!preview) return;
  if (preview->isFinished) setWhy(preview->why);
  m_pane->show(*preview, *m_exporter);
}

/// The reason stands where it is read before the button: nothing is written while there is one.
void ExportDialog::setWhy(const QString& why) {
  m_reason->setText(why);
  m_reason->setVisible(!why.isEmpty());
  m_export->setEnabled(why.isEmpty());
  m_export->setToolTip(why.isEmpty() ? tr("Asks where, and writes it") : why);
}

}  // namespace geargraph

#include "moc_export_dialog.cpp"
