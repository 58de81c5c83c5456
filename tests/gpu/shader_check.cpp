// What the vertex shader makes of blending surfaces, beside the core: draws into buffers by transform feedback, through
// the very textures that the stage uploads. Prints one JSON object a line; the browser's test reads them.

#include <emscripten/html5.h>
#include <webgl/webgl2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "knotwork/surface/blending_surface.h"
#include "web/shader_sources.h"
#include "web/surface_textures.h"

namespace knotwork::web {
namespace {

using std::numbers::pi;

struct Case {
  std::string name;
  std::variant<BlendingSurface, BSplineSurface> surface;
  bool smooth = true;  ///< partials do not jump, so that there are normals to compare
  double nudge = 0;    ///< a deliberate error in one map, model units
  int samples = 48;    ///< steps a direction
};

KnotVector even(int n, Topology topology, const Interval& range) {
  return KnotVector::uniform(1, n, topology, range.start, range.end).value();
}

/// Over the whole model, with some locals moved, turned and stretched.
BlendingSurface moved_surface(const ModelSurface& model, int n_u, int n_v, Topology topology_u, Topology topology_v,
                              LocalSurfaces shape) {
  const SurfaceDomain where = domain(model);
  const KnotVector u = even(n_u, topology_u, where.u), v = even(n_v, topology_v, where.v);
  BlendingSurface surface =
      BlendingSurface::make(model, u, v, BlendingFunction::make(BlendingKind::polynomial2).value(),
                            BlendingSurface::unmoved_locals(model, u, v), shape)
          .value();
  for (int k = 0; k < n_u * n_v; k += 2) {
    const int i = k / n_v, j = k % n_v;
    const Eigen::AngleAxisd turn(0.4 * std::sin(1.0 + k), Eigen::Vector3d(1, 0.5, k % 3).normalized());
    const Eigen::Translation3d shift(0.1 * std::cos(2.0 * k), 0.1 * std::sin(3.0 * k), 0.2);
    surface.set_local(i, j, shift * surface.local(i, j) * turn * Eigen::Scaling(1.2, 0.9, 1.0));
  }
  return surface;
}

/// Over knots of which some coincide where the direction is open.
BSplineSurface net_surface(int p, int q, Topology topology_u, Topology topology_v) {
  const auto knots = [](int degree, Topology topology) {
    const KnotVector even = KnotVector::uniform(degree, 7, topology, 0, 3).value();
    if (topology == Topology::closed) return even;
    std::vector<double> t(even.knots().begin(), even.knots().end());
    t[static_cast<std::size_t>(degree) + 1] += 0.2;
    t[static_cast<std::size_t>(degree) + 2] = t[static_cast<std::size_t>(degree) + 1];
    return KnotVector::make(degree, topology, t).value();
  };
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 7; ++i) {
    for (int j = 0; j < 7; ++j) {
      const double a = 2 * pi * i / 7, b = 2 * pi * j / 7, r = 1 + 0.45 * std::cos(b) + 0.1 * std::sin(3.0 * i + j);
      points.emplace_back(r * std::cos(a), r * std::sin(a), 0.45 * std::sin(b) + 0.05 * std::cos(2.0 * i - j));
    }
  }
  return BSplineSurface::make(knots(p, topology_u), knots(q, topology_v), points).value();
}

std::vector<Case> all_cases() {
  constexpr Topology open = Topology::open, closed = Topology::closed;
  constexpr LocalSurfaces sub{}, hermite{LocalSurfaceKind::bezier_hermite, 3, 3},
      uneven{LocalSurfaceKind::bezier_hermite, 2, 3};
  const ModelSurface torus = torus_surface(1, 0.4, 0.4);
  const auto model = [](const char* name) { return ModelSurface(make_catalogue_surface(name).value()); };
  std::vector<Case> cases;
  for (const auto& [kind, shape] : {std::pair("", sub), std::pair(", Bezier-Hermite", hermite)}) {
    const std::string rest = kind;
    cases.push_back({"plane" + rest, moved_surface(torus, 3, 4, open, open, shape)});
    cases.push_back({"cylinder" + rest, moved_surface(torus, 3, 4, open, closed, shape)});
    cases.push_back({"torus" + rest, moved_surface(torus, 3, 4, closed, closed, shape)});
    cases.push_back({"torus of 20 x 20" + rest, moved_surface(torus, 20, 20, closed, closed, shape), true, 0, 200});
  }
  for (const auto& [kind, shape] : {std::pair("", sub), std::pair(", Bezier-Hermite", uneven)}) {
    const std::string rest = kind;
    cases.push_back({"moebius" + rest, moved_surface(model("moebius"), 3, 4, open, closed, shape)});
    cases.push_back({"figure-eight-klein-bottle" + rest,
                     moved_surface(model("figure-eight-klein-bottle"), 4, 3, closed, closed, shape)});
    cases.push_back({"klein-bottle" + rest, moved_surface(model("klein-bottle"), 3, 4, closed, closed, shape), false});
    cases.push_back({"cross-cap" + rest, moved_surface(model("cross-cap"), 3, 3, closed, closed, shape)});
  }
  cases.push_back({"bicubic net", net_surface(3, 3, open, open)});
  cases.push_back({"closed net", net_surface(3, 2, closed, open)});
  cases.push_back({"net of high degree", net_surface(5, 4, closed, closed)});
  cases.push_back({"a wrong map", moved_surface(torus, 3, 4, closed, closed, sub), true, 1e-4});
  return cases;
}

GLuint compiled(GLenum stage, const std::string& source) {
  const GLuint shader = glCreateShader(stage);
  const char* text = source.c_str();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  return shader;
}

/// blending.glsl with its vertices as output.
DrawProgram make_feedback_program() {
  const std::string head = "#version 300 es\nprecision highp float;\nprecision highp int;\n";
  const GLuint program = glCreateProgram();
  glAttachShader(program, compiled(GL_VERTEX_SHADER, head + std::string(shader_source("blending.glsl")) + R"(
uniform int u_rows;
out vec3 found_point;
out vec3 found_normal;
void main() {
  SurfaceVertex surface = surface_vertex(ivec2(gl_VertexID / u_rows, gl_VertexID % u_rows));
  found_point = surface.point;
  found_normal = surface.normal;
  gl_Position = vec4(0.0);
  gl_PointSize = 1.0;
})"));
  glAttachShader(program, compiled(GL_FRAGMENT_SHADER, head + "void main() {}\n"));
  const char* const outputs[] = {"found_point", "found_normal"};
  glTransformFeedbackVaryings(program, 2, outputs, GL_SEPARATE_ATTRIBS);
  glLinkProgram(program);
  GLint linked = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  if (linked == 0) std::printf("{\"error\": \"the program does not link\"}\n");
  return DrawProgram(Program(program));
}

/// Three floats a vertex.
std::vector<float> read(const Buffer& buffer, std::size_t vertices) {
  std::vector<float> values(3 * vertices);
  glBindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, buffer.get());
  glGetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0, static_cast<GLsizeiptr>(4 * values.size()), values.data());
  glBindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, 0);
  return values;
}

