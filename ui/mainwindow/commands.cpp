#include "ui/mainwindow/commands.h"

#include <QMainWindow>
#include <utility>

#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

QString words(const char* text) {
  return QMainWindow::tr(text);
}

QString alone() {
  return words("This window is not connected to others.");
}

QString notKept() {
  return words("A lesson's drawing is not kept: copy what you need into another window.");
}

QString nothingSelected() {
  return words("Nothing is selected.");
}

QString whyNotCopied(const CommandState& now) {
  if (now.isOnlyGround()) return words("There is one ground in every document.");
  return now.selected > 0 ? QString() : nothingSelected();
}

std::vector<Command> commandsOfFile() {
  return {
      {.id = CommandId::newDocument,
       .name = "file.new",
       .text = words("&New"),
       .tip = words("A document with the ground and nothing else"),
       .keys = {QKeySequence::New}},
      {.id = CommandId::newWindow,
       .name = "file.newWindow",
       .text = words("New &window"),
       .tip = words("Another window with an empty document"),
       .keys = {QKeySequence(QStringLiteral("Ctrl+Shift+N"))},
       .searchWords = "second another beside",
       .whyNot = [](const CommandState& now) { return now.hasSiblings ? QString() : alone(); }},
      {.id = CommandId::startPage,
       .name = "file.startPage",
       .text = words("S&tart page"),
       .tip = words("New document, recent documents and examples"),
       .searchWords = "examples samples recent welcome"},
      {.id = CommandId::open,
       .name = "file.open",
       .text = words("&Open…"),
       .tip = words("Open a document"),
       .keys = {QKeySequence::Open},
       .searchWords = "load import file document"},
      {.id = CommandId::save,
       .name = "file.save",
       .text = words("&Save"),
       .tip = words("Save the document"),
       .keys = {QKeySequence::Save},
       .whyNot = [](const CommandState& now) { return now.isTransient ? notKept() : QString(); }},
      {.id = CommandId::saveAs,
       .name = "file.saveAs",
       .text = words("Save &as…"),
       .tip = words("Save the document under another name"),
       .keys = {QKeySequence(QStringLiteral("Ctrl+Shift+S"))},
       .searchWords = "rename store write folder",
       .whyNot = [](const CommandState& now) { return now.isTransient ? notKept() : QString(); }},
      {.id = CommandId::revert,
       .name = "file.revert",
       .text = words("Re&vert"),
       .tip = words("Reload the file; this can be undone"),
       .searchWords = "reload discard restore",
       .whyNot =
           [](const CommandState& now) {
             if (!now.hasFile) return words("The document has no file yet.");
             return now.isModified ? QString() : words("Nothing has been changed since it was saved.");
           }},
      {.id = CommandId::restoreSession,
       .name = "file.restoreSession",
       .text = words("Reopen w&indows at start"),
       .tip = words("Open the documents of the last time when the program starts without one"),
       .isCheckable = true,
       .whyNot = [](const CommandState& now) { return now.hasSiblings ? QString() : alone(); }},
      {.id = CommandId::exportAny,
       .name = "file.export",
       .text = words("&Export…"),
       .tip = words("Export graphs, matrices, derivations, drawings, pictures, solids and models for other "
                    "programs, with all their options, and see first what will be written"),
       .searchWords = "any format dot graphviz graphml networkx mjcf mujoco urdf modelica glb gltf stl obj "
                      "ply 3mf scorm "
                      "simulator convert program format"},
      {.id = CommandId::exportMatrix,
       .name = "file.exportCsv",
       .text = words("Export &matrix as CSV…"),
       .tip = words("Export the matrix that is shown, with its labels"),
       .keys = {QKeySequence(QStringLiteral("Ctrl+E"))},
       .searchWords = "table spreadsheet excel matlab numpy save matrix",
       .whyNot =
           [](const CommandState& now) {
             if (now.hasMatrix) return QString();
             return now.isQuantity ? words("This matrix needs a mechanism without errors.")
                                   : words("This matrix needs the turning joints to be a spanning tree.");
           }},
      {.id = CommandId::exportPicture,
       .name = "file.exportPicture",
       .text = words("Export pict&ure…"),
       .tip = words("Export a drawing as SVG, PDF or PNG, or the 3D view as PNG"),
       .keys = {QKeySequence(QStringLiteral("Ctrl+Shift+E"))},
       .searchWords = "image png svg pdf glb film video animation 3d save drawing"},
      {.id = CommandId::exportDerivation,
       .name = "file.exportDerivation",
       .text = words("Export &derivation…"),
       .tip = words(
           "Both methods worked out step by step for this mechanism, as a web page, PDF, LaTeX or Markdown"),
       .whyNot = [](const CommandState& now) { return now.whyNoDerivation; }},
      {.id = CommandId::exportHandout,
       .name = "file.exportHandout",
       .text = words("Export &handout…"),
       .tip = words("One page for any browser, also on a phone and without a network: drawings, matrices, "
                    "solution, derivation and the train in 3D, with inputs that move, and exercises if you "
                    "choose them; also as a package for learning platforms"),
       .searchWords = "html web page share students website publish offline",
       .whyNot = [](const CommandState& now) { return now.whyNoDerivation; }},
      {.id = CommandId::print,
       .name = "file.print",
       .text = words("&Print…"),
       .tip = words("Print the drawings and the derivation, or look at the pages first"),
       .keys = {QKeySequence(QStringLiteral("Ctrl+P"))},
       .searchWords = "printer paper page preview pdf hardcopy"},
      {.id = CommandId::close,
       .name = "file.close",
       .text = words("&Close window"),
       .tip = words("Close this window"),
       .keys = {QKeySequence::Close}},
      {.id = CommandId::quit,
       .name = "file.quit",
       .text = words("&Quit"),
       .tip = words("Close all windows"),
       .keys = {QKeySequence(QStringLiteral("Ctrl+Q"))}},
  };
}

