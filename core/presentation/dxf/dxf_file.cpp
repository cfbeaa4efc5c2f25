#include "core/presentation/dxf/dxf_file.h"

#include <array>
#include <charconv>
#include <cmath>
#include <utility>

namespace geargraph {
namespace {

std::string decimal(double value) {
  std::array<char, 40> text{};
  const double written = value == 0 ? 0.0 : value;
  std::string digits(text.data(), std::to_chars(text.data(), text.data() + text.size(), written).ptr);
  if (digits.find_first_of(".e") == std::string::npos) digits += ".0";
  return digits;
}

std::string hexadecimal(unsigned value) {
  std::array<char, 16> text{};
  std::string digits(text.data(), std::to_chars(text.data(), text.data() + text.size(), value, 16).ptr);
  for (char& digit : digits) {
    if (digit >= 'a') digit = static_cast<char>(digit - 'a' + 'A');
  }
  return digits;
}

std::string group(int code, std::string_view value) {
  std::string text = std::to_string(code);
  if (text.size() < 3) text.insert(0, 3 - text.size(), ' ');
  return text + '\n' + std::string(value) + '\n';
}
std::string group(int code, int value) {
  return group(code, std::string_view(std::to_string(value)));
}
std::string group(int code, double value) {
  return group(code, std::string_view(decimal(value)));
}
std::string pointGroups(const Eigen::Vector2d& point, int first = 10) {
  return group(first, point.x()) + group(first + 10, point.y()) + group(first + 20, 0.0);
}

/// "\U+00B0" for what is not ASCII; control characters are left out.
std::string escaped(std::string_view utf8) {
  std::string text;
  for (std::size_t i = 0; i < utf8.size();) {
    const auto byte = static_cast<unsigned char>(utf8[i]);
    if (byte < 0x80) {
      if (byte >= 0x20) text += utf8[i];
      ++i;
      continue;
    }
    const std::size_t length = byte >= 0xF0 ? 4 : byte >= 0xE0 ? 3 : 2;
    unsigned point = byte & (0xFFU >> (length + 1));
    for (std::size_t k = 1; k < length && i + k < utf8.size(); ++k)
      point = point << 6U | (static_cast<unsigned char>(utf8[i + k]) & 0x3FU);
    i += length;
    std::string digits = hexadecimal(point);
    if (digits.size() < 4) digits.insert(0, 4 - digits.size(), '0');
    text += digits.size() > 4 ? "?" : "\\U+" + digits;
  }
  return text;
}

// Handles of what every file has.
constexpr unsigned kBlockRecords = 1;
constexpr unsigned kModelRecord = 0x1F;
constexpr unsigned kPaperRecord = 0x1B;
constexpr unsigned kFirstFree = 0x30;

/// Tables and their entries with handles from one counter.
class DxfTables {
 public:
  explicit DxfTables(const std::vector<DxfLayer>& layers) : m_layers(layers) {}

  std::string text() {
    std::string text = group(0, "SECTION") + group(2, "TABLES");
    text += table("VPORT", 8, {});
    text += table(
        "LTYPE", 5,
        {lineType("ByBlock", "", {}), lineType("ByLayer", "", {}), lineType("Continuous", "Solid line", {}),
         lineType("CENTER", "Center ____ _ ____", {8, -1.5, 1, -1.5})});
    std::vector<Entry> layers{layer({"0", 7, false})};
    for (const DxfLayer& each : m_layers) layers.push_back(layer(each));
    text += table("LAYER", 2, layers);
    text += table("STYLE", 3,
                  {{"STYLE", "AcDbTextStyleTableRecord",
                    group(2, "Standard") + group(70, 0) + group(40, 0.0) + group(41, 1.0) + group(50, 0.0) +
                        group(71, 0) + group(42, 2.5) + group(3, "txt") + group(4, "")}});
    text += table("VIEW", 6, {});
    text += table("UCS", 7, {});
    text += table("APPID", 9, {{"APPID", "AcDbRegAppTableRecord", group(2, "ACAD") + group(70, 0)}});
    text += dimensionStyles();
    text += table(
        "BLOCK_RECORD", kBlockRecords,
        {{"BLOCK_RECORD", "AcDbBlockTableRecord", group(2, "*Model_Space") + group(340, "0"), kModelRecord},
         {"BLOCK_RECORD", "AcDbBlockTableRecord", group(2, "*Paper_Space") + group(340, "0"), kPaperRecord}});
    return text + group(0, "ENDSEC");
  }

