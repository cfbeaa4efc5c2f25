#include "ui/mainwindow/status_line.h"

#include <QAccessible>
#include <QEvent>
#include <QPainter>
#include <QStyle>
#include <QToolButton>

#include "ui/models/freedom_text.h"
#include "ui/models/term_tips.h"
#include "ui/theme/application_theme.h"
#include "ui/theme/icons.h"

namespace geargraph {
namespace {

/// "A, B, C"; empty where nothing is engaged.
QString engagedNames(const Mechanism& mechanism) {
  constexpr std::size_t kMaxNames = 6;
  QStringList names;
  for (std::size_t i = 0; i < mechanism.engaged.size() && i < kMaxNames; ++i)
    names << shownText(mechanism.engaged[i].text());
  if (mechanism.engaged.size() > kMaxNames) names << QStringLiteral("…");
  return names.join(QStringLiteral(", "));
}

}  // namespace

QString StatusMessage::shown() const {
  return fontMetrics().elidedText(text(), Qt::ElideRight, contentsRect().width());
}

bool StatusMessage::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) setToolTip(shown() == text() ? QString() : text());
  return QLabel::event(event);
}

void StatusMessage::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  style()->drawItemText(&painter, contentsRect(), Qt::AlignLeft | Qt::AlignVCenter, palette(), isEnabled(),
                        shown(), foregroundRole());
}

StatusLine::StatusLine(Selection* selection, QWidget* parent)
    : QStatusBar(parent),
      m_selection(selection),
      m_icon(new QLabel(this)),
      m_message(new StatusMessage(this)) {
  setObjectName(QStringLiteral("statusLine"));
  setSizeGripEnabled(false);
  setContentsMargins(4, 0, 8, 0);
  m_icon->setContentsMargins(10, 0, 0, 0);
  m_message->setContentsMargins(4, 0, 4, 0);
  m_message->setTextFormat(Qt::PlainText);
  m_message->setMinimumWidth(1);  // a long sentence must not widen the window
  m_message->setObjectName(QStringLiteral("statusMessage"));
  addWidget(m_icon);
  addWidget(m_message, 1);
  m_links = addChip("chip.n", tipOf(Term::movingLinks));
  m_joints = addChip("chip.t", tipOf(Term::turningJoints));
  m_meshes = addChip("chip.c", tipOf(Term::gearMeshes));
  m_rank = addChip("chip.rank", tipOf(Term::rank));
  m_freedom = addChip("chip.dof", tipOf(Term::degreesOfFreedom), "strongCount");
  updateMessage();
}

void StatusLine::showCounts(bool isShown) {
  for (QToolButton* chip : {m_links, m_joints, m_meshes, m_rank, m_freedom}) chip->setVisible(isShown);
}

QToolButton* StatusLine::addChip(const char* name, const QString& tip, const char* look) {
  auto* chip = new QToolButton(this);
  chip->setObjectName(QLatin1String(name));
  chip->setProperty("look", look);
  chip->setToolTip(tip);
  chip->setFocusPolicy(Qt::TabFocus);
  chip->installEventFilter(this);
  addPermanentWidget(chip);
  connect(chip, &QToolButton::clicked, this, [this, chip] { m_selection->select(counted(chip)); });
  return chip;
}

void StatusLine::setHint(const QString& hint) {
  m_hint = hint;
  updateMessage();
}

void StatusLine::showRejection(const QString& why) {
  m_rejection = why;
  updateMessage();
}

void StatusLine::clearRejection() {
  m_rejection.clear();
  m_note.clear();
  updateMessage();
}

void StatusLine::showNote(const QString& note) {
  m_rejection.clear();
  m_note = note;
  updateMessage();
}

QString StatusLine::text() const {
  if (!m_rejection.isEmpty()) return m_rejection;
  return m_note.isEmpty() ? m_hint : m_note;
}

void StatusLine::updateMessage() {
  const bool rejected = !m_rejection.isEmpty();
  const Theme theme = themeOf(palette());
  const std::tuple message(text(), rejected, theme);
  if (m_shown == message) return;
  m_shown = message;
  m_message->setText(text());
  announce(rejected || !m_note.isEmpty());
  const QString look = rejected ? QStringLiteral("problem") : QStringLiteral("hint");
  if (m_message->property("look") != look) {
    m_message->setProperty("look", look);
    m_message->style()->polish(m_message);  // which a changed property alone does not
  }
  m_icon->setVisible(rejected);
  m_icon->setPixmap(
      iconPixmap(severityIconName(Severity::error), ColorRole::error, theme, 16, devicePixelRatioF()));
}