std::vector<Command> commandsOfEdit() {
  return {
      {.id = CommandId::undo,
       .name = "edit.undo",
       .text = words("&Undo"),
       .tip = words("Undo"),
       .keys = {QKeySequence(QStringLiteral("Ctrl+Z"))},
       .icon = "undo",
       .whyNot =
           [](const CommandState& now) {
             return now.canUndo ? QString() : words("There is nothing to undo.");
           }},
      {.id = CommandId::redo,
       .name = "edit.redo",
       .text = words("&Redo"),
       .tip = words("Redo"),
       .keys = {QKeySequence(QStringLiteral("Ctrl+Y")), QKeySequence(QStringLiteral("Ctrl+Shift+Z"))},
       .icon = "redo",
       .whyNot =
           [](const CommandState& now) {
             return now.canRedo ? QString() : words("There is nothing to redo.");
           }},
      {.id = CommandId::history,
       .name = "edit.history",
       .text = words("&History…"),
       .tip = words("All steps as a list; a click goes to any of them"),
       .keys = {QKeySequence(QStringLiteral("Ctrl+Shift+H"))},
       .searchWords = "undo redo steps list back versions"},
      {.id = CommandId::cut,
       .name = "edit.cut",
       .text = words("Cu&t"),
       .tip = words("Copy what is selected, and delete it"),
       .keys = {QKeySequence::Cut},
       .whyNot = [](const CommandState& now) { return whyNotCopied(now); }},
      {.id = CommandId::copy,
       .name = "edit.copy",
       .text = words("&Copy"),
       .tip = words("Copy the selected links with the joints and meshes between them"),
       .keys = {QKeySequence::Copy},
       .whyNot = [](const CommandState& now) { return now.isMeasured ? QString() : whyNotCopied(now); }},
      {.id = CommandId::copyPicture,
       .name = "edit.copyPicture",
       .text = words("Copy as p&icture"),
       .tip = words("Copy the drawing in front, or the 3D view where it has the focus, as SVG and PNG"),
       .keys = {QKeySequence(QStringLiteral("Ctrl+Shift+C"))},
       .searchWords = "image png svg clipboard screenshot"},
      {.id = CommandId::paste,
       .name = "edit.paste",
       .text = words("&Paste"),
       .tip = words("Insert what was copied, in this window or in another"),
       .keys = {QKeySequence::Paste}},
      {.id = CommandId::duplicate,
       .name = "edit.duplicate",
       .text = words("Dup&licate"),
       .tip = words("A copy of the selection in the drawing"),
       .keys = {QKeySequence(QStringLiteral("Ctrl+D"))},
       .searchWords = "clone copy again twin",
       .whyNot = [](const CommandState& now) { return whyNotCopied(now); }},
      {.id = CommandId::remove,
       .name = "edit.delete",
       .text = words("&Delete"),
       .tip = words("Delete what is selected, and what needs it"),
       .keys = {QKeySequence(Qt::Key_Delete)},
       .icon = "delete",
       .searchWords = "remove erase drop",
       .whyNot =
           [](const CommandState& now) {
             if (now.isOnlyGround()) return words("The ground cannot be deleted.");
             return now.selected > 0 ? QString() : nothingSelected();
           }},
      {.id = CommandId::rename,
       .name = "edit.rename",
       .text = words("Re&name"),
       .tip = words("Rename the selected link"),
       .keys = {QKeySequence(Qt::Key_F2)},
       .searchWords = "name label title",
       .whyNot =
           [](const CommandState& now) {
             const bool isOneNote = now.selected == 1 && now.notes == 1;
             return now.isOneLink() || isOneNote
                        ? QString()
                        : words("Select one link to rename it, or one note to change it.");
           }},
      {.id = CommandId::selectAll,
       .name = "edit.selectAll",
       .text = words("Select &all"),
       .tip = words("Select everything"),
       .keys = {QKeySequence::SelectAll}},
  };
}

