#include "core/design/teeth_check/certificate_reader.h"

#include <optional>

#include "core/foundations/base/translation.h"
#include "core/foundations/files/json.h"
#include "core/mechanism/document_format/mechanism_file.h"

namespace geargraph {
namespace {

class CertificateReader {
 public:
  explicit CertificateReader(JsonValue root) : m_root(root) {}

  Expected<TeethCertificate> run() {
    const auto format = m_root.is(JsonKind::object) ? m_root.member("format") : std::nullopt;
    if (!format || !format->is(JsonKind::string) || !format->equals("geargraph-teeth-certificate"))
      return failure(Code::format, translated("This is no certificate of teeth."), "/format");
    if (const auto version = m_root.member("version"); !version || version->slice() != "1")
      return failure(Code::version, translated("The certificate is newer than this program."), "/version");
    const auto problem = m_root.member("problem");
    const auto document =
        problem && problem->is(JsonKind::object) ? problem->member("document") : std::nullopt;
    const auto wish = problem && problem->is(JsonKind::object) ? problem->member("wish") : std::nullopt;
    if (!document || !wish) return wrong("/problem");
    m_read.problem = problem->compact();
    auto mechanism = readMechanism(document->slice());
    if (!mechanism) return mechanism.error();
    m_read.mechanism = *std::move(mechanism);
    auto wished = readTeethWish(wish->slice(), m_read.mechanism);
    if (!wished) return wished.error();
    m_read.wish = *std::move(wished);
    const auto mark = m_root.member("mark");
    if (!mark || !mark->is(JsonKind::string)) return wrong("/mark");
    m_read.mark = mark->string();
    if (!readWheels()) return wrong("/wheels");
    if (!readWholes(m_root.member("order"), m_read.order, wheelCount() - 1)) return wrong("/order");
    if (!readFirst()) return wrong("/first");
    if (!readRatios()) return wrong("/ratios");
    if (!readCounts(m_root.member("counts"), 0, m_read.counts)) return wrong("/counts");
    if (!readBranches()) return wrong("/branches");
    if (!readChoices()) return wrong("/choices");
    return std::move(m_read);
  }

 private:
  static Diagnostic failure(Code code, std::string message, std::string pointer) {
    return {code, std::move(message), {}, std::move(pointer), 0, 0};
  }
  static Diagnostic wrong(const std::string& pointer) {
    return failure(Code::schema, translated("%1 is not what a certificate has there.", {pointer}), pointer);
  }
  [[nodiscard]] int wheelCount() const { return static_cast<int>(m_read.wheels.size()); }

  static std::optional<std::int64_t> wholeOf(JsonValue value) {
    const auto number = value.is(JsonKind::number) ? Rational::fromText(value.slice()) : std::nullopt;
    if (!number || !number->isInteger() || fmpz_fits_si(fmpq_numref(number->flint())) == 0)
      return std::nullopt;
    return fmpz_get_si(fmpq_numref(number->flint()));
  }

  /// From 0 to `most`.
  static bool readWholes(const std::optional<JsonValue>& list, std::vector<int>& into, std::int64_t most) {
    if (!list || !list->is(JsonKind::array)) return false;
    bool isRight = true;
    list->forEachElement([&](JsonValue each, std::size_t /*position*/) {
      const auto number = wholeOf(each);
      isRight = isRight && number && *number >= 0 && *number <= most;
      if (isRight) into.push_back(static_cast<int>(*number));
    });
    return isRight;
  }

  std::optional<int> endNamed(const std::string& name) const {
    for (MeshOrdinal mesh = 0; mesh < m_read.mechanism.c(); ++mesh) {
      const std::string label = std::to_string(m_read.mechanism.meshLabel(mesh));
      if (name == label + ":tail") return 2 * mesh;
      if (name == label + ":head") return 2 * mesh + 1;
    }
    return std::nullopt;
  }

  bool readWheels() {
    const auto list = m_root.member("wheels");
    if (!list || !list->is(JsonKind::array)) return false;
    bool isRight = true;
    list->forEachElement([&](JsonValue each, std::size_t /*position*/) {
      isRight = isRight && each.is(JsonKind::object) && readWheel(each);
    });
    return isRight;
  }
  bool readWheel(JsonValue value) {
    const auto ends = value.member("ends");
    const auto copies = value.member("copies");
    if (!ends || !ends->is(JsonKind::array) || !copies) return false;
    const std::int64_t count = wholeOf(*copies).value_or(0);
    if (count < 1 || count > kMaxTeeth) return false;
    TeethCertificate::Wheel wheel;
    wheel.copies = static_cast<int>(count);
    bool isRight = true;
    ends->forEachElement([&](JsonValue name, std::size_t /*position*/) {
      const int end = name.is(JsonKind::string) ? endNamed(name.string()).value_or(-1) : -1;
      isRight = isRight && end >= 0;
      wheel.ends.push_back(end);
    });
    m_read.wheels.push_back(std::move(wheel));
    return isRight;
  }