  unsigned next() { return m_next++; }

 private:
  struct Entry {
    std::string type;
    std::string subclass;
    std::string groups;
    unsigned handle = 0;
  };

  static std::string head(const char* name, unsigned handle, std::size_t entries) {
    return group(0, "TABLE") + group(2, name) + group(5, hexadecimal(handle)) + group(330, "0") +
           group(100, "AcDbSymbolTable") + group(70, static_cast<int>(entries));
  }

  std::string table(const char* name, unsigned handle, const std::vector<Entry>& entries) {
    std::string text = head(name, handle, entries.size());
    for (const Entry& entry : entries) {
      text += group(0, entry.type) + group(5, hexadecimal(entry.handle != 0 ? entry.handle : next())) +
              group(330, hexadecimal(handle)) + group(100, "AcDbSymbolTableRecord") +
              group(100, entry.subclass) + entry.groups;
    }
    return text + group(0, "ENDTAB");
  }

  /// Without an entry it still names its subclass.
  static std::string dimensionStyles() {
    return head("DIMSTYLE", 0xA, 0) + group(100, "AcDbDimStyleTable") + group(71, 0) + group(0, "ENDTAB");
  }

  static Entry lineType(const char* name, const char* shown, const std::vector<double>& dashes) {
    double length = 0;
    for (const double dash : dashes) length += std::abs(dash);
    std::string groups = group(2, name) + group(70, 0) + group(3, shown) + group(72, 65) +
                         group(73, static_cast<int>(dashes.size())) + group(40, length);
    for (const double dash : dashes) groups += group(49, dash) + group(74, 0);
    return {"LTYPE", "AcDbLinetypeTableRecord", groups};
  }

  static Entry layer(const DxfLayer& of) {
    return {"LAYER", "AcDbLayerTableRecord",
            group(2, of.name) + group(70, 0) + group(62, of.color) +
                group(6, of.isDashDotted ? "CENTER" : "Continuous")};
  }

