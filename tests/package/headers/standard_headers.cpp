// Compiled for the headers of CMakeLists.txt, of which this source needs none.
