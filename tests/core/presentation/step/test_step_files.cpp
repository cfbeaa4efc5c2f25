#include <BRepBndLib.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepTools.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "app/step/occ_solid.h"
#include "core/machine/body_layout/body_recipe.h"
#include "core/machine/solids/gear_body.h"
#include "core/machine/solids/gear_solid.h"
#include "core/machine/teeth/wheel_kind.h"
#include "core/presentation/brep/body_brep.h"
#include "core/presentation/brep/brep_builder.h"
#include "core/presentation/brep/wheel_brep.h"
#include "core/presentation/exporters/exporters.h"
#include "core/presentation/step/step_model.h"
#include "core/presentation/step/step_process.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/snapshot_of.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

/// A part of a file: what it is called, its colour, and its shape in its place.
struct ReadPart {
  std::string name;
  std::string group;  ///< of the link that it is in
  std::array<double, 3> colour{-1, -1, -1};
  TopoDS_Shape shape;
};

std::string nameOf(const TDF_Label& label) {
  Handle(TDataStd_Name) name;
  if (!label.FindAttribute(TDataStd_Name::GetID(), name)) return {};
  const TCollection_ExtendedString& text = name->Get();
  std::string buffer(static_cast<std::size_t>(text.LengthOfCString()) + 1, 0);
  char* start = buffer.data();
  text.ToUTF8CString(start);
  return buffer.c_str();
}

/// Every part of a file, as OpenCASCADE reads it.
class ReadFile {
 public:
  explicit ReadFile(const std::string& path) {
    XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", m_document);
    STEPCAFControl_Reader reader;
    reader.SetColorMode(true);
    reader.SetNameMode(true);
    if (reader.ReadFile(path.c_str()) != IFSelect_RetDone || !reader.Transfer(m_document)) return;
    m_shapes = XCAFDoc_DocumentTool::ShapeTool(m_document->Main());
    m_colours = XCAFDoc_DocumentTool::ColorTool(m_document->Main());
    TDF_LabelSequence free;
    m_shapes->GetFreeShapes(free);
    roots = free.Length();
    if (roots != 1) return;
    root = nameOf(free.First());
    addBelow(free.First(), TopLoc_Location(), {});
  }

  int roots = 0;
  std::string root;
  std::vector<ReadPart> parts;

 private:
  void addBelow(const TDF_Label& assembly, const TopLoc_Location& place, const std::string& group) {
    TDF_LabelSequence components;
    XCAFDoc_ShapeTool::GetComponents(assembly, components);
    for (const TDF_Label& component : components) {
      TDF_Label product;
      XCAFDoc_ShapeTool::GetReferredShape(component, product);
      const TopLoc_Location here = place * XCAFDoc_ShapeTool::GetLocation(component);
      if (XCAFDoc_ShapeTool::IsAssembly(product)) {
        addBelow(product, here, nameOf(component));
        continue;
      }
      ReadPart part{nameOf(component), group, {-1, -1, -1}, XCAFDoc_ShapeTool::GetShape(product).Moved(here)};
      Quantity_Color colour;
      if (m_colours->GetColor(product, XCAFDoc_ColorGen, colour) ||
          m_colours->GetColor(product, XCAFDoc_ColorSurf, colour))
        colour.Values(part.colour[0], part.colour[1], part.colour[2], Quantity_TOC_sRGB);
      // Of several pieces each has the colour.
      const TopExp_Explorer piece(XCAFDoc_ShapeTool::GetShape(product), TopAbs_SOLID);
      if (part.colour[0] < 0 && piece.More() &&
          m_colours->GetColor(piece.Current(), XCAFDoc_ColorSurf, colour))
        colour.Values(part.colour[0], part.colour[1], part.colour[2], Quantity_TOC_sRGB);
      parts.push_back(std::move(part));
    }
  }

  Handle(TDocStd_Document) m_document;
  Handle(XCAFDoc_ShapeTool) m_shapes;
  Handle(XCAFDoc_ColorTool) m_colours;
};

ExportResult exported(const std::string& name, const std::string& path, const OptionValues& given = {},
                      std::vector<std::string>* notes = nullptr) {
  ExportSource source;
  source.read = [name]() -> std::variant<Mechanism, ExportError> { return example(name); };
  source.stem = name;
  source.note = [notes](const ExportNote& note) {
    if (notes != nullptr) notes->push_back(note.text);
  };
  ExportContext context(std::move(source));
  return exporterWithId("step")->write(context, given, {path}, {});
}

