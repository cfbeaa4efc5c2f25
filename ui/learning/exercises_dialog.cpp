#include "ui/learning/exercises_dialog.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <climits>

#include "core/teaching/lessons/lesson.h"
#include "ui/theme/theme_colors.h"

namespace geargraph {
namespace {

constexpr int kKindRole = Qt::UserRole + 1;
constexpr int kRequestedRole = Qt::UserRole + 2;  ///< chosen, also while the mechanism does not give the kind
constexpr int kMaxOfEach = 5;

QString shownText(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

QSpinBox* makeNumber(const QString& name, const QString& tip, int least, int most, QWidget* parent) {
  auto* number = new QSpinBox(parent);
  number->setObjectName(name);
  number->setRange(least, most);
  number->setToolTip(tip);
  return number;
}

}  // namespace

ExercisesDialog::ExercisesDialog(QWidget* parent)
    : QDialog(parent),
      m_service(new ExerciseService(this)),
      m_difficulty(new QLabel(this)),
      m_kinds(new QListWidget(this)),
      m_each(makeNumber(QStringLiteral("exerciseEach"), tr("How many questions of each kind are asked"), 1,
                        kMaxOfEach, this)),
      m_seed(makeNumber(QStringLiteral("exerciseSeed"),
                        tr("The same seed makes the same questions, here and on the command line"), 0,
                        INT_MAX, this)),
      m_title(new QLineEdit(tr("Exercises"), this)),
      m_variants(makeNumber(QStringLiteral("exerciseVariants"),
                            tr("Sheets that differ in their questions: one for each student, or one for all"),
                            1, kMaxVariants, this)),
      m_count(new QLabel(this)),
      m_practise(new QPushButton(tr("Practise"), this)),
      m_sheets(new QPushButton(tr("Export sheets…"), this)),
      m_handout(new QPushButton(tr("Export handout…"), this)) {
  setObjectName(QStringLiteral("exercisesDialog"));
  setWindowTitle(tr("Exercises"));
  auto* title = new QLabel(tr("Questions about this mechanism"), this);
  title->setProperty("look", "heading");
  m_difficulty->setObjectName(QStringLiteral("exerciseDifficulty"));
  m_difficulty->setProperty("look", "hint");
  m_count->setObjectName(QStringLiteral("exerciseCount"));
  m_count->setProperty("look", "hint");
  m_kinds->setObjectName(QStringLiteral("exerciseKinds"));
  m_kinds->setAccessibleName(tr("Kinds of questions"));
  m_kinds->setWordWrap(true);
  m_kinds->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  m_seed->setValue(static_cast<int>(randomSeed()));
  m_practise->setObjectName(QStringLiteral("exercisePractise"));
  m_practise->setDefault(true);
  m_sheets->setObjectName(QStringLiteral("exerciseSheets"));
  m_handout->setObjectName(QStringLiteral("exerciseHandout"));
  for (QPushButton* each : {m_sheets, m_handout}) each->setAutoDefault(false);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(m_count, 1);
  buttons->addWidget(m_sheets);
  buttons->addWidget(m_handout);
  buttons->addWidget(m_practise);
  auto* right = new QVBoxLayout;
  right->addWidget(makeChoice());
  right->addWidget(makeClass());
  right->addStretch(1);
  auto* middle = new QHBoxLayout;
  middle->addWidget(m_kinds, 1);
  middle->addLayout(right);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(16, 14, 16, 12);
  layout->addWidget(title);
  layout->addWidget(m_difficulty);
  layout->addLayout(middle, 1);
  layout->addLayout(buttons);
  resize(scaledPixels(760), scaledPixels(600));

  m_service->onAnswer(this, [this](const ExerciseAnswerPtr& answer) {
    if (answer) onAnswer(*answer);
  });
  connect(m_service, &ExerciseService::failed, m_difficulty, &QLabel::setText);
  connect(m_kinds, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
    item->setData(kRequestedRole, item->checkState() == Qt::Checked);
    updateButtons();
  });
  connect(m_each, &QSpinBox::valueChanged, this, &ExercisesDialog::updateButtons);
  for (const auto& form : m_forms)
    connect(form.second, &QCheckBox::toggled, this, &ExercisesDialog::updateButtons);
  connect(m_practise, &QPushButton::clicked, this, &ExercisesDialog::practise);
  connect(m_sheets, &QPushButton::clicked, this, [this] {
    SheetRequest request{plan(), {}, {}};
    for (const auto& [form, box] : m_forms) {
      if (box->isChecked()) request.forms.push_back(form);
    }
    emit sheetsWanted(request);
  });
  connect(m_handout, &QPushButton::clicked, this, [this] { emit handoutWanted(plan()); });
  updateButtons();
}

QWidget* ExercisesDialog::makeChoice() {
  auto* box = new QGroupBox(tr("Questions"), this);
  auto* form = new QFormLayout(box);
  form->addRow(tr("Of each kind"), m_each);
  form->addRow(tr("Seed"), m_seed);
  auto* all = new QPushButton(tr("All"), box);
  auto* none = new QPushButton(tr("None"), box);
  all->setToolTip(tr("Choose every kind that the mechanism gives"));
  none->setToolTip(tr("Choose no kind, to begin with a few"));
  auto* row = new QHBoxLayout;
  for (QPushButton* each : {all, none}) {
    each->setAutoDefault(false);
    row->addWidget(each);
  }
  form->addRow(tr("Kinds"), row);
  connect(all, &QPushButton::clicked, this, [this] { checkAll(true); });
  connect(none, &QPushButton::clicked, this, [this] { checkAll(false); });
  return box;
}

QWidget* ExercisesDialog::makeClass() {
  auto* box = new QGroupBox(tr("For a class"), this);
  auto* form = new QFormLayout(box);
  m_title->setObjectName(QStringLiteral("exerciseTitle"));
  m_title->setToolTip(tr("The heading of sheets and handouts"));
  form->addRow(tr("Title"), m_title);
  form->addRow(tr("Variants"), m_variants);
  auto* forms = new QVBoxLayout;
  const std::pair<SheetFileForm, QString> kForms[] = {{SheetFileForm::pdf, tr("PDF")},
                                                      {SheetFileForm::html, tr("Web page")},
                                                      {SheetFileForm::latex, tr("LaTeX")},
                                                      {SheetFileForm::handout, tr("Handout")},
                                                      {SheetFileForm::scorm, tr("SCORM package")}};
  for (const auto& [kind, name] : kForms) {
    auto* check = new QCheckBox(name, box);
    check->setChecked(kind == SheetFileForm::pdf);
    check->setToolTip(kind == SheetFileForm::handout
                          ? tr("A page for each variant, with the train in 3D, that grades what is filled in")
                      : kind == SheetFileForm::scorm
                          ? tr("That page for each variant as a package for learning platforms")
                          : tr("Sheets and solutions in this form"));
    forms->addWidget(check);
    m_forms.emplace_back(kind, check);
  }
  form->addRow(tr("Sheets as"), forms);
  return box;
}

void ExercisesDialog::setMechanism(const MechanismPtr& mechanism) {
  m_mechanism = mechanism;
  m_isPractising = false;
  if (mechanism->n() <= kMaxExerciseLinks) {
    m_service->request({mechanism});
  } else {
    m_service->cancel();
    m_difficulty->setText(
        tr("Exercises are made of mechanisms of at most %1 moving links.").arg(kMaxExerciseLinks));
    m_kinds->clear();
  }
  updateButtons();
}

void ExercisesDialog::onAnswer(const ExerciseAnswer& answer) {
  if (answer.mechanism != m_mechanism) return;
  m_offered = answer.mechanism;
  m_difficulty->setText(shownText(answer.difficulty));
  showOffers(answer.offers);
  updateButtons();
  if (!answer.practice || !m_isPractising) return;
  m_isPractising = false;
  emit practiceWanted(answer.practice);
}

void ExercisesDialog::showOffers(const std::vector<KindOffer>& offers) {
  const QSignalBlocker blocker(m_kinds);
  const bool isNew = m_kinds->count() == 0;
  for (std::size_t i = 0; i < offers.size(); ++i) {
    const auto row = static_cast<int>(i);
    if (isNew) m_kinds->addItem(new QListWidgetItem);
    QListWidgetItem* item = m_kinds->item(row);
    if (isNew) item->setData(kRequestedRole, true);
    const KindOffer& offer = offers[i];
    const bool isOffered = offer.reason.empty();
    item->setText(isOffered ? shownText(kindTitle(offer.kind))
                            : tr("%1 (%2)").arg(shownText(kindTitle(offer.kind)), shownText(offer.reason)));
    item->setToolTip(isOffered
                         ? tr("On the command line: %1").arg(shownText(kindName(offer.kind)))
                         : tr("The mechanism gives no such question: %1.").arg(shownText(offer.reason)));
    item->setData(kKindRole, static_cast<int>(offer.kind));
    item->setFlags(isOffered ? Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable
                             : Qt::ItemFlags());
    item->setCheckState(isOffered && item->data(kRequestedRole).toBool() ? Qt::Checked : Qt::Unchecked);
  }
  if (isNew) m_kinds->setCurrentRow(0);
}

SheetPlan ExercisesDialog::plan() const {
  SheetPlan plan;
  plan.title = m_title->text().trimmed().toStdString();
  plan.seed = static_cast<std::uint64_t>(m_seed->value());
  plan.variants = m_variants->value();
  for (int row = 0; row < m_kinds->count(); ++row) {
    const QListWidgetItem* item = m_kinds->item(row);
    if (item->checkState() != Qt::Checked) continue;
    const auto kind = static_cast<ExerciseKind>(item->data(kKindRole).toInt());
    plan.kinds.insert(plan.kinds.end(), static_cast<std::size_t>(m_each->value()), kind);
  }
  return plan;
}

void ExercisesDialog::practise() {
  m_isPractising = true;
  m_service->request({m_mechanism, plan()});
}

void ExercisesDialog::checkAll(bool isChecked) {
  for (int row = 0; row < m_kinds->count(); ++row) {
    QListWidgetItem* item = m_kinds->item(row);
    if ((item->flags() & Qt::ItemIsEnabled) != 0)
      item->setCheckState(isChecked ? Qt::Checked : Qt::Unchecked);
  }
}

void ExercisesDialog::updateButtons() {
  const auto count = static_cast<int>(plan().kinds.size());
  m_count->setText(tr("Questions: %1").arg(count));
  const bool isEmpty = count == 0 || m_mechanism == nullptr;
  const QString nothing = tr("Choose a kind of question first.");
  const auto set = [&](QPushButton* button, const QString& tip, const QString& why) {
    button->setEnabled(why.isEmpty());
    button->setToolTip(why.isEmpty() ? tip : why);
  };
  const QString tooMany = tr("A sheet has at most %1 questions.").arg(kMaxQuestions);
  // A kind that the former mechanism gave cannot be asked of this one.
  const bool isWaiting =
      m_mechanism != nullptr && m_mechanism->n() <= kMaxExerciseLinks && m_offered != m_mechanism;
  const QString waiting = tr("The solution is still being worked out. Try again in a moment.");
  const QString why = isWaiting ? waiting : isEmpty ? nothing : count > kMaxQuestions ? tooMany : QString();
  const bool isLong = count > static_cast<int>(kMaxLessonSteps);
  set(m_practise, tr("Answer the questions in a window of their own, with hints and reasons"),
      isWaiting ? waiting
      : isEmpty ? nothing
      : isLong  ? tr("At most %1 questions are practised at once.").arg(kMaxLessonSteps)
                : QString());
  const bool hasForm =
      std::any_of(m_forms.begin(), m_forms.end(), [](const auto& form) { return form.second->isChecked(); });
  set(m_sheets, tr("Sheets, solutions and files for answers, which geargraph-cli exercises grade reads"),
      !why.isEmpty() ? why
      : hasForm      ? QString()
                     : tr("Choose a form of the sheets first."));
  set(m_handout,
      tr("The mechanism with these questions as one page for any browser, or for a learning platform"), why);
}

}  // namespace geargraph

#include "moc_exercises_dialog.cpp"