std::vector<Command> commandsOfMechanism() {
  return {
      {.id = CommandId::flip,
       .name = "mechanism.flip",
       .text = words("&Flip"),
       .tip = words("Exchange tail and head of the selected arrows"),
       .keys = {QKeySequence(QStringLiteral("X"))},
       .icon = "flip",
       .searchWords = "reverse arrow direction orientation",
       .whyNot =
           [](const CommandState& now) {
             return now.arrows() > 0 ? QString() : words("Select a joint or a mesh to turn its arrow round.");
           }},
      {.id = CommandId::makeGround,
       .name = "mechanism.ground",
       .text = words("Make &ground"),
       .tip = words("Makes the selected link the ground"),
       .searchWords = "fix frame housing base fixed",
       .whyNot =
           [](const CommandState& now) {
             if (now.isGroundSelected) return words("This link is the ground already.");
             return now.links == 1 ? QString() : words("Select one link to make it the ground.");
           }},
      {.id = CommandId::attachGear,
       .name = "mechanism.attachGear",
       .text = words("&Attach a gear"),
       .tip = words("A new gear in mesh with the selected one, on the same carrier"),
       .keys = {QKeySequence(QStringLiteral("Ctrl+G"))},
       .searchWords = "wheel tooth teeth pinion add cog",
       .whyNot =
           [](const CommandState& now) {
             return now.isOneLink() ? now.whyNoGear
                                    : words("Select the link that the gear should mesh with.");
           }},
      {.id = CommandId::weld,
       .name = "mechanism.weld",
       .text = words("&Weld links"),
       .tip = words("The two selected links become one, which two gear sets then share; axes on one carrier "
                    "become one line"),
       .keys = {QKeySequence(QStringLiteral("Ctrl+J"))},
       .searchWords = "merge join combine connect unite fuse rigid one link couple sets",
       .whyNot = [](const CommandState& now) { return now.whyNoWeld; }},
      {.id = CommandId::split,
       .name = "mechanism.split",
       .text = words("Sp&lit the link"),
       .tip =
           words("A new link takes the selected joints and meshes of the selected link, or the side of the "
                 "train that was drawn last; both turn about one axis"),
       .keys = {QKeySequence(QStringLiteral("Ctrl+Shift+J"))},
       .searchWords = "divide separate cut unweld part unmerge two links",
       .whyNot = [](const CommandState& now) { return now.whyNoSplit; }},
      {.id = CommandId::drive,
       .name = "mechanism.drive",
       .text = words("Dri&ve"),
       .tip = words("Drive the selected joints, or stop driving them"),
       .keys = {QKeySequence(QStringLiteral("Ctrl+I"))},
       .icon = "input",
       .searchWords = "motor input speed actuator engine crank",
       .whyNot =
           [](const CommandState& now) {
             return now.joints + now.links > 0 && !now.isOnlyGround()
                        ? QString()
                        : words("Select a turning joint, or the link it carries.");
           }},
      {.id = CommandId::hold,
       .name = "mechanism.hold",
       .text = words("Hold with a &brake"),
       .tip = words("Engage the brake of the selected link, a new one where it has none, or release it"),
       .keys = {QKeySequence(QStringLiteral("B"))},
       .searchWords = "fix stop block lock band engage held ring",
       .whyNot =
           [](const CommandState& now) {
             if (now.isOnlyGround()) return words("The ground does not move.");
             return now.isOneLink() ? QString() : words("Select one link to hold it.");
           }},
      {.id = CommandId::load,
       .name = "mechanism.load",
       .text = words("T&orque…"),
       .tip = words("A torque in the selected joint or on the selected link: type 10 Nm, nothing removes it"),
       .searchWords = "force moment couple weight newton nm",
       .whyNot = [](const CommandState& now) { return now.whyNoLoad; }},
      {.id = CommandId::releaseAll,
       .name = "mechanism.releaseAll",
       .text = words("&Release brakes and clutches"),
       .tip = words("Release every brake and clutch; the motion goes on"),
       .keys = {QKeySequence(QStringLiteral("Ctrl+B"))},
       .searchWords = "disengage free unlock open let go",
       .whyNot =
           [](const CommandState& now) {
             return now.isEngaged ? QString() : words("No brake and no clutch is engaged.");
           }},
      {.id = CommandId::insertSet,
       .name = "mechanism.insertSet",
       .text = words("&Insert set…"),
       .tip = words(
           "A whole planetary, Ravigneaux or Simpson set, a differential, a reverted train, a wrist, a worm "
           "or belt stage, a strain wave, cycloidal or RV reducer"),
       .keys = {QKeySequence(QStringLiteral("Ctrl+Shift+I"))},
       .icon = "set",
       .searchWords = "ratio teeth planetary epicyclic differential sun ring carrier reverted worm belt "
                      "harmonic strain wave "
                      "cycloidal wizard template"},
      {.id = CommandId::findTeeth,
       .name = "mechanism.findTeeth",
       .text = words("Teeth for ratios…"),
       .tip = words("Every choice of whole teeth with which this train has the ratios that you want"),
       .searchWords = "ratio teeth tooth counts number wanted synthesis find hunting certificate",
       .whyNot =
           [](const CommandState& now) {
             if (!now.hasLinks) return words("There is no train yet whose teeth could be chosen.");
             return now.areAnswersOpen
                        ? QString()
                        : words("The teeth hold the answer: they open when the step is right or shown.");
           }},
      {.id = CommandId::atlas,
       .name = "mechanism.atlas",
       .text = words("Atlas of chains"),
       .tip = words("All geared kinematic chains up to 7 links, and which of them this train is"),
       .searchWords = "identify isomorphism chain number enumerate gallery cannot turn degenerate"},
      {.id = CommandId::designGearbox,
       .name = "mechanism.designGearbox",
       .text = words("Gearbox designer…"),
       .tip = words("Search for planetary sets, brakes and clutches that have the ratios you want"),
       .searchWords = "design gearbox synthesis wanted ratios automatic transmission speeds layout invent"},
      {.id = CommandId::hardware,
       .name = "mechanism.hardware",
       .text = words("Ratios to hardware…"),
       .tip = words("What may be inside a hub gear with these ratios, and what to count"),
       .searchWords = "hub gear bicycle inside teeth count reverse engineer sheet ratios"},
      {.id = CommandId::tidy,
       .name = "mechanism.tidy",
       .text = words("&Tidy the drawing"),
       .tip = words("Lay the digraph out anew"),
       .keys = {QKeySequence(QStringLiteral("Ctrl+L"))},
       .searchWords = "layout arrange clean up align",
       .whyNot =
           [](const CommandState& now) {
             return now.hasLinks ? QString() : words("There is no link to lay out yet.");
           }},
  };
}

