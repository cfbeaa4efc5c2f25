#pragma once

#include <QKeySequence>
#include <QList>
#include <QString>
#include <vector>

namespace geargraph {

/// The commands of a window. Tools, numbers of planets, sizes of type, languages, panels and examples are
/// commands of their own kinds, made from their own lists.
enum class CommandId {
  newDocument,
  newWindow,
  startPage,
  open,
  save,
  saveAs,
  revert,
  restoreSession,
  exportAny,  ///< in a format of core's registry
  exportMatrix,
  exportPicture,
  exportDerivation,
  exportHandout,
  print,
  close,
  quit,
  undo,
  redo,
  history,
  cut,
  copy,
  copyPicture,
  paste,
  duplicate,
  remove,
  rename,
  selectAll,
  flip,
  makeGround,
  attachGear,
  weld,
  split,
  drive,
  hold,
  load,
  releaseAll,
  insertSet,
  findTeeth,
  atlas,
  designGearbox,
  hardware,
  tidy,
  fit,
  zoomIn,
  zoomOut,
  fitSelected,
  asSystem,
  light,
  dark,
  highContrast,
  half3d,
  projector,
  presentation,
  grid,
  captions,
  powerFlow,
  resetLayout,
  play,
  toStart,
  faster,
  slower,
  normalSpeed,
  backwards,
  lessons,
  lessonFile,
  lessonPages,
  exercises,
  checkPaper,
  handoutNow,
  showDerivation,
  compareMethods,
  lookUp,
  search,
  manual,
  whatsThis,
  tour,
  shortcuts,
  about,
};
constexpr std::size_t kCommandCount = static_cast<std::size_t>(CommandId::about) + 1;

/// What decides which commands are possible, as it is now.
struct CommandState {
  bool canUndo = false;
  bool canRedo = false;
  int links = 0;  ///< selected ones
  int joints = 0;
  int meshes = 0;
  int notes = 0;
  int selected = 0;  ///< elements of every kind
  bool isGroundSelected = false;
  bool hasLinks = false;    ///< besides the ground
  bool isEngaged = false;   ///< a brake or a clutch is
  bool hasSiblings = true;  ///< the window is one of several that the program may open
  bool restoresSession = false;
  bool isTransient = false;  ///< the document belongs to a lesson, and is never saved
  bool hasFile = false;
  bool isModified = false;
  bool hasMatrix = false;      ///< the chosen matrix is there
  bool isQuantity = false;     ///< it is a table of quantities, not of whole numbers
  bool areAnswersOpen = true;  ///< no step of a lesson asks for what a view shows
  bool isMeasured = false;     ///< a measured value is shown, which Copy copies
  QString whyNoLoad = {};      ///< why the selection takes no load; empty: it does
  QString whyNoGear = {};      ///< why no gear can be attached to the one selected link
  QString whyNoWeld = {};      ///< why the selected links cannot be welded
  QString whyNoSplit = {};     ///< why the selected link cannot be split
  QString whyNoDerivation = {};
  QString whyNoPowerFlow = {};

  [[nodiscard]] int arrows() const { return joints + meshes; }
  [[nodiscard]] bool isOnlyGround() const { return selected == 1 && isGroundSelected; }
  [[nodiscard]] bool isOneLink() const { return links == 1 && arrows() == 0; }
};

/// All that menus, tool bar, search, sheet of keys and tests have to know of a command. What it does is
/// connected in MainWindow::wireActions(), wireFiles() and wireMotion(). Texts are in the language in use.
struct Command {
  CommandId id = {};
  const char* name = "";  ///< "edit.undo": of its action; never changed, never translated
  QString text = {};      ///< of its menu entry
  QString tip = {};       ///< what it does, without its key
  QList<QKeySequence> keys = {};
  const char* icon = "";         ///< a file of resources/icons; empty: none
  const char* searchWords = "";  ///< by which the search finds it besides its text, in English
  bool isCheckable = false;
  /// Why it is not possible, as a sentence; empty: it is. Null: it always is.
  QString (*whyNot)(const CommandState& now) = nullptr;
};

/// One row for each CommandId, in their order.
[[nodiscard]] std::vector<Command> commandTable();

}  // namespace geargraph
