#include "core/mechanism/model/patch.h"

#include <algorithm>
#include <array>
#include <bit>
#include <iterator>
#include <tuple>
#include <unordered_set>

#include "core/foundations/base/contract.h"
#include "core/mechanism/model/patch_bytes.h"

namespace geargraph {
namespace {

// --- texts ------------------------------------------------------------------------------------------------

std::optional<TextPatch> patchOf(const std::string& before, const std::string& after) {
  if (before == after) return std::nullopt;
  const std::size_t shorter = std::min(before.size(), after.size());
  const auto first =
      std::mismatch(before.begin(), before.begin() + static_cast<std::ptrdiff_t>(shorter), after.begin());
  const auto at = static_cast<std::size_t>(first.first - before.begin());
  std::size_t end = 0;
  while (end < shorter - at && before[before.size() - 1 - end] == after[after.size() - 1 - end]) ++end;
  return TextPatch{at, before.substr(at, before.size() - at - end),
                   after.substr(at, after.size() - at - end)};
}

void apply(const std::optional<TextPatch>& patch, std::string& text, bool forward) {
  if (!patch) return;
  const std::string& from = forward ? patch->before : patch->after;
  text.replace(patch->at, from.size(), forward ? patch->after : patch->before);
}

// --- lists ------------------------------------------------------------------------------------------------

InternedString keyOf(const Input& input) {
  return input.joint.atom();
}
const std::string& keyOf(const ShiftState& state) {
  return state.name;
}
template <class Element>
InternedString keyOf(const Element& element) {
  return element.id.atom();
}

/// Finds the runs in which two lists differ: elements are matched by their keys, and from where the order of
/// the keys differs, the rest is one run.
template <class Element>
class ListComparison {
 public:
  ListComparison(const std::vector<Element>& before, const std::vector<Element>& after)
      : m_before(before), m_after(after) {}

  ListPatch<Element> run() {
    const std::size_t shorter = std::min(m_before.size(), m_after.size());
    while (m_b < shorter && m_before[m_b] == m_after[m_b]) ++m_b;
    m_a = m_b;
    while (m_end < shorter - m_b &&
           m_before[m_before.size() - 1 - m_end] == m_after[m_after.size() - 1 - m_end]) {
      ++m_end;
    }
    compareMiddle();
    return std::move(m_patch);
  }

 private:
  using Key = std::decay_t<decltype(keyOf(std::declval<const Element&>()))>;

  [[nodiscard]] std::size_t beforeEnd() const { return m_before.size() - m_end; }
  [[nodiscard]] std::size_t afterEnd() const { return m_after.size() - m_end; }

  void compareMiddle() {
    std::unordered_set<Key> olds, news;
    for (std::size_t i = m_b; i < beforeEnd(); ++i) olds.insert(keyOf(m_before[i]));
    for (std::size_t i = m_a; i < afterEnd(); ++i) news.insert(keyOf(m_after[i]));
    while (m_b < beforeEnd() && m_a < afterEnd()) {
      const Element& old = m_before[m_b];
      const Element& now = m_after[m_a];
      if (keyOf(old) == keyOf(now)) {
        if (old == now) {
          ++m_b, ++m_a;
        } else {
          take(1, 1);
        }
      } else if (!news.contains(keyOf(old))) {
        take(1, 0);
      } else if (!olds.contains(keyOf(now))) {
        take(0, 1);
      } else {
        break;
      }
    }
    take(beforeEnd() - m_b, afterEnd() - m_a);
  }

  /// The next elements of both lists differ.
  void take(std::size_t olds, std::size_t news) {
    if (olds + news == 0) return;
    const bool goesOn = !m_patch.empty() && m_patch.back().beforeAt + m_patch.back().before.size() == m_b &&
                        m_patch.back().afterAt + m_patch.back().after.size() == m_a;
    if (!goesOn) m_patch.push_back({m_b, m_a, {}, {}});
    for (; olds > 0; --olds) m_patch.back().before.push_back(m_before[m_b++]);
    for (; news > 0; --news) m_patch.back().after.push_back(m_after[m_a++]);
  }

