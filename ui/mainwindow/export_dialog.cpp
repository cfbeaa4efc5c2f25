#include "ui/mainwindow/export_dialog.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QStandardItemModel>

#include "ui/settings/settings.h"

namespace geargraph {
namespace {

const QString kExportFormatKey = QStringLiteral("export/format");
/// What a flag's field holds when it is set; any text would do.
const QString kSet = QStringLiteral("true");

QString wordOf(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

QString spoken(std::string_view text) {
  return text.empty() ? QString() : QString::fromStdString(translated(text));
}

/// A heading in the list, which cannot be chosen, and the formats of its family below it.
void addFamily(QComboBox& formats, const ExportFamily& family) {
  formats.addItem(spoken(family.title));
  auto* model = qobject_cast<QStandardItemModel*>(formats.model());
  QStandardItem* heading = model->item(formats.count() - 1);
  heading->setFlags(heading->flags() & ~(Qt::ItemIsSelectable | Qt::ItemIsEnabled));
  for (const Exporter& exporter : family.exporters)
    formats.addItem(QStringLiteral("   ") + spoken(exporter.title), wordOf(exporter.id));
}

/// "s, 1e-06 to 1"; bounds that nobody meets are left out.
QString boundsOf(const ExportOption& option) {
  constexpr double kFar = 1e6;
  const QString unit = spoken(option.unit);
  if (option.most >= kFar) return unit;
  const QString range =
      ExportDialog::tr("%1 to %2")
          .arg(QString::number(option.least, 'g', 12), QString::number(option.most, 'g', 12));
  return unit.isEmpty() ? range : unit + QStringLiteral(", ") + range;
}

}  // namespace

ExportDialog::ExportDialog(SnapshotPtr live, QWidget* parent)
    : QDialog(parent),
      m_live(std::move(live)),
      m_format(new QComboBox(this)),
      m_reason(new QLabel(this)),
      m_scroll(new QScrollArea(this)),
      m_export(nullptr) {
  setObjectName(QStringLiteral("exportDialog"));
  setWindowTitle(tr("Export"));
  setAttribute(Qt::WA_DeleteOnClose);
  m_format->setObjectName(QStringLiteral("exportFormat"));
  m_format->setMaxVisibleItems(24);
  for (const ExportFamily& family : exportFamilies()) addFamily(*m_format, family);
  m_reason->setObjectName(QStringLiteral("exportReason"));
  m_reason->setWordWrap(true);
  m_scroll->setWidgetResizable(true);
  m_scroll->setFrameShape(QFrame::NoFrame);
  m_scroll->viewport()->setAutoFillBackground(false);
  m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  m_export = buttons->addButton(tr("Export…"), QDialogButtonBox::AcceptRole);
  m_export->setDefault(true);

  auto* form = new QFormLayout;
  form->addRow(tr("Format"), m_format);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(form);
  layout->addWidget(m_reason);
  layout->addWidget(m_scroll, 1);
  layout->addWidget(buttons);
  resize(560, 480);

  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(buttons, &QDialogButtonBox::accepted, this, [this] {
    saveSetting(kExportFormatKey, m_format->currentData());
    emit wanted(m_format->currentData().toString(), options());
    accept();
  });
  connect(m_format, &QComboBox::currentIndexChanged, this, &ExportDialog::updateOptions);
  const std::string last = savedSetting(kExportFormatKey).toString().toStdString();
  choose(exporterWithId(last) != nullptr ? last : allExporters().front()->id);
  updateOptions();
}

void ExportDialog::setSnapshot(const SnapshotPtr& live) {
  m_live = live;
  updateReason();
}

void ExportDialog::choose(std::string_view id) {
  m_format->setCurrentIndex(m_format->findData(wordOf(id)));
}

const Exporter& ExportDialog::exporter() const {
  return *exporterWithId(m_format->currentData().toString().toStdString());
}

OptionValues ExportDialog::options() const {
  OptionValues given;
  for (const auto& [name, value] : m_fields) {
    const QString text = value();
    if (!text.isEmpty()) given.options[std::string(name)] = {text.toStdString()};
  }
  return withImplied(exporter(), std::move(given));
}

void ExportDialog::updateOptions() {
  m_fields.clear();
  auto* page = new QWidget(m_scroll);
  auto* form = new QFormLayout(page);
  for (const ExportOption& option : exporter().options) {
    QWidget* field = fieldFor(option);
    const QString help = spoken(exportOptionText(option.name).help);
    field->setObjectName(wordOf(option.name));
    field->setToolTip(help);
    const QString title = QString::fromStdString(exportOptionTitle(option.name));
    if (auto* box = qobject_cast<QCheckBox*>(field)) {
      box->setText(title);
      form->addRow(QString(), box);
    } else {
      field->setAccessibleName(title);
      form->addRow(title, field);
    }
  }
  if (m_fields.empty()) form->addRow(new QLabel(tr("This format has no options."), page));
  m_scroll->setWidget(page);  // deletes the one before
  page->setAutoFillBackground(false);
  updateReason();
}

void ExportDialog::updateReason() {
  const std::string why = m_live ? unmetNeed(exporter(), *m_live) : std::string();
  m_export->setEnabled(why.empty());
  m_reason->setVisible(!why.empty());
  m_reason->setText(QString::fromStdString(why));
}

QWidget* ExportDialog::fieldFor(const ExportOption& option) {
  if (option.type == OptionType::flag) {
    auto* box = new QCheckBox(m_scroll);
    m_fields.emplace_back(option.name, [box] { return box->isChecked() ? kSet : QString(); });
    return box;
  }
  if (option.type == OptionType::choice) {
    auto* box = new QComboBox(m_scroll);
    if (!option.isNeeded && option.otherwise.empty()) box->addItem(tr("As usual"), QString());
    for (const std::string& choice : option.choices())
      box->addItem(QString::fromStdString(choice), QString::fromStdString(choice));
    if (!option.otherwise.empty()) box->setCurrentIndex(box->findData(wordOf(option.otherwise)));
    m_fields.emplace_back(option.name, [box, usual = wordOf(option.otherwise)] {
      const QString chosen = box->currentData().toString();
      return chosen == usual ? QString() : chosen;
    });
    return box;
  }
  auto* line = new QLineEdit(m_scroll);
  const OptionText& text = exportOptionText(option.name);
  line->setPlaceholderText(option.otherwise.empty()
                               ? QStringLiteral("%1: %2").arg(wordOf(text.value), spoken(text.help))
                               : wordOf(option.otherwise));
  if (option.type != OptionType::number) {
    m_fields.emplace_back(option.name, [line] { return line->text().trimmed(); });
    return line;
  }
  m_fields.emplace_back(option.name, [line] {  // with the decimal sign of any language
    return line->text().trimmed().replace(QLatin1Char(','), QLatin1Char('.'));
  });
  auto* row = new QWidget(m_scroll);
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(line);
  const QString bounds = boundsOf(option);
  if (!bounds.isEmpty()) layout->addWidget(new QLabel(bounds, row));
  row->setFocusProxy(line);
  return row;
}

}  // namespace geargraph

#include "moc_export_dialog.cpp"
