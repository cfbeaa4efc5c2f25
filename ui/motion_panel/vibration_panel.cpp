#include "ui/motion_panel/vibration_panel.h"

#include <QApplication>
#include <QBoxLayout>
#include <QButtonGroup>
#include <QClipboard>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QToolButton>
#include <algorithm>

#include "core/foundations/base/translation.h"
#include "core/presentation/diagrams/spectrum.h"
#include "ui/canvas/drawing_preview.h"
#include "ui/forces/linked_table.h"
#include "ui/models/term_tips.h"
#include "ui/panels/number_field.h"
#include "ui/theme/control_button.h"
#include "ui/theme/empty_label.h"
#include "ui/theme/sideways_scroll.h"
#include "ui/workbench/views.h"

namespace geargraph {
namespace {

constexpr double kMaxRpm = 1e9;

bool isLostMotion(VibrationView view) {
  return view == VibrationView::lostMotion;
}

}  // namespace

VibrationPanel::VibrationPanel(Selection* selection, QWidget* parent)
    : QWidget(parent),
      m_service(new VibrationService(this)),
      m_reference(new QLabel(this)),
      m_pages(new QStackedWidget(this)),
      m_empty(emptyLabel(this)),
      m_model(new ValueTableModel(this)),
      m_table(new LinkedTable(m_model, selection, this)),
      m_spectrum(new DrawingPreview(this)) {
  m_table->setObjectName(QStringLiteral("vibrationTable"));
  m_table->setAccessibleName(tr("Frequencies, or lost motion"));
  m_spectrum->setObjectName(QStringLiteral("spectrum"));
  m_spectrum->setAccessibleName(tr("Spectrum"));
  m_reference->setObjectName(QStringLiteral("vibrationReference"));
  m_reference->setProperty("look", "hint");
  m_reference->setWordWrap(true);
  m_reference->setContentsMargins(12, 2, 12, 4);
  for (QWidget* page :
       {static_cast<QWidget*>(m_table), static_cast<QWidget*>(m_spectrum), static_cast<QWidget*>(m_empty)})
    m_pages->addWidget(page);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  layout->addWidget(new SidewaysScroll(makeChips(), this));
  m_fields = makeFields();
  layout->addWidget(new SidewaysScroll(m_fields, this));
  auto* middle = new QHBoxLayout;
  middle->setContentsMargins(10, 0, 0, 0);
  middle->addWidget(m_pages);
  layout->addLayout(middle, 1);
  layout->addWidget(m_reference);
  setBackgroundRole(QPalette::Base);
  setAutoFillBackground(true);
  m_service->onAnswer(this, [this](const VibrationPtr& answer) {
    showAnswer(answer);
    if (m_service->isComplete()) emit settled();
  });
  connect(m_service, &VibrationService::failed, this, [this](const QString& why) {
    showEmpty(tr("The frequencies could not be worked out: %1").arg(why));
  });
  showEmpty(tr("Draw turning joints and gear meshes: what repeats in their motion appears here."));
}

QWidget* VibrationPanel::makeChips() {
  auto* bar = new QWidget(this);
  auto* layout = new QHBoxLayout(bar);
  layout->setContentsMargins(12, 6, 10, 2);
  layout->setSpacing(4);
  m_chips = new QButtonGroup(this);
  const std::tuple<const char*, QString, QString> chips[] = {
      {"chip.frequencies", tr("Frequencies"),
       tr("Shafts, tooth meshes with harmonics and sidebands, passing planets, hunting tooth and assembly "
          "phase")},
      {"chip.spectrum", tr("Spectrum"), tr("The same as lines over a logarithmic axis")},
      {"chip.lostMotion", tr("Lost motion"),
       tr("How far the outputs turn by the play of the teeth while the inputs are held")}};
  for (int id = 0; const auto& [name, text, tip] : chips) {
    auto* chip = new QToolButton(bar);
    chip->setObjectName(QLatin1String(name));
    chip->setText(text);
    chip->setToolTip(tip);
    chip->setCheckable(true);
    chip->setProperty("look", "chip");
    m_chips->addButton(chip, id++);
    layout->addWidget(chip);
  }
  m_chips->button(0)->setChecked(true);
  connect(m_chips, &QButtonGroup::idClicked, this,
          [this](int id) { showView(static_cast<VibrationView>(id)); });
  layout->addStretch(1);
  m_copy =
      controlButton(QStringLiteral("copyVibration"), tr("Copy"), tr("Copy the table for a spreadsheet"), bar);
  connect(m_copy, &QToolButton::clicked, this, [this] { QApplication::clipboard()->setText(csv('\t')); });
  layout->addWidget(m_copy);
  m_export =
      controlButton(QStringLiteral("exportVibration"), tr("CSV…"), tr("Export the table to a CSV file"), bar);
  connect(m_export, &QToolButton::clicked, this, [this] {
    emit exportWanted(isLostMotion(view()) ? tr("lost-motion.csv") : tr("frequencies.csv"), csv(','));
  });
  layout->addWidget(m_export);
  return bar;
}

NumberField* VibrationPanel::wholeField(const char* name, const QString& title, int value, int least,
                                        int most) {
  auto* field = new NumberField(this);
  field->setObjectName(QLatin1String(name));
  field->setAccessibleName(title);
  field->setWhole(least, most);
  field->setNumber(Number(value));
  connect(field, &NumberField::edited, this, [this, field](const std::optional<Number>& number) {
    if (!number) return;
    field->setNumber(number);
    ask();
  });
  return field;
}

QWidget* VibrationPanel::makeFields() {
  auto* bar = new QWidget(this);
  auto* layout = new QHBoxLayout(bar);
  layout->setContentsMargins(12, 2, 10, 2);
  layout->setSpacing(6);
  const auto add = [&](const QString& title, const QString& tip, QWidget* field) {
    auto* label = new QLabel(title, bar);
    label->setProperty("look", "hint");
    label->setToolTip(tip);
    label->setBuddy(field);
    field->setToolTip(tip);
    layout->addWidget(label);
    layout->addWidget(field);
    layout->addSpacing(6);
    return label;
  };
  m_states = new QComboBox(bar);
  m_states->setObjectName(QStringLiteral("vibrationState"));
  m_states->setAccessibleName(tr("State"));
  connect(m_states, &QComboBox::activated, this, [this] {
    if (const VibrationPtr& answer = m_service->answer()) showCases(*answer);
  });
  m_states->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  m_stateName = add(tr("State"), tr("The state whose couplings are engaged"), m_states);
  m_rpm = new NumberField(bar);
  m_rpm->setObjectName(QStringLiteral("vibrationRpm"));
  m_rpm->setAccessibleName(tr("Speed of the input shaft, rpm"));
  m_rpm->setOptional(true);
  m_rpm->setEmptyText(tr("none"));
  m_rpm->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("1000000.000")));
  connect(m_rpm, &NumberField::edited, this, [this](const std::optional<Number>& number) {
    if (number && (number->value() <= 0 || number->value() > kMaxRpm)) {
      m_rpm->reject(tr("A speed above 0, in turns a minute."));
      return;
    }
    m_rpm->setNumber(number);
    ask();
  });
  add(tr("Input shaft, rpm"), tr("Its speed in turns a minute: frequencies in Hz"), m_rpm);
  m_harmonics = wholeField("vibrationHarmonics", tr("Harmonics"), 1, 1, FrequencyOptions::kMaxHarmonics);
  add(tr("Harmonics"), tr("How many multiples of each tooth mesh are listed"), m_harmonics);
  m_sidebands = wholeField("vibrationSidebands", tr("Sidebands"), 1, 0, FrequencyOptions::kMaxSidebands);
  add(tr("Sidebands"), tr("How many sidebands each multiple has on either side"), m_sidebands);
  m_planets = wholeField("vibrationPlanets", tr("Planets"), 1, 1, FrequencyOptions::kMaxPlanets);
  add(tr("Planets"), tr("How many equal planets one stands for that is drawn alone"), m_planets);
  layout->addStretch(1);
  return bar;
}

