#include "ui/search/synonyms.h"

#include <QHash>

#include "ui/search/word_match.h"

namespace geargraph::inline search {
namespace {

struct Words {
  const char* command;
  const char* words;
};

constexpr Words kWords[] = {
    {"dock.gearbox", "brake clutch hold engage release state shift gearbox transmission gear ratio"},
    {"dock.inputs",
     "speed velocity rpm ratio transmission reduction result solution motor drive input output relative "
     "absolute"},
    {"dock.matrices", "matrix table incidence path cycle"},
    {"dock.problems", "error warning hint fix diagnostics mistake wrong message"},
    {"dock.properties", "teeth tooth count module axis name edit value"},
    {"dock.speeds", "plot graph chart curve diagram time"},
    {"dock.view3d", "3d model solid picture view render"},
    {"dock.derivation", "proof steps explanation equations report"},
    {"dock.forces",
     "torque force load moment power flow efficiency losses statics bearing reaction self-locking"},
    {"dock.dynamics",
     "mass inertia weight density gravity acceleration simulation dynamic energy equation of motion motor "
     "torque"},
    {"mechanism.drive", "motor input speed actuator engine crank"},
    {"mechanism.ground", "fix frame housing base fixed"},
    {"mechanism.hold", "fix stop block lock band engage held ring"},
    {"mechanism.load", "force moment couple weight newton nm"},
    {"mechanism.releaseAll", "disengage free unlock open let go"},
    {"mechanism.flip", "reverse arrow direction orientation"},
    {"mechanism.attachGear", "wheel tooth teeth pinion add cog"},
    {"mechanism.insertSet", "planetary epicyclic differential sun ring carrier reverted wizard template"},
    {"mechanism.tidy", "layout arrange clean up align"},
    {"file.exportCsv", "table spreadsheet excel matlab numpy save matrix"},
    {"file.exportPicture", "image png svg pdf glb film video animation 3d save drawing"},
    {"file.exportHandout", "html web page share students website publish offline"},
    {"file.saveAs", "rename store write folder"},
    {"file.revert", "reload discard restore"},
    {"file.open", "load import file document"},
    {"file.newWindow", "second another beside"},
    {"file.startPage", "examples samples recent welcome"},
    {"file.print", "printer paper page preview pdf hardcopy"},
    {"edit.history", "undo redo steps list back versions"},
    {"edit.delete", "remove erase drop"},
    {"edit.duplicate", "clone copy again twin"},
    {"edit.rename", "name label title"},
    {"edit.copyPicture", "image png svg clipboard screenshot"},
    {"learn.derivation", "proof steps explanation equations"},
    {"learn.lessons", "course tutorial teach learn lecture practise training"},
    {"learn.exercises", "practise quiz questions homework sheet exam test class handout scorm students"},
    {"learn.check", "grade verify homework paper solution correct matrix equation compare mine"},
    {"learn.compare", "difference advantage versus similar both methods matroid t-t graph"},
    {"learn.lookUp", "glossary definition dictionary meaning"},
    {"help.manual", "documentation guide instructions f1 how"},
    {"help.tour", "introduction beginner start overview"},
    {"help.about", "version licence license authors"},
    {"help.shortcuts", "keys hotkeys keyboard"},
    {"motion.play", "animate simulate run move turn start"},
    {"motion.backwards", "reverse rewind"},
    {"motion.start", "rewind reset home"},
    {"motion.faster", "accelerate quicker"},
    {"motion.slower", "slow brake down"},
    {"tool.note", "text comment label annotation write remark caption sticky post-it"},
    {"view.presentation", "full screen beamer projector lecture large"},
    {"view.dark", "night mode theme colour color"},
    {"view.light", "day mode theme colour color"},
    {"view.highContrast", "accessibility theme colour color"},
    {"view.asSystem", "theme automatic desktop colour color"},
    {"view.half3d", "wide large split solid gears"},
    {"view.fit", "zoom all show everything centre center"},
    {"view.grid", "snap raster align"},
    {"view.powerFlow", "watt power energy circulating losses bands"},
    {"view.typeSize150", "font larger bigger text letters size accessibility"},
    {"view.reset", "panels docks default windows"},
};

QHash<QString, QString> foldedWords() {
  QHash<QString, QString> folded;
  for (const Words& each : kWords)
    folded.insert(QLatin1String(each.command), foldedText(QLatin1String(each.words)));
  return folded;
}

}  // namespace

QString synonymsFor(const QString& command) {
  static const QHash<QString, QString> kFolded = foldedWords();
  return kFolded.value(command);
}

}  // namespace geargraph::inline search
