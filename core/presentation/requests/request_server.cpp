#include "core/presentation/requests/request_server.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <memory>
#include <utility>

#include "core/foundations/base/translation.h"
#include "core/foundations/files/base64.h"
#include "core/foundations/files/json_writer.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "core/mechanism/document_format/mechanism_graph.h"
#include "core/presentation/requests/document_edits.h"
#include "core/presentation/result_json/diagnostics_json.h"

namespace geargraph {
namespace {

using Layout = JsonWriter::Layout;

constexpr std::size_t kMaxDocuments = 1'000;

/// In one line, as the answers are.
std::string oneLine(const std::string& json) {
  const auto parsed = JsonDocument::parse(json);
  return parsed ? parsed->root().compact() : "null";
}

template <class Write>
std::string objectOf(const Write& write) {
  TextSink sink;
  {
    JsonWriter json(sink);
    json.beginObject();
    write(json);
    json.endObject();
  }
  return sink.take();
}

bool isUtf8(const std::string& bytes) {
  std::string json;
  appendJsonString(json, bytes);
  return JsonDocument::parse(json).has_value() && JsonDocument::parse(json)->root().string() == bytes;
}

/// Texts as such, other bytes in base64.
void writeFiles(JsonWriter& json, const std::vector<std::pair<std::string, std::string>>& files) {
  json.key("files");
  json.beginArray();
  for (const auto& [name, bytes] : files) {
    json.beginObject();
    json.member("name", name);
    isUtf8(bytes) ? json.member("text", bytes) : json.member("base64", base64(bytes));
    json.endObject();
  }
  json.endArray();
}

constexpr std::array kRequestMembers = {
    RequestMember{"id", "any value, given back in the answer"}, RequestMember{"method", "text", true},
    RequestMember{"params", "object", true}, RequestMember{"jsonrpc", "text, not used"}};
constexpr std::string_view kDocument = "number of a document, from open";
constexpr std::array kOpenMembers = {
    RequestMember{"text", "document as a text or an object; or a table or a graph as a text", true}};
constexpr std::array kEditMembers = {RequestMember{"document", kDocument, true},
                                     RequestMember{"edits", "list of edits", true}};
constexpr std::array kDocumentMembers = {RequestMember{"document", kDocument, true}};
constexpr std::string_view kWish = "object, as the command line reads it from a file";
constexpr RequestMember kArguments{"arguments", "list of options of the command line"};
constexpr std::array kOfDocument = {RequestMember{"document", kDocument, true}, kArguments};
constexpr std::array kOfDocumentAndWish = {RequestMember{"document", kDocument, true},
                                           RequestMember{"wish", kWish, true}, kArguments};
constexpr std::array kOfTwoDocuments = {RequestMember{"document", kDocument, true},
                                        RequestMember{"with", "number of another document"}, kArguments};
constexpr std::array kOfWish = {RequestMember{"wish", kWish, true}, kArguments};
constexpr std::array kOfNumber = {RequestMember{"number", "text, of a chain"}, kArguments};

/// The params of a hosted method.
std::span<const RequestMember> paramsOf(const HostedMethod& method) {
  switch (method.input) {
    case MethodInput::document:
      return kOfDocument;
    case MethodInput::documentAndWish:
      return kOfDocumentAndWish;
    case MethodInput::twoDocuments:
      return kOfTwoDocuments;
    case MethodInput::wish:
      return kOfWish;
    case MethodInput::number:
      return kOfNumber;
  }
  return {};
}

bool isRefused(const HostedMethod& method, std::string_view option) {
  return std::find(method.refusedOptions.begin(), method.refusedOptions.end(), option) !=
         method.refusedOptions.end();
}

Rejection unknownDocument() {
  return {"unknown-document", "The member \"document\" is the number that \"open\" has given."};
}

void writeMethod(JsonWriter& json, std::string_view name, std::span<const RequestMember> members,
                 const std::vector<OptionText>& options) {
  json.beginObject();
  json.member("method", name);
  json.key("params");
  writeMembers(json, members);
  if (!options.empty()) {
    json.key("options");
    json.beginArray();
    for (const OptionText& option : options) {
      json.beginObject(Layout::row);
      json.member("name", option.name);
      json.member("value", option.value);
      json.endObject();
    }
    json.endArray();
  }
  json.endObject();
}

/// States are named, the others have ids.
template <class Element>
std::string idOf(const Element& element) {
  if constexpr (requires { element.id; }) {
    return element.id.text();
  } else {
    return element.name;
  }
}

template <class Element>
void writeAdded(JsonWriter& json, ElementKind kind, const std::vector<Element>& before,
                const std::vector<Element>& after) {
  std::vector<std::string> added;
  for (const Element& element : after) {
    const bool wasThere = std::any_of(before.begin(), before.end(),
                                      [&](const Element& old) { return idOf(old) == idOf(element); });
    if (!wasThere) added.push_back(idOf(element));
  }
  if (added.empty()) return;
  json.key(listName(kind));
  json.beginArray();
  for (const std::string& id : added) json.string(id);
  json.endArray();
}

/// Words of a command that would reach beyond standard input and output are rejected.
std::optional<Rejection> wrongWord(const HostedMethod& method, const std::vector<std::string>& words) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    const bool isOutput = word == "-o" && i + 1 < words.size() && words[i + 1] == "-";
    if (word.starts_with("-o") && !isOutput)
      return Rejection{"request", "A served command writes nothing but its answer: -o takes \"-\"."};
    const std::string option = word.substr(0, word.find('='));
    if (word == "--" || word == "--force" || word == "--all" || option == "--limit-seconds" ||
        isRefused(method, option))
      return Rejection{"request", "A served command does not take " + word + "."};
    if (!word.empty() && word.front() != '-' && (i == 0 || !words[i - 1].starts_with('-')))
      return Rejection{"request", "A served command takes options only, not \"" + word + "\"."};
  }
  return std::nullopt;
}