std::vector<Command> commandsOfView() {
  return {
      {.id = CommandId::fit,
       .name = "view.fit",
       .text = words("&Fit"),
       .tip = words("Show all of the drawing"),
       .keys = {QKeySequence(QStringLiteral("Ctrl+0"))},
       .searchWords = "zoom all show everything centre center"},
      {.id = CommandId::zoomIn,
       .name = "view.zoomIn",
       .text = words("Zoom &in"),
       .tip = words("Larger"),
       .keys = {QKeySequence::ZoomIn}},
      {.id = CommandId::zoomOut,
       .name = "view.zoomOut",
       .text = words("Zoom &out"),
       .tip = words("Smaller"),
       .keys = {QKeySequence::ZoomOut}},
      {.id = CommandId::fitSelected,
       .name = "view.fitSelected",
       .text = words("Fit the &selection"),
       .tip = words("Show all that is selected"),
       .keys = {QKeySequence(QStringLiteral("Ctrl+Shift+0"))},
       .whyNot = [](const CommandState& now) { return now.selected > 0 ? QString() : nothingSelected(); }},
      {.id = CommandId::asSystem,
       .name = "view.asSystem",
       .text = words("As the &system"),
       .tip = words("Light or dark as the system is"),
       .searchWords = "theme automatic desktop colour color",
       .isCheckable = true},
      {.id = CommandId::light,
       .name = "view.light",
       .text = words("&Light"),
       .tip = words("Dark on light"),
       .searchWords = "day mode theme colour color",
       .isCheckable = true},
      {.id = CommandId::dark,
       .name = "view.dark",
       .text = words("&Dark"),
       .tip = words("Light on dark"),
       .searchWords = "night mode theme colour color",
       .isCheckable = true},
      {.id = CommandId::highContrast,
       .name = "view.highContrast",
       .text = words("&High contrast"),
       .tip = words("Light on black"),
       .searchWords = "accessibility theme colour color",
       .isCheckable = true},
      {.id = CommandId::half3d,
       .name = "view.half3d",
       .text = words("3D on &half the width"),
       .tip = words("The 3D view as wide as the drawing"),
       .keys = {QKeySequence(QStringLiteral("Ctrl+Shift+3"))},
       .searchWords = "wide large split solid gears"},
      {.id = CommandId::projector,
       .name = "view.projector",
       .text = words("Layout for projectors"),
       .tip =
           words("Drawing and 3D alone, the drawing on three fifths of the width, in large type; Reset the "
                 "layout brings the panels back"),
       .searchWords = "beamer lecture hall large type wide drawing screen big"},
      {.id = CommandId::presentation,
       .name = "view.presentation",
       .text = words("&Presentation"),
       .tip = words("Full screen, large type, the drawing and the panels that were chosen"),
       .keys = {QKeySequence(Qt::Key_F11)},
       .searchWords = "full screen beamer projector lecture large",
       .isCheckable = true},
      {.id = CommandId::grid,
       .name = "view.grid",
       .text = words("Snap to the &grid"),
       .tip = words("Nodes keep to a grid; Alt suspends it"),
       .keys = {QKeySequence(QStringLiteral("#"))},
       .searchWords = "snap raster align",
       .isCheckable = true},
      {.id = CommandId::captions,
       .name = "view.captions",
       .text = words("N&ames and teeth"),
       .tip = words("Names of links and tooth counts beside their numbers, where there is room; lessons and "
                    "presentations have them on"),
       .keys = {QKeySequence(QStringLiteral("Ctrl+Shift+L"))},
       .searchWords = "labels captions tooth counts show names teaching text annotate",
       .isCheckable = true},
      {.id = CommandId::powerFlow,
       .name = "view.powerFlow",
       .text = words("Po&wer flow"),
       .tip = words("Bands in digraph and schematic show where the power of the loads goes"),
       .keys = {QKeySequence(QStringLiteral("Ctrl+Shift+F"))},
       .searchWords = "watt power energy circulating losses bands",
       .isCheckable = true,
       .whyNot = [](const CommandState& now) { return now.whyNoPowerFlow; }},
      {.id = CommandId::resetLayout,
       .name = "view.reset",
       .text = words("&Reset the layout"),
       .tip = words("All panels back to their places, in this window and in those to come"),
       .searchWords = "panels docks default windows"},
  };
}

