#include "core/design/teeth_search/teeth_certificate.h"

#include "core/design/teeth_wish/problem_mark.h"
#include "core/foundations/base/translation.h"
#include "core/foundations/files/json_writer.h"
#include "core/mechanism/document_format/mechanism_file.h"

namespace geargraph {
namespace {

using Layout = JsonWriter::Layout;

Diagnostic noCertificate(std::string message) {
  return {Code::schema, std::move(message), {}, {}, 0, 0};
}

void writeWholes(JsonWriter& json, std::span<const int> numbers) {
  json.beginArray(Layout::row);
  for (const int number : numbers) json.number(std::int64_t{number});
  json.endArray();
}

void writePolynomial(JsonWriter& json, const TeethPolynomial& polynomial) {
  json.beginArray(Layout::row);
  for (const TeethPolynomial::Term& term : polynomial.terms) {
    json.beginArray(Layout::row);
    json.number(term.factor);
    writeWholes(json, term.wheels);
    json.endArray();
  }
  json.endArray();
}

void writeCounts(JsonWriter& json, const TeethCounts& counts) {
  for (const std::int64_t count : {counts.tried, counts.turns, counts.clears, counts.assembles, counts.hunts,
                                   counts.stands, counts.within})
    json.number(count);
}

void writeWheel(JsonWriter& json, const Mechanism& train, const SearchedWheel& wheel) {
  json.beginObject(Layout::row);
  json.key("ends");
  json.beginArray(Layout::row);
  for (const int end : wheel.ends)
    json.string(std::to_string(train.meshLabel(end / 2)) + (end % 2 == 0 ? ":tail" : ":head"));
  json.endArray();
  json.member("copies", wheel.copies);
  json.endObject();
}

void writeTexts(JsonWriter& json, std::string_view name, const std::vector<Rational>& numbers) {
  json.key(name);
  json.beginArray(Layout::row);
  for (const Rational& number : numbers) json.string(number.toString());
  json.endArray();
}

}  // namespace

Expected<std::string> teethCertificate(const TeethAnswer& answer, std::string_view wish,
                                       std::string_view program) {
  const TeethProblem& problem = *answer.problem;
  if (!answer.found.isComplete)
    return noCertificate(translated("Not all choices were tried, so that there is nothing to certify."));
  if (problem.wish.leastEfficiency.sign() > 0)
    return noCertificate(translated("A wish with a least efficiency has no certificate."));
  if (!problem.closures.empty())
    return noCertificate(translated("A train that locks with other teeth has no certificate."));
  const std::string text = problemText(writeMechanism(problem.drawn.mechanism()), wish);
  TextSink sink;
  {
    JsonWriter json(sink);
    json.beginObject();
    json.member("format", "geargraph-teeth-certificate");
    json.member("version", 1);
    json.member("program", program);
    json.member("mark", markOf(text));
    json.key("problem");
    json.json(text);
    json.key("wheels");
    json.beginArray();
    for (const SearchedWheel& wheel : problem.wheels) writeWheel(json, problem.train, wheel);
    json.endArray();
    json.key("order");
    writeWholes(json, answer.found.order);
    json.key("first");
    answer.found.first < 0 ? json.null() : json.number(std::int64_t{answer.found.first});
    json.key("ratios");
    json.beginArray();
    for (const SearchedRatio& ratio : problem.ratios) {
      json.beginObject(Layout::row);
      json.key("numerator");
      writePolynomial(json, ratio.numerator);
      json.key("denominator");
      writePolynomial(json, ratio.denominator);
      json.endObject();
    }
    json.endArray();
    json.key("counts");
    json.beginArray(Layout::row);
    writeCounts(json, answer.found.counts);
    json.endArray();
    json.key("branches");
    json.beginArray();
    for (const TeethBranch& branch : answer.found.branches) {
      json.beginArray(Layout::row);
      json.number(std::int64_t{branch.teeth});
      writeCounts(json, branch.counts);
      json.endArray();
    }
    json.endArray();
    json.key("choices");
    json.beginArray();
    for (const FoundTeeth& found : answer.found.best) {
      json.beginObject(Layout::row);
      json.key("teeth");
      writeWholes(json, found.teeth);
      writeTexts(json, "ratios", found.ratios);
      writeTexts(json, "errors", found.errors);
      json.endObject();
    }
    json.endArray();
    json.endObject();
  }
  return sink.take();
}

}  // namespace geargraph
