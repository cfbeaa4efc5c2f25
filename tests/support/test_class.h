#pragma once

#include <QTest>

/// In unity builds one program holds the tests of a group, and this header stands before each source of its
/// batches: QTEST_MAIN and its kin then add a test class to the program, whose main() runs the one that its
/// first argument names.
namespace geargraph::test {

/// @return true: initialising the result adds the class.
/// @param file  the source; its name without folder and ending is the name to run the class by
bool addTestClass(const char* file, int (*run)(int count, char** words));

template <typename Class>
struct TestClass {
  static const bool added;
};

}  // namespace geargraph::test

#ifndef QTEST_MAIN_WRAPPER
#error "This Qt builds QTEST_MAIN in another way; configure with GEARGRAPH_UNITY=OFF."
#endif
#undef QTEST_MAIN_WRAPPER
#define QTEST_MAIN_WRAPPER(Class, ...)                                    \
  template <>                                                             \
  const bool geargraph::test::TestClass<Class>::added =                   \
      geargraph::test::addTestClass(__FILE__, [](int argc, char** argv) { \
        QT_PREPEND_NAMESPACE(QTest::Internal::callInitMain)<Class>();     \
        __VA_ARGS__                                                       \
        Class test;                                                       \
        QTEST_SET_MAIN_SOURCE_PATH                                        \
        return QTest::qExec(&test, argc, argv);                           \
      });