std::vector<Command> commandsOfMotion() {
  return {
      {.id = CommandId::play,
       .name = "motion.play",
       .text = words("&Play\tSpace"),
       .tip = words("Start or stop the motion (Space)"),
       .searchWords = "animate simulate run move turn start"},
      {.id = CommandId::toStart,
       .name = "motion.start",
       .text = words("Back to the &start"),
       .tip = words("The time goes back to 0"),
       .keys = {QKeySequence(QStringLiteral("Ctrl+Home"))},
       .searchWords = "rewind reset home"},
      {.id = CommandId::faster,
       .name = "motion.faster",
       .text = words("&Faster"),
       .tip = words("The motion is shown faster"),
       .keys = {QKeySequence(QStringLiteral("Ctrl+."))},
       .searchWords = "accelerate quicker"},
      {.id = CommandId::slower,
       .name = "motion.slower",
       .text = words("Slo&wer"),
       .tip = words("The motion is shown more slowly"),
       .keys = {QKeySequence(QStringLiteral("Ctrl+,"))},
       .searchWords = "slow brake down"},
      {.id = CommandId::normalSpeed,
       .name = "motion.normal",
       .text = words("&Normal speed"),
       .tip = words("A second of the motion takes a second")},
      {.id = CommandId::backwards,
       .name = "motion.backwards",
       .text = words("&Backwards"),
       .tip = words("The motion runs back in time"),
       .searchWords = "reverse rewind",
       .isCheckable = true},
  };
}