  const std::vector<DxfLayer>& m_layers;
  unsigned m_next = kFirstFree;
};

std::string blockText(DxfTables& handles, const char* name, unsigned record) {
  const std::string owner = group(330, hexadecimal(record));
  return group(0, "BLOCK") + group(5, hexadecimal(handles.next())) + owner + group(100, "AcDbEntity") +
         group(8, "0") + group(100, "AcDbBlockBegin") + group(2, name) + group(70, 0) +
         pointGroups(Eigen::Vector2d::Zero()) + group(3, name) + group(1, "") + group(0, "ENDBLK") +
         group(5, hexadecimal(handles.next())) + owner + group(100, "AcDbEntity") + group(8, "0") +
         group(100, "AcDbBlockEnd");
}

}  // namespace

int dxfUnits(double metres) {
  constexpr std::array<std::pair<int, double>, 9> kUnits = {{{1, 0.0254},
                                                             {2, 0.3048},
                                                             {4, 0.001},
                                                             {5, 0.01},
                                                             {6, 1},
                                                             {7, 1000},
                                                             {9, 0.0254e-3},
                                                             {13, 1e-6},
                                                             {14, 0.1}}};
  for (const auto& [code, size] : kUnits) {
    if (std::abs(metres / size - 1) < 1e-9) return code;
  }
  return 0;
}

void DxfFile::reach(const Eigen::Vector2d& point) {
  m_low = m_isEmpty ? point : m_low.cwiseMin(point);
  m_high = m_isEmpty ? point : m_high.cwiseMax(point);
  m_isEmpty = false;
}

void DxfFile::addPolyline(int layer, const std::vector<ArcVertex>& vertices, bool isClosed) {
  std::string groups = group(100, "AcDbPolyline") + group(90, static_cast<int>(vertices.size())) +
                       group(70, isClosed ? 1 : 0) + group(43, 0.0);
  for (const ArcVertex& vertex : vertices) {
    groups += group(10, vertex.at.x()) + group(20, vertex.at.y());
    if (vertex.bulge != 0) groups += group(42, vertex.bulge);
    reach(vertex.at);
  }
  m_entities.push_back({"LWPOLYLINE", layer, std::move(groups)});
}

void DxfFile::addCircle(int layer, const Eigen::Vector2d& center, double radius) {
  reach(center - Eigen::Vector2d(radius, radius));
  reach(center + Eigen::Vector2d(radius, radius));
  m_entities.push_back({"CIRCLE", layer, group(100, "AcDbCircle") + pointGroups(center) + group(40, radius)});
}

void DxfFile::addLine(int layer, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  reach(from);
  reach(to);
  m_entities.push_back({"LINE", layer, group(100, "AcDbLine") + pointGroups(from) + pointGroups(to, 11)});
}

void DxfFile::addText(int layer, const Eigen::Vector2d& at, double height, std::string_view utf8) {
  reach(at);
  reach(at + Eigen::Vector2d(0, height));
  m_entities.push_back({"TEXT", layer,
                        group(100, "AcDbText") + pointGroups(at) + group(40, height) +
                            group(1, escaped(utf8)) + group(7, "Standard") + group(100, "AcDbText")});
}

std::string DxfFile::text(int units) const {
  DxfTables tables(m_layers);
  std::string body = group(0, "SECTION") + group(2, "CLASSES") + group(0, "ENDSEC") + tables.text();
  body += group(0, "SECTION") + group(2, "BLOCKS") + blockText(tables, "*Model_Space", kModelRecord) +
          blockText(tables, "*Paper_Space", kPaperRecord) + group(0, "ENDSEC");
  body += group(0, "SECTION") + group(2, "ENTITIES");
  for (const Entity& entity : m_entities) {
    body += group(0, entity.type) + group(5, hexadecimal(tables.next())) +
            group(330, hexadecimal(kModelRecord)) + group(100, "AcDbEntity") +
            group(8, m_layers[static_cast<std::size_t>(entity.layer)].name) + entity.groups;
  }
  body += group(0, "ENDSEC");
  const unsigned root = tables.next();
  const unsigned groups = tables.next();
  body += group(0, "SECTION") + group(2, "OBJECTS") + group(0, "DICTIONARY") + group(5, hexadecimal(root)) +
          group(330, "0") + group(100, "AcDbDictionary") + group(281, 1) + group(3, "ACAD_GROUP") +
          group(350, hexadecimal(groups)) + group(0, "DICTIONARY") + group(5, hexadecimal(groups)) +
          group(330, hexadecimal(root)) + group(100, "AcDbDictionary") + group(281, 1) + group(0, "ENDSEC") +
          group(0, "EOF");
  return group(0, "SECTION") + group(2, "HEADER") + group(9, "$ACADVER") + group(1, "AC1015") +
         group(9, "$DWGCODEPAGE") + group(3, "ANSI_1252") + group(9, "$EXTMIN") + pointGroups(m_low) +
         group(9, "$EXTMAX") + pointGroups(m_high) + group(9, "$INSUNITS") + group(70, units) +
         group(9, "$MEASUREMENT") + group(70, units == 1 || units == 2 ? 0 : 1) + group(9, "$HANDSEED") +
         group(5, hexadecimal(tables.next())) + group(0, "ENDSEC") + body;
}

}  // namespace geargraph
