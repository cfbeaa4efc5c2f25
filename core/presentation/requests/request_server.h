#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/foundations/base/diagnostic.h"
#include "core/foundations/files/json.h"
#include "core/mechanism/model/mechanism.h"
#include "core/presentation/exporters/option_values.h"
#include "core/presentation/requests/edit_members.h"

namespace geargraph {

/// What a method reads besides its options.
enum class MethodInput {
  document,         ///< one that is open
  documentAndWish,  ///< also a wish, which is a member of the request
  twoDocuments,     ///< maybe another one, after --with
  wish,
  number  ///< of a chain of the atlas, or nothing
};

/// A method that the program around the server answers, with options as texts.
struct HostedMethod {
  std::string_view name;
  MethodInput input = MethodInput::document;
  std::vector<OptionText> options = {};               ///< those of a request
  std::vector<std::string_view> refusedOptions = {};  ///< those that would read or write files
};

/// What a hosted method reads: "-" among its words is the first text, kSecondInput the second.
struct HostedTexts {
  std::string first;
  std::string second;
};
constexpr std::string_view kSecondInput = "/second input/";

/// The result of a hosted method.
struct HostedOutcome {
  std::optional<int> status;  ///< as of a command; std::nullopt if it was ended at a limit or crashed
  std::string output;
  std::string messages;  ///< what a command writes to standard error
  std::string failure;   ///< why there is no status, as a sentence
  std::string_view failureCode = "limit";
  /// Files of a folder that it has written, by their paths within the folder with slashes.
  std::optional<std::vector<std::pair<std::string, std::string>>> files = std::nullopt;
};

using RunHosted = std::function<HostedOutcome(const HostedMethod& method, std::vector<std::string> words,
                                              const HostedTexts& texts)>;

/// Why a request was not answered.
struct Rejection {
  std::string_view code;  ///< "request", "unknown-document", "limit", or that of the first diagnostic
  std::string message;
  Diagnostics diagnostics = {};
};

/// Holds documents and answers requests about them, one JSON object each (resources/schema/README.md). It
/// reads and writes nothing itself and starts no process: what is computed about a document is asked of the
/// program around it.
class RequestServer {
 public:
  RequestServer(std::vector<HostedMethod> hosted, RunHosted run);

  /// The line of the answer, without its end. Never throws but std::bad_alloc: what is wrong with a request
  /// is its answer.
  [[nodiscard]] std::string answerTo(const std::string& line);

 private:
  /// A result as JSON, or a rejection.
  using Answer = std::variant<std::string, Rejection>;
  /// A method of the server's own.
  struct Method {
    std::string_view name;
    std::span<const RequestMember> members;
    Answer (RequestServer::*answer)(const JsonValue& params);
  };
  friend std::string requestMethodsText(std::span<const HostedMethod> hosted);

  static std::span<const Method> ownMethods();
  static const Method* methodNamed(std::string_view name);

  Answer answerTo(const JsonValue& request);
  Answer help(const JsonValue& params);
  Answer open(const JsonValue& params);
  Answer edit(const JsonValue& params);
  Answer text(const JsonValue& params);
  Answer close(const JsonValue& params);
  Answer run(const HostedMethod& method, const JsonValue& params);
  /// Adds the words by which the method reads what the request gives it.
  [[nodiscard]] std::optional<Rejection> addInputs(const HostedMethod& method, const JsonValue& params,
                                                   std::vector<std::string>& words, HostedTexts& texts) const;
  [[nodiscard]] std::optional<std::string> documentOf(const JsonValue& params,
                                                      std::string_view member = "document") const;
  static std::string lineOf(const std::string& id, const Answer& answer);

  std::vector<HostedMethod> m_hosted;
  RunHosted m_run;
  std::map<std::string, MechanismPtr> m_documents;
  int m_opened = 0;
};

/// Methods and edits with their members, for the help of a command, in the current language.
[[nodiscard]] std::string requestMethodsText(std::span<const HostedMethod> hosted);

}  // namespace geargraph