std::vector<Command> commandsOfLearn() {
  return {
      {.id = CommandId::lessons,
       .name = "learn.lessons",
       .text = words("&Lessons…"),
       .tip = words("A course from one gear pair to the robot, with tasks that are checked; in a window of "
                    "its own"),
       .searchWords = "course tutorial teach learn lecture practise training"},
      {.id = CommandId::lessonFile,
       .name = "learn.lessonFile",
       .text = words("Open a lesson &file…"),
       .tip = words("Preview a lesson of your own: it is reloaded whenever the file is saved")},
      {.id = CommandId::lessonPages,
       .name = "learn.lessonPages",
       .text = words("Lessons as &web pages…"),
       .tip =
           words("Writes all lessons into a folder, with the same grader: pages for any browser, phones too, "
                 "and packages for learning platforms"),
       .searchWords = "html scorm moodle course class publish offline students"},
      {.id = CommandId::exercises,
       .name = "learn.exercises",
       .text = words("&Exercises…"),
       .tip = words("Questions about this mechanism, to practise, or as sheets and handouts for a class"),
       .searchWords = "practise quiz questions homework sheet exam test class handout scorm students"},
      {.id = CommandId::checkPaper,
       .name = "learn.check",
       .text = words("Check &my matrices…"),
       .tip = words("Matrices and equations that you have worked out, beside the derived ones"),
       .searchWords = "grade verify homework paper solution correct matrix equation compare mine"},
      {.id = CommandId::handoutNow,
       .name = "learn.handout",
       .text = words("&Handout for the class"),
       .tip = words("Writes a page for any browser beside the document, at once: drawings, matrices, "
                    "derivation and the train in 3D, with inputs that move"),
       .searchWords = "html web page share students publish offline one button",
       .whyNot = [](const CommandState& now) { return now.whyNoDerivation; }},
      {.id = CommandId::showDerivation,
       .name = "learn.derivation",
       .text = words("Show the &derivation"),
       .tip = words("Both methods worked out step by step for this mechanism"),
       .keys = {QKeySequence(Qt::Key_F6)},
       .searchWords = "proof steps explanation equations",
       .whyNot =
           [](const CommandState& now) {
             return now.areAnswersOpen
                        ? now.whyNoDerivation
                        : words("The derivation holds the answer: it opens when the step is right or shown.");
           }},
      {.id = CommandId::compareMethods,
       .name = "learn.compare",
       .text = words("&Compare the methods"),
       .tip = words("Both methods side by side, counted for this mechanism"),
       .searchWords = "difference advantage versus similar both methods matroid t-t graph",
       .whyNot = [](const CommandState& now) { return now.whyNoDerivation; }},
      {.id = CommandId::lookUp,
       .name = "learn.lookUp",
       .text = words("Look &up a term…"),
       .tip = words("The definition of a technical term"),
       .searchWords = "glossary definition dictionary meaning"},
  };
}