/// For screen readers: what was rejected or done is read out; what the tool expects waits until it is asked.
void StatusLine::announce(bool isUrgent) {
  if (!QAccessible::isActive() || m_message->text().isEmpty()) return;
  QAccessibleEvent changed(m_message, QAccessible::NameChanged);
  QAccessible::updateAccessibility(&changed);
  if (!isUrgent) return;
  QAccessibleEvent alert(m_message, QAccessible::Alert);
  QAccessible::updateAccessibility(&alert);
}

void StatusLine::setSnapshot(const SnapshotPtr& snapshot) {
  m_snapshot = snapshot;
  m_links->setText(tr("n %1").arg(snapshot->mechanism->n()));
  m_joints->setText(tr("t %1").arg(snapshot->mechanism->t()));
  m_meshes->setText(tr("c %1").arg(snapshot->mechanism->c()));
  // Without a tree, or with a mesh that has no geometry, there is no coefficient matrix to take a rank of.
  const MatroidAnalysis* matroid = snapshot->matroid();
  const QString engaged = engagedNames(*snapshot->mechanism);
  if (matroid == nullptr) {
    m_rank->setText(tr("rank –"));
    m_freedom->setText(tr("DOF –"));
  } else if (engaged.isEmpty()) {
    m_rank->setText(tr("rank %1").arg(matroid->rank));
    m_freedom->setText(tr("DOF %1").arg(matroid->dof));
  } else {
    m_rank->setText(
        tr("rank %1 + %2").arg(matroid->independentMeshes.size()).arg(matroid->independentHeld.size()));
    m_freedom->setText(tr("DOF %1 (engaged: %2)").arg(QString::number(matroid->dof), engaged));
  }
}

/// Which joints turn together takes long to tell of a large train: only when it is read.
void StatusLine::updateFreedomTip() {
  const QString freedom = m_snapshot ? freedomText(*m_snapshot).toHtmlEscaped() : QString();
  const QString lines = QString(freedom).replace(QLatin1Char('\n'), QStringLiteral("<br>"));
  m_freedom->setToolTip(tipOf(Term::degreesOfFreedom) +
                        (lines.isEmpty() ? QString() : QStringLiteral("<p>%1</p>").arg(lines)));
}

std::set<ElementId> StatusLine::counted(const QObject* chip) const {
  std::set<ElementId> elements;
  if (!m_snapshot) return elements;
  const Mechanism& mechanism = *m_snapshot->mechanism;
  if (chip == m_links) {
    for (std::size_t i = 1; i < mechanism.links.size(); ++i) elements.insert(mechanism.links[i].id);
  } else if (chip == m_joints) {
    for (const TurningJoint& joint : mechanism.turningJoints) elements.insert(joint.id);
  } else if (chip == m_meshes) {
    for (const GearMesh& mesh : mechanism.gearMeshes) elements.insert(mesh.id);
  } else if (const MatroidAnalysis* matroid = m_snapshot->matroid()) {
    const Digraph& graph = *m_snapshot->graph;
    if (chip == m_rank) {
      for (const int mesh : matroid->independentMeshes) elements.insert(graph.edgeId(graph.t() + mesh));
      elements.insert(mechanism.engaged.begin(), mechanism.engaged.end());
    } else {
      for (const int joint : matroid->choice.joints) elements.insert(graph.edgeId(joint));
    }
  }
  return elements;
}

bool StatusLine::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Enter) m_selection->hover(counted(watched));
  if (event->type() == QEvent::Leave) m_selection->unhover();
  if (event->type() == QEvent::ToolTip && watched == m_freedom) updateFreedomTip();
  return QStatusBar::eventFilter(watched, event);
}

void StatusLine::changeEvent(QEvent* event) {
  QStatusBar::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && m_message != nullptr) updateMessage();
}

}  // namespace geargraph

#include "moc_status_line.cpp"
