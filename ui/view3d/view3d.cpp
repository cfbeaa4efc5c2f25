#include "ui/view3d/view3d.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QSurfaceFormat>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <unordered_set>
#include <utility>

#include "ui/models/printed_number.h"
#include "ui/settings/settings.h"
#include "ui/view3d/axis_hold.h"
#include "ui/view3d/canvas_host.h"
#include "ui/view3d/canvas_surface.h"
#include "ui/view3d/measure_layer.h"
#include "ui/view3d/overlay_layer.h"
#include "ui/view3d/playback_bar.h"
#include "ui/view3d/section_bar.h"
#include "ui/view3d/view_buttons.h"
#include "ui/workbench/measuring.h"

namespace geargraph {
namespace {
const QString kNavigationKey = QStringLiteral("view3d/navigation");
}

class View3D::Private {
 public:
  Private(View3D* view, Selection* chosen)
      : q(view),
        selection(chosen),
        viewer(chosen, view),
        host(new CanvasHost(&viewer, &labels, view)),
        bar(new PlaybackBar(&playback, view)),
        strip(new SectionBar(&viewer, view)),
        emptyText(new QLabel(view)),
        note(new QLabel(view)),
        painter(new QLabel(view)),
        axis(new AxisHold(&viewer, chosen, view)),
        buttons(new ViewButtons(view)) {}

  void tellWhatPaints(bool isSoftware, const QString& why);
  void showPainter();
  void wireButtons();
  void placeStrip();
  void onOptionsChanged();
  [[nodiscard]] SceneRange range() const;
  void updateRange();
  void wireAxis();
  void showReference();
  bool measureKey(int key);
  void openPartMenu(std::optional<Hit> hit, const QPointF& at);
  [[nodiscard]] std::optional<ElementId> selectedLink() const;