std::vector<Command> commandsOfHelp() {
  return {
      {.id = CommandId::search,
       .name = "help.search",
       .text = words("&Search…"),
       .tip = words("Find a command, an element, a term or a page of the manual"),
       .keys = {QKeySequence(QStringLiteral("Ctrl+K"))}},
      {.id = CommandId::manual,
       .name = "help.manual",
       .text = words("&Manual"),
       .tip = words("The page of the manual about what has the focus"),
       .keys = {QKeySequence(Qt::Key_F1)},
       .searchWords = "documentation guide instructions f1 how"},
      {.id = CommandId::whatsThis,
       .name = "help.whatsThis",
       .text = words("&What's this"),
       .tip = words("Then click something to learn what it is for"),
       .keys = {QKeySequence(Qt::SHIFT | Qt::Key_F1)}},
      {.id = CommandId::tour,
       .name = "help.tour",
       .text = words("&Tour"),
       .tip = words("The parts of the window in two minutes"),
       .searchWords = "introduction beginner start overview"},
      {.id = CommandId::shortcuts,
       .name = "help.shortcuts",
       .text = words("&Keyboard shortcuts"),
       .tip = words("All keys on one sheet"),
       .keys = {QKeySequence(Qt::CTRL | Qt::Key_F1)},
       .searchWords = "keys hotkeys keyboard"},
      {.id = CommandId::about,
       .name = "help.about",
       .text = words("&About GearGraph"),
       .tip = words("What this program is"),
       .searchWords = "version licence license authors"},
  };
}

}  // namespace

std::vector<Command> commandTable() {
  std::vector<Command> all;
  for (const auto part : {&commandsOfFile, &commandsOfEdit, &commandsOfMechanism, &commandsOfView,
                          &commandsOfMotion, &commandsOfLearn, &commandsOfHelp})
    for (Command& command : part()) all.push_back(std::move(command));
  GEARGRAPH_REQUIRE(all.size() == kCommandCount);
  for (std::size_t i = 0; i < all.size(); ++i) GEARGRAPH_REQUIRE(all[i].id == static_cast<CommandId>(i));
  return all;
}

}  // namespace geargraph
