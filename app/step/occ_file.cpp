#include "app/step/occ_file.h"

#include <APIHeaderSection_MakeHeader.hxx>
#include <BRep_Builder.hxx>
#include <IFSelect_WorkLibrary.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_PrinterOStream.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <STEPControl_Writer.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSControl_WorkSession.hxx>
#include <gp_Trsf.hxx>
#include <iomanip>
#include <sstream>

#include "app/step/occ_solid.h"

namespace geargraph {
namespace {

/// OpenCASCADE doubles every backslash, also those of the marks of stepText(), which has no others. A line
/// may end between the two.
std::string withSingleMarks(const std::string& bytes) {
  std::string single;
  single.reserve(bytes.size());
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    single += bytes[i];
    if (bytes[i] != '\\') continue;
    if (i + 1 < bytes.size() && bytes[i + 1] == '\n') single += bytes[++i];
    if (i + 1 < bytes.size() && bytes[i + 1] == '\\') ++i;
  }
  return single;
}

/// The text in the letters of a STEP file (ISO 10303-21): others than those of ASCII as UTF-16 between marks.
std::string stepText(const std::string& text) {
  const TCollection_ExtendedString letters(text.c_str(), Standard_True);
  std::ostringstream coded;
  coded << std::hex << std::uppercase << std::setfill('0');
  bool isMarked = false;
  for (int i = 1; i <= letters.Length(); ++i) {
    const auto letter = static_cast<unsigned>(letters.Value(i));
    const bool isPlain = letter >= 0x20 && letter < 0x7F && letter != '\\';
    if (isPlain == isMarked) coded << (isMarked ? "\\X0\\" : "\\X2\\");
    isMarked = !isPlain;
    if (isPlain) {
      coded << static_cast<char>(letter);
    } else {
      coded << std::setw(4) << letter;
    }
  }
  if (isMarked) coded << "\\X0\\";
  return std::move(coded).str();
}

void name(const TDF_Label& label, const std::string& text) {
  TDataStd_Name::Set(label, TCollection_ExtendedString(stepText(text).c_str()));
}

TopLoc_Location placeOf(const Eigen::Isometry3d& pose) {
  const auto m = [&](int row, int column) { return pose.matrix()(row, column); };
  gp_Trsf placed;
  placed.SetValues(m(0, 0), m(0, 1), m(0, 2), m(0, 3), m(1, 0), m(1, 1), m(1, 2), m(1, 3), m(2, 0), m(2, 1),
                   m(2, 2), m(2, 3));
  return TopLoc_Location(placed);
}

int solidsIn(const TopoDS_Shape& shape) {
  int count = 0;
  for (TopExp_Explorer each(shape, TopAbs_SOLID); each.More(); each.Next()) ++count;
  return count;
}

/// Text of a header in the letters that STEP has for it.
Handle(TCollection_HAsciiString) headerText(const std::string& text) {
  return new TCollection_HAsciiString(stepText(text).c_str());
}

}  // namespace

std::variant<StepFile, std::string> stepFile(const CadAssembly& assembly,
                                             const std::function<void(double)>& progress) {
  // What it says would go where the file goes.
  Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_PrinterOStream));
  StepFile file;
  Handle(TDocStd_Document) document;
  XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", document);
  const Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  const Handle(XCAFDoc_ColorTool) colours = XCAFDoc_DocumentTool::ColorTool(document->Main());

  std::vector<TDF_Label> parts;
  for (const CadPart& part : assembly.parts) {
    std::vector<TopoDS_Solid> solids;
    for (const Brep& solid : part.solids) {
      solids.push_back(occSolid(solid));
      if (!isValid(solids.back())) return part.name;
    }
    const TopoDS_Shape shape = united(solids);
    file.solids += solidsIn(shape);
    if (solids.size() > 1 && solidsIn(shape) == static_cast<int>(solids.size())) ++file.ununited;
    const TDF_Label label = shapes->AddShape(shape, Standard_False);
    name(label, part.name);
    const Quantity_Color colour(part.colour[0], part.colour[1], part.colour[2], Quantity_TOC_sRGB);
    colours->SetColor(label, colour, XCAFDoc_ColorGen);
    parts.push_back(label);
    progress(0.6 * static_cast<double>(parts.size()) / static_cast<double>(assembly.parts.size()));
  }

  // A node without a part is an assembly of its own; each of the others a component of its parent.
  const TDF_Label whole = shapes->NewShape();
  name(whole, assembly.name);
  std::vector<TDF_Label> nodes;
  for (const CadNode& node : assembly.nodes) {
    const TDF_Label parent = node.parent < 0 ? whole : nodes[static_cast<std::size_t>(node.parent)];
    TDF_Label product = node.part < 0 ? shapes->NewShape() : parts[static_cast<std::size_t>(node.part)];
    if (node.part < 0) name(product, node.name);
    nodes.push_back(product);
    name(shapes->AddComponent(parent, product, placeOf(node.pose)), node.name);
  }
  shapes->UpdateAssemblies();

  Interface_Static::SetCVal("write.step.schema", "AP214IS");
  Interface_Static::SetCVal("write.step.unit", "MM");
  Interface_Static::SetIVal("write.surfacecurve.mode",
                            0);  // curves in space only: who reads them lays them on faces
  Interface_Static::SetCVal("write.step.product.name", stepText(assembly.name).c_str());
  STEPCAFControl_Writer writer;
  writer.SetColorMode(Standard_True);
  writer.SetNameMode(Standard_True);
  writer.SetLayerMode(Standard_False);
  writer.SetPropsMode(Standard_False);
  if (!writer.Transfer(document, STEPControl_AsIs)) return assembly.name;
  progress(0.8);

  const Handle(StepData_StepModel) model = writer.ChangeWriter().Model();
  APIHeaderSection_MakeHeader header(model);
  header.SetName(headerText(assembly.name));
  header.SetAuthorValue(1, headerText({}));
  header.SetOrganizationValue(1, headerText({}));
  header.SetDescriptionValue(1, headerText(assembly.description));
  header.SetTimeStamp(headerText("1970-01-01T00:00:00"));
  header.SetOriginatingSystem(headerText(assembly.program));
  StepData_StepWriter text(model);
  text.SendModel(Handle(StepData_Protocol)::DownCast(writer.ChangeWriter().WS()->Protocol()));
  std::ostringstream stream;
  if (!text.Print(stream)) return assembly.name;
  file.bytes = withSingleMarks(std::move(stream).str());
  progress(1);
  return file;
}

}  // namespace geargraph