Rejection rejected(const Diagnostics& diagnostics) {
  return {codeName(diagnostics.front().code), diagnostics.front().message, diagnostics};
}

/// "  addLink         [id], [name], ..."
std::string helpLine(std::string_view name, std::span<const RequestMember> members) {
  constexpr std::size_t kIndent = 18;
  std::string line = "  " + std::string(name);
  if (!members.empty()) {
    line.resize(std::max(line.size() + 1, kIndent), ' ');
    line += membersText(members);
  }
  return line + '\n';
}

}  // namespace

RequestServer::RequestServer(std::vector<HostedMethod> hosted, RunHosted run)
    : m_hosted(std::move(hosted)), m_run(std::move(run)) {}

std::span<const RequestServer::Method> RequestServer::ownMethods() {
  static constexpr std::array kMethods = {Method{"help", {}, &RequestServer::help},
                                          Method{"open", kOpenMembers, &RequestServer::open},
                                          Method{"edit", kEditMembers, &RequestServer::edit},
                                          Method{"text", kDocumentMembers, &RequestServer::text},
                                          Method{"close", kDocumentMembers, &RequestServer::close}};
  return kMethods;
}

const RequestServer::Method* RequestServer::methodNamed(std::string_view name) {
  const std::span<const Method> methods = ownMethods();
  const auto found =
      std::find_if(methods.begin(), methods.end(), [&](const Method& each) { return each.name == name; });
  return found == methods.end() ? nullptr : &*found;
}

std::string RequestServer::answerTo(const std::string& line) {
  const auto parsed = JsonDocument::parse(line);
  if (!parsed) return lineOf("null", rejected(parsed.error()));
  const JsonValue request = parsed->root();
  if (!request.is(JsonKind::object))
    return lineOf("null", Rejection{"request", "A request is a JSON object."});
  const auto id = request.member("id");
  return lineOf(id ? id->compact() : "null", answerTo(request));
}

RequestServer::Answer RequestServer::answerTo(const JsonValue& request) {
  const auto named = request.member("method");
  const auto params = request.member("params");
  if (!named || !named->is(JsonKind::string) || (params && !params->is(JsonKind::object)))
    return Rejection{"request", "A request has a \"method\", a text, and \"params\", an object."};
  if (auto sentence = unknownMember("A request", request, kRequestMembers))
    return Rejection{"request", *std::move(sentence)};
  const std::string name = named->string();
  if (const Method* const method = methodNamed(name)) {
    if (!params && !method->members.empty()) return Rejection{"request", "The member \"params\" is missing."};
    if (!params) return (this->*method->answer)(request);
    if (auto sentence = unknownMember(name, *params, method->members))
      return Rejection{"request", *std::move(sentence)};
    return (this->*method->answer)(*params);
  }
  for (const HostedMethod& hosted : m_hosted) {
    if (hosted.name != name) continue;
    if (!params) return Rejection{"request", "The member \"params\" is missing."};
    if (auto sentence = unknownMember(name, *params, paramsOf(hosted)))
      return Rejection{"request", *std::move(sentence)};
    return run(hosted, *params);
  }
  return Rejection{"request", "There is no method \"" + name + "\"; \"help\" lists them."};
}

