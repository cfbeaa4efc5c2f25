#include "app/cli/atlas_output.h"

#include <algorithm>

#include "core/foundations/base/translation.h"

namespace geargraph::cli {

void writeChainMembers(JsonWriter& json, const Chain& chain) {
  json.key("axes");
  json.beginArray(JsonWriter::Layout::row);
  for (const std::vector<int>& axis : chain.axes) {
    json.beginArray(JsonWriter::Layout::row);
    for (const int link : axis) json.number(static_cast<std::int64_t>(link) + 1);
    json.endArray();
  }
  json.endArray();
  json.key("meshes");
  json.beginArray(JsonWriter::Layout::row);
  for (const ChainMesh& mesh : chain.meshes) {
    json.beginArray(JsonWriter::Layout::row);
    for (const int link : {mesh.tail, mesh.head, mesh.carrier})
      json.number(static_cast<std::int64_t>(link) + 1);
    json.endArray();
  }
  json.endArray();
}

void writeRelatives(JsonWriter& json, const ChainRelatives& relatives) {
  json.beginObject(JsonWriter::Layout::row);
  for (const auto& [name, numbers] : {std::pair("sameEquations", &relatives.sameEquations),
                                      {"oneMeshLess", &relatives.oneMeshLess},
                                      {"oneMeshMore", &relatives.oneMeshMore}}) {
    json.key(name);
    json.beginArray(JsonWriter::Layout::row);
    for (const ChainNumber& number : *numbers) json.string(number.toString());
    json.endArray();
  }
  json.member("frames", relatives.frames);
  json.endObject();
}

std::string numbersText(const std::vector<ChainNumber>& numbers) {
  constexpr std::size_t kMaxNumbers = 12;
  if (numbers.empty()) return translated("none");
  std::string text;
  for (std::size_t i = 0; i < std::min(numbers.size(), kMaxNumbers); ++i)
    text += (i == 0 ? "" : " ") + numbers[i].toString();
  if (numbers.size() <= kMaxNumbers) return text;
  return translated("%1 and %2 more", {text, std::to_string(numbers.size() - kMaxNumbers)});
}

std::string relativesText(const ChainRelatives& relatives) {
  return "  " + translated("same equations, other shafts: %1", {numbersText(relatives.sameEquations)}) +
         "\n  " + translated("one gear pair less: %1", {numbersText(relatives.oneMeshLess)}) + "\n  " +
         translated("one gear pair more: %1", {numbersText(relatives.oneMeshMore)}) + "\n  " +
         translated("links that differ as the frame: %1", {std::to_string(relatives.frames)}) + '\n';
}

std::string lockedText(const Chain& chain, const std::vector<int>& meshes) {
  return translated("cannot turn: %1 gear pairs between %2 links, of which one is held",
                    {std::to_string(meshes.size()), std::to_string(linksOf(chain, meshes).size())});
}

}  // namespace geargraph::cli
