// `serve --stdio`: answers requests, one JSON object a line, until standard input ends.

#include <algorithm>
#include <array>
#include <iostream>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "app/cli/command.h"
#include "app/cli/serve_edits.h"
#include "app/cli/serve_members.h"
#include "app/cli/served_command.h"
#include "app/cli/time_limit.h"
#include "core/foundations/base/translation.h"
#include "core/foundations/files/base64.h"
#include "core/foundations/files/file.h"
#include "core/foundations/files/json.h"
#include "core/foundations/files/json_writer.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "core/mechanism/document_format/mechanism_graph.h"
#include "core/presentation/export_api/diagnostics_json.h"

namespace geargraph::cli {
namespace {

using Layout = JsonWriter::Layout;

constexpr std::size_t kLargestRequest = 2 * kLargestFile;
constexpr std::size_t kMaxDocuments = 1'000;

/// Why a request was not answered.
struct Rejection {
  std::string_view code;  ///< "request", "unknown-document", "limit", or that of the first diagnostic
  std::string message;
  Diagnostics diagnostics = {};
};

/// A result as JSON, or a rejection.
using Answer = std::variant<std::string, Rejection>;

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

constexpr std::array kRequestMembers = {
    ServedMember{"id", "any value, given back in the answer"}, ServedMember{"method", "text", true},
    ServedMember{"params", "object", true}, ServedMember{"jsonrpc", "text, not used"}};
constexpr std::string_view kDocument = "number of a document, from open";
constexpr std::array kOpenMembers = {
    ServedMember{"text", "document as a text or an object; or a table or a graph as a text", true}};
constexpr std::array kEditMembers = {ServedMember{"document", kDocument, true},
                                     ServedMember{"edits", "list of edits", true}};
constexpr std::array kDocumentMembers = {ServedMember{"document", kDocument, true}};
constexpr std::string_view kWish = "object, as the command line reads it from a file";
constexpr ServedMember kArguments{"arguments", "list of options of the command line"};
constexpr std::array kOfDocument = {ServedMember{"document", kDocument, true}, kArguments};
constexpr std::array kOfDocumentAndWish = {ServedMember{"document", kDocument, true},
                                           ServedMember{"wish", kWish, true}, kArguments};
constexpr std::array kOfTwoDocuments = {ServedMember{"document", kDocument, true},
                                        ServedMember{"with", "number of another document"}, kArguments};
constexpr std::array kOfWish = {ServedMember{"wish", kWish, true}, kArguments};
constexpr std::array kOfNumber = {ServedMember{"number", "text, of a chain"}, kArguments};

/// The params of a command as a method.
std::span<const ServedMember> paramsOf(const Command& command) {
  switch (command.servedInput) {
    case ServedInput::document:
      return kOfDocument;
    case ServedInput::documentAndWish:
      return kOfDocumentAndWish;
    case ServedInput::twoDocuments:
      return kOfTwoDocuments;
    case ServedInput::wish:
      return kOfWish;
    case ServedInput::number:
      return kOfNumber;
  }
  return {};
}

bool isUnserved(const Command& command, std::string_view option) {
  return std::find(command.unserved.begin(), command.unserved.end(), option) != command.unserved.end();
}

/// The commands that are methods, too.
std::vector<const Command*> servedCommands() {
  std::vector<const Command*> served;
  std::copy_if(commands().begin(), commands().end(), std::back_inserter(served),
               [](const Command* command) { return command->isServed; });
  return served;
}

/// Holds documents and answers requests about them.
class Server {
 public:
  /// A method that is no command: its name, its parameters and the function that answers it.
  struct Method {
    std::string_view name;
    std::span<const ServedMember> members;
    Answer (Server::*answer)(const JsonValue& params);
  };

  explicit Server(const ServedLimits& limits) : m_limits(limits) {}

