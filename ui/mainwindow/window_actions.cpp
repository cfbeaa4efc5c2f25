#include "ui/mainwindow/window_actions.h"

#include <QMainWindow>
#include <utility>

#include "ui/theme/icons.h"

namespace geargraph::inline mainwindow {
namespace {

QString words(const char* text) {
  return QMainWindow::tr(text);
}

/// Where the tip of an enabled action is kept while it is disabled.
constexpr const char* kTip = "tip";

}  // namespace

QAction* WindowActions::make(const char* name, const QString& text, const QString& tip,
                             const QList<QKeySequence>& keys, const QString& iconName) {
  auto* action = new QAction(text, m_window);
  action->setObjectName(QLatin1String(name));
  action->setShortcuts(keys);
  QString full = tip;
  if (!keys.isEmpty()) full += QStringLiteral(" (%1)").arg(keys.first().toString(QKeySequence::NativeText));
  action->setToolTip(full);
  action->setProperty(kTip, full);
  if (!iconName.isEmpty()) m_icons.emplace_back(action, iconName);
  m_window->addAction(action);
  return action;
}

void WindowActions::setAvailable(QAction* action, bool available, const QString& why) {
  action->setEnabled(available);
  action->setToolTip(available ? action->property(kTip).toString() : why);
}

void WindowActions::makeTools() {
  struct ToolEntry {
    ToolKind kind;
    const char* icon;
    QString tip;
  };
  const ToolEntry entries[] = {
      {ToolKind::select, "select", words("Select, move, and change what is drawn")},
      {ToolKind::link, "link", words("Draw links: click on an empty place")},
      {ToolKind::turningJoint, "turning-joint",
       words("Draw a turning joint: drag from a link to the link it carries")},
      {ToolKind::gearMesh, "gear-mesh", words("Draw a gear mesh: drag from a gear to the one it drives")},
      {ToolKind::input, "input", words("Drive a joint: click a turning joint or the link it carries")},
      {ToolKind::load, "load",
       words("Load a joint or a link: drag for its torque, or click and type 10 Nm; where one is selected, "
             "its torque is typed at once")},
      {ToolKind::note, "note",
       words(
           "Write a note on the sheet of the digraph: click where it should be; a double click changes one")},
      {ToolKind::pan, "pan", words("Move the sheet; the middle mouse button does so with any tool")},
  };
  tools = new QActionGroup(m_window);
  for (const ToolEntry& entry : entries) {
    const QString name = words(std::string(toolName(entry.kind)).c_str());
    const QChar key = QLatin1Char(toolKey(entry.kind));
    QAction* action = make("", name, entry.tip, {QKeySequence(QString(key))}, QLatin1String(entry.icon));
    action->setObjectName(QStringLiteral("tool.") + QLatin1String(entry.icon));
    action->setIconText(name + QStringLiteral("  ") + key);
    action->setCheckable(true);
    action->setData(static_cast<int>(entry.kind));
    tools->addAction(action);
    tool[static_cast<std::size_t>(entry.kind)] = action;
  }
  tool[static_cast<std::size_t>(ToolKind::select)]->setChecked(true);
}

WindowActions::WindowActions(QMainWindow* window) : m_window(window) {
  newDocument = make("file.new", words("&New"), words("A document with the ground and nothing else"),
                     {QKeySequence::New});
  newWindow = make("file.newWindow", words("New &window"), words("Another window with an empty document"),
                   {QKeySequence(QStringLiteral("Ctrl+Shift+N"))});
  startPage =
      make("file.startPage", words("S&tart page"), words("New document, recent documents and examples"), {});
  open = make("file.open", words("&Open…"), words("Open a document"), {QKeySequence::Open});
  save = make("file.save", words("&Save"), words("Save the document"), {QKeySequence::Save});
  saveAs = make("file.saveAs", words("Save &as…"), words("Save the document under another name"),
                {QKeySequence(QStringLiteral("Ctrl+Shift+S"))});
  revert = make("file.revert", words("Re&vert"), words("Reload the file; this can be undone"), {});
  restoreSession = make("file.restoreSession", words("Reopen w&indows at start"),
                        words("Open the documents of the last time when the program starts without one"), {});
  restoreSession->setCheckable(true);
  exportMatrix = make("file.exportCsv", words("&Export matrix as CSV…"),
                      words("Export the matrix that is shown, with its labels"),
                      {QKeySequence(QStringLiteral("Ctrl+E"))});
  exportPicture = make("file.exportPicture", words("Export pict&ure…"),
                       words("Export a drawing as SVG, PDF or PNG, or the 3D view as PNG"),
                       {QKeySequence(QStringLiteral("Ctrl+Shift+E"))});
  exportDerivation = make(
      "file.exportDerivation", words("Export &derivation…"),
      words("Both methods worked out step by step for this mechanism, as a web page, PDF, LaTeX or Markdown"),
      {});
  exportHandout =
      make("file.exportHandout", words("Export &handout…"),
           words("One page for any browser, also on a phone and without a network: drawings, matrices, "
                 "solution, derivation and the train in 3D, with inputs that move, and exercises if you "
                 "choose them; also as a package for learning platforms"),
           {});
  print = make("file.print", words("&Print…"),
               words("Print the drawings and the derivation, or look at the pages first"),
               {QKeySequence(QStringLiteral("Ctrl+P"))});
  showDerivation =
      make("learn.derivation", words("Show the &derivation"),
           words("Both methods worked out step by step for this mechanism"), {QKeySequence(Qt::Key_F6)});
  compareMethods = make("learn.compare", words("&Compare the methods"),
                        words("Both methods side by side, counted for this mechanism"), {});
  lessons =
      make("learn.lessons", words("&Lessons…"),
           words("A course from one gear pair to the robot, with tasks that are checked; in a window of "
                 "its own"),
           {});
  exercises =
      make("learn.exercises", words("&Exercises…"),
           words("Questions about this mechanism, to practise, or as sheets and handouts for a class"), {});
  checkPaper = make("learn.check", words("Check &my matrices…"),
                    words("Matrices and equations that you have worked out, beside the derived ones"), {});
  lessonFile = make("learn.lessonFile", words("Open a lesson &file…"),
                    words("Preview a lesson of your own: it is reloaded whenever the file is saved"), {});
  close = make("file.close", words("&Close window"), words("Close this window"), {QKeySequence::Close});
  quit =
      make("file.quit", words("&Quit"), words("Close all windows"), {QKeySequence(QStringLiteral("Ctrl+Q"))});

  undo = make("edit.undo", words("&Undo"), words("Undo"), {QKeySequence(QStringLiteral("Ctrl+Z"))},
              QStringLiteral("undo"));
  redo = make("edit.redo", words("&Redo"), words("Redo"),
              {QKeySequence(QStringLiteral("Ctrl+Y")), QKeySequence(QStringLiteral("Ctrl+Shift+Z"))},
              QStringLiteral("redo"));
  history =
      make("edit.history", words("&History…"), words("All steps as a list; a click goes to any of them"),
           {QKeySequence(QStringLiteral("Ctrl+Shift+H"))});
  cut = make("edit.cut", words("Cu&t"), words("Copy what is selected, and delete it"), {QKeySequence::Cut});
  copy = make("edit.copy", words("&Copy"),
              words("Copy the selected links with the joints and meshes between them"), {QKeySequence::Copy});
  copyPicture =
      make("edit.copyPicture", words("Copy as p&icture"),
           words("Copy the drawing in front, or the 3D view where it has the focus, as SVG and PNG"),
           {QKeySequence(QStringLiteral("Ctrl+Shift+C"))});
  paste = make("edit.paste", words("&Paste"), words("Insert what was copied, in this window or in another"),
               {QKeySequence::Paste});
  duplicate = make("edit.duplicate", words("Dup&licate"), words("A copy of the selection in the drawing"),
                   {QKeySequence(QStringLiteral("Ctrl+D"))});
  remove = make("edit.delete", words("&Delete"), words("Delete what is selected, and what needs it"),
                {QKeySequence(Qt::Key_Delete)}, QStringLiteral("delete"));
  rename =
      make("edit.rename", words("Re&name"), words("Rename the selected link"), {QKeySequence(Qt::Key_F2)});
  selectAll =
      make("edit.selectAll", words("Select &all"), words("Select everything"), {QKeySequence::SelectAll});
  makeTools();

  flip = make("mechanism.flip", words("&Flip"), words("Exchange tail and head of the selected arrows"),
              {QKeySequence(QStringLiteral("X"))}, QStringLiteral("flip"));
  makeGround =
      make("mechanism.ground", words("Make &ground"), words("Makes the selected link the ground"), {});
  attachGear = make("mechanism.attachGear", words("&Attach a gear"),
                    words("A new gear in mesh with the selected one, on the same carrier"),
                    {QKeySequence(QStringLiteral("Ctrl+G"))});
  drive = make("mechanism.drive", words("Dri&ve"), words("Drive the selected joints, or stop driving them"),
               {QKeySequence(QStringLiteral("Ctrl+I"))}, QStringLiteral("input"));
  hold = make("mechanism.hold", words("Hold with a &brake"),
              words("Engage the brake of the selected link, a new one where it has none, or release it"),
              {QKeySequence(QStringLiteral("B"))});
  load = make("mechanism.load", words("T&orque…"),
              words("A torque in the selected joint or on the selected link: type 10 Nm, nothing removes it"),
              {});
  releaseAll = make("mechanism.releaseAll", words("&Release brakes and clutches"),
                    words("Release every brake and clutch; the motion goes on"),
                    {QKeySequence(QStringLiteral("Ctrl+B"))});
  insertSet =
      make("mechanism.insertSet", words("&Insert set…"),
           words("A whole planetary, Ravigneaux or Simpson set, a differential, a reverted train, a wrist"),
           {QKeySequence(QStringLiteral("Ctrl+Shift+I"))});
  for (std::size_t i = 0; i < planets.size(); ++i) {
    const QString count = QString::number(i + 2);
    planets[i] = make("", words("%1 planets").arg(count),
                      words("Copies of the selected planet, equally spaced, %1 in all").arg(count), {});
    planets[i]->setObjectName(QStringLiteral("mechanism.planets") + count);
  }
  tidy = make("mechanism.tidy", words("&Tidy the drawing"), words("Lay the digraph out anew"),
              {QKeySequence(QStringLiteral("Ctrl+L"))});

  fit = make("view.fit", words("&Fit"), words("Show all of the drawing"),
             {QKeySequence(QStringLiteral("Ctrl+0"))});
  zoomIn = make("view.zoomIn", words("Zoom &in"), words("Larger"), {QKeySequence::ZoomIn});
  zoomOut = make("view.zoomOut", words("Zoom &out"), words("Smaller"), {QKeySequence::ZoomOut});
  fitSelected = make("view.fitSelected", words("Fit the &selection"), words("Show all that is selected"),
                     {QKeySequence(QStringLiteral("Ctrl+Shift+0"))});
  makeAppearance();
  presentation = make("view.presentation", words("&Presentation"),
                      words("Full screen, large type, the drawing and the panels that were chosen"),
                      {QKeySequence(Qt::Key_F11)});
  presentation->setCheckable(true);
  grid = make("view.grid", words("Snap to the &grid"), words("Nodes keep to a grid; Alt suspends it"),
              {QKeySequence(QStringLiteral("#"))});
  grid->setCheckable(true);
  powerFlow = make("view.powerFlow", words("Po&wer flow"),
                   words("Bands in digraph and schematic show where the power of the loads goes"),
                   {QKeySequence(QStringLiteral("Ctrl+Shift+F"))});
  powerFlow->setCheckable(true);
  resetLayout = make("view.reset", words("&Reset the layout"), words("All panels back to their places"), {});
  makeMotion();
  lookUp = make("learn.lookUp", words("Look &up a term…"), words("The definition of a technical term"), {});
  search = make("help.search", words("&Search…"),
                words("Find a command, an element, a term or a page of the manual"),
                {QKeySequence(QStringLiteral("Ctrl+K"))});
  manual = make("help.manual", words("&Manual"), words("The page of the manual about what has the focus"),
                {QKeySequence(Qt::Key_F1)});
  whatsThis =
      make("help.whatsThis", words("&What's this"), words("Then click something to learn what it is for"),
           {QKeySequence(Qt::SHIFT | Qt::Key_F1)});
  tour = make("help.tour", words("&Tour"), words("The parts of the window in two minutes"), {});
  shortcuts = make("help.shortcuts", words("&Keyboard shortcuts"), words("All keys on one sheet"),
                   {QKeySequence(Qt::CTRL | Qt::Key_F1)});
  about = make("help.about", words("&About GearGraph"), words("What this program is"), {});
}

void WindowActions::makeAppearance() {
  asSystem = make("view.asSystem", words("As the &system"), words("Light or dark as the system is"), {});
  light = make("view.light", words("&Light"), words("Dark on light"), {});
  dark = make("view.dark", words("&Dark"), words("Light on dark"), {});
  highContrast = make("view.highContrast", words("&High contrast"), words("Light on black"), {});
  auto* themes = new QActionGroup(m_window);
  for (QAction* action : {asSystem, light, dark, highContrast}) {
    action->setCheckable(true);
    themes->addAction(action);
  }
  typeSizes = new QActionGroup(m_window);
  for (const int percent : {90, 100, 115, 130, 150, 200}) {
    QAction* size = make("", words("%1 %").arg(percent),
                         words("Words of the window at %1 % of their size").arg(percent), {});
    size->setObjectName(QStringLiteral("view.typeSize%1").arg(percent));
    size->setCheckable(true);
    size->setData(percent / 100.0);
    typeSizes->addAction(size);
  }
  half3d = make("view.half3d", words("3D on &half the width"), words("The 3D view as wide as the drawing"),
                {QKeySequence(QStringLiteral("Ctrl+Shift+3"))});
}

void WindowActions::makeMotion() {
  // Space belongs to the drawings and the 3D view, where a tap plays and holding it pans; it is only named
  // here, so that elsewhere it still presses the button that has the focus.
  play = make("motion.play", words("&Play\tSpace"), words("Start or stop the motion (Space)"), {});
  toStart = make("motion.start", words("Back to the &start"), words("The time goes back to 0"),
                 {QKeySequence(QStringLiteral("Ctrl+Home"))});
  faster = make("motion.faster", words("&Faster"), words("The motion is shown faster"),
                {QKeySequence(QStringLiteral("Ctrl+."))});
  slower = make("motion.slower", words("Slo&wer"), words("The motion is shown more slowly"),
                {QKeySequence(QStringLiteral("Ctrl+,"))});
  normalSpeed =
      make("motion.normal", words("&Normal speed"), words("A second of the motion takes a second"), {});
  backwards = make("motion.backwards", words("&Backwards"), words("The motion runs back in time"), {});
  backwards->setCheckable(true);
}

void WindowActions::setTheme(Theme theme, bool isAsSystem, double typeScale) {
  if (std::exchange(m_iconTheme, theme) != theme) {
    for (const auto& [action, name] : m_icons) action->setIcon(icon(name, ColorRole::ink, theme));
  }
  QAction* chosen = theme == Theme::light ? light : theme == Theme::dark ? dark : highContrast;
  (isAsSystem ? asSystem : chosen)->setChecked(true);
  for (QAction* size : typeSizes->actions()) {
    if (size->data().toDouble() == typeScale) size->setChecked(true);
  }
}

}  // namespace geargraph::inline mainwindow
