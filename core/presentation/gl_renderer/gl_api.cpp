#include "core/presentation/gl_renderer/gl_api.h"

namespace geargraph {

std::string GlApi::load(const std::function<void*(const char*)>& getProcAddress) {
#define GEARGRAPH_GL_LOAD(TYPE, Name)                                                  \
  Name = reinterpret_cast<PFNGL##TYPE##PROC>(getProcAddress("gl" #Name)); /* NOLINT */ \
  if (Name == nullptr) return "gl" #Name;
  GEARGRAPH_GL_FUNCTIONS(GEARGRAPH_GL_LOAD)
#undef GEARGRAPH_GL_LOAD
  return {};
}

}  // namespace geargraph