  static std::span<const Method> ownMethods() {
    static constexpr std::array kMethods = {
        Method{"help", {}, &Server::help}, Method{"open", kOpenMembers, &Server::open},
        Method{"edit", kEditMembers, &Server::edit}, Method{"text", kDocumentMembers, &Server::text},
        Method{"close", kDocumentMembers, &Server::close}};
    return kMethods;
  }

  /// The line of the answer, without its end.
  std::string answerTo(const std::string& line) {
    const auto parsed = JsonDocument::parse(line);
    if (!parsed) return lineOf("null", rejected(parsed.error()));
    const JsonValue request = parsed->root();
    if (!request.is(JsonKind::object))
      return lineOf("null", Rejection{"request", "A request is a JSON object."});
    const auto id = request.member("id");
    return lineOf(id ? id->compact() : "null", answerTo(request));
  }

 private:
  Answer answerTo(const JsonValue& request) {
    const auto named = request.member("method");
    const auto params = request.member("params");
    if (!named || !named->is(JsonKind::string) || (params && !params->is(JsonKind::object)))
      return Rejection{"request", "A request has a \"method\", a text, and \"params\", an object."};
    if (auto sentence = unknownMember("A request", request, kRequestMembers))
      return Rejection{"request", *std::move(sentence)};
    const std::string name = named->string();
    if (const Method* const method = methodNamed(name)) {
      if (!params && !method->members.empty())
        return Rejection{"request", "The member \"params\" is missing."};
      if (!params) return (this->*method->answer)(request);
      if (auto sentence = unknownMember(name, *params, method->members))
        return Rejection{"request", *std::move(sentence)};
      return (this->*method->answer)(*params);
    }
    for (const Command* const command : servedCommands()) {
      if (command->name != name) continue;
      if (!params) return Rejection{"request", "The member \"params\" is missing."};
      if (auto sentence = unknownMember(name, *params, paramsOf(*command)))
        return Rejection{"request", *std::move(sentence)};
      return run(*command, *params);
    }
    return Rejection{"request", "There is no method \"" + name + "\"; \"help\" lists them."};
  }

  static Rejection unknownDocument() {
    return {"unknown-document", "The member \"document\" is the number that \"open\" has given."};
  }

  static const Method* methodNamed(std::string_view name) {
    const std::span<const Method> methods = ownMethods();
    const auto found =
        std::find_if(methods.begin(), methods.end(), [&](const Method& each) { return each.name == name; });
    return found == methods.end() ? nullptr : &*found;
  }

  /// Lists methods and edits with their members.
  Answer help(const JsonValue& /*params*/) {
    return objectOf([](JsonWriter& json) {
      json.member("format", "geargraph-serve");
      json.member("version", 1);
      json.key("methods");
      json.beginArray();
      for (const Method& method : ownMethods()) writeMethod(json, method.name, method.members, {});
      for (const Command* const command : servedCommands())
        writeMethod(json, command->name, paramsOf(*command), servedOptionsOf(*command));
      json.endArray();
      json.key("edits");
      json.beginArray();
      for (const ServedEdit& edit : servedEdits()) {
        json.beginObject();
        json.member("edit", edit.name);
        json.key("members");
        writeMembers(json, edit.members);
        json.endObject();
      }
      json.endArray();
    });
  }

  static std::vector<Option> servedOptionsOf(const Command& command) {
    std::vector<Option> options = optionsOf(command);
    std::erase_if(options, [&](const Option& option) { return isUnserved(command, option.name); });
    return options;
  }

  static void writeMethod(JsonWriter& json, std::string_view name, std::span<const ServedMember> members,
                          const std::vector<Option>& options) {
    json.beginObject();
    json.member("method", name);
    json.key("params");
    writeMembers(json, members);
    if (!options.empty()) {
      json.key("options");
      json.beginArray();
      for (const Option& option : options) {
        json.beginObject(Layout::row);
        json.member("name", option.name);
        json.member("value", option.value);
        json.endObject();
      }
      json.endArray();
    }
    json.endObject();
  }

