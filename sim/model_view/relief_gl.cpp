#include "sim/model_view/relief_gl.h"

#ifdef MOONTRACE_HAVE_GL
#include <GL/gl.h>
#endif

namespace moontrace {

#ifdef MOONTRACE_HAVE_GL

namespace {

/// What else decides how a point is drawn.
constexpr GLenum kOff[] = {GL_LIGHTING,      GL_TEXTURE_2D, GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_T,
                           GL_TEXTURE_GEN_R, GL_CULL_FACE,  GL_STENCIL_TEST,  GL_SCISSOR_TEST,
                           GL_FOG,           GL_ALPHA_TEST, GL_COLOR_MATERIAL};
constexpr GLenum kStacks[] = {GL_PROJECTION, GL_MODELVIEW};

/// Newer MuJoCo's may be from 0 to 1, OpenGL's own is from -1.
bool DepthBeginsAtZero() {
  constexpr GLenum kClipDepthMode = 0x935D;
  constexpr GLint kZeroToOne = 0x935F;
  GLint mode = 0;
  glGetIntegerv(kClipDepthMode, &mode);
  glGetError();  // older OpenGL does not know it
  return mode == kZeroToOne;
}

}  // namespace

bool DepthIsReversed() {
  GLfloat cleared_to = 1;
  glGetFloatv(GL_DEPTH_CLEAR_VALUE, &cleared_to);
  return cleared_to < 0.5F;
}

void LeaveNoTexture() {
  constexpr GLenum kTextures[] = {GL_TEXTURE_2D,    GL_TEXTURE_CUBE_MAP, GL_TEXTURE_GEN_S,
                                  GL_TEXTURE_GEN_T, GL_TEXTURE_GEN_R,    GL_TEXTURE_GEN_Q};
  constexpr GLenum kUnits[] = {GL_TEXTURE1, GL_TEXTURE0};  // the last stays chosen
  for (const GLenum unit : kUnits) {
    glActiveTexture(unit);
    for (const GLenum texture : kTextures) glDisable(texture);
  }
}

void DrawRelief(const std::vector<DrawnPoint>& points, const std::vector<std::uint32_t>& triangles,
                mjrRect rect) {
  if (triangles.empty()) return;
  glPushAttrib(GL_ALL_ATTRIB_BITS);
  glPushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
  for (const GLenum off : kOff) {
    glDisable(off);
  }
  glShadeModel(GL_SMOOTH);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glEnable(GL_BLEND);
  glBlendFunc(GL_DST_COLOR, GL_SRC_COLOR);  // twice their product
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(DepthIsReversed() ? GL_GEQUAL : GL_LEQUAL);
  glDepthMask(GL_FALSE);
  glViewport(rect.left, rect.bottom, rect.width, rect.height);
  for (const GLenum stack : kStacks) {
    glMatrixMode(stack);
    glPushMatrix();
    glLoadIdentity();
  }
  if (DepthBeginsAtZero()) {
    const GLfloat halved[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0.5F, 0, 0, 0, 0.5F, 1};
    glLoadMatrixf(halved);
  }
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_COLOR_ARRAY);
  glDisableClientState(GL_NORMAL_ARRAY);
  glDisableClientState(GL_TEXTURE_COORD_ARRAY);
  glVertexPointer(4, GL_FLOAT, sizeof(DrawnPoint), points.data()->clip);
  glColorPointer(3, GL_FLOAT, sizeof(DrawnPoint), points.data()->factor);
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(triangles.size()), GL_UNSIGNED_INT,
                 triangles.data());
  for (const GLenum stack : kStacks) {
    glMatrixMode(stack);
    glPopMatrix();
  }
  glPopClientAttrib();
  glPopAttrib();
}

#else

bool DepthIsReversed() { return false; }
void LeaveNoTexture() {}
void DrawRelief(const std::vector<DrawnPoint>& /*points*/,
                const std::vector<std::uint32_t>& /*triangles*/, mjrRect /*rect*/) {}

#endif

}  // namespace moontrace