RequestServer::Answer RequestServer::help(const JsonValue& /*params*/) {
  return objectOf([this](JsonWriter& json) {
    json.member("format", "geargraph-serve");
    json.member("version", 1);
    json.key("methods");
    json.beginArray();
    for (const Method& method : ownMethods()) writeMethod(json, method.name, method.members, {});
    for (const HostedMethod& hosted : m_hosted)
      writeMethod(json, hosted.name, paramsOf(hosted), hosted.options);
    json.endArray();
    json.key("edits");
    json.beginArray();
    for (const DocumentEdit& edit : documentEdits()) {
      json.beginObject();
      json.member("edit", edit.name);
      json.key("members");
      writeMembers(json, edit.members);
      json.endObject();
    }
    json.endArray();
  });
}

std::optional<std::string> RequestServer::documentOf(const JsonValue& params, std::string_view member) const {
  const auto named = params.member(member);
  if (!named || !named->is(JsonKind::string)) return std::nullopt;
  const std::string name = named->string();
  return m_documents.contains(name) ? std::optional(name) : std::nullopt;
}

RequestServer::Answer RequestServer::open(const JsonValue& params) {
  if (m_documents.size() >= kMaxDocuments) return Rejection{"limit", "Over 1,000 documents are open."};
  const auto given = params.member("text");
  if (!given || !(given->is(JsonKind::string) || given->is(JsonKind::object)))
    return Rejection{
        "request",
        "\"open\" takes \"text\": a document, as a text or as an object; a table (CSV); or a graph (DOT, "
        "GraphML, node-link JSON)."};
  auto read = readAnyMechanism(given->is(JsonKind::string) ? given->string() : std::string(given->slice()));
  if (!read) return rejected(read.error());
  const std::string name = std::to_string(++m_opened);
  m_documents.emplace(name, std::make_shared<const Mechanism>(read->mechanism));
  return objectOf([&](JsonWriter& json) {
    json.member("format", "geargraph-serve");
    json.member("version", 1);
    json.member("document", name);
    if (read->notes.empty()) return;
    json.key("notes");
    json.beginArray(JsonWriter::Layout::row);
    for (const std::string& note : read->notes) json.string(note);
    json.endArray();
  });
}

RequestServer::Answer RequestServer::edit(const JsonValue& params) {
  const auto name = documentOf(params);
  if (!name) return unknownDocument();
  const auto edits = params.member("edits");
  if (!edits || !edits->is(JsonKind::array))
    return Rejection{"request", "\"edit\" takes \"edits\", a list of objects."};
  const MechanismPtr before = m_documents.at(*name);
  auto next = withDocumentEdits(*before, *edits);
  if (!next) return rejected(next.error());
  const auto after = std::make_shared<const Mechanism>(std::move(next).value());
  m_documents[*name] = after;
  return objectOf([&](JsonWriter& json) {
    json.key("added");
    json.beginObject(Layout::row);
    writeAdded(json, ElementKind::link, before->links, after->links);
    writeAdded(json, ElementKind::axis, before->axes, after->axes);
    writeAdded(json, ElementKind::turningJoint, before->turningJoints, after->turningJoints);
    writeAdded(json, ElementKind::gearMesh, before->gearMeshes, after->gearMeshes);
    writeAdded(json, ElementKind::wheel, before->wheels, after->wheels);
    writeAdded(json, ElementKind::coupling, before->couplings, after->couplings);
    writeAdded(json, ElementKind::state, before->states, after->states);
    writeAdded(json, ElementKind::load, before->loads, after->loads);
    json.endObject();
  });
}

RequestServer::Answer RequestServer::text(const JsonValue& params) {
  const auto name = documentOf(params);
  if (!name) return unknownDocument();
  return objectOf([&](JsonWriter& json) { json.member("text", writeMechanism(*m_documents.at(*name))); });
}