  [[nodiscard]] std::optional<std::string> documentOf(const JsonValue& params,
                                                      std::string_view member = "document") const {
    const auto named = params.member(member);
    if (!named || !named->is(JsonKind::string)) return std::nullopt;
    const std::string name = named->string();
    return m_documents.contains(name) ? std::optional(name) : std::nullopt;
  }

  Answer open(const JsonValue& params) {
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

  Answer edit(const JsonValue& params) {
    const auto name = documentOf(params);
    if (!name) return unknownDocument();
    const auto edits = params.member("edits");
    if (!edits || !edits->is(JsonKind::array))
      return Rejection{"request", "\"edit\" takes \"edits\", a list of objects."};
    const MechanismPtr before = m_documents.at(*name);
    auto next = withServedEdits(*before, *edits);
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

  template <class Element>
  static void writeAdded(JsonWriter& json, ElementKind kind, const std::vector<Element>& before,
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

  /// States are named, the others have ids.
  template <class Element>
  static std::string idOf(const Element& element) {
    if constexpr (requires { element.id; }) {
      return element.id.text();
    } else {
      return element.name;
    }
  }

  Answer text(const JsonValue& params) {
    const auto name = documentOf(params);
    if (!name) return unknownDocument();
    return objectOf([&](JsonWriter& json) { json.member("text", writeMechanism(*m_documents.at(*name))); });
  }

  Answer close(const JsonValue& params) {
    const auto name = documentOf(params);
    if (!name) return unknownDocument();
    m_documents.erase(*name);
    return std::string("{}");
  }

  /// Words of a command that would reach beyond standard input and output are rejected.
  static std::optional<Rejection> wrongWord(const Command& command, const std::vector<std::string>& words) {
    for (std::size_t i = 0; i < words.size(); ++i) {
      const std::string& word = words[i];
      const bool isOutput = word == "-o" && i + 1 < words.size() && words[i + 1] == "-";
      if (word.starts_with("-o") && !isOutput)
        return Rejection{"request", "A served command writes nothing but its answer: -o takes \"-\"."};
      const std::string option = word.substr(0, word.find('='));
      if (word == "--" || word == "--force" || word == "--all" || option == "--limit-seconds" ||
          isUnserved(command, option))
        return Rejection{"request", "A served command does not take " + word + "."};
      if (!word.empty() && word.front() != '-' && (i == 0 || !words[i - 1].starts_with('-')))
        return Rejection{"request", "A served command takes options only, not \"" + word + "\"."};
    }
    return std::nullopt;
  }

  /// Adds the words by which the command reads what the request gives it.
  [[nodiscard]] std::optional<Rejection> addInputs(const Command& command, const JsonValue& params,
                                                   std::vector<std::string>& words,
                                                   ServedTexts& texts) const {
    const bool readsDocument =
        command.servedInput != ServedInput::wish && command.servedInput != ServedInput::number;
    const bool readsWish =
        command.servedInput == ServedInput::wish || command.servedInput == ServedInput::documentAndWish;
    if (readsDocument) {
      const auto name = documentOf(params);
      if (!name) return unknownDocument();
      texts.first = writeMechanism(*m_documents.at(*name));
    }
    if (command.servedInput != ServedInput::number) words.emplace_back("-");
    if (readsWish) {
      const auto wish = params.member("wish");
      if (!wish || !wish->is(JsonKind::object))
        return Rejection{"request", "The member \"wish\" is an object."};
      (readsDocument ? texts.second : texts.first) = wish->slice();
      if (readsDocument) words.emplace_back(kSecondInput);
    }
    if (command.servedInput == ServedInput::twoDocuments && params.member("with")) {
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

  Answer run(const Command& command, const JsonValue& params) {
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
    if (auto rejection = wrongWord(command, words)) return *std::move(rejection);
    ServedTexts texts;
    if (auto rejection = addInputs(command, params, words, texts)) return *std::move(rejection);
    const ServedOutcome outcome = runServed(command, std::move(words), texts, m_limits);
    if (!outcome.status) return Rejection{"limit", outcome.failure};
    return objectOf([&](JsonWriter& json) {
      json.member("status", *outcome.status);
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

  static Rejection rejected(const Diagnostics& diagnostics) {
    return {codeName(diagnostics.front().code), diagnostics.front().message, diagnostics};
  }

  static std::string lineOf(const std::string& id, const Answer& answer) {
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

  ServedLimits m_limits;
  std::map<std::string, MechanismPtr> m_documents;
  int m_opened = 0;
};

/// The next line of standard input, without its end; none at the end, or where it is too long.
std::optional<std::string> nextLine() {
  std::string line;
  for (int c = std::cin.get(); c != std::char_traits<char>::eof(); c = std::cin.get()) {
    if (c == '\n') return line;
    line += static_cast<char>(c);
    if (line.size() > kLargestRequest) {
      std::cerr << "geargraph-cli: A request of over 128 MiB ends the program.\n";
      return std::nullopt;
    }
  }
  return line.empty() ? std::nullopt : std::optional(line);
}

int runServe(const Arguments& arguments) {
  if (!arguments.files.empty() || !arguments.has("--stdio"))
    return wrongUsage(kServe, "--stdio is needed, and no file.");
  const auto seconds = limitFrom(arguments);
  if (const auto* error = std::get_if<UsageError>(&seconds)) return wrongUsage(kServe, error->message);
  ServedLimits limits{std::get<0>(seconds), {}};
  if (const auto word = arguments.value("--limit-memory")) {
    limits.megabytes = numberFrom<std::size_t>(*word);
    constexpr std::size_t kMaxMegabytes = 1'000'000;
    if (!limits.megabytes || *limits.megabytes == 0 || *limits.megabytes > kMaxMegabytes)
      return wrongUsage(kServe, "--limit-memory takes whole megabytes from 1 to 1000000.");
  }
  Server server(limits);
  StandardOutput out;
  while (const auto line = nextLine()) {
    out.write(server.answerTo(*line) + '\n');
    if (out.failed()) return fileFailure("Standard output could not be written.");
  }
  return kFine;
}

/// "  addLink         [id], [name], ..."
std::string helpLine(std::string_view name, std::span<const ServedMember> members) {
  constexpr std::size_t kIndent = 18;
  std::string line = "  " + std::string(name);
  if (!members.empty()) {
    line.resize(std::max(line.size() + 1, kIndent), ' ');
    line += membersText(members);
  }
  return line + '\n';
}

/// Methods and edits with their members, for the help of the command.
std::string methodsHelp() {
  std::string text = '\n' + translated("Methods and their params; those in [ ] may be left out:") + '\n';
  for (const Server::Method& method : Server::ownMethods()) text += helpLine(method.name, method.members);
  for (const Command* const command : servedCommands()) text += helpLine(command->name, paramsOf(*command));
  text +=
      '\n' + translated("Edits and their members beside \"edit\"; null removes what may be left out:") + '\n';
  for (const ServedEdit& edit : servedEdits()) text += helpLine(edit.name, edit.members);
  return text;
}

constexpr std::array kServeOptions = {
    Option{"--stdio", "", toTranslate("requests on standard input, answers on standard output")},
    Option{"--limit-memory", "MB", toTranslate("of address space, for each command")},
};

}  // namespace

const Command kServe = {
    "serve",
    "--stdio [--limit-seconds S] [--limit-memory MB]",
    toTranslate("Answers requests, a JSON object a line: open, edit, analyze, export, ..."),
    kServeOptions,
    runServe,
    true,
    false,
    methodsHelp};

}  // namespace geargraph::cli
