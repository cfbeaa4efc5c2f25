// Stands for a geargraph-step that crashes halfway.

#include <cstdio>
#include <cstdlib>

int main() {
  std::fputs("done 0.5\n", stderr);
  std::fputs("ISO-10303-21;\n", stdout);
  std::fflush(stdout);
  std::abort();
}