VibrationView VibrationPanel::view() const {
  return static_cast<VibrationView>(m_chips->checkedId());
}

void VibrationPanel::showView(VibrationView view) {
  m_chips->button(static_cast<int>(view))->setChecked(true);
  const VibrationPtr& answer = m_service->answer();
  if (isLostMotion(view) && (!answer || !answer->lostMotion)) {
    ask();
  } else if (answer) {
    showAnswer(answer);
  }
}

/// The complete snapshot that follows the live one has the same motion.
void VibrationPanel::setSnapshot(const SnapshotPtr& snapshot) {
  m_snapshot = snapshot;
  ask();
}

void VibrationPanel::setAwake(bool awake) {
  m_isAwake = awake;
  ask();
}

QString VibrationPanel::emptyText() const {
  return m_pages->currentWidget() == m_empty ? m_empty->text() : QString();
}

void VibrationPanel::ask() {
  if (!m_isAwake || !m_snapshot) return;
  if (m_snapshot->matroid() == nullptr) {
    m_service->cancel();
    showEmpty(tr("Draw turning joints and gear meshes: what repeats in their motion appears here."));
    return;
  }
  VibrationOptions options;
  const auto whole = [](const NumberField* field) { return static_cast<int>(field->number()->value()); };
  options.lines = {whole(m_harmonics), whole(m_sidebands), whole(m_planets)};
  if (const auto rpm = m_rpm->number()) options.rpm = rpm->value();
  m_service->request({m_snapshot, options, isLostMotion(view())});
}

void VibrationPanel::showEmpty(const QString& why) {
  m_empty->setText(why);
  m_pages->setCurrentWidget(m_empty);
  m_model->showTable(nullptr);
  m_reference->clear();
  m_copy->setEnabled(false);
  m_export->setEnabled(false);
}