  const std::vector<Element>& m_before;
  const std::vector<Element>& m_after;
  std::size_t m_b = 0;
  std::size_t m_a = 0;
  std::size_t m_end = 0;  ///< equal elements at the ends
  ListPatch<Element> m_patch;
};

template <class List>
requires DescribedList<List>
auto patchOf(const List& before, const List& after) {
  return ListComparison<typename ElementOfList<List>::Type>(before, after).run();
}

template <class Element>
void apply(const ListPatch<Element>& patch, std::vector<Element>& list, bool forward) {
  if (patch.empty()) return;
  std::vector<Element> next;
  std::size_t taken = 0;
  const auto takeTo = [&](std::size_t end) {
    GEARGRAPH_REQUIRE(taken <= end && end <= list.size());
    for (; taken < end; ++taken) next.push_back(std::move(list[taken]));
  };
  for (const ListRun<Element>& run : patch) {
    const std::vector<Element>& gone = forward ? run.before : run.after;
    const std::vector<Element>& come = forward ? run.after : run.before;
    takeTo(forward ? run.beforeAt : run.afterAt);
    next.insert(next.end(), come.begin(), come.end());
    taken += gone.size();
  }
  takeTo(list.size());
  list = std::move(next);
}

const std::vector<Input> kNoInputs;

StatedListPatch<Input> patchOf(const std::optional<std::vector<Input>>& before,
                               const std::optional<std::vector<Input>>& after) {
  return {patchOf(before ? *before : kNoInputs, after ? *after : kNoInputs), before.has_value(),
          after.has_value()};
}

void apply(const StatedListPatch<Input>& patch, std::optional<std::vector<Input>>& inputs, bool forward) {
  std::vector<Input> next = inputs ? *inputs : kNoInputs;
  apply(patch.list, next, forward);
  inputs.reset();
  if (forward ? patch.isStatedAfter : patch.isStatedBefore) inputs = std::move(next);
}

// --- values, members and nodes ----------------------------------------------------------------------------

template <class Value>
requires(!DescribedList<Value>) ValuePatch<Value> patchOf(const Value& before, const Value& after) {
  return before == after ? std::nullopt : ValuePatch<Value>({before, after});
}

/// By their bits: a coordinate of -0 is written otherwise than one of 0.
ValuePatch<std::optional<ViewCamera>> patchOf(const std::optional<ViewCamera>& before,
                                              const std::optional<ViewCamera>& after) {
  const auto bits = [](const ViewCamera& camera) {
    std::array<std::uint64_t, 6> all{};
    for (std::size_t i = 0; i < 3; ++i) all[i] = std::bit_cast<std::uint64_t>(camera.target[i]);
    all[3] = std::bit_cast<std::uint64_t>(camera.azimuth);
    all[4] = std::bit_cast<std::uint64_t>(camera.elevation);
    all[5] = std::bit_cast<std::uint64_t>(camera.distance);
    return all;
  };
  if (before == after && (!before || bits(*before) == bits(*after))) return std::nullopt;
  return {{before, after}};
}

template <class Value>
void apply(const ValuePatch<Value>& patch, Value& value, bool forward) {
  if (patch) value = forward ? patch->second : patch->first;
}

MemberPatch memberPatch(const UnknownMembers& before, const UnknownMembers& after) {
  MemberPatch patch;
  const bool sameNames = std::equal(before.begin(), before.end(), after.begin(), after.end(),
                                    [](const auto& old, const auto& now) { return old.first == now.first; });
  if (!sameNames) {
    patch.replaced = {before, after};
    return patch;
  }
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (auto text = patchOf(before[i].second, after[i].second)) patch.changed.emplace_back(i, *text);
  }
  return patch;
}

void apply(const MemberPatch& patch, UnknownMembers& members, bool forward) {
  apply(patch.replaced, members, forward);
  for (const auto& [position, text] : patch.changed) apply(text, members[position].second, forward);
}

/// By the bits: a place of -0 is written otherwise than one of 0.
std::pair<std::uint64_t, std::uint64_t> bitsOf(const CanvasPoint& place) {
  return {std::bit_cast<std::uint64_t>(place.x), std::bit_cast<std::uint64_t>(place.y)};
}
int bitsOf(int number) {
  return number;
}

template <class Value>
MapPatch<Value> patchOf(const std::map<LinkId, Value>& before, const std::map<LinkId, Value>& after) {
  const auto byId = [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first < b.first : bitsOf(a.second) < bitsOf(b.second);
  };
  MapPatch<Value> patch;
  std::set_difference(before.begin(), before.end(), after.begin(), after.end(),
                      std::back_inserter(patch.before), byId);
  std::set_difference(after.begin(), after.end(), before.begin(), before.end(),
                      std::back_inserter(patch.after), byId);
  return patch;
}

template <class Value>
void apply(const MapPatch<Value>& patch, std::map<LinkId, Value>& values, bool forward) {
  for (const auto& entry : forward ? patch.before : patch.after) values.erase(entry.first);
  const auto& come = forward ? patch.after : patch.before;
  values.insert(come.begin(), come.end());
}

// --- objects ----------------------------------------------------------------------------------------------

template <class Object>
ObjectPatch<Object> objectPatch(const Object& before, const Object& after);

ObjectPatch<View> patchOf(const View& before, const View& after) {
  return objectPatch(before, after);
}

template <class Object>
ObjectPatch<Object> objectPatch(const Object& before, const Object& after) {
  return std::apply(
      [&](const auto&... fields) {
        return ObjectPatch<Object>{{patchOf(before.*fields.member, after.*fields.member)...},
                                   memberPatch(before.unknown, after.unknown)};
      },
      Description<Object>::fields);
}

template <class Object>
void apply(const ObjectPatch<Object>& patch, Object& object, bool forward) {
  constexpr std::size_t kFields = std::tuple_size_v<decltype(patch.fields)>;
  [&]<std::size_t... at>(std::index_sequence<at...>) {
    (apply(std::get<at>(patch.fields), object.*std::get<at>(Description<Object>::fields).member, forward),
     ...);
  }
  (std::make_index_sequence<kFields>());
  apply(patch.members, object.unknown, forward);
}

template <class Value>
bool isNothing(const std::optional<Value>& patch) {
  return !patch;
}
template <class Element>
bool isNothing(const std::vector<Element>& patch) {
  return patch.empty();
}
bool isNothing(const StatedListPatch<Input>& patch) {
  return patch.list.empty() && patch.isStatedBefore == patch.isStatedAfter;
}
bool isNothing(const MemberPatch& patch) {
  return patch.changed.empty() && !patch.replaced;
}
template <class Value>
bool isNothing(const MapPatch<Value>& patch) {
  return patch.before.empty() && patch.after.empty();
}
template <class Object>
bool isNothing(const ObjectPatch<Object>& patch) {
  return isNothing(patch.members) &&
         std::apply([](const auto&... fields) { return (isNothing(fields) && ...); }, patch.fields);
}

}  // namespace

struct MechanismPatch::Parts : ObjectPatch<Mechanism> {
  explicit Parts(ObjectPatch<Mechanism> patch) : ObjectPatch<Mechanism>(std::move(patch)) {}
};

MechanismPatch::MechanismPatch(const Mechanism& before, const Mechanism& after)
    : m_parts(std::make_shared<const Parts>(objectPatch(before, after))), m_isEmpty(isNothing(*m_parts)) {
  ByteCount bytes;
  bytes.add(*m_parts);
  m_bytes = sizeof(MechanismPatch) + sizeof(Parts) + bytes.total();
}

Mechanism MechanismPatch::forward(Mechanism before) const {
  apply<Mechanism>(*m_parts, before, true);
  return before;
}

Mechanism MechanismPatch::back(Mechanism after) const {
  apply<Mechanism>(*m_parts, after, false);
  return after;
}

}  // namespace geargraph
