#include "ui/mainwindow/csv_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QPushButton>

#include "ui/settings/settings.h"

namespace geargraph {
namespace {

const QString kSeparatorKey = QStringLiteral("csv/separator");
const QString kDecimalKey = QStringLiteral("csv/decimal");
const QString kLabelsKey = QStringLiteral("csv/labels");
const QString kMarkKey = QStringLiteral("csv/byteOrderMark");

/// A choice between characters; the one that was chosen last is proposed.
QComboBox* choice(const char* name, const QList<std::pair<QString, QChar>>& entries, const QString& key,
                  QWidget* parent) {
  auto* box = new QComboBox(parent);
  box->setObjectName(QLatin1String(name));
  for (const auto& [text, character] : entries) box->addItem(text, QString(character));
  box->setCurrentIndex(std::max(0, box->findData(savedSetting(key))));
  return box;
}

}  // namespace

CsvDialog::CsvDialog(const QString& table, QWidget* parent)
    : QDialog(parent),
      m_separator(choice("csvSeparator", {{tr("Comma"), u','}, {tr("Semicolon"), u';'}, {tr("Tab"), u'\t'}},
                         kSeparatorKey, this)),
      m_decimal(choice("csvDecimal", {{tr("Point"), u'.'}, {tr("Comma"), u','}}, kDecimalKey, this)),
      m_labels(new QCheckBox(tr("Labels of rows and columns"), this)),
      m_mark(new QCheckBox(tr("Byte order mark"), this)) {
  setObjectName(QStringLiteral("csvDialog"));
  setWindowTitle(tr("Export %1 as CSV").arg(table));
  setAttribute(Qt::WA_DeleteOnClose);
  m_separator->setToolTip(tr("What parts the columns"));
  m_decimal->setToolTip(tr("Numbers with a decimal comma are quoted where commas part the columns"));
  m_labels->setObjectName(QStringLiteral("csvLabels"));
  m_labels->setToolTip(tr("Without them the file holds the entries alone"));
  m_labels->setChecked(savedSetting(kLabelsKey, true).toBool());
  m_mark->setObjectName(QStringLiteral("csvByteOrderMark"));
  m_mark->setToolTip(tr("Begins the file with a mark by which spreadsheet programs know UTF-8"));
  m_mark->setChecked(savedSetting(kMarkKey, false).toBool());
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  buttons->addButton(tr("Export…"), QDialogButtonBox::AcceptRole)->setDefault(true);
  auto* form = new QFormLayout(this);
  form->addRow(tr("Columns parted by"), m_separator);
  form->addRow(tr("Decimal sign"), m_decimal);
  form->addRow(QString(), m_labels);
  form->addRow(QString(), m_mark);
  form->addRow(buttons);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(this, &QDialog::accepted, this, &CsvDialog::remember);
}

CsvOptions CsvDialog::options() const {
  const auto character = [](const QComboBox* box) { return box->currentData().toString().at(0).toLatin1(); };
  return {character(m_separator), character(m_decimal), m_labels->isChecked(), m_mark->isChecked()};
}

void CsvDialog::remember() const {
  saveSetting(kSeparatorKey, m_separator->currentData());
  saveSetting(kDecimalKey, m_decimal->currentData());
  saveSetting(kLabelsKey, m_labels->isChecked());
  saveSetting(kMarkKey, m_mark->isChecked());
}

}  // namespace geargraph

#include "moc_csv_dialog.cpp"
