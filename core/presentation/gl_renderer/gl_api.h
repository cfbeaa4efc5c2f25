#pragma once

#include <GL/glcorearb.h>

#include <functional>
#include <string>

namespace geargraph {

// clang-format off
#define GEARGRAPH_GL_FUNCTIONS(F) \
  F(ACTIVETEXTURE, ActiveTexture) F(ATTACHSHADER, AttachShader) F(BINDATTRIBLOCATION, BindAttribLocation) \
  F(BINDBUFFER, BindBuffer) F(BINDFRAMEBUFFER, BindFramebuffer) F(BINDRENDERBUFFER, BindRenderbuffer) \
  F(BINDTEXTURE, BindTexture) F(BINDVERTEXARRAY, BindVertexArray) F(BLENDEQUATION, BlendEquation) \
  F(BLENDFUNCSEPARATE, BlendFuncSeparate) F(BLITFRAMEBUFFER, BlitFramebuffer) F(BUFFERDATA, BufferData) \
  F(BUFFERSUBDATA, BufferSubData) F(CHECKFRAMEBUFFERSTATUS, CheckFramebufferStatus) F(CLEAR, Clear) \
  F(CLEARCOLOR, ClearColor) F(COLORMASK, ColorMask) F(COMPILESHADER, CompileShader) \
  F(CREATEPROGRAM, CreateProgram) F(CREATESHADER, CreateShader) F(CULLFACE, CullFace) \
  F(DELETEBUFFERS, DeleteBuffers) F(DELETEFRAMEBUFFERS, DeleteFramebuffers) F(DELETEPROGRAM, DeleteProgram) \
  F(DELETERENDERBUFFERS, DeleteRenderbuffers) F(DELETESHADER, DeleteShader) F(DELETETEXTURES, DeleteTextures) \
  F(DELETEVERTEXARRAYS, DeleteVertexArrays) F(DEPTHFUNC, DepthFunc) F(DEPTHMASK, DepthMask) \
  F(DISABLE, Disable) F(DRAWARRAYS, DrawArrays) F(DRAWELEMENTSINSTANCED, DrawElementsInstanced) \
  F(ENABLE, Enable) F(VERTEXATTRIBDIVISOR, VertexAttribDivisor) F(ENABLEVERTEXATTRIBARRAY, EnableVertexAttribArray) F(FINISH, Finish) F(FRAMEBUFFERRENDERBUFFER, FramebufferRenderbuffer) \
  F(FRAMEBUFFERTEXTURE2D, FramebufferTexture2D) F(GENBUFFERS, GenBuffers) F(GENFRAMEBUFFERS, GenFramebuffers) \
  F(GENRENDERBUFFERS, GenRenderbuffers) F(GENTEXTURES, GenTextures) F(GENVERTEXARRAYS, GenVertexArrays) \
  F(GETERROR, GetError) F(GETINTEGERV, GetIntegerv) F(GETPROGRAMINFOLOG, GetProgramInfoLog) \
  F(GETPROGRAMIV, GetProgramiv) F(GETSHADERINFOLOG, GetShaderInfoLog) F(GETSHADERIV, GetShaderiv) \
  F(GETSTRING, GetString) F(GETUNIFORMLOCATION, GetUniformLocation) F(ISENABLED, IsEnabled) F(LINKPROGRAM, LinkProgram) \
  F(PIXELSTOREI, PixelStorei) F(POLYGONOFFSET, PolygonOffset) F(READPIXELS, ReadPixels) \
  F(RENDERBUFFERSTORAGEMULTISAMPLE, RenderbufferStorageMultisample) F(SHADERSOURCE, ShaderSource) \
  F(STENCILFUNC, StencilFunc) F(STENCILOP, StencilOp) F(STENCILOPSEPARATE, StencilOpSeparate) \
  F(TEXIMAGE2D, TexImage2D) F(TEXPARAMETERI, TexParameteri) F(UNIFORM1F, Uniform1f) F(UNIFORM1I, Uniform1i) \
  F(UNIFORM2F, Uniform2f) F(UNIFORM3F, Uniform3f) F(UNIFORM4F, Uniform4f) F(UNIFORMMATRIX4FV, UniformMatrix4fv) \
  F(USEPROGRAM, UseProgram) F(VERTEXATTRIBPOINTER, VertexAttribPointer) F(VIEWPORT, Viewport)
// clang-format on

/// The functions of OpenGL 3.3 core that the renderer calls, found at run time: `gl.Clear(...)` is glClear.
struct GlApi {
#define GEARGRAPH_GL_MEMBER(TYPE, Name) PFNGL##TYPE##PROC Name = nullptr;
  GEARGRAPH_GL_FUNCTIONS(GEARGRAPH_GL_MEMBER)
#undef GEARGRAPH_GL_MEMBER

  /// Loads all functions. Returns the name of the first missing one, or an empty text.
  [[nodiscard]] std::string load(const std::function<void*(const char*)>& getProcAddress);
};

}  // namespace geargraph