void VibrationPanel::showAnswer(const VibrationPtr& answer) {
  if (!answer) return;
  const Mechanism& mechanism = *answer->snapshot->mechanism;
  const QSignalBlocker quiet(m_states);
  const QString before = m_states->currentText();
  m_states->clear();
  for (const FrequencyCase& each : answer->cases) {
    m_states->addItem(each.state ? shownText(mechanism.states[static_cast<std::size_t>(*each.state)].name)
                                 : tr("as engaged"));
  }
  m_states->setCurrentIndex(std::max(0, m_states->findText(before)));
  for (QWidget* each : {static_cast<QWidget*>(m_stateName), static_cast<QWidget*>(m_states)})
    each->setVisible(answer->cases.size() > 1);
  showCases(*answer);
}

int VibrationPanel::chosenCase(const VibrationAnswer& answer) const {
  return std::clamp(m_states->currentIndex(), 0, static_cast<int>(answer.cases.size()) - 1);
}

void VibrationPanel::showCases(const VibrationAnswer& answer) {
  if (answer.cases.empty()) return;
  const Mechanism& mechanism = *answer.snapshot->mechanism;
  const auto at = static_cast<std::size_t>(chosenCase(answer));
  const FrequencyCase& chosen = answer.cases[at];
  m_fields->setVisible(!isLostMotion(view()) || answer.cases.size() > 1);
  for (QWidget* field : {static_cast<QWidget*>(m_rpm), static_cast<QWidget*>(m_harmonics),
                         static_cast<QWidget*>(m_sidebands), static_cast<QWidget*>(m_planets)})
    field->setEnabled(!isLostMotion(view()));
  if (isLostMotion(view())) {
    if (!answer.lostMotion) return;  // asked for, not there yet
    LostMotionCase one = (*answer.lostMotion)[std::min(at, answer.lostMotion->size() - 1)];
    one.state.reset();
    auto table = std::make_shared<const ValueTable>(lostMotionTable(mechanism, {one}));
    if (!one.motions || table->rows.empty()) {
      showEmpty(
          tr("No output can be told from an input here, so that there is no lost motion: drive a joint."));
      return;
    }
    m_model->showTable(std::move(table), true);
    m_reference->setText(
        tr("Minutes of arc from stop to stop, inputs held; \"worst\" adds all plays, the root of squares "
           "is what assemblies show."));
    m_pages->setCurrentWidget(m_table);
  } else {
    if (chosen.absence != FrequencyAbsence::none) {
      showEmpty(shownText(absenceText(mechanism, chosen)));
      return;
    }
    FrequencyCase alone = chosen;
    alone.state.reset();
    m_model->showTable(std::make_shared<const ValueTable>(frequencyTable(mechanism, {alone}, answer.options)),
                       true);
    const std::string reference = referenceText(mechanism, *chosen.reference);
    m_spectrum->setDrawing(spectrumDrawing(mechanism, chosen.lines,
                                           translated("cycles for a turn of the shaft (%1)", {reference}),
                                           std::string()));
    m_reference->setText(tr("Cycles for one turn of the %1.").arg(shownText(reference)));
    m_pages->setCurrentWidget(view() == VibrationView::spectrum ? static_cast<QWidget*>(m_spectrum)
                                                                : m_table);
  }
  m_table->fitColumns([](int) { return true; });
  m_table->selectRowOfSelection();
  m_copy->setEnabled(true);
  m_export->setEnabled(true);
}

std::shared_ptr<const ValueTable> VibrationPanel::table() const {
  return m_model->shownTable();
}

QString VibrationPanel::csv(char separator) const {
  const auto shown = table();
  if (!shown) return {};
  TextSink sink;
  CsvOptions options;
  options.separator = separator;
  writeForceCsv(sink, *shown, options);
  return QString::fromStdString(sink.take());
}

ViewEntry vibrationView() {
  return {.id = QStringLiteral("vibration"),
          .title = VibrationPanel::tr("Vibration"),
          .purpose = VibrationPanel::tr(
              "Frequencies of shafts, tooth meshes and planets, and the motion that the play of "
              "the teeth loses."),
          .helpPage = QStringLiteral("forces-and-dynamics#vibration-and-play"),
          .searchWords = QStringLiteral("vibration frequency spectrum hertz harmonic sideband hunting tooth "
                                        "accelerometer backlash lost motion play"),
          .place = ViewPlace::bottom,
          .make = [](Views& views, QWidget* parent) -> ResultsView* {
            auto* panel = new VibrationPanel(views.selection(), parent);
            QObject::connect(panel, &VibrationPanel::settled, &views, &Views::settled);
            QObject::connect(panel, &VibrationPanel::exportWanted, &views, &Views::tableExportWanted);
            return panel;
          }};
}

}  // namespace geargraph

#include "moc_vibration_panel.cpp"
