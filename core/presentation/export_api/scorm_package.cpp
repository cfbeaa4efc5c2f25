#include "core/presentation/export_api/scorm_package.h"

#include "core/foundations/base/text_lists.h"
#include "core/presentation/meshfile/zip_archive.h"

namespace geargraph {
namespace {

constexpr const char* kPage = "index.html";

/// [ADL, SCORM 1.2 Content Aggregation Model, 2.3]
std::string manifest(const std::string& title) {
  const std::string name = escapedXml(title);
  return R"(<?xml version="1.0" encoding="UTF-8"?>
<manifest identifier="geargraph-handout" version="1.0"
    xmlns="http://www.imsproject.org/xsd/imscp_rootv1p1p2" xmlns:adlcp="http://www.adlnet.org/xsd/adlcp_rootv1p2">
  <metadata>
    <schema>ADL SCORM</schema>
    <schemaversion>1.2</schemaversion>
  </metadata>
  <organizations default="handout">
    <organization identifier="handout">
      <title>)" +
         name + R"(</title>
      <item identifier="page" identifierref="resource">
        <title>)" +
         name + R"(</title>
      </item>
    </organization>
  </organizations>
  <resources>
    <resource identifier="resource" type="webcontent" adlcp:scormtype="sco" href=")" +
         kPage + R"(">
      <file href=")" +
         kPage + R"("/>
    </resource>
  </resources>
</manifest>
)";
}

}  // namespace

std::string scormPackage(const std::string& title, std::string_view page) {
  ZipArchive archive;
  archive.beginEntry("imsmanifest.xml");
  archive.write(manifest(title));
  archive.endEntry();
  archive.beginEntry(kPage);
  archive.write(page);
  archive.endEntry();
  return archive.finish();
}

}  // namespace geargraph
