#include "ui/learning/course_dialog.h"

#include <QBoxLayout>
#include <QLabel>
#include <QListView>
#include <QPainter>
#include <QPushButton>
#include <QStandardItemModel>
#include <QStyledItemDelegate>

#include "core/teaching/lessons/course.h"
#include "ui/learning/lesson_progress.h"
#include "ui/theme/theme_colors.h"

namespace geargraph {
namespace {

enum Role { goalRole = Qt::UserRole + 1, timeRole, pointsRole, completeRole, begunRole, reviewRole };

constexpr int kPadding = 8;
constexpr int kBadge = 24;  ///< px of the disc with the number or the tick
constexpr int kTimeWidth = 60;
constexpr int kPointsWidth = 110;

/// A lesson: number or tick, title over goal, time, points.
class LessonRow : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    Q_UNUSED(index)
    return {400, 2 * QFontMetrics(option.font).height() + kPadding};
  }

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const Theme theme = themeOf(option.palette);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    const bool isChosen = (option.state & QStyle::State_Selected) != 0;
    if (isChosen) {
      painter->setPen((option.state & QStyle::State_HasFocus) != 0 ? QPen(qColor(ColorRole::accent, theme))
                                                                   : QPen(Qt::NoPen));
      painter->setBrush(qColor(ColorRole::halo, theme));
      painter->setOpacity(0.5);
      painter->drawRoundedRect(QRectF(option.rect).adjusted(2.5, 1.5, -2.5, -1.5), 5, 5);
      painter->setOpacity(1);
    }
    const QRect room = option.rect.adjusted(kPadding, 0, -kPadding, 0);
    drawBadge(*painter, QRectF(room.left(), room.center().y() - kBadge / 2.0, kBadge, kBadge), index, theme);
    const int right = kTimeWidth + kPointsWidth;
    QRect words = room.adjusted(kBadge + kPadding, 0, -right, 0);
    const int height = words.height() / 2;
    QFont bold = option.font;
    bold.setWeight(QFont::DemiBold);
    painter->setFont(bold);
    painter->setPen(qColor(ColorRole::ink, theme));
    drawElided(*painter, QRect(words.left(), words.top() + 2, words.width(), height),
               index.data().toString());
    painter->setFont(option.font);
    painter->setPen(qColor(ColorRole::secondary, theme));
    drawElided(*painter, QRect(words.left(), words.top() + height - 2, words.width(), height),
               index.data(goalRole).toString());
    painter->drawText(QRect(room.right() - right, room.top(), kTimeWidth, room.height()),
                      Qt::AlignRight | Qt::AlignVCenter, index.data(timeRole).toString());
    painter->drawText(QRect(room.right() - kPointsWidth, room.top(), kPointsWidth, room.height()),
                      Qt::AlignRight | Qt::AlignVCenter, index.data(pointsRole).toString());
    painter->restore();
  }

 private:
  static void drawElided(QPainter& painter, const QRect& room, const QString& text) {
    const QFontMetrics metrics(painter.font());
    painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter,
                     metrics.elidedText(text, Qt::ElideRight, room.width()));
  }
  static void drawBadge(QPainter& painter, const QRectF& disc, const QModelIndex& index, Theme theme) {
    const bool isComplete = index.data(completeRole).toBool();
    const bool isBegun = index.data(begunRole).toBool();
    const ColorRole role = isComplete ? ColorRole::fine : isBegun ? ColorRole::accent : ColorRole::secondary;
    painter.setPen(QPen(qColor(role, theme), 1.6));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(disc.adjusted(1, 1, -1, -1));
    painter.drawText(disc, Qt::AlignCenter,
                     isComplete ? QStringLiteral("✓") : QString::number(index.row() + 1));
  }
};

}  // namespace

