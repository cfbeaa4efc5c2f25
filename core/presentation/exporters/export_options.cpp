// The options of `geargraph-cli export`, in the order of its help.

#include <algorithm>
#include <array>

#include "core/foundations/base/text_lists.h"
#include "core/presentation/exporters/engagement_options.h"
#include "core/presentation/exporters/exporters.h"
#include "core/presentation/exporters/mass_options.h"
#include "core/teaching/derivation/named_results.h"

namespace geargraph {
namespace {

// Headings in the help; the words that ask for the exporters follow, of these with what they have in common.
constexpr std::string_view kOfMatrices = toTranslate("Matrices");
constexpr std::string_view kOfDerivations = toTranslate("Derivations");
constexpr std::string_view kOfHandouts = toTranslate("Handouts");
constexpr std::string_view kOfSolids = toTranslate("Solids");
constexpr std::string_view kOfKits = toTranslate("Print kits");
constexpr std::string_view kOfSimulators = toTranslate("Simulators");
constexpr std::string_view kOfControllers = toTranslate("Controllers");
constexpr std::string_view kOfViews =
    toTranslate("Drawings and 3D pictures (--to svg, pdf or png --view NAME)");
constexpr std::string_view kOf3D = toTranslate("3D pictures (--to png --view 3d)");
constexpr std::string_view kOfAnimations = toTranslate("Animations (--to png --view 3d)");

bool listsOption(const Exporter& exporter, std::string_view name) {
  for (const ExportOption& option : exporter.options) {
    if (option.name == name) return true;
  }
  return false;
}

bool needsView(const Exporter& exporter) {
  for (const ExportOption& option : exporter.options) {
    if (option.name == "--view" && option.isNeeded) return true;
  }
  return false;
}

/// "csv: matrices; html, latex, md, pdf: the worked derivation; ...".
std::string helpOfForms() {
  std::string text, names;
  bool isViewed = false;
  const std::span<const Exporter* const> all = allExporters();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Exporter& exporter = *all[i];
    if (exporter.implied.empty()) {
      names += (names.empty() ? "" : ", ") + std::string(exporter.form);
      isViewed = needsView(exporter);
    }
    if (names.empty() || (i + 1 < all.size() && all[i + 1]->what == exporter.what)) continue;
    text += (text.empty() ? "" : "; ") + (isViewed ? translated("%1 with --view", {names}) : names) + ": " +
            translated(exporter.what);
    names.clear();
  }
  return text;
}

/// The group and the forms of the exporters that take its first option: "Solids (--to stl, obj, ply, glb or
/// 3mf)".
std::string headingOfGroup(std::string_view group) {
  const auto texts = exportOptionTexts();
  std::string_view first;
  for (const OptionText& text : texts) {
    if (text.group == group && first.empty()) first = text.name;
  }
  std::vector<std::string> forms;
  for (const Exporter* exporter : allExporters()) {
    const bool isNew = std::find(forms.begin(), forms.end(), exporter->form) == forms.end();
    if (isNew && listsOption(*exporter, first)) forms.emplace_back(exporter->form);
  }
  return translated(group) + " (--to " + listed(forms, kAllNames, toTranslate("or")) + ')';
}

constexpr OptionText composed(OptionText option, std::string_view group) {
  option.group = group;
  option.composedHeading = headingOfGroup;
  return option;
}

struct Row {
  OptionText text;
  std::string_view title = {};
};

constexpr std::array kRows = {
    Row{{"--to", "FORM", {}, {}, helpOfForms}},
    Row{{"-o", "OUT", toTranslate("the file (\"-\" is standard output), or with --all the folder")}},
    Row{{"--all", "",
         toTranslate("every matrix, or every picture of an animation, into the folder that -o names")}},
    Row{{"--force", "", toTranslate("with a folder: overwrite files that are there")}},
    Row{composed(
            {"--matrix", "NAME",
             toTranslate("incidence, reduced-incidence, path, spanning-tree, cycle-basis, cutset, screw, p, "
                         "solution, "
                         "tt-circuits, tt-cutsets; of statics: statics, cutset-equations, joint-torques, "
                         "coupling-torques, "
                         "mesh-forces, bearings, powers, circulations, and shift-torques of all states")},
            kOfMatrices),
        toTranslate("Table")},
    Row{composed({"--no-labels", "", toTranslate("without the header row and the first column")},
                 kOfMatrices),
        toTranslate("Without labels")},
    Row{composed({"--separator", "NAME", toTranslate("comma (the default), semicolon or tab")}, kOfMatrices),
        toTranslate("Columns parted by")},
    Row{composed({"--decimal", "NAME", toTranslate("point (the default) or comma")}, kOfMatrices),
        toTranslate("Decimal sign")},
    Row{composed({"--bom", "", toTranslate("begin with a byte order mark, for spreadsheet programs")},
                 kOfMatrices),
        toTranslate("Byte order mark")},
    Row{composed(
            {"--inputs", "8,9,11", toTranslate("drive these joints (by label) instead of the document's")},
            kOfDerivations),
        toTranslate("Inputs")},
    Row{composed({"--speed", "8=1/2", toTranslate("the speed of an input in rad/s; may be repeated")},
                 kOfDerivations),
        toTranslate("Speeds")},
    Row{composed(
            {"--exercises", "",
             toTranslate("with an exercise sheet that tells where an answer is wrong, and why. Saved answers "
                         "are graded "
                         "by exercises grade with the sheet.json of exercises make with the same options")},
            kOfHandouts),
        toTranslate("With exercises")},
    Row{composed({"--kinds", "LIST", toTranslate("kinds of questions, as for exercises make (all)")},
                 kOfHandouts),
        toTranslate("Kinds of questions")},
    Row{composed({"--seed", "N", toTranslate("the same number makes the same sheets everywhere (random)")},
                 kOfHandouts),
        toTranslate("Seed")},
    Row{composed({"--title", "TEXT", toTranslate("the heading of the sheet (\"Exercises\")")}, kOfHandouts),
        toTranslate("Title")},
    Row{composed({"--variants", "N", toTranslate("how many different sheets there are (1)")}, kOfHandouts),
        toTranslate("Variants")},
    Row{composed({"--variant", "K", toTranslate("which of them this is (1)")}, kOfHandouts),
        toTranslate("This variant")},
    Row{kStateOption},
    Row{kEngageOption},
    Row{{"--view", "NAME",
         toTranslate(
             "digraph, ttgraph or schematic; with png and glb also 3d, the train as seen; of graphs digraph "
             "or ttgraph"),
         kOfViews},
        toTranslate("View")},
    Row{{"--size", "WxH", toTranslate("pixels (as large as the drawing is; 3d: 1600x1000)"), kOfViews},
        toTranslate("Size")},
    Row{{"--dark", "", toTranslate("on a dark ground"), kOfViews}, toTranslate("Light on dark")},
    Row{{"--transparent", "", toTranslate("on no ground"), kOfViews}, toTranslate("Transparent background")},
    Row{{"--captions", "",
         toTranslate(
             "names of links and tooth counts in a digraph, T–T graph or schematic, where there is room"),
         kOfViews},
        toTranslate("Names and teeth")},
    Row{{"--power", "LINK",
         toTranslate(
             "under a digraph or schematic: where the power of the loads goes, seen from \"ground\" or "
             "the link with this label"),
         kOfViews},
        toTranslate("Power seen from")},
    Row{{"--from", "NAME", toTranslate("front, back, left, right, top, bottom or iso"), kOf3D},
        toTranslate("Seen from")},
    Row{{"--camera", "AZ,EL", toTranslate("from this azimuth and elevation, degrees (-26,20)"), kOf3D},
        toTranslate("Camera")},
    Row{{"--time", "SECONDS", toTranslate("how far the inputs have turned (0); also with glb"), kOf3D},
        toTranslate("Time")},
    Row{{"--section", "AXIS:PART",
         toTranslate("section perpendicular to x, y or z at this fraction of the length (y:0.5)"), kOf3D},
        toTranslate("Section")},
    Row{{"--explode", "PART", toTranslate("exploded view along the axes, 0 to 1; also with glb"), kOf3D},
        toTranslate("Exploded view")},
    Row{{"--faces", "NAME", toTranslate("shaded, lines (hidden ones left out) or edges (all of them)"),
         kOf3D},
        toTranslate("Faces")},
    Row{{"--show", "NAMES",
         toTranslate("labels,joint-labels,axis-labels,scale,pitch-circles,pitch-points,axes,instant-axes,"
                     "velocities,forces,power"),
         kOf3D},
        toTranslate("Shown")},
    Row{{"--hide", "LABELS", toTranslate("links that are left out: 2,5; also with glb"), kOf3D},
        toTranslate("Hidden links")},
    Row{{"--ride", "LABEL", toTranslate("the link that the reference frame is fixed to; also with glb"),
         kOf3D},
        toTranslate("Reference frame fixed to")},
    Row{{"--turntable", "", toTranslate("once round the train, as an animated PNG (or --all)"),
         kOfAnimations}},
    Row{{"--motion", "", toTranslate("one period of the motion (a minute without one)"), kOfAnimations}},
    Row{{"--fps", "N", toTranslate("pictures a second (24)"), kOfAnimations},
        toTranslate("Pictures a second")},
    Row{{"--frames", "N", toTranslate("pictures (72); with assembly: poses of every gear (24)"),
         kOfAnimations},
        toTranslate("Pictures")},
    Row{composed({"--gear", "MESH:SIDE", toTranslate("one gear in its own frame: 15:tail or 15:head")},
                 kOfSolids),
        toTranslate("Only the gear")},
    Row{composed({"--link", "LABEL", toTranslate("the solids of one link")}, kOfSolids),
        toTranslate("Only the link")},
    Row{composed({"--animate", "SECONDS",
                  toTranslate("with glb: how long one period plays (without: as long as it takes; of a "
                              "period too long for "
                              "a file, so many seconds of the motion, 60)")},
                 kOfSolids),
        toTranslate("A period plays")},
    Row{composed(
            {"--tolerance", "MODULES",
             toTranslate(
                 "farthest chord from the exact form (0.002; of large trains as fine as 10 million triangles "
                 "allow); also with assembly, step (farthest surface of a tooth, 0.001), mjcf and urdf "
                 "(0.01)")},
            kOfSolids),
        toTranslate("Tolerance")},
    Row{composed({"--bed", "WxD", toTranslate("the plate of the printer, mm (220x220)")}, kOfKits),
        toTranslate("Plate of the printer")},
    Row{composed({"--play", "MM", toTranslate("play on either flank of a tooth, mm (0.15)")}, kOfKits),
        toTranslate("Play of the teeth")},
    Row{composed({"--clearance", "MM", toTranslate("by which bores are wider than their shafts, mm (0.2)")},
                 kOfKits),
        toTranslate("Clearance of bores")},
    Row{composed({"--chamfer", "MM",
                  toTranslate("by which the lowest layers are narrower, against their spread, mm (0.4)")},
                 kOfKits),
        toTranslate("Chamfer of first layers")},
    Row{composed({"--scale", "FACTOR", toTranslate("by which all lengths are multiplied (1)")}, kOfKits),
        toTranslate("Scale")},
    Row{composed(kGravityOption, kOfSimulators), toTranslate("Gravity")},
    Row{composed(kDensityOption, kOfSimulators), toTranslate("Density")},
    Row{composed(
            {"--motor", "NAME", toTranslate("mjcf: speed (servos with rotors, the default), torque or none")},
            kOfSimulators),
        toTranslate("Motors")},
    Row{composed({"--armature", "I",
                  toTranslate("mjcf: inertia of the rotors, kg m² (100 times what the input feels)")},
                 kOfSimulators),
        toTranslate("Inertia of the rotors")},
    Row{composed({"--timestep", "S", toTranslate("mjcf: seconds (0.001)")}, kOfSimulators),
        toTranslate("Time step")},
    Row{composed({"--outputs", "10,12,14",
                  toTranslate("the joints that the motors drive, by label, as many as motors (the chain from "
                              "the ground to a link that they determine)")},
                 kOfControllers),
        toTranslate("Joints")},
    Row{composed({"--as", "NAME",
                  toTranslate("json (the default), header (C++17), python, or ros2 (transmissions of "
                              "ros2_control); each of header and python tests itself")},
                 kOfControllers),
        toTranslate("Written as")},
};

constexpr auto kTexts = [] {
  std::array<OptionText, kRows.size()> texts;
  for (std::size_t i = 0; i < kRows.size(); ++i) texts[i] = kRows[i].text;
  return texts;
}();

}  // namespace