  bool readFirst() {
    const auto first = m_root.member("first");
    if (!first) return false;
    if (first->is(JsonKind::null)) return true;
    const auto wheel = wholeOf(*first);
    if (!wheel || *wheel < 0 || *wheel >= wheelCount()) return false;
    m_read.first = static_cast<int>(*wheel);
    return true;
  }

  bool readTerms(const std::optional<JsonValue>& list, std::vector<TeethCertificate::Term>& into) const {
    if (!list || !list->is(JsonKind::array)) return false;
    bool isRight = true;
    list->forEachElement([&](JsonValue each, std::size_t /*position*/) {
      if (!each.is(JsonKind::array) || each.size() != 2) {
        isRight = false;
        return;
      }
      TeethCertificate::Term term;
      const auto factor = wholeOf(*each.element(0));
      isRight = isRight && factor && readWholes(each.element(1), term.wheels, wheelCount() - 1);
      if (!isRight) return;
      term.factor = *factor;
      into.push_back(std::move(term));
    });
    return isRight;
  }

  bool readRatios() {
    const auto list = m_root.member("ratios");
    if (!list || !list->is(JsonKind::array) || list->size() != m_read.wish.ratios.size()) return false;
    bool isRight = true;
    list->forEachElement([&](JsonValue each, std::size_t /*position*/) {
      TeethCertificate::Ratio ratio;
      isRight = isRight && each.is(JsonKind::object) &&
                readTerms(each.member("numerator"), ratio.numerator) &&
                readTerms(each.member("denominator"), ratio.denominator);
      m_read.ratios.push_back(std::move(ratio));
    });
    return isRight;
  }

  static bool readCounts(const std::optional<JsonValue>& list, std::size_t from,
                         TeethCertificate::Counts& into) {
    if (!list || !list->is(JsonKind::array) || list->size() != from + into.size()) return false;
    for (std::size_t i = 0; i < into.size(); ++i) {
      const auto number = wholeOf(*list->element(from + i));
      if (!number) return false;
      into[i] = *number;
    }
    return true;
  }

  bool readBranches() {
    const auto list = m_root.member("branches");
    if (!list || !list->is(JsonKind::array)) return false;
    bool isRight = true;
    list->forEachElement([&](JsonValue each, std::size_t /*position*/) {
      TeethCertificate::Branch branch;
      const auto teeth = each.is(JsonKind::array) ? each.element(0) : std::nullopt;
      const auto number = teeth ? wholeOf(*teeth) : std::nullopt;
      isRight =
          isRight && number && *number >= 0 && *number <= kMaxTeeth && readCounts(each, 1, branch.counts);
      if (!isRight) return;
      branch.teeth = static_cast<int>(*number);
      m_read.branches.push_back(branch);
    });
    return isRight;
  }

  static bool readFractions(const std::optional<JsonValue>& list, std::vector<Rational>& into) {
    if (!list || !list->is(JsonKind::array)) return false;
    bool isRight = true;
    list->forEachElement([&](JsonValue each, std::size_t /*position*/) {
      const auto number = each.is(JsonKind::string) ? Rational::fromText(each.string()) : std::nullopt;
      isRight = isRight && number;
      if (number) into.push_back(*number);
    });
    return isRight;
  }

  bool readChoices() {
    const auto list = m_root.member("choices");
    if (!list || !list->is(JsonKind::array)) return false;
    bool isRight = true;
    list->forEachElement([&](JsonValue each, std::size_t /*position*/) {
      TeethCertificate::Choice choice;
      isRight = isRight && each.is(JsonKind::object) &&
                readWholes(each.member("teeth"), choice.teeth, kMaxTeeth) &&
                choice.teeth.size() == m_read.wheels.size() &&
                readFractions(each.member("ratios"), choice.ratios) &&
                readFractions(each.member("errors"), choice.errors);
      m_read.choices.push_back(std::move(choice));
    });
    return isRight;
  }

  JsonValue m_root;
  TeethCertificate m_read;
};

}  // namespace

Expected<TeethCertificate> readTeethCertificate(std::string_view text) {
  const auto document = JsonDocument::parse(text);
  if (!document) return document.error();
  return CertificateReader(document->root()).run();
}

}  // namespace geargraph