CourseDialog::CourseDialog(QWidget* parent)
    : QDialog(parent),
      m_model(new QStandardItemModel(this)),
      m_list(new QListView(this)),
      m_summary(new QLabel(this)),
      m_start(new QPushButton(tr("Start"), this)) {
  setObjectName(QStringLiteral("courseDialog"));
  setWindowTitle(tr("Lessons"));
  auto* title = new QLabel(tr("From one gear pair to the robot"), this);
  title->setProperty("look", "heading");
  m_summary->setProperty("look", "hint");
  m_list->setObjectName(QStringLiteral("courseList"));
  m_list->setAccessibleName(tr("Lessons"));
  m_list->setModel(m_model);
  m_list->setItemDelegate(new LessonRow(m_list));
  m_list->setEditTriggers(QAbstractItemView::NoEditTriggers);
  m_list->setUniformItemSizes(true);
  m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* own = new QPushButton(tr("Open a lesson file…"), this);
  own->setAutoDefault(false);
  own->setToolTip(tr("A lesson of your own: it is reloaded whenever the file is saved"));
  auto* test = new QPushButton(tr("Where do I begin?"), this);
  test->setObjectName(QStringLiteral("courseTest"));
  test->setAutoDefault(false);
  test->setToolTip(
      tr("A question about each lesson in turn: it ends with the second one that is not right at the first "
         "check, and chooses the lesson of the first"));
  m_start->setObjectName(QStringLiteral("courseStart"));
  m_start->setDefault(true);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(test);
  buttons->addWidget(own);
  buttons->addStretch(1);
  buttons->addWidget(m_start);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(16, 14, 16, 12);
  layout->addWidget(title);
  layout->addWidget(m_summary);
  layout->addWidget(m_list, 1);
  layout->addLayout(buttons);
  resize(800, 700);
  connect(m_list, &QListView::activated, this, [this](const QModelIndex& row) { choose(row.row()); });
  connect(m_list->selectionModel(), &QItemSelectionModel::currentChanged, this, &CourseDialog::updateButton);
  connect(m_start, &QPushButton::clicked, this, [this] { choose(m_list->currentIndex().row()); });
  connect(test, &QPushButton::clicked, this, [this] {
    hide();
    emit testWanted();
  });
  connect(own, &QPushButton::clicked, this, &CourseDialog::fileWanted);
  renew();
}

void CourseDialog::renew() {
  const int chosen = m_list->currentIndex().row();
  m_model->clear();
  int minutes = 0;
  int left = 0;
  int done = 0;
  int next = -1;
  int toReview = 0;
  const QDate today = QDate::currentDate();
  for (const Lesson& lesson : course()) {
    const LessonProgress progress = progressOf(lesson);
    const int most = kStepPoints * static_cast<int>(lesson.steps.size());
    auto* row = new QStandardItem(QString::fromStdString(lesson.title));
    row->setData(QString::fromStdString(lesson.goal), goalRole);
    row->setData(tr("%1 min").arg(lesson.minutes), timeRole);
    const bool isBegun = progress.doneSteps() > 0;
    const ReviewState review = reviewStateOf(lesson, today);
    toReview += review == ReviewState::due ? 1 : 0;
    row->setData(static_cast<int>(review), reviewRole);
    if (isBegun)
      row->setData(review == ReviewState::due         ? tr("review due")
                   : review == ReviewState::freshLeft ? tr("questions left")
                   : progress.isComplete()
                       ? tr("%1 of %2 points").arg(progress.score()).arg(most)
                       : tr("step %1 of %2").arg(progress.step + 1).arg(lesson.steps.size()),
                   pointsRole);
    row->setData(progress.isComplete(), completeRole);
    row->setData(isBegun, begunRole);
    row->setToolTip(tr("Afterwards you can %1.").arg(QString::fromStdString(lesson.goal)));
    minutes += lesson.minutes;
    if (progress.isComplete()) {
      ++done;
    } else {
      left += lesson.minutes;
      if (next < 0) next = m_model->rowCount();
    }
    m_model->appendRow(row);
  }
  QString summary = tr("%1 lessons, %2 min. %3 done, about %4 min to go.")
                        .arg(m_model->rowCount())
                        .arg(minutes)
                        .arg(done)
                        .arg(left);
  if (toReview > 0) summary += QLatin1Char(' ') + tr("%n to review.", nullptr, toReview);
  if (const auto first = lessonToBeginWith(course())) {
    const Lesson& lesson = course()[*first];
    if (!progressOf(lesson).isComplete()) {
      next = static_cast<int>(*first);
      summary +=
          QLatin1Char(' ') +
          tr("After the start test: begin with \u201c%1\u201d.").arg(QString::fromStdString(lesson.title));
    }
  }
  m_summary->setText(summary);
  m_list->setCurrentIndex(m_model->index(chosen >= 0 ? chosen : std::max(next, 0), 0));
  updateButton();
}

void CourseDialog::updateButton() {
  const QModelIndex row = m_list->currentIndex();
  m_start->setEnabled(row.isValid());
  const auto review = static_cast<ReviewState>(row.data(reviewRole).toInt());
  m_start->setText(review == ReviewState::due         ? tr("Review")
                   : review == ReviewState::freshLeft ? tr("Continue")
                   : row.data(completeRole).toBool()  ? tr("Repeat")
                   : row.data(begunRole).toBool()     ? tr("Continue")
                                                      : tr("Start"));
}

void CourseDialog::choose(int lesson) {
  if (lesson < 0) return;
  emit lessonChosen(lesson);
  hide();
}

}  // namespace geargraph

#include "moc_course_dialog.cpp"
