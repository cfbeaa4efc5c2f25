#include "core/presentation/result_json/torque_matrix_json.h"

#include <functional>

namespace geargraph {
namespace {

using Layout = JsonWriter::Layout;

void writeLabels(JsonWriter& json, const char* name, std::span<const int> joints,
                 const Mechanism& mechanism) {
  json.key(name);
  json.beginArray(Layout::row);
  for (const int joint : joints) json.number(static_cast<std::int64_t>(mechanism.jointLabel(joint)));
  json.endArray();
}

}  // namespace

void writeTorqueMatrixJson(JsonWriter& json, const Mechanism& mechanism, std::span<const int> balancedJoints,
                           const TorqueMatrix& matrix, const std::optional<SymbolicStatics>& symbolic) {
  const auto rows = [&](const char* name, const std::function<void(std::size_t)>& writeEntry) {
    json.key(name);
    json.beginArray();
    for (std::size_t row = 0; row < balancedJoints.size(); ++row) {
      json.beginArray(Layout::row);
      for (std::size_t column = 0; column < matrix.loaded.size(); ++column)
        writeEntry(row * matrix.loaded.size() + column);
      json.endArray();
    }
    json.endArray();
  };
  json.beginObject();
  writeLabels(json, "balanced", balancedJoints, mechanism);
  writeLabels(json, "loaded", matrix.loaded, mechanism);
  rows("exact", [&](std::size_t at) { json.string(matrix.entries[at].toString()); });
  if (symbolic) {
    rows("symbolic", [&](std::size_t at) {
      const auto& entry = symbolic->matrix[at];
      entry ? json.string(entry->toText()) : json.null();
    });
  } else {
    json.key("symbolic");
    json.null();
  }
  json.endObject();
}

}  // namespace geargraph