OptionValues with(const std::string& option, const std::string& value) {
  OptionValues given;
  given.options[option] = {value};
  return given;
}

int solidsIn(const TopoDS_Shape& shape) {
  int count = 0;
  for (TopExp_Explorer each(shape, TopAbs_SOLID); each.More(); each.Next()) ++count;
  return count;
}

}  // namespace

class StepFilesTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { qputenv("GEARGRAPH_STEP_WRITER", GEARGRAPH_STEP_WRITER); }

  void examples_data() {
    QTest::addColumn<QString>("name");
    for (const char* const name :
         {"robot", "planetary-ring-held", "three-planets", "bevel-differential", "worm-hoist", "spur-pair"})
      QTest::newRow(name) << QString::fromLatin1(name);
  }
  /// Names, links, colours, places, solids that are valid, one a part, and as large as those of the 3D view.
  void examples() {
    QFETCH(QString, name);
    const QTemporaryDir folder;
    const std::string path = folder.filePath("train.step").toStdString();
    std::vector<std::string> notes;
    const ExportResult result = exported(name.toStdString(), path, {}, &notes);
    const auto* error = std::get_if<ExportError>(&result);
    QVERIFY2(error == nullptr, error != nullptr ? error->message.c_str() : "");
    const ReadFile file(path);
    QCOMPARE(file.roots, 1);
    QCOMPARE(file.root, name.toStdString());

    const SnapshotPtr snapshot = snapshotOf(example(name.toStdString()));
    const auto loaded = exportTrain(snapshot);
    const auto& train = std::get<ExportTrain>(loaded).train;
    std::map<std::string, const TrainGear*> gears;
    for (const TrainGear& gear : train.gears) gears[gear.name] = &gear;
    std::map<std::string, const LinkBody*> bodies;
    for (const LinkBody& body : train.bodies)
      bodies["body of link " + std::to_string(snapshot->mechanism->linkLabel(body.link))] = &body;
    QCOMPARE(file.parts.size(), gears.size() + bodies.size());
    std::map<std::string, std::array<double, 3>> colours;
    for (const ReadPart& part : file.parts) {
      const char* const which = part.name.c_str();
      QVERIFY2(BRepCheck_Analyzer(part.shape).IsValid(), which);
      // Of a body that is not joined: each of its pieces.
      QVERIFY2(solidsIn(part.shape) == 1 || (bodies.contains(part.name) && solidsIn(part.shape) <= 2), which);
      QVERIFY2(part.colour[0] >= 0, which);
      const auto [known, isNew] = colours.emplace(part.group, part.colour);
      QVERIFY2(isNew || known->second == part.colour, which);
      const double volume = volumeOf(part.shape);
      if (const auto gear = gears.find(part.name); gear != gears.end()) {
        const GearSpec& spec = gear->second->spec;
        const double mesh = signedVolume(gearSolid(spec, 1e-4).value());
        // The end of a bevel's tooth is a cone, and flat in the mesh.
        const double most = isConical(spec) ? 3e-3 : 1e-3;
        QVERIFY2(std::abs(volume / mesh - 1) < most,
                 (part.name + ' ' + std::to_string(volume / mesh - 1)).c_str());
        // Its place: the middle of the box is that of the mesh.
        Bnd_Box box;
        BRepBndLib::AddOptimal(part.shape, box, false, false);
        const auto solid = moved(gearSolid(spec, 0.002).value(), gear->second->pose);
        const Eigen::AlignedBox3d bounds = boundsOf(solid);
        const gp_Pnt low = box.CornerMin(), high = box.CornerMax();
        const double off =
            (Eigen::Vector3d(low.X(), low.Y(), low.Z()) - bounds.min()).cwiseAbs().maxCoeff() +
            (Eigen::Vector3d(high.X(), high.Y(), high.Z()) - bounds.max()).cwiseAbs().maxCoeff();
        QVERIFY2(off < 0.05 * toothSize(spec), (part.name + ' ' + std::to_string(off)).c_str());
      } else {
        QVERIFY2(bodies.contains(part.name), which);
        const BodyRecipe& recipe = *bodies.at(part.name)->recipe;
        const double shells = signedVolume(madeBy(recipe, 1e-4));  // overlaps are counted twice
        double largest = 0;
        for (const Brep& each : bodyBreps(recipe)) largest = std::max(largest, volumeOf(occSolid(each)));
        const std::string values = part.name + ": " + std::to_string(volume) + " of " +
                                   std::to_string(largest) + " to " + std::to_string(shells);
        QVERIFY2(volume < 1.001 * shells && volume > 0.999 * largest, values.c_str());
      }
    }
    QVERIFY(!notes.empty() && notes.back().find("0.001") != std::string::npos);
  }

  /// The parts of bodies before they are united.
  void partsOfBodiesAreThoseOfTheMesh() {
    for (const char* const name : {"robot", "planetary-ring-held", "bevel-differential", "worm-hoist"}) {
      const SnapshotPtr snapshot = snapshotOf(example(name));
      const auto loaded = exportTrain(snapshot);
      for (const LinkBody& body : std::get<ExportTrain>(loaded).train.bodies) {
        for (const BodyPart& part : *body.recipe) {
          double volume = 0;
          for (const Brep& solid : bodyBreps({part})) {
            const TopoDS_Solid made = occSolid(solid);
            QVERIFY2(isValid(made), name);
            volume += volumeOf(made);
          }
          const double mesh = signedVolume(madeBy({part}, 1e-5));
          QVERIFY2(std::abs(volume / mesh - 1) < 1e-3,
                   (std::string(name) + ' ' + std::to_string(volume / mesh - 1)).c_str());
        }
      }
    }
  }

  /// For a cone with its top in the apex, V = (sum of A h)/3: the flanks, tips and roots point to the apex
  /// and add nothing, the back cone is the cone distance away, and the front cone that less the face.
  void bevelsHaveTheVolumeOfTheirEnds() {
    GearSpec spec = standardGear(GearKind::bevel, 24, 3, 14);
    spec.coneAngle = 0.7;
    spec.bore = 12;
    const double large = coneDistance(spec), small = large - spec.faceWidth;
    // Unrolled, the back cone is plane: polar coordinates about its own apex.
    const HalfTooth tooth = toothOf(spec, 1e-7);
    const double far = std::tan(spec.coneAngle);  // of a cone distance of 1
    double half = 0;                              // area below half a tooth, measured from the cone's apex
    for (std::size_t i = 0; i + 1 < tooth.points.size(); ++i) {
      const auto reach = [&](std::size_t k) { return far + std::tan(tooth.points[k].rad - spec.coneAngle); };
      const double angle = (tooth.points[i].gam - tooth.points[i + 1].gam) * std::cos(spec.coneAngle);
      half += reach(i) * reach(i + 1) * std::sin(angle) / 2;
    }
    const std::vector<ProfileVertex> body = bodyProfile(spec);
    const auto coneArea = [&](const ProfileVertex& circle) {  // from the cone's apex to a circle of the body
      return std::numbers::pi * circle.radius * circle.radius / std::cos(spec.coneAngle);
    };
    const double back = 2 * spec.teeth * half * large * large - coneArea(body.front());
    const double front = 2 * spec.teeth * half * small * small - coneArea(body.back());
    const auto disc = [&](const ProfileVertex& circle) {
      return std::numbers::pi * (circle.radius * circle.radius - spec.bore * spec.bore / 4) * circle.height;
    };
    const double bore = std::numbers::pi * spec.bore * (body[1].height - body[2].height) * spec.bore / 2;
    const double exact = (back * large - front * small + disc(body.front()) - disc(body.back()) - bore) / 3;
    const double made = volumeOf(occSolid(wheelBrep(spec, 1e-4).solid));
    QVERIFY2(std::abs(made / exact - 1) < 1e-4, std::to_string(made / exact - 1).c_str());
  }

  void oneWheelAndOneLink() {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("part.step").toStdString();
    QVERIFY(
        std::holds_alternative<ExportOutcome>(exported("planetary-ring-held", path, with("--link", "1"))));
    const ReadFile link(path);
    QVERIFY(!link.parts.empty());
    for (const ReadPart& part : link.parts) QCOMPARE(part.group, link.parts.front().group);
    const SnapshotPtr snapshot = snapshotOf(example("planetary-ring-held"));
    const auto loaded = exportTrain(snapshot);
    const std::string name = std::get<ExportTrain>(loaded).train.gears.front().name;
    QVERIFY(
        std::holds_alternative<ExportOutcome>(exported("planetary-ring-held", path, with("--gear", name))));
    const ReadFile gear(path);
    QCOMPARE(gear.parts.size(), std::size_t{1});
    QCOMPARE(gear.parts.front().name, name);
    const auto wrong = exported("planetary-ring-held", path, with("--gear", "nowhere"));
    QCOMPARE(std::get<ExportError>(wrong).kind, ExportError::Kind::usage);
  }

  void theHeaderSaysHowNearTheTeethAre() {
    const QTemporaryDir folder;
    const QString path = folder.filePath("pair.step");
    for (const bool again : {false, true}) {
      QVERIFY(std::holds_alternative<ExportOutcome>(
          exported("spur-pair", path.toStdString(), with("--tolerance", "0.0005"))));
      QFile file(path);
      QVERIFY(file.open(QIODevice::ReadOnly));
      static QByteArray before;
      const QByteArray bytes = file.readAll();
      QVERIFY(bytes.left(2000).simplified().replace(" ", "").contains("within0.0005modules"));
      QVERIFY(!again || bytes == before);  // the same document gives the same bytes
      before = bytes;
    }
  }

  void lettersOfAllLanguagesAreKept() {
    CadAssembly assembly{"Getriebe für Ω", "text", "test", {}, {}};
    assembly.parts.push_back({"Rad ä\\ 'ç' ş", {1, 0, 0}, {revolvedBrep(tubeProfile(10, 4, 0, 5))}});
    assembly.nodes.push_back({assembly.parts.front().name, Eigen::Isometry3d::Identity(), -1, 0});
    const auto made = stepBytes(GEARGRAPH_STEP_WRITER, assembly, {}, {}, {});
    QVERIFY(std::holds_alternative<StepBytes>(made));
    const QTemporaryDir folder;
    QFile file(folder.filePath("letters.step"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(std::get<StepBytes>(made).bytes.c_str());
    file.close();
    for (const char letter : std::get<StepBytes>(made).bytes)
      QVERIFY(static_cast<unsigned char>(letter) < 0x7F);
    const ReadFile read(file.fileName().toStdString());
    QCOMPARE(read.root, assembly.name);
    QCOMPARE(read.parts.front().name, assembly.parts.front().name);
    QVERIFY(std::abs(volumeOf(read.parts.front().shape)) > 1);
  }

  void aWriterThatFailsLeavesNothing() {
    const QTemporaryDir folder;
    const QString path = folder.filePath("none.step");
    const auto codeWith = [&](const char* writer) {
      qputenv("GEARGRAPH_STEP_WRITER", writer);
      const ExportResult result = exported("spur-pair", path.toStdString());
      qputenv("GEARGRAPH_STEP_WRITER", GEARGRAPH_STEP_WRITER);
      const auto* error = std::get_if<ExportError>(&result);
      return error == nullptr || error->message.empty() ? std::string() : std::string(error->code);
    };
    QCOMPARE(codeWith(STEP_CRASHER), "step-failed");
    QCOMPARE(codeWith("/bin/false"), "step-failed");
    QCOMPARE(codeWith("/nowhere/geargraph-step"), "no-step");
    QCOMPARE(codeWith(""), "no-step");
    QVERIFY(!QFile::exists(path));
  }

  void limitsAndStopsAreKept() {
    CadAssembly assembly{"name", "text", "test", {}, {}};
    assembly.parts.push_back({"tube", {1, 0, 0}, {revolvedBrep(tubeProfile(10, 4, 0, 5))}});
    assembly.nodes.push_back({"tube", Eigen::Isometry3d::Identity(), -1, 0});
    const auto kindOf = [&](const StepLimits& limits, const std::stop_token& stop) {
      const auto made = stepBytes(GEARGRAPH_STEP_WRITER, assembly, limits, {}, stop);
      const auto* error = std::get_if<StepProcessError>(&made);
      return error == nullptr                                 ? std::string("written")
             : error->kind == StepProcessError::Kind::limit   ? std::string("limit")
             : error->kind == StepProcessError::Kind::stopped ? std::string("stopped")
                                                              : std::string("failed");
    };
    QCOMPARE(kindOf({}, {}), "written");
    QCOMPARE(kindOf({1000, std::size_t{6} << 30U, 100}, {}), "limit");  // bytes
    QCOMPARE(kindOf({std::size_t{1} << 30U, std::size_t{6} << 30U, -1}, {}), "limit");
    std::stop_source source;
    source.request_stop();
    QCOMPARE(kindOf({}, source.get_token()), "stopped");
    double last = 0;
    const auto made =
        stepBytes(GEARGRAPH_STEP_WRITER, assembly, {}, [&last](double done) { last = done; }, {});
    QVERIFY(std::holds_alternative<StepBytes>(made));
    QCOMPARE(last, 1.0);
    // An open solid is no solid: the writer says so, and does not try.
    assembly.parts[0].solids[0].faces.pop_back();
    QCOMPARE(kindOf({}, {}), "failed");
  }
};

QTEST_GUILESS_MAIN(StepFilesTest)
#include "test_step_files.moc"
