#pragma once

#include <QMetaType>
#include <QTest>
#include <string>

#include "core/presentation/meshfile/mesh_writer.h"

Q_DECLARE_METATYPE(geargraph::MeshFormat)

namespace geargraph::test {

/// A row of the test's data for each format.
inline void addFormats() {
  QTest::addColumn<MeshFormat>("format");
  for (const MeshFormat format : allMeshFormats()) {
    QTest::newRow(std::string(meshFormatName(format)).c_str()) << format;
  }
}

}  // namespace geargraph::test
