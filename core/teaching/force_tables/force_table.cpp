#include "core/teaching/force_tables/force_table.h"

#include <charconv>

#include "core/foundations/base/contract.h"
#include "core/foundations/base/readable.h"
#include "core/foundations/base/translation.h"

namespace geargraph {
namespace {

struct Names {
  ForceTableKind kind;
  std::string_view title;
  std::string_view command;
};

constexpr Names kNames[] = {
    {ForceTableKind::needs, toTranslate("Torques"), "needed-torques"},
    {ForceTableKind::joints, toTranslate("Joints"), "joint-torques"},
    {ForceTableKind::couplings, toTranslate("Couplings"), "coupling-torques"},
    {ForceTableKind::meshes, toTranslate("Meshes"), "mesh-forces"},
    {ForceTableKind::bearings, toTranslate("Bearings"), "bearings"},
    {ForceTableKind::powers, toTranslate("Power"), "powers"},
    {ForceTableKind::circulations, toTranslate("Circulating power"), "circulations"},
    {ForceTableKind::states, toTranslate("States"), "shift-torques"},
};

const Names& namesOf(ForceTableKind kind) {
  for (const Names& names : kNames)
    if (names.kind == kind) return names;
  GEARGRAPH_REQUIRE(false);
  return kNames[0];
}

bool isWritten(const ForceColumn& column) {
  return column.isInFiles && !column.isFraction;
}

std::string csvNumber(double number, const CsvOptions& options) {
  char buffer[32];
  std::string text(buffer, std::to_chars(buffer, buffer + sizeof buffer, number).ptr);
  const auto point = text.find('.');
  if (options.decimalPoint == '.' || point == std::string::npos) return text;
  text[point] = options.decimalPoint;
  return options.decimalPoint == options.separator ? '"' + text + '"' : text;
}

}  // namespace

const std::vector<ForceTableKind>& allForceTableKinds() {
  static const std::vector<ForceTableKind> kinds = [] {
    std::vector<ForceTableKind> all;
    for (const Names& names : kNames)
      if (names.kind != ForceTableKind::needs && names.kind != ForceTableKind::states)
        all.push_back(names.kind);
    return all;
  }();
  return kinds;
}

std::string_view forceTableTitle(ForceTableKind kind) {
  return namesOf(kind).title;
}

std::string_view forceTableCommandName(ForceTableKind kind) {
  return namesOf(kind).command;
}

void writeForceCsv(ByteSink& sink, const ValueTable& table, const CsvOptions& options) {
  std::string text = options.byteOrderMark ? "\xEF\xBB\xBF" : "";
  const auto endLine = [&] {
    text.back() = '\n';  // in place of the last separator
    sink.write(text);
    text.clear();
  };
  if (options.labels) {
    for (const ForceColumn& column : table.columns) {
      if (!isWritten(column)) continue;
      const std::string& head = column.headInFiles.empty() ? column.head : column.headInFiles;
      text += csvLabel(column.unit.empty() ? head : head + " [" + column.unit + ']', options.separator) +
              options.separator;
    }
    endLine();
  }
  for (const ForceRow& row : table.rows) {
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      if (!isWritten(table.columns[i])) continue;
      const ForceCell& cell = row.cells[i];
      if (cell.number) {
        text += csvNumber(*cell.number, options);
      } else {
        text += csvLabel(cell.textInFiles.empty() ? cell.text : cell.textInFiles, options.separator);
      }
      text += options.separator;
    }
    endLine();
  }
}

std::string shownNumber(double number) {
  return readableNumber(number);
}

std::string shownReal(const Real& value) {
  return value.isExact() ? readableNumber(*value.fraction()) : readableNumber(value.number());
}

}  // namespace geargraph