/// The grid's parameters.
struct Grid {
  std::vector<double> u, v;
};

Grid upload(SurfaceTextures& textures, const BlendingSurface& surface, const Case& test) {
  const BlendingTables tables = blending_tables(surface, test.samples, test.samples);
  std::vector<float> maps = map_table(surface);
  maps[12 * 5 + 3] += static_cast<float>(test.nudge);
  textures.upload(tables);
  textures.upload_maps(maps, tables.counts.u, tables.counts.v);
  return {tables.u, tables.v};
}

Grid upload(SurfaceTextures& textures, const BSplineSurface& surface, const Case& test) {
  const NetTables tables = net_tables(surface, test.samples, test.samples);
  textures.upload(tables);
  textures.upload_net(point_table(surface), surface.knots_u().count(), surface.knots_v().count());
  return {tables.u, tables.v};
}

/// The largest distance from the core's points, over the surface's size, and the largest angle to its normals in radians.
template <class Surface>
void compare(const DrawProgram& program, const Case& test, const Surface& surface) {
  SurfaceTextures textures;
  const Grid grid = upload(textures, surface, test);
  textures.upload_hues(std::array{glm::vec3(0)}, 1, 1);

  const std::size_t vertices = grid.u.size() * grid.v.size();
  const Buffer points = make_buffer(), normals = make_buffer();
  for (GLuint k = 0; k < 2; ++k) {
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, k, (k == 0 ? points : normals).get());
    glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, static_cast<GLsizeiptr>(12 * vertices), nullptr, GL_STREAM_READ);
  }
  GlState state;
  state.use(program);
  textures.bind(state, program);
  program.set("u_rows", textures.rows());
  const VertexArray none = make_vertex_array();
  state.bind(none);
  glEnable(GL_RASTERIZER_DISCARD);
  glBeginTransformFeedback(GL_POINTS);
  glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(vertices));
  glEndTransformFeedback();
  glDisable(GL_RASTERIZER_DISCARD);
  for (GLuint k = 0; k < 2; ++k) glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, k, 0);
  const std::vector<float> found_points = read(points, vertices), found_normals = read(normals, vertices);

  double far = 0, size = 0, angle = 0;
  int with_normal = 0;
  for (std::size_t a = 0; a < grid.u.size(); ++a) {
    for (std::size_t b = 0; b < grid.v.size(); ++b) {
      const std::size_t k = 3 * (a * grid.v.size() + b);
      const SurfaceJet jet = surface.evaluate(grid.u[a], grid.v[b]);
      const Eigen::Vector3d point = Eigen::Vector3f(&found_points[k]).cast<double>();
      far = std::max(far, (point - jet.s).norm());
      size = std::max(size, jet.s.norm());
      const Eigen::Vector3d normal = jet.su.cross(jet.sv);
      if (!test.smooth || normal.norm() < 0.05 * jet.su.norm() * jet.sv.norm() || normal.norm() < 1e-3) continue;
      const Eigen::Vector3d found = Eigen::Vector3f(&found_normals[k]).cast<double>();
      angle = std::max(angle, std::atan2(found.cross(normal).norm(), found.dot(normal)));
      ++with_normal;
    }
  }
  std::printf("{\"name\": \"%s\", \"vertices\": %zu, \"point\": %.3g, \"normals\": %d, \"angle\": %.3g, \"gl\": %u}\n",
              test.name.c_str(), vertices, far / size, with_normal, angle, glGetError());
}

}  // namespace
}  // namespace knotwork::web

int main() {
  using namespace knotwork::web;
  EmscriptenWebGLContextAttributes attributes;
  emscripten_webgl_init_context_attributes(&attributes);
  attributes.majorVersion = 2;
  const EMSCRIPTEN_WEBGL_CONTEXT_HANDLE context = emscripten_webgl_create_context("#stage", &attributes);
  if (context <= 0 || emscripten_webgl_make_context_current(context) != EMSCRIPTEN_RESULT_SUCCESS) return 1;
  const DrawProgram program = make_feedback_program();
  for (const Case& test : all_cases())
    std::visit([&](const auto& surface) { compare(program, test, surface); }, test.surface);
  return 0;
}