std::span<const OptionText> exportOptionTexts() {
  return kTexts;
}

std::string exportChoiceTitle(std::string_view option, std::string_view choice) {
  struct Title {
    std::string_view choice;
    const char* title;
  };
  static constexpr std::array kTitles = {
      Title{"comma", toTranslate("Comma")},
      Title{"semicolon", toTranslate("Semicolon")},
      Title{"tab", toTranslate("Tab")},
      Title{"point", toTranslate("Point")},
      Title{"speed", toTranslate("Given speeds")},
      Title{"torque", toTranslate("Given torques")},
      Title{"none", toTranslate("No motors")},
      Title{"front", toTranslate("From the front")},
      Title{"back", toTranslate("From behind")},
      Title{"left", toTranslate("From the left")},
      Title{"right", toTranslate("From the right")},
      Title{"top", toTranslate("From above")},
      Title{"bottom", toTranslate("From below")},
      Title{"iso", toTranslate("Isometric")},
      Title{"shaded", toTranslate("Shaded")},
      Title{"lines", toTranslate("Lines in sight")},
      Title{"edges", toTranslate("All edges")},
      Title{"digraph", toTranslate("Digraph")},
      Title{"ttgraph", toTranslate("T–T graph")},
      Title{"schematic", toTranslate("Schematic")},
      Title{"levers", toTranslate("Levers")},
      Title{"nomogram", toTranslate("Nomogram")},
      Title{"plan", toTranslate("Plane of points")},
      Title{"kutzbach", toTranslate("Speed plan")},
      Title{"spectrum", toTranslate("Spectrum")},
      Title{"motors", toTranslate("Range of two motors")},
  };
  if (option == "--matrix") {
    const NamedResult* const result = resultNamed(choice);
    return result != nullptr ? translated(result->title) : std::string();
  }
  for (const Title& each : kTitles) {
    if (each.choice == choice) return translated(each.title);
  }
  return {};
}

std::string exportOptionTitle(std::string_view name) {
  for (const Row& row : kRows) {
    if (row.text.name == name) return translated(row.title);
  }
  return std::string(name);
}

}  // namespace geargraph