  View3D* q;
  Selection* selection;
  Viewer viewer;
  LabelLayer labels;
  Playback playback;
  CanvasHost* host;
  PlaybackBar* bar;
  SectionBar* strip;
  QLabel* emptyText;
  QLabel* note;
  QLabel* painter;  ///< says so where the processor paints
  AxisHold* axis;
  Measuring* measuring = nullptr;
  ViewButtons* buttons;
  bool isPaintedBySoftware = false;
};

/// The times that the joints' limits leave to the motion from where hands have put it.
SceneRange View3D::Private::range() const {
  const MechanismScenePtr& stage = viewer.stage();
  if (stage == nullptr || !stage->range) return {};
  std::vector<double> added = viewer.turnedByHand();
  added.resize(stage->inputSpeeds.size(), 0);
  return stage->range(added);
}

/// Of the viewer's trajectory, which knows no limits of its own, or of the stage.
void View3D::Private::updateRange() {
  const MechanismScenePtr& stage = viewer.stage();
  const InputTrajectory* const along = stage ? trajectoryOf(*stage, viewer.view()) : nullptr;
  playback.setPeriod(along != nullptr ? along->seconds() : stage ? stage->period : 0);
  const SceneRange now = along != nullptr ? SceneRange() : range();
  playback.setRange(now.from.time, now.to.time);
}

/// The axes of the document are those of the reference pose.
void View3D::Private::wireAxis() {
  connect(axis, &AxisHold::grabbed, q, [this] { showReference(); });
  connect(axis, &AxisHold::pulled, q, &View3D::axisPulled);
  connect(axis, &AxisHold::dropped, q, &View3D::axisDropped);
  connect(axis, &AxisHold::putBack, q, &View3D::axisPutBack);
  connect(axis, &AxisHold::nudged, q, &View3D::axisNudged);
}

void View3D::Private::showReference() {
  const std::vector<double>& hands = viewer.turnedByHand();
  const bool isTurned = std::any_of(hands.begin(), hands.end(), [](double angle) { return angle != 0; });
  if (playback.isPlaying() || playback.time() != 0 || isTurned || q->trajectory()) q->showMoment(0);
}

/// The keys of measuring; false: it is off, or the key is another.
bool View3D::Private::measureKey(int key) {
  if (measuring == nullptr || !measuring->isOn()) return false;
  if (key == Qt::Key_Escape) {
    if (!measuring->cancel()) measuring->setOn(false);
    return true;
  }
  const auto link = key == Qt::Key_Return || key == Qt::Key_Enter ? selectedLink() : std::nullopt;
  if (link) measuring->take(*link);
  return link.has_value();
}

void View3D::setMeasuring(Measuring* measuring) {
  d->measuring = measuring;
  auto* layer = new MeasureLayer(&d->viewer, measuring);
  connect(layer, &MeasureLayer::hintChanged, this, &View3D::hintChanged);
  connect(measuring, &Measuring::changed, this, [this, measuring] {
    if (!measuring->isOn()) return;
    d->showReference();
    ViewOptions flat = options();
    if (flat.explosion == 0) return;
    flat.explosion = 0;
    setOptions(flat);
  });
}

void View3D::Private::tellWhatPaints(bool isSoftware, const QString& why) {
  isPaintedBySoftware = isSoftware;
  painter->setText(tr("Software 3D"));
  painter->setToolTip(tr("%1 Painted by the processor (%2): finer when nothing moves.")
                          .arg(why, q->rendererName())
                          .trimmed());
  showPainter();
}

/// Where it would lie under the buttons it is left out.
void View3D::Private::showPainter() {
  painter->adjustSize();
  painter->setVisible(isPaintedBySoftware && painter->geometry().right() < buttons->x());
}

void View3D::Private::wireButtons() {
  connect(buttons, &ViewButtons::fitWanted, q, &View3D::fit);
  connect(buttons, &ViewButtons::viewWanted, q, &View3D::showFrom);
  connect(buttons, &ViewButtons::menuOpening, q, &View3D::fillViewMenu);
  connect(buttons, &ViewButtons::sectionToggled, q, [this] {
    ViewOptions options = viewer.options();
    options.section = options.section ? std::nullopt : std::optional(SectionChoice{});
    viewer.setOptions(options);
  });
}

void View3D::Private::placeStrip() {
  const QSize wanted = strip->sizeHint();
  const int width = qMin(q->width() - 16, qMax(300, wanted.width()));
  strip->setGeometry(q->width() - width - 10, buttons->geometry().bottom() + 4, width, wanted.height());
}

void View3D::Private::onOptionsChanged() {
  const ViewOptions& options = viewer.options();
  labels.setShown(LabelKind::link, options.linkLabels);
  labels.setShown(LabelKind::joint, options.jointLabels);
  labels.setShown(LabelKind::axis, options.axisLabels);
  buttons->setSection(options.section.has_value());
  strip->layout()->activate();
  placeStrip();
  emit viewer.viewChanged();
}

// What the menu is about is selected first, as in the drawings.
void View3D::Private::openPartMenu(std::optional<Hit> hit, const QPointF& at) {
  if (hit && !selection->isSelected(hit->element)) selection->select({hit->element});
  if (hit && !selection->isSelected(hit->element)) hit.reset();  // deleted since the picture was drawn
  auto* menu = new QMenu(q);
  menu->setObjectName("view3dPartMenu");
  menu->setAttribute(Qt::WA_DeleteOnClose);
  q->fillPartMenu(*menu, hit);
  emit q->menuOpening(menu, hit ? std::optional(hit->element) : std::nullopt);
  menu->popup(host->canvas()->mapToGlobal(at.toPoint()));
}

std::optional<ElementId> View3D::Private::selectedLink() const {
  for (const ElementId& element : selection->selected()) {
    if (element.kind == ElementKind::link) return element;
  }
  return std::nullopt;
}

void View3D::prepareApplication() {
  QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
  QSurfaceFormat format = QSurfaceFormat::defaultFormat();
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  QSurfaceFormat::setDefaultFormat(format);
}

View3D::View3D(Selection* selection, QWidget* parent)
    : QWidget(parent), d(std::make_unique<Private>(this, selection)) {
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(220, 160);
  auto* whole = new QVBoxLayout(this);
  whole->setContentsMargins(0, 0, 0, 0);
  d->emptyText->setAlignment(Qt::AlignCenter);
  d->emptyText->setWordWrap(true);
  d->emptyText->setAttribute(Qt::WA_TransparentForMouseEvents);
  d->note->setObjectName("view3dNote");
  d->note->setProperty("look", "note3d");
  d->note->setWordWrap(true);
  d->note->setAttribute(Qt::WA_TransparentForMouseEvents);
  d->note->hide();
  d->painter->setObjectName("view3dPainter");
  d->viewer.setParent(this);
  new OverlayLayer(&d->viewer);
  d->painter->setProperty("look", "veil");
  d->painter->move(12, 10);
  d->painter->hide();
  d->wireButtons();
  d->wireAxis();
  connect(d->host, &CanvasHost::started, this,
          [this](bool isSoftware, const QString& why) { d->tellWhatPaints(isSoftware, why); });
  d->host->start(waitingText());
  connect(&d->playback, &Playback::timeChanged, &d->viewer, [this](double seconds) {
    emit d->viewer.moving();
    d->viewer.setTime(seconds);
  });
  connect(&d->playback, &Playback::playingChanged, &d->viewer, &Viewer::setRunning);
  connect(&d->viewer, &Viewer::timeWanted, this, [this](double seconds) {
    d->playback.setPlaying(false);
    const SceneRange range = d->range();
    d->playback.setTime(seconds);
    if (seconds < d->playback.from() || seconds > d->playback.to())
      emit noteMade(
          tr("Limit reached: %1.")
              .arg(QString::fromStdString((seconds > d->playback.to() ? range.to : range.from).text)));
  });
  connect(&d->viewer, &Viewer::pointed, this, &View3D::hintChanged);
  connect(&d->playback, &Playback::endReached, this, [this](bool isEnd) {
    const SceneRange range = d->range();
    const QString joint = QString::fromStdString((isEnd ? range.to : range.from).text);
    emit noteMade(d->playback.isPlaying() ? tr("Limit reached: %1. The motion turns round.").arg(joint)
                                          : tr("Limit reached: %1.").arg(joint));
  });
  connect(&d->viewer, &Viewer::turnedByHandChanged, this, [this] { d->updateRange(); });
  connect(&d->viewer, &Viewer::limitReached, this,
          [this](const QString& joint) { emit noteMade(tr("Limit reached: %1.").arg(joint)); });
  connect(d->bar, &PlaybackBar::trajectoryEnded, this, [this] { setTrajectory(nullptr); });
  connect(&d->viewer, &Viewer::cameraChanged, this, &View3D::cameraChanged);
  connect(&d->viewer, &Viewer::optionsChanged, this, [this] {
    d->onOptionsChanged();
    emit contentChanged();
  });
  connect(&d->viewer, &Viewer::traced, this, [this](const TracedPath& path) {
    if (path.times.empty() || stage() == nullptr) return;  // by now nothing moves
    emit noteMade(tr("The point travels %1 %2 in %3 s.")
                      .arg(printedNumber(path.length, 5), QString::fromStdString(stage()->unit),
                           printedNumber(path.times.back(), 5)));
  });
  connect(&d->viewer, &Viewer::menuWanted, this,
          [this](const std::optional<Hit>& hit, const QPointF& at) { d->openPartMenu(hit, at); });
  setNavigation(savedNavigation());
  setDark(false);
  setEmptyText(tr("Nothing to turn yet: place axes and give the meshes their teeth."));
}

// The canvas goes while the viewer it looks at is still there.
View3D::~View3D() {
  d->host->stop();
}

void View3D::setForces(SceneForces forces, const QString& caption) {
  d->viewer.setForces(std::move(forces), caption);
}
const QString& View3D::forcesCaption() const {
  return d->viewer.forcesCaption();
}

void View3D::setScene(const MechanismScenePtr& stage) {
  d->viewer.setScene(stage);
  const bool isOfOthers = trajectory() && (!stage || trajectoryOf(*stage, view()) == nullptr);
  if (isOfOthers) setTrajectory(nullptr);
  d->updateRange();
  d->viewer.setTime(d->playback.time());
  d->bar->refresh();
  setEmptyText(d->emptyText->text());
  emit contentChanged();
}

const MechanismScenePtr& View3D::stage() const {
  return d->viewer.stage();
}

void View3D::setEmptyText(const QString& text) {
  d->emptyText->setText(text);
  d->emptyText->setVisible(stage() == nullptr || stage()->scene.instances.empty());
  const bool moves = stage() != nullptr && stage()->place && !stage()->inputSpeeds.empty();
  d->bar->setVisible(moves);
}

QString View3D::emptyText() const {
  return d->emptyText->isHidden() ? QString() : d->emptyText->text();
}

void View3D::setNote(const QString& text) {
  d->note->setText(text);
  d->note->setVisible(!text.isEmpty());
  placeNote();
}

void View3D::placeNote() {
  constexpr int kMargin = 12;
  const int wide = width() - 2 * kMargin;
  const int high = d->note->heightForWidth(wide);
  d->note->setGeometry(kMargin, d->buttons->geometry().bottom() + 6, wide, high);
}

Playback& View3D::playback() {
  return d->playback;
}

void View3D::setTrajectory(const InputTrajectoryPtr& trajectory) {
  if (trajectory == this->trajectory()) return;
  if (trajectory) d->viewer.setTurnedByHand({});
  d->viewer.setTrajectory(trajectory);
  d->bar->setAlongTrajectory(trajectory != nullptr);
  d->playback.setSpeed(std::abs(d->playback.speed()));
  d->updateRange();
  d->playback.setTime(0);
  d->bar->refresh();
  emit trajectoryChanged();
}

const InputTrajectoryPtr& View3D::trajectory() const {
  return view().trajectory;
}

void View3D::setTurnedByHand(const std::vector<double>& angles) {
  d->viewer.setTurnedByHand(angles);
}
const std::vector<double>& View3D::turnedByHand() const {
  return d->viewer.turnedByHand();
}

void View3D::showMoment(double time) {
  d->playback.setPlaying(false);
  setTrajectory(nullptr);
  d->viewer.setTurnedByHand(std::vector<double>(d->viewer.turnedByHand().size(), 0));
  d->playback.setTime(time);
}

const Camera& View3D::camera() const {
  return d->viewer.camera();
}
void View3D::setCamera(const Camera& camera) {
  d->viewer.setCamera(camera);
}

void View3D::startAnew(const std::optional<Camera>& camera) {
  d->labels.reset();
  d->viewer.startAnew(camera);
}
bool View3D::isCameraChosen() const {
  return d->viewer.isCameraChosen();
}
const SceneView& View3D::view() const {
  return d->viewer.view();
}

Navigation View3D::savedNavigation() {
  const int saved = savedSetting(kNavigationKey, 0).toInt();
  return static_cast<Navigation>(std::clamp(saved, 0, static_cast<int>(Navigation::solidWorks)));
}

void View3D::setNavigation(Navigation navigation) {
  d->viewer.setNavigation(navigation);
}

void View3D::chooseNavigation(Navigation navigation) {
  saveSetting(kNavigationKey, static_cast<int>(navigation));
  for (QWidget* window : QApplication::topLevelWidgets()) {
    for (View3D* view : window->findChildren<View3D*>()) view->setNavigation(navigation);
  }
  setNavigation(navigation);
}

void View3D::setDark(bool dark) {
  d->host->setDark(dark);
  d->bar->setDark(dark);
  d->viewer.setRenderStyle(dark ? RenderStyle::dark() : RenderStyle::light());
}

const ViewOptions& View3D::options() const {
  return d->viewer.options();
}
void View3D::setOptions(const ViewOptions& options) {
  d->viewer.setOptions(options);
}

const std::optional<ElementId>& View3D::referenceLink() const {
  return d->viewer.referenceLink();
}
void View3D::fixReferenceFrame(const std::optional<ElementId>& link) {
  d->viewer.fixReferenceFrame(link);
}

const std::set<ElementId>& View3D::hidden() const {
  return d->viewer.hidden();
}
void View3D::setHidden(std::set<ElementId> links) {
  d->viewer.setHidden(std::move(links));
}

void View3D::lookAlong(const ElementId& link) {
  if (const auto axis = d->viewer.axisOf(link)) {
    d->viewer.setCamera(d->viewer.camera().turnedAlong(-*axis));
    d->viewer.fit();
  }
}
bool View3D::takeAxisHandle() {
  return d->axis->takeFocus();
}
bool View3D::hasAxis(const ElementId& link) const {
  return d->viewer.axisOf(link).has_value();
}

void View3D::trace(const Hit& hit) {
  d->viewer.trace(hit);
}
void View3D::clearTraces() {
  d->viewer.clearTraces();
}
const std::vector<ShownTrace>& View3D::traces() const {
  return d->viewer.traces();
}

QString View3D::rendererName() const {
  return d->host->rendererName();
}

QString View3D::driver() {
  const CanvasSurface& surface = canvasSurface();
  if (!surface.driver.isEmpty()) return surface.driver;
  return surface.why.isEmpty() ? tr("not asked (GEARGRAPH_3D is set)") : surface.why;
}

bool View3D::isImage() const {
  return d->host->isImage();
}

bool View3D::isUpToDate() const {
  return d->host->isUpToDate();
}

void View3D::fit() {
  d->viewer.fit();
}
void View3D::showFrom(StandardView view) {
  d->viewer.showFrom(view);
}

void View3D::keyPressEvent(QKeyEvent* event) {
  if (d->measureKey(event->key())) return;
  switch (event->key()) {
    case Qt::Key_Space:
      if (!event->isAutoRepeat()) d->playback.toggle();
      return;
    case Qt::Key_F:
    case Qt::Key_Home:
      return fit();
    case Qt::Key_0:
      return showFrom(StandardView::isometric);
    case Qt::Key_1:
      return showFrom(StandardView::front);
    case Qt::Key_2:
      return showFrom(StandardView::right);
    case Qt::Key_3:
      return showFrom(StandardView::top);
    case Qt::Key_PageDown:
      return walk(1);
    case Qt::Key_PageUp:
      return walk(-1);
    case Qt::Key_Backspace:
      return d->viewer.setTurnedByHand({});
    case Qt::Key_Comma:
      return d->playback.step(-1);
    case Qt::Key_Period:
      return d->playback.step(+1);
    case Qt::Key_S:
      return d->buttons->toggleSection();
    case Qt::Key_E: {
      ViewOptions changed = options();
      changed.explosion = changed.explosion > 0 ? 0 : 1;
      return setOptions(changed);
    }
    case Qt::Key_R:
      return fixReferenceFrame(referenceLink() ? std::nullopt : d->selectedLink());
    case Qt::Key_A:
      if (const auto link = d->selectedLink()) lookAlong(*link);
      return;
    case Qt::Key_H: {
      const auto link = d->selectedLink();
      return setHidden(hidden().empty() && link ? std::set<ElementId>{*link} : std::set<ElementId>{});
    }
    default:
      if (!d->viewer.keyPress(*event)) QWidget::keyPressEvent(event);
  }
}

std::vector<ElementId> View3D::shownLinks() const {
  std::vector<ElementId> links;
  std::unordered_set<ElementId> known;
  if (stage() == nullptr) return links;
  for (const SceneLabel& label : stage()->labels) {
    const bool isLink = label.element.kind == ElementKind::link && !hidden().contains(label.element);
    if (isLink && known.insert(label.element).second) links.push_back(label.element);
  }
  return links;
}

bool View3D::isSelected(const ElementId& link) const {
  return d->selection->isSelected(link);
}

void View3D::select(const ElementId& link) {
  d->selection->select({link});
}

/// By the number that the link's label shows; the ground has none.
QString View3D::nameOf(const ElementId& link) const {
  for (const SceneLabel& label : stage()->labels) {
    if (label.element == link) return tr("link %1").arg(QString::fromStdString(label.text));
  }
  return tr("the ground");
}

/// Selects the link after, or before, the one that is selected.
void View3D::walk(int steps) {
  const std::vector<ElementId> links = shownLinks();
  if (links.empty()) return;
  const auto count = static_cast<int>(links.size());
  const auto selected = d->selectedLink();
  const auto found = selected ? std::find(links.begin(), links.end(), *selected) : links.end();
  const int at = found == links.end() ? (steps > 0 ? -1 : count) : static_cast<int>(found - links.begin());
  select(links[static_cast<std::size_t>((at + steps + count) % count)]);
}

/// The mouse opens it on release over the picture; this is for the Menu key.
void View3D::contextMenuEvent(QContextMenuEvent* event) {
  if (event->reason() != QContextMenuEvent::Keyboard) return QWidget::contextMenuEvent(event);
  const auto link = d->selectedLink();
  const auto part = stage() != nullptr ? instanceOf(*stage(), link) : std::nullopt;
  std::optional<Hit> hit;
  if (part) hit = Hit{*part, *link, d->viewer.poses()[*part].translation()};
  d->openPartMenu(hit, QPointF(d->host->canvas()->rect().center()));
}

void View3D::resizeEvent(QResizeEvent* event) {
  const QSize wanted = d->buttons->sizeHint();
  d->buttons->setGeometry(width() - wanted.width() - 6, 4, wanted.width(), wanted.height());
  d->showPainter();
  d->placeStrip();
  const int height = d->bar->sizeHint().height();
  d->bar->setGeometry(96, this->height() - height, width() - 96, height);
  d->labels.setBorders(d->buttons->geometry().bottom() + 1, height);
  d->emptyText->setGeometry(rect().adjusted(30, 30, -30, -30));
  placeNote();
  QWidget::resizeEvent(event);
}

}  // namespace geargraph

#include "moc_view3d.cpp"
