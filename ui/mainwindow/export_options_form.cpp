#include "ui/mainwindow/export_options_form.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <array>

#include "core/mechanism/model/length.h"
#include "ui/document/typed_length.h"
#include "ui/mainwindow/export_source.h"
#include "ui/models/term_tips.h"
#include "ui/theme/theme_colors.h"

namespace geargraph {
namespace {

/// What a flag's field holds when it is set; any text would do.
const QString kSet = QStringLiteral("true");

std::optional<Number> secondsFromText(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, std::pair<int, int>>, 3> kUnits = {
      {{"ms", {1, 1000}}, {"min", {60, 1}}, {"s", {1, 1}}}};
  for (const auto& [name, part] : kUnits) {
    if (!text.ends_with(name)) continue;
    const auto number = typedNumber(text.substr(0, text.size() - name.size()));
    if (number) return Number(number->exact() * Rational(part.first) / Rational(part.second));
  }
  return std::nullopt;
}

/// "0.001" in the numbers of the language.
QString optionNumber(double number) {
  return QLocale().toString(number, 'g', 12);
}

/// "1 to 100, mm"; bounds that nobody meets are left out.
QString boundsOf(const ExportOption& option) {
  constexpr double kFar = 1e6;
  if (option.most >= kFar) return {};
  return ExportOptionsForm::tr("%1 to %2").arg(optionNumber(option.least), optionNumber(option.most));
}

}  // namespace

QString exportedNumber(const QString& typed, std::string_view unit) {
  QString text = typed.trimmed();
  text.replace(QLatin1Char(','), QLatin1Char('.'));
  const std::string bytes = text.toStdString();
  if (typedNumber(bytes)) return text;
  std::optional<Number> number;
  if (unit == "s") number = secondsFromText(bytes);
  if (unit == "mm") number = lengthFromText(bytes, unit);
  return number ? QString::fromStdString(number->exact().toString()) : QString();
}

ExportOptionsForm::ExportOptionsForm(const Exporter& exporter, QWidget* parent) : QWidget(parent) {
  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 6, 0);
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  for (const ExportOption& option : exporter.options) add(option, *form);
  if (m_fields.empty()) {
    auto* none = new QLabel(tr("This format has no options."), this);
    none->setProperty("look", "hint");
    none->setWordWrap(true);
    form->addRow(none);
  }
  m_usual = options();
}

void ExportOptionsForm::add(const ExportOption& option, QFormLayout& form) {
  const QString title = QString::fromStdString(exportOptionTitle(option.name));
  if (option.type == OptionType::flag) return form.addRow(flagField(option));
  QWidget* field = option.type == OptionType::choice ? choiceField(option) : lineField(option);
  field->setAccessibleName(title);
  auto* label = new QLabel(title, this);
  label->setToolTip(field->toolTip());
  label->setBuddy(field);
  form.addRow(label, field);
}

QWidget* ExportOptionsForm::flagField(const ExportOption& option) {
  auto* box = new QCheckBox(QString::fromStdString(exportOptionTitle(option.name)), this);
  box->setObjectName(shownText(option.name));
  box->setToolTip(spoken(exportOptionText(option.name).help));
  m_fields.push_back({&option, [box] { return box->isChecked() ? kSet : QString(); },
                      [box](const QString& value) { box->setChecked(!value.isEmpty()); }});
  connect(box, &QCheckBox::toggled, this, &ExportOptionsForm::changed);
  return box;
}

QWidget* ExportOptionsForm::choiceField(const ExportOption& option) {
  auto* box = new QComboBox(this);
  box->setObjectName(shownText(option.name));
  box->setToolTip(spoken(exportOptionText(option.name).help));
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(8);
  if (!option.isNeeded && option.otherwise.empty()) box->addItem(tr("As usual"), QString());
  for (const std::string& choice : option.choices()) {
    const std::string title = exportChoiceTitle(option.name, choice);
    box->addItem(QString::fromStdString(title.empty() ? choice : title), QString::fromStdString(choice));
  }
  const int usual = option.otherwise.empty() ? 0 : box->findData(shownText(option.otherwise));
  box->setCurrentIndex(usual);
  const QString otherwise = shownText(option.otherwise);
  m_fields.push_back({&option,
                      [box, otherwise] {
                        const QString chosen = box->currentData().toString();
                        return chosen == otherwise ? QString() : chosen;
                      },
                      [box, usual](const QString& value) {
                        const int found = value.isEmpty() ? -1 : box->findData(value);
                        box->setCurrentIndex(found < 0 ? usual : found);
                      }});
  connect(box, &QComboBox::currentIndexChanged, this, &ExportOptionsForm::changed);
  return box;
}

/// The line, the unit beside it, and below what may be typed.
QWidget* ExportOptionsForm::lineField(const ExportOption& option) {
  const bool isNumber = option.type == OptionType::number;
  const OptionText& text = exportOptionText(option.name);
  auto* box = new QWidget(this);
  box->setObjectName(shownText(option.name));
  box->setToolTip(spoken(text.help));
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(1);
  auto* row = new QHBoxLayout;
  row->setSpacing(6);
  auto* line = new QLineEdit(box);
  line->setMaxLength(kMaxTyped);
  line->setAccessibleName(QString::fromStdString(exportOptionTitle(option.name)));
  const QString usual = shownText(option.otherwise);
  line->setPlaceholderText(!usual.isEmpty() && isNumber ? optionNumber(usual.toDouble()) : usual);
  row->addWidget(line, 1);
  if (!option.unit.empty()) row->addWidget(new QLabel(spoken(option.unit), box));
  column->addLayout(row);
  const QString hint = isNumber ? boundsOf(option) : spoken(text.help);
  if (!hint.isEmpty()) {
    auto* below = new QLabel(hint, box);
    below->setProperty("look", "hint");
    below->setWordWrap(true);
    column->addWidget(below);
  }
  box->setFocusProxy(line);
  m_fields.push_back({&option,
                      [line, isNumber, unit = option.unit] {
                        const QString typed = line->text().trimmed();
                        if (!isNumber || typed.isEmpty()) return typed;
                        const QString number = exportedNumber(typed, unit);
                        return number.isEmpty() ? typed : number;
                      },
                      [line](const QString& value) { line->setText(value); }});
  connect(line, &QLineEdit::textChanged, this, [this, line, &option] {
    mark(*line, option);
    emit changed();
  });
  return box;
}

/// A number that the option cannot be is red while it is typed.
void ExportOptionsForm::mark(QLineEdit& line, const ExportOption& option) {
  if (option.type != OptionType::number) return;
  const QString typed = line.text().trimmed();
  const auto number = typedNumber(exportedNumber(typed, option.unit).toStdString());
  const bool isFine =
      typed.isEmpty() || (number && number->value() >= option.least && number->value() <= option.most);
  QPalette palette;
  if (!isFine) palette.setColor(QPalette::Text, qColor(ColorRole::error, themeOf(palette)));
  line.setPalette(palette);
}

OptionValues ExportOptionsForm::options() const {
  OptionValues given;
  for (const Field& field : m_fields) {
    const QString value = field.value();
    if (!value.isEmpty()) given.options[std::string(field.option->name)] = {value.toStdString()};
  }
  return given;
}

void ExportOptionsForm::setOptions(const OptionValues& given) {
  for (const Field& field : m_fields)
    field.show(QString::fromStdString(given.value(field.option->name).value_or("")));
}

void ExportOptionsForm::reset() {
  for (const Field& field : m_fields) field.show({});
}

}  // namespace geargraph

#include "moc_export_options_form.cpp"
