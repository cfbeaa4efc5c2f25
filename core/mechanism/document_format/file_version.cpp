#include "core/mechanism/document_format/file_version.h"

#include <algorithm>

#include "core/mechanism/model/fields.h"

namespace geargraph {
namespace {

/// Visits the members that a document states, as the writer does.
class VersionFinder {
 public:
  template <class Object>
  void visit(const Object& object) {
    static const Object kDefault{};
    forEachField<Object>([&]<class Member>(const Member& field) {
      // Which members of a composite value are stated has to be decided in a function of its own.
      static_assert(!hasLaterPart<Member, Object>());
      const auto& value = object.*field.member;
      const MemberInfo& info = field.info();
      if (info.since > m_version && !(value == kDefault.*field.member)) m_version = info.since;
      inside(value);
    });
    if constexpr (std::is_same_v<Object, ShiftElement>) {  // the kind is stated beside the links
      constexpr int kFreewheels = 2;
      if (object.kind == ShiftElementKind::freewheel) m_version = std::max(m_version, kFreewheels);
    }
  }

  [[nodiscard]] int version() const { return m_version; }

 private:
  /// Did a part of a value that several members state together come later than the others?
  template <class Member, class Object>
  static constexpr bool hasLaterPart() {
    if constexpr (Member::kCount == 1) return false;
    bool found = false;
    forEachField<Object>([&]<class Other>(const Other& field) {
      if constexpr (std::is_same_v<Other, Member>) {
        for (const MemberInfo& info : field.infos) found = found || info.since > 1;
      }
    });
    return found;
  }

  template <class Value>
  void inside(const Value& value) {
    if constexpr (DescribedList<Value>) {
      for (const auto& element : value) visit(element);
    } else if constexpr (Described<Value>) {
      visit(value);
    } else if constexpr (requires { value.has_value(); }) {
      if (value) inside(*value);
    } else if constexpr (std::is_same_v<Value, MeshKind>) {
      m_version = std::max(m_version, pairKind(value).since);
    }
  }

  int m_version = 1;
};

}  // namespace

int fileVersionOf(const Mechanism& mechanism) {
  VersionFinder finder;
  finder.visit(mechanism);
  return finder.version();
}

}  // namespace geargraph