RequestServer::Answer RequestServer::close(const JsonValue& params) {
  const auto name = documentOf(params);
  if (!name) return unknownDocument();
  m_documents.erase(*name);
  return std::string("{}");
}

std::optional<Rejection> RequestServer::addInputs(const HostedMethod& method, const JsonValue& params,
                                                  std::vector<std::string>& words, HostedTexts& texts) const {
  const bool readsDocument = method.input != MethodInput::wish && method.input != MethodInput::number;
  const bool readsWish = method.input == MethodInput::wish || method.input == MethodInput::documentAndWish;
  if (readsDocument) {
    const auto name = documentOf(params);
    if (!name) return unknownDocument();
    texts.first = writeMechanism(*m_documents.at(*name));
  }
  if (method.input != MethodInput::number) words.emplace_back("-");
  if (readsWish) {
    const auto wish = params.member("wish");
    if (!wish || !wish->is(JsonKind::object))
      return Rejection{"request", "The member \"wish\" is an object."};
    (readsDocument ? texts.second : texts.first) = wish->slice();
    if (readsDocument) words.emplace_back(kSecondInput);
  }
  if (method.input == MethodInput::twoDocuments && params.member("with")) {
    const auto other = documentOf(params, "with");
    if (!other)
      return Rejection{"unknown-document", "The member \"with\" is the number that \"open\" has given."};
    texts.second = writeMechanism(*m_documents.at(*other));
    words.emplace_back("--with");
    words.emplace_back(kSecondInput);
  }
  if (const auto number = params.member("number")) {
    if (!number->is(JsonKind::string) || number->string().starts_with('-'))
      return Rejection{"request", "The member \"number\" is a text, as \"6-1.12.1\"."};
    words.push_back(number->string());
  }
  return std::nullopt;
}

RequestServer::Answer RequestServer::run(const HostedMethod& method, const JsonValue& params) {
  std::vector<std::string> words;
  if (const auto given = params.member("arguments")) {
    bool isFine = given->is(JsonKind::array);
    if (isFine) {
      given->forEachElement([&](const JsonValue& word, std::size_t /*position*/) {
        isFine = isFine && word.is(JsonKind::string);
        if (isFine) words.push_back(word.string());
      });
    }
    if (!isFine) return Rejection{"request", "\"arguments\" is a list of texts."};
  }
  if (auto rejection = wrongWord(method, words)) return *std::move(rejection);
  HostedTexts texts;
  if (auto rejection = addInputs(method, params, words, texts)) return *std::move(rejection);
  const HostedOutcome outcome = m_run(method, std::move(words), texts);
  if (!outcome.status) return Rejection{outcome.failureCode, outcome.failure};
  return objectOf([&](JsonWriter& json) {
    json.member("status", *outcome.status);
    if (outcome.files) writeFiles(json, *outcome.files);
    const auto parsed = JsonDocument::parse(outcome.output);
    if (parsed && parsed->root().is(JsonKind::object)) {
      json.key("output");
      json.json(parsed->root().compact());
    } else if (isUtf8(outcome.output)) {
      json.member("output", outcome.output);
    } else {
      json.member("base64", base64(outcome.output));
    }
    json.member("messages", outcome.messages);
  });
}

std::string RequestServer::lineOf(const std::string& id, const Answer& answer) {
  return oneLine(objectOf([&](JsonWriter& json) {
    json.key("id");
    json.json(id);
    if (const auto* result = std::get_if<std::string>(&answer)) {
      json.key("result");
      json.json(*result);
      return;
    }
    const auto& rejection = std::get<Rejection>(answer);
    json.key("error");
    json.beginObject();
    json.member("code", rejection.code);
    json.member("message", rejection.message);
    json.key("diagnostics");
    writeDiagnostics(json, rejection.diagnostics);
    json.endObject();
  }));
}

std::string requestMethodsText(std::span<const HostedMethod> hosted) {
  std::string text = '\n' + translated("Methods and their params; those in [ ] may be left out:") + '\n';
  for (const RequestServer::Method& method : RequestServer::ownMethods())
    text += helpLine(method.name, method.members);
  for (const HostedMethod& method : hosted) text += helpLine(method.name, paramsOf(method));
  text +=
      '\n' + translated("Edits and their members beside \"edit\"; null removes what may be left out:") + '\n';
  for (const DocumentEdit& edit : documentEdits()) text += helpLine(edit.name, edit.members);
  return text;
}

}  // namespace geargraph
