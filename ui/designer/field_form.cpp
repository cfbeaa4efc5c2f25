#include "ui/designer/field_form.h"

#include <QBoxLayout>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QRegularExpression>
#include <QSpinBox>
#include <QStyle>
#include <algorithm>

#include "core/foundations/base/rational.h"
#include "core/foundations/files/json_writer.h"
#include "ui/theme/plain_text_field.h"
#include "ui/theme/theme_colors.h"

namespace geargraph {

std::string plainNumber(QString text) {
  return text.trimmed().replace(QChar(0x2212), '-').replace(',', '.').toStdString();
}

std::string partOfOne(const QString& percent) {
  const std::string plain = plainNumber(percent);
  const auto number = Rational::fromText(plain);
  return number ? (*number / Rational(100)).toString() : plain;
}

QString localNumbers(const char* numbers) {
  return QString::fromLatin1(numbers).replace(QLatin1Char('.'), QLocale().decimalPoint());
}

QStringList ratiosIn(const QString& text) {
  QStringList ratios;
  static const QRegularExpression kGap(QStringLiteral("[\\s;|]+"));
  for (QString word : text.split(kGap, Qt::SkipEmptyParts)) {
    while (word.endsWith(',')) word.chop(1);
    // "4.17,2.34" has a decimal sign already, and so have "4,17,2,34" none that can be told.
    if (word.contains('.') || word.count(',') > 1) {
      ratios << word.split(',', Qt::SkipEmptyParts);
    } else if (!word.isEmpty()) {
      ratios << word.replace(',', '.');
    }
  }
  return ratios;
}

int FieldForm::roomFor(int least) const {
  return std::max(least, minimumSizeHint().width() + style()->pixelMetric(QStyle::PM_ScrollBarExtent));
}

QVBoxLayout* FieldForm::makeColumn() {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 8, 12, 8);
  column->setSpacing(6);
  return column;
}

QFormLayout* FieldForm::addForm(QVBoxLayout& column, const QString& heading) {
  auto* title = new QLabel(heading, this);
  title->setProperty("look", "title");
  column.addWidget(title);
  auto* form = new QFormLayout;
  form->setHorizontalSpacing(8);
  form->setVerticalSpacing(4);
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  column.addLayout(form);
  return form;
}

QSpinBox* FieldForm::spin(const char* name, int least, int most, int value) {
  auto* box = new QSpinBox(this);
  box->setObjectName(QLatin1String(name));
  box->setRange(least, most);
  box->setValue(value);
  connect(box, &QSpinBox::valueChanged, this, [this] { onEdited(); });
  return box;
}

QLineEdit* FieldForm::line(const char* name, const QString& text) {
  auto* edit = new QLineEdit(text, this);
  edit->setObjectName(QLatin1String(name));
  edit->setMaxLength(80);
  connect(edit, &QLineEdit::textChanged, this, [this] { onEdited(); });
  connect(edit, &QLineEdit::returnPressed, this, &FieldForm::searchWanted);
  return edit;
}

QPlainTextEdit* FieldForm::ratiosField(const char* name, const QString& tip) {
  auto* field = new PlainTextField(this);
  field->setObjectName(QLatin1String(name));
  field->setAccessibleName(tr("Wanted ratios"));
  field->setToolTip(tip);
  field->setTabChangesFocus(true);
  field->setFixedHeight(scaledPixels(52));
  connect(field, &QPlainTextEdit::textChanged, this, [this] { onEdited(); });
  return field;
}

FieldForm::Numbers FieldForm::range(const char* name, int least, int most, std::array<int, 2> values) {
  const Numbers ends{spin(name, least, most, values[0]), spin(name, least, most, values[1])};
  ends[0]->setObjectName(QLatin1String(name) + QStringLiteral("From"));
  ends[1]->setObjectName(QLatin1String(name) + QStringLiteral("To"));
  return ends;
}

QHBoxLayout* FieldForm::fromTo(QWidget* from, QWidget* to) {
  auto* row = new QHBoxLayout;
  row->addWidget(from, 1);
  row->addWidget(new QLabel(QStringLiteral("–")));
  row->addWidget(to, 1);
  return row;
}

void FieldForm::writeWhole(JsonWriter& json, const char* name, const QSpinBox& box) {
  json.key(name);
  json.number(static_cast<std::int64_t>(box.value()));
}

void FieldForm::writeRange(JsonWriter& json, const char* name, const Numbers& ends) {
  json.key(name);
  json.beginArray(JsonWriter::Layout::row);
  for (const QSpinBox* each : ends) json.number(static_cast<std::int64_t>(each->value()));
  json.endArray();
}

void FieldForm::addFault(QVBoxLayout& column, int group) {
  auto* fault = new QLabel(this);
  fault->setProperty("look", "problem");
  fault->setObjectName(QStringLiteral("fault.%1").arg(group));
  fault->setWordWrap(true);
  fault->hide();
  column.addWidget(fault);
  m_faults[group] = fault;
}

void FieldForm::clearFaults() {
  for (const auto& [group, label] : m_faults) label->hide();
}

void FieldForm::showFault(int group, const QString& why) {
  QLabel* const label = m_faults.at(group);
  if (!label->isHidden()) return;
  label->setText(why);
  label->show();
}

void FieldForm::onEdited() {
  clearFaults();
  emit changed();
}

}  // namespace geargraph

#include "moc_field_form.cpp"
