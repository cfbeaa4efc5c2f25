# Python and pybind11, for app/python and its tests.

set(GEARGRAPH_PYTHON_EXECUTABLE "" CACHE FILEPATH "The Python that the module is built for; empty: the distribution's")
if(GEARGRAPH_PYTHON_EXECUTABLE)
  set(Python_EXECUTABLE ${GEARGRAPH_PYTHON_EXECUTABLE})
elseif(EXISTS /usr/bin/python3)
  set(Python_EXECUTABLE /usr/bin/python3)   # its modules are packages of the distribution
endif()
find_package(Python 3.9 REQUIRED COMPONENTS Interpreter Development.Module)
find_package(pybind11 2.10 CONFIG REQUIRED)
