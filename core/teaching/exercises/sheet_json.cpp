#include <charconv>

#include "core/foundations/base/translation.h"
#include "core/foundations/files/json_writer.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "core/teaching/exercises/exercise_sheet.h"
#include "core/teaching/grading/member_reader.h"

namespace geargraph {
namespace {

/// What the mark is made of: plan and mechanism.
void writePlan(JsonWriter& json, const SheetFile& sheet) {
  json.member("generator", kGeneratorVersion);
  json.member("title", sheet.plan.title);
  json.member("seed", std::to_string(sheet.plan.seed));
  json.member("variants", sheet.plan.variants);
  if (sheet.plan.comma == CommaUse::decimal) json.member("decimal", ",");
  json.key("kinds");
  json.beginArray(JsonWriter::Layout::row);
  for (const ExerciseKind kind : sheet.plan.kinds) json.string(kindName(kind));
  json.endArray();
  json.key("mechanism");
  std::string mechanism = writeMechanism(sheet.mechanism);
  while (!mechanism.empty() && mechanism.back() == '\n') mechanism.pop_back();
  json.json(mechanism);
}

std::uint64_t seedFrom(MemberReader& reader, const JsonValue& root) {
  const std::string text = reader.text(root, "seed", "");
  std::uint64_t seed = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
  if (error != std::errc() || end != text.data() + text.size() || text.empty())
    reader.fail("/seed", translated("The seed is a whole number from 0 to 2^64 - 1, in quotes."));
  return seed;
}

}  // namespace

std::string sheetMark(const SheetFile& sheet) {
  TextSink sink;
  {
    JsonWriter json(sink);
    json.beginObject();
    writePlan(json, sheet);
    json.endObject();
  }
  std::uint64_t hash = 0xCBF29CE484222325U;
  for (const char c : sink.text()) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3U;
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string mark;
  for (int shift = 60; shift >= 0; shift -= 4) mark += kDigits[hash >> static_cast<unsigned>(shift) & 15U];
  return mark;
}

std::string sheetJson(const SheetFile& sheet) {
  TextSink sink;
  {
    JsonWriter json(sink);
    json.beginObject();
    json.member("format", "geargraph-sheet");
    json.member("version", kSheetVersion);
    json.member("mark", sheetMark(sheet));
    writePlan(json, sheet);
    json.endObject();
  }
  return sink.take() + '\n';
}

Expected<SheetFile> readSheet(std::string_view text) {
  const auto document = JsonDocument::parse(text);
  if (!document) return document.error();
  const JsonValue root = document->root();
  MemberReader reader;
  reader.heading(root, "geargraph-sheet", kSheetVersion);
  if (reader.fault()) return *reader.fault();
  SheetFile sheet;
  const auto generator = reader.memberNumber(root, "generator", "");
  if (generator && *generator != kGeneratorVersion) {
    reader.fail("/generator",
                translated("The sheet was made by another version of the program, whose questions this one "
                           "cannot make again."),
                Code::version);
  }
  sheet.plan.title = reader.text(root, "title", "");
  sheet.plan.seed = seedFrom(reader, root);
  sheet.plan.variants = reader.memberNumber(root, "variants", "").value_or(0);
  sheet.plan.comma = reader.text(root, "decimal", "", false) == "," ? CommaUse::decimal : CommaUse::ambiguous;
  if (sheet.plan.variants < 1 || sheet.plan.variants > kMaxVariants)
    reader.fail("/variants", translated("A sheet has 1 to 1,000 variants."));
  for (const std::string& name : reader.texts(root, "kinds", "", true)) {
    const auto kind = kindFromName(name);
    if (!kind) reader.fail("/kinds", translated("There is no kind of question \"%1\".", {name}));
    if (kind) sheet.plan.kinds.push_back(*kind);
  }
  if (sheet.plan.kinds.empty() || static_cast<int>(sheet.plan.kinds.size()) > kMaxQuestions)
    reader.fail("/kinds", translated("A sheet has 1 to 100 questions."));
  const auto mechanism = reader.member(root, "mechanism", JsonKind::object, "");
  if (reader.fault()) return *reader.fault();
  auto read = readMechanism(mechanism->slice());
  if (!read) return read.error();
  sheet.mechanism = std::move(read).value();
  if (sheet.mechanism.n() > kMaxExerciseLinks)
    return Diagnostic{Code::schema,
                      translated("Exercises are made of mechanisms of at most %1 moving links.", {"60"}),
                      {},
                      "/mechanism"};
  const ExerciseSource source(sheet.mechanism);
  for (const ExerciseKind kind : sheet.plan.kinds) {
    const auto reason = reasonAgainst(source, kind);
    if (reason)
      return Diagnostic{Code::schema,
                        translated("The mechanism gives no question \"%1\": %2.", {kindName(kind), *reason}),
                        {},
                        "/kinds"};
  }
  return sheet;
}

}  // namespace geargraph
