#include "core/mechanism/model/shapes.h"

#include <algorithm>
#include <cctype>

#include "core/foundations/base/translation.h"
#include "core/mechanism/model/rejections.h"

namespace geargraph {
namespace {

Diagnostic shapeRejection(Code code, std::string message, LinkId link) {
  return {code, std::move(message), {link}, {}, 0, 0};
}

}  // namespace

Expected<Mechanism> withShapes(Mechanism mechanism, LinkId link, std::vector<LinkShape> shapes) {
  const auto found = std::find_if(mechanism.links.begin(), mechanism.links.end(),
                                  [&](const Link& each) { return each.id == link; });
  if (found == mechanism.links.end()) return unknownElement(link);
  for (const LinkShape& shape : shapes) {
    if (!staysInFolder(shape.file)) {
      return shapeRejection(
          Code::schema,
          translated("\"%1\" is not in the folder of the document: save the document first, then copy the 3D "
                     "file into its folder.",
                     {shape.file}),
          link);
    }
    if (shape.scale && shape.scale->exact().sign() <= 0)
      return shapeRejection(Code::schema, translated("The scale of a 3D file has to be above 0."), link);
  }
  found->shapes = std::move(shapes);
  return mechanism;
}

Diagnostics shapeDiagnostics(const Mechanism& mechanism) {
  std::vector<ElementId> dressed;
  for (const Link& link : mechanism.links) {
    if (!link.shapes.empty()) dressed.emplace_back(link.id);
  }
  if (dressed.empty()) return {};
  return {{Code::shownOnly,
           translated("3D files of links are shown only: they have no mass, and overlaps and collisions with "
                      "them are not looked for."),
           std::move(dressed),
           {}}};
}

bool staysInFolder(std::string_view path) {
  if (path.empty() || path.front() == '/' || path.front() == '\\') return false;
  if (path.size() >= 2 && path[1] == ':' && std::isalpha(static_cast<unsigned char>(path[0])) != 0)
    return false;
  int depth = 0;  // folders below the first
  while (!path.empty()) {
    const std::size_t end = std::min(path.find_first_of("/\\"), path.size());
    const std::string_view step = path.substr(0, end);
    if (step == "..") {
      if (--depth < 0) return false;
    } else if (!step.empty() && step != ".") {
      ++depth;
    }
    path.remove_prefix(std::min(end + 1, path.size()));
  }
  return true;
}

}  // namespace geargraph
