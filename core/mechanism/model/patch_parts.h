#pragma once

#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "core/mechanism/model/fields.h"

namespace geargraph {

/// The difference between two texts: the part between their common prefix and suffix.
struct TextPatch {
  std::size_t at = 0;  ///< length of the common prefix in bytes
  std::string before;
  std::string after;
};

/// A run of elements of a list replaced by others, with its position in either list.
template <class Element>
struct ListRun {
  std::size_t beforeAt = 0;
  std::size_t afterAt = 0;
  std::vector<Element> before;
  std::vector<Element> after;
};

/// Ascending runs, with equal elements between them.
template <class Element>
using ListPatch = std::vector<ListRun<Element>>;

/// Of a list that may be left out.
template <class Element>
struct StatedListPatch {
  ListPatch<Element> list;
  bool isStatedBefore = false;
  bool isStatedAfter = false;
};

/// The old and the new value of what is replaced as a whole; none if they are equal.
template <class Value>
using ValuePatch = std::optional<std::pair<Value, Value>>;

/// Unknown members: the changed texts, by position, if both versions have the same members; else all of them.
struct MemberPatch {
  std::vector<std::pair<std::size_t, TextPatch>> changed;
  ValuePatch<UnknownMembers> replaced;
};

/// Values by link, such as places of nodes.
template <class Value>
struct MapPatch {
  using Entry = std::pair<LinkId, Value>;
  std::vector<Entry> before;  ///< gone or another
  std::vector<Entry> after;   ///< new or another
};

template <class Object>
struct ObjectPatch;

/// How the difference between two values of a member is kept.
template <class Value>
struct PatchOf {
  using Type = ValuePatch<Value>;
};
template <>
struct PatchOf<std::string> {
  using Type = std::optional<TextPatch>;
};
template <class List>
requires DescribedList<List>
struct PatchOf<List> {
  using Type = ListPatch<typename ElementOfList<List>::Type>;
};
template <>
struct PatchOf<std::optional<std::vector<Input>>> {
  using Type = StatedListPatch<Input>;
};
template <class Value>
struct PatchOf<std::map<LinkId, Value>> {
  using Type = MapPatch<Value>;
};
template <>
struct PatchOf<View> {
  using Type = ObjectPatch<View>;
};

template <class Fields>
struct PatchesOf;
template <class... Fields>
struct PatchesOf<std::tuple<Fields...>> {
  using Type = std::tuple<typename PatchOf<typename Fields::Value>::Type...>;
};

/// The differences of all members of an object, in the order of its description.
template <class Object>
struct ObjectPatch {
  typename PatchesOf<std::remove_cvref_t<decltype(Description<Object>::fields)>>::Type fields;
  MemberPatch members;
};

}  // namespace geargraph
