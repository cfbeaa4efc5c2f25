#include "core/mechanism/document_format/shape_files.h"

#include <fstream>
#include <set>

#include "core/foundations/base/translation.h"
#include "core/mechanism/model/element_pointer.h"

namespace geargraph {

Diagnostics missingFileDiagnostics(const Mechanism& mechanism, const std::filesystem::path& folder) {
  Diagnostics missing;
  for (std::size_t i = 0; i < mechanism.links.size(); ++i) {
    const Link& link = mechanism.links[i];
    std::set<std::string> seen;
    for (std::size_t k = 0; k < link.shapes.size(); ++k) {
      const std::string& file = link.shapes[k].file;
      if (!seen.insert(file).second) continue;
      const std::filesystem::path path = folder / file;
      std::error_code failure;
      const bool isThere = std::filesystem::is_regular_file(path, failure);
      if (isThere && std::ifstream(path, std::ios::binary).is_open()) continue;
      const std::string pointer = pointerTo(ElementKind::link, i) + "/shapes/" + std::to_string(k) + "/file";
      missing.push_back(
          {Code::missingFile,
           isThere ? translated("Link \"%1\" names the 3D file \"%2\", which cannot be read.",
                                {link.id.text(), file})
                   : translated(
                         "Link \"%1\" names the 3D file \"%2\", which is not there: the path begins at the "
                         "folder of the document.",
                         {link.id.text(), file}),
           {link.id},
           pointer});
    }
  }
  return missing;
}

}  // namespace geargraph
