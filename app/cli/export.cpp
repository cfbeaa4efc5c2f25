// `export FILE --to FORM ...`: each form has a file of its own (export_forms.h), and rejects the options of
// others.

#include <array>
#include <functional>

#include "app/cli/command.h"
#include "app/cli/engagement_options.h"
#include "app/cli/export_forms.h"
#include "app/cli/mass_options.h"
#include "core/foundations/base/words.h"

namespace geargraph::cli {
namespace {

// What is written. An option names those that it means something for.
constexpr unsigned kMatrices = 1U << 0U;
constexpr unsigned kDerivation = 1U << 1U;
constexpr unsigned kDrawing = 1U << 2U;
constexpr unsigned kPicture = 1U << 3U;
constexpr unsigned kAnimation = 1U << 4U;
constexpr unsigned kSeenSolids = 1U << 5U;
constexpr unsigned kSolids = 1U << 6U;
constexpr unsigned kAssembly = 1U << 7U;
constexpr unsigned kSimulator = 1U << 8U;
constexpr unsigned kGraph = 1U << 9U;
constexpr unsigned kHandout = 1U << 10U;
constexpr unsigned kModelica = 1U << 11U;
constexpr unsigned kEverything = (1U << 12U) - 1;

constexpr std::string_view kOfMatrices = toTranslate("Matrices (--to csv)");
constexpr std::string_view kOfDerivations =
    toTranslate("Derivations (--to html, latex, md, pdf, handout or scorm)");
constexpr std::string_view kOfViews =
    toTranslate("Drawings and 3D pictures (--to svg, pdf or png --view NAME)");
constexpr std::string_view kOf3D = toTranslate("3D pictures (--to png --view 3d)");
constexpr std::string_view kOfAnimations = toTranslate("Animations (--to png --view 3d)");
constexpr std::string_view kOfSolids = toTranslate("Solids (--to stl, obj, ply, glb or 3mf)");
constexpr std::string_view kOfHandouts = toTranslate("Handouts (--to handout or scorm)");
constexpr std::string_view kOfSimulators = toTranslate("Simulators (--to mjcf or urdf)");

/// What --help, and the rejection of an option, call what is written.
constexpr std::array<std::string_view, 12> kNames = {
    "--to csv",
    toTranslate("derivations (--to html, latex, md, pdf)"),
    toTranslate("drawings (--view digraph, ttgraph, schematic)"),
    toTranslate("3D pictures (--to png --view 3d)"),
    toTranslate("animations (--turntable, --motion)"),
    "--to glb --view 3d",
    "--to stl, obj, ply, glb, 3mf",
    "--to assembly",
    "--to mjcf, urdf",
    toTranslate("graphs (--to dot, graphml, node-link)"),
    toTranslate("handouts (--to handout, scorm)"),
    "--to modelica"};

struct ExportOption {
  Option option;
  unsigned uses = 0;
};

constexpr Option grouped(Option option, std::string_view group) {
  option.group = group;
  return option;
}

constexpr std::array kExportOptions = {
    ExportOption{
        {"--to", "FORM",
         toTranslate(
             "csv: matrices; html, latex, md, pdf: the worked derivation; handout: a page for browsers, with "
             "inputs to move; scorm: that page as a package for learning platforms (SCORM 1.2); svg, png, "
             "pdf "
             "with --view: a picture; "
             "stl, obj, ply, glb, 3mf: gears; assembly: gears for a check; mjcf, urdf: a model for "
             "simulators; modelica: a model of the "
             "joints; dot, graphml, node-link: a graph")},
        kEverything},
    ExportOption{{"-o", "OUT", toTranslate("the file (\"-\" is standard output), or with --all the folder")},
                 kEverything},
    ExportOption{
        {"--all", "",
         toTranslate("every matrix, or every picture of an animation, into the folder that -o names")},
        kMatrices | kAnimation},
    ExportOption{{"--force", "", toTranslate("with a folder: overwrite files that are there")},
                 kMatrices | kAnimation | kAssembly | kSimulator},
    ExportOption{
        {"--matrix", "NAME",
         toTranslate(
             "incidence, reduced-incidence, path, spanning-tree, cycle-basis, cutset, screw, p, solution, "
             "tt-circuits, tt-cutsets; of statics: statics, cutset-equations, joint-torques, "
             "coupling-torques, "
             "mesh-forces, bearings, powers, circulations, and shift-torques of all states"),
         kOfMatrices},
        kMatrices},
    ExportOption{{"--no-labels", "", toTranslate("without the header row and the first column"), kOfMatrices},
                 kMatrices},
    ExportOption{{"--separator", "NAME", toTranslate("comma (the default), semicolon or tab"), kOfMatrices},
                 kMatrices},
    ExportOption{{"--decimal", "NAME", toTranslate("point (the default) or comma"), kOfMatrices}, kMatrices},
    ExportOption{
        {"--bom", "", toTranslate("begin with a byte order mark, for spreadsheet programs"), kOfMatrices},
        kMatrices},
    ExportOption{{"--inputs", "8,9,11",
                  toTranslate("drive these joints (by label) instead of the document's"), kOfDerivations},
                 kDerivation | kHandout},
    ExportOption{
        {"--speed", "8=1/2", toTranslate("the speed of an input in rad/s; may be repeated"), kOfDerivations},
        kDerivation | kHandout},
    ExportOption{
        {"--exercises", "",
         toTranslate(
             "with an exercise sheet that tells where an answer is wrong, and why. Saved answers are graded "
             "by exercises grade with the sheet.json of exercises make with the same options"),
         kOfHandouts},
        kHandout},
    ExportOption{
        {"--kinds", "LIST", toTranslate("kinds of questions, as for exercises make (all)"), kOfHandouts},
        kHandout},
    ExportOption{{"--seed", "N", toTranslate("the same number makes the same sheets everywhere (random)"),
                  kOfHandouts},
                 kHandout},
    ExportOption{{"--title", "TEXT", toTranslate("the heading of the sheet (\"Exercises\")"), kOfHandouts},
                 kHandout},
    ExportOption{{"--variants", "N", toTranslate("how many different sheets there are (1)"), kOfHandouts},
                 kHandout},
    ExportOption{{"--variant", "K", toTranslate("which of them this is (1)"), kOfHandouts}, kHandout},
    ExportOption{kStateOption, kEverything},
    ExportOption{kEngageOption, kEverything},
    ExportOption{
        {"--view", "NAME",
         toTranslate(
             "digraph, ttgraph or schematic; with png and glb also 3d, the train as seen; of graphs digraph "
             "or ttgraph"),
         kOfViews},
        kDrawing | kPicture | kAnimation | kSeenSolids | kGraph},
    ExportOption{
        {"--size", "WxH", toTranslate("pixels (as large as the drawing is; 3d: 1600x1000)"), kOfViews},
        kDrawing | kPicture | kAnimation},
    ExportOption{{"--dark", "", toTranslate("on a dark ground"), kOfViews}, kDrawing | kPicture | kAnimation},
    ExportOption{{"--transparent", "", toTranslate("on no ground"), kOfViews},
                 kDrawing | kPicture | kAnimation},
    ExportOption{
        {"--power", "LINK",
         toTranslate(
             "under a digraph or schematic: where the power of the loads goes, seen from \"ground\" or "
             "the link with this label"),
         kOfViews},
        kDrawing},
    ExportOption{{"--from", "NAME", toTranslate("front, back, left, right, top, bottom or iso"), kOf3D},
                 kPicture | kAnimation},
    ExportOption{
        {"--camera", "AZ,EL", toTranslate("from this azimuth and elevation, degrees (-26,20)"), kOf3D},
        kPicture | kAnimation},
    ExportOption{
        {"--time", "SECONDS", toTranslate("how far the inputs have turned (0); also with glb"), kOf3D},
        kPicture | kAnimation | kSeenSolids},
    ExportOption{
        {"--section", "AXIS:PART",
         toTranslate("section perpendicular to x, y or z at this fraction of the length (y:0.5)"), kOf3D},
        kPicture | kAnimation},
    ExportOption{
        {"--explode", "PART", toTranslate("exploded view along the axes, 0 to 1; also with glb"), kOf3D},
        kPicture | kAnimation | kSeenSolids},
    ExportOption{{"--faces", "NAME",
                  toTranslate("shaded, lines (hidden ones left out) or edges (all of them)"), kOf3D},
                 kPicture | kAnimation},
    ExportOption{
        {"--show", "NAMES",
         toTranslate("labels,joint-labels,axis-labels,scale,pitch-circles,pitch-points,axes,instant-axes,"
                     "velocities,forces,power"),
         kOf3D},
        kPicture | kAnimation},
    ExportOption{{"--hide", "LABELS", toTranslate("links that are left out: 2,5; also with glb"), kOf3D},
                 kPicture | kAnimation | kSeenSolids},
    ExportOption{{"--ride", "LABEL",
                  toTranslate("the link that the reference frame is fixed to; also with glb"), kOf3D},
                 kPicture | kAnimation | kSeenSolids},
    ExportOption{{"--turntable", "", toTranslate("once round the train, as an animated PNG (or --all)"),
                  kOfAnimations},
                 kAnimation},
    ExportOption{
        {"--motion", "", toTranslate("one period of the motion (a minute without one)"), kOfAnimations},
        kAnimation},
    ExportOption{{"--fps", "N", toTranslate("pictures a second (24)"), kOfAnimations}, kAnimation},
    ExportOption{{"--frames", "N", toTranslate("pictures (72); with assembly: poses of every gear (24)"),
                  kOfAnimations},
                 kAnimation | kAssembly},
    ExportOption{
        {"--gear", "MESH:SIDE", toTranslate("one gear in its own frame: 15:tail or 15:head"), kOfSolids},
        kSolids},
    ExportOption{{"--link", "LABEL", toTranslate("the solids of one link"), kOfSolids}, kSolids},
    ExportOption{
        {"--animate", "SECONDS",
         toTranslate(
             "with glb: how long one period plays (without: as long as it takes; of a period too long for "
             "a file, so many seconds of the motion, 60)"),
         kOfSolids},
        kSolids},
    ExportOption{
        {"--tolerance", "MODULES",
         toTranslate(
             "farthest chord from the exact form (0.002; of large trains as fine as 10 million triangles "
             "allow); also with assembly, mjcf and urdf (0.01)"),
         kOfSolids},
        kSolids | kAssembly | kSimulator},
    ExportOption{grouped(kGravityOption, kOfSimulators), kSimulator},
    ExportOption{grouped(kDensityOption, kOfSimulators), kSimulator},
    ExportOption{
        {"--motor", "NAME", toTranslate("mjcf: speed (servos with rotors, the default), torque or none"),
         kOfSimulators},
        kSimulator},
    ExportOption{
        {"--armature", "I",
         toTranslate("mjcf: inertia of the rotors, kg m² (100 times what the input feels)"), kOfSimulators},
        kSimulator},
    ExportOption{{"--timestep", "S", toTranslate("mjcf: seconds (0.001)"), kOfSimulators}, kSimulator},
};

constexpr auto kOptionsOfExport = [] {
  std::array<Option, kExportOptions.size()> options;
  for (std::size_t i = 0; i < options.size(); ++i) options[i] = kExportOptions[i].option;
  return options;
}();

/// One thing that can be written: how, its options, and the words that ask for it.
struct Exporter {
  unsigned use = 0;
  std::string words;
  std::function<int()> run;
};

/// None where there is no such form.
std::optional<Exporter> exporterOf(const Arguments& arguments, const std::string& form) {
  const std::string view = arguments.value("--view").value_or("");
  const std::string to = "--to " + form;
  const auto picture = pictureFormFromName(form);
  if (view == "3d" && (form == "glb" || picture == PictureForm::png)) {
    const bool isAnimation = arguments.has("--turntable") || arguments.has("--motion");
    const unsigned use = form == "glb" ? kSeenSolids : isAnimation ? kAnimation : kPicture;
    return Exporter{use, to + " --view 3d",
                    [&arguments, form] { return exportPicture(arguments, form == "glb"); }};
  }
  if (const auto format = meshFormatFromName(form))
    return Exporter{kSolids, to, [&arguments, format] { return exportSolids(arguments, *format); }};
  if (picture == PictureForm::pdf && view.empty())
    return Exporter{kDerivation, to, [&arguments] { return exportReportPages(arguments); }};
  if (picture) {
    return Exporter{kDrawing, to + (view.empty() ? "" : " --view " + view),
                    [&arguments, picture] { return exportDrawing(arguments, *picture); }};
  }
  if (const auto report = reportFormFromName(form))
    return Exporter{kDerivation, to, [&arguments, report] { return exportReport(arguments, *report); }};
  if (form == "handout" || form == "scorm") {
    const HandoutUse use = form == "handout" ? HandoutUse::alone : HandoutUse::learningPlatform;
    return Exporter{kHandout, to, [&arguments, use] { return exportHandout(arguments, use); }};
  }
  if (const auto graph = graphFormFromName(form))
    return Exporter{kGraph, to, [&arguments, graph] { return exportGraph(arguments, *graph); }};
  if (form == "assembly") return Exporter{kAssembly, to, [&arguments] { return exportAssembly(arguments); }};
  if (form == "mjcf" || form == "urdf") {
    const auto simulator = form == "mjcf" ? SimulatorForm::mjcf : SimulatorForm::urdf;
    return Exporter{kSimulator, to,
                    [&arguments, simulator] { return exportSimulator(arguments, simulator); }};
  }
  if (form == "modelica") return Exporter{kModelica, to, [&arguments] { return exportModelica(arguments); }};
  if (form == "csv") return Exporter{kMatrices, to, [&arguments] { return exportCsv(arguments); }};
  return std::nullopt;
}

/// The first option that means nothing for what is written, as a sentence.
std::optional<UsageError> uselessOption(const Arguments& arguments, const Exporter& exporter) {
  for (const auto& [option, uses] : kExportOptions) {
    if ((uses & exporter.use) != 0 || !arguments.has(option.name)) continue;
    std::string others;
    for (std::size_t i = 0; i < kNames.size(); ++i) {
      if ((uses >> i & 1U) != 0) others += (others.empty() ? "" : "; ") + translated(kNames[i]);
    }
    return UsageError{translated("%1 has no meaning with %2; it is an option of %3.",
                                 {option.name, exporter.words, others})};
  }
  return std::nullopt;
}

int runExport(const Arguments& arguments) {
  if (arguments.files.size() != 1) return wrongUsage(kExport, translated("One file is needed."));
  if (arguments.value("--to") == "sdf") {
    return wrongUsage(
        kExport,
        translated(
            "SDF is not written: no current Gazebo runs its gear joints. --to urdf is read by Gazebo."));
  }
  const auto exporter = exporterOf(arguments, arguments.value("--to").value_or(""));
  if (!exporter) {
    return wrongUsage(
        kExport,
        translated(
            "--to is one of csv, html, latex, md, pdf, handout, scorm, svg, png, stl, obj, ply, glb, 3mf, "
            "assembly, mjcf, urdf, modelica, dot, graphml, node-link."));
  }
  if (const auto error = uselessOption(arguments, *exporter)) return wrongUsage(kExport, error->message);
  if (!arguments.has("-o")) return wrongUsage(kExport, translated("-o says where to write."));
  return exporter->run();
}

}  // namespace

const Command kExport = {
    "export", "FILE --to FORM [...] -o OUT",
    toTranslate("Writes matrices as CSV, the worked derivation, pictures and animations, gears as "
                "3D files, models for simulators, and graphs."),
    kOptionsOfExport, runExport};

}  // namespace geargraph::cli
