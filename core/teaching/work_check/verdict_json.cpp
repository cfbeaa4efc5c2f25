#include "core/foundations/files/json_writer.h"
#include "core/teaching/work_check/work_check.h"

namespace geargraph {
namespace {

class VerdictWriter {
 public:
  explicit VerdictWriter(ByteSink& sink) : m_json(sink) {}

  void write(const WorkVerdict& verdict) {
    m_json.beginObject();
    m_json.member("format", "geargraph-check");
    m_json.member("version", 1);
    if (const auto* matrix = std::get_if<MatrixVerdict>(&verdict)) {
      write(*matrix);
    } else {
      m_json.key("equations");
      m_json.beginArray();
      for (const EquationVerdict& equation : std::get<std::vector<EquationVerdict>>(verdict)) write(equation);
      m_json.endArray();
    }
    m_json.endObject();
  }

 private:
  void write(const MatrixVerdict& verdict) {
    m_json.member("matrix", paperMatrixName(verdict.kind));
    m_json.member("recognised", verdict.isRecognised);
    m_json.member("outcome", outcomeName(verdict.outcome));
    m_json.key("notes");
    m_json.beginArray();
    for (const std::string& note : verdict.notes) m_json.string(note);
    m_json.endArray();
    headings("rows", verdict.rows);
    headings("columns", verdict.columns);
    m_json.key("derived");
    m_json.beginArray();
    for (const auto& row : verdict.entries) {
      m_json.beginArray(JsonWriter::Layout::row);
      for (const ComparedEntry& entry : row) m_json.string(entry.derived);
      m_json.endArray();
    }
    m_json.endArray();
    m_json.key("differences");
    m_json.beginArray();
    for (const WorkDifference& difference : verdict.differences) write(difference);
    m_json.endArray();
  }

  void write(const EquationVerdict& verdict) {
    m_json.beginObject();
    m_json.member("text", verdict.text);
    m_json.member("line", verdict.line);
    m_json.member("outcome", outcomeName(verdict.isRight ? WorkOutcome::right : WorkOutcome::wrong));
    m_json.key("difference");
    if (verdict.difference) {
      write(*verdict.difference);
    } else {
      m_json.null();
    }
    m_json.endObject();
  }

  void write(const WorkDifference& difference) {
    m_json.beginObject();
    m_json.member("mistake", difference.name);
    m_json.member("title", paperMistakeTitle(difference.name));
    m_json.member("reason", difference.reason);
    m_json.key("entries");
    m_json.beginArray(JsonWriter::Layout::row);
    for (const EntryPlace& place : difference.entries) {
      m_json.beginArray(JsonWriter::Layout::row);
      m_json.number(std::int64_t{place.row} + 1);
      m_json.number(std::int64_t{place.column} + 1);
      m_json.endArray();
    }
    m_json.endArray();
    m_json.key("elements");
    m_json.beginArray(JsonWriter::Layout::row);
    for (const ElementId& element : difference.elements)
      m_json.string(std::string(listName(element.kind)) + '/' + element.id.text());
    m_json.endArray();
    m_json.endObject();
  }

  void headings(const char* name, const std::vector<Heading>& headings) {
    m_json.key(name);
    m_json.beginArray(JsonWriter::Layout::row);
    for (const Heading& heading : headings) m_json.number(std::int64_t{heading.label});
    m_json.endArray();
  }

  JsonWriter m_json;
};

}  // namespace

std::string verdictJson(const WorkVerdict& verdict) {
  TextSink sink;
  VerdictWriter(sink).write(verdict);
  return sink.take() + '\n';
}

}  // namespace geargraph
