// What the vertex shader makes of blending surfaces, beside the core: draws into buffers by transform feedback, through
// the very textures that the stage uploads. Prints one JSON object a line; the browser's test reads them.

#include <emscripten/html5.h>
#include <webgl/webgl2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
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

/// A program whose output is the point and the normal of `vertex`, an expression of a vertex with both.
DrawProgram make_feedback_program(std::initializer_list<std::string_view> files, const std::string& uniforms,
                                  const std::string& vertex) {
  const std::string head = "#version 300 es\nprecision highp float;\nprecision highp int;\n";
  std::string source = head;
  for (const std::string_view file : files) source += shader_source(file);
  const GLuint program = glCreateProgram();
  glAttachShader(program, compiled(GL_VERTEX_SHADER, source + uniforms + R"(
uniform int u_rows;
out vec3 found_point;
out vec3 found_normal;
void main() {
  ivec2 vertex = ivec2(gl_VertexID / u_rows, gl_VertexID % u_rows);
  )" + vertex + R"(
  found_point = found.point;
  found_normal = found.normal;
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

template <class Surface>
SampleGrid grid_of(const Surface& surface, const Case& test) {
  GridSteps steps = even_steps(surface.knots_u(), surface.knots_v(), test.samples, test.samples);
  // Some intervals finer than others, the same way from both ends, as twisted seams want it.
  for (std::vector<int>* direction : {&steps.u, &steps.v}) {
    direction->front() += 3;
    direction->back() = direction->front();
  }
  return sample_grid(surface.knots_u(), surface.knots_v(), steps, Seam::repeated);
}

SampleGrid upload(SurfaceTextures& textures, const BlendingSurface& surface, const Case& test) {
  const BlendingTables tables = blending_tables(surface, grid_of(surface, test));
  std::vector<float> maps = map_table(surface);
  maps[12 * 5 + 3] += static_cast<float>(test.nudge);
  textures.upload(tables);
  textures.upload_maps(maps, tables.counts.u, tables.counts.v);
  return tables.grid;
}

SampleGrid upload(SurfaceTextures& textures, const BSplineSurface& surface, const Case& test) {
  const NetTables tables = net_tables(surface, grid_of(surface, test));
  textures.upload(tables);
  textures.upload_net(point_table(surface), surface.knots_u().count(), surface.knots_v().count());
  return tables.grid;
}

/// What a program makes of so many vertices: three floats each.
struct Found {
  std::vector<float> points, normals;
};
Found feed_back(const DrawProgram& program, GlState& state, std::size_t vertices) {
  const Buffer points = make_buffer(), normals = make_buffer();
  for (GLuint k = 0; k < 2; ++k) {
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, k, (k == 0 ? points : normals).get());
    glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, static_cast<GLsizeiptr>(12 * vertices), nullptr, GL_STREAM_READ);
  }
  state.use(program);
  const VertexArray none = make_vertex_array();
  state.bind(none);
  glEnable(GL_RASTERIZER_DISCARD);
  glBeginTransformFeedback(GL_POINTS);
  glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(vertices));
  glEndTransformFeedback();
  glDisable(GL_RASTERIZER_DISCARD);
  for (GLuint k = 0; k < 2; ++k) glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, k, 0);
  return {read(points, vertices), read(normals, vertices)};
}

/// The largest distance from the core's points, over the surface's size, and the largest angle to its normals in radians.
class Comparison {
 public:
  void look(const Found& found, std::size_t vertex, const SurfaceJet& jet, bool smooth) {
    ++vertices_;
    const Eigen::Vector3d point = Eigen::Vector3f(&found.points[3 * vertex]).cast<double>();
    far_ = std::max(far_, (point - jet.s).norm());
    size_ = std::max(size_, jet.s.norm());
    const Eigen::Vector3d normal = jet.su.cross(jet.sv);
    if (!smooth || normal.norm() < 0.05 * jet.su.norm() * jet.sv.norm() || normal.norm() < 1e-3) return;
    const Eigen::Vector3d seen = Eigen::Vector3f(&found.normals[3 * vertex]).cast<double>();
    angle_ = std::max(angle_, std::atan2(seen.cross(normal).norm(), seen.dot(normal)));
    ++with_normal_;
  }
  void print(const std::string& name) const {
    std::printf("{\"name\": \"%s\", \"vertices\": %d, \"point\": %.3g, \"normals\": %d, \"angle\": %.3g, \"gl\": %u}\n",
                name.c_str(), vertices_, far_ / size_, with_normal_, angle_, glGetError());
  }

 private:
  double far_ = 0, size_ = 0, angle_ = 0;
  int vertices_ = 0, with_normal_ = 0;
};

template <class Surface>
void compare(const DrawProgram& program, const Case& test, const Surface& surface) {
  SurfaceTextures textures;
  const SampleGrid grid = upload(textures, surface, test);
  textures.upload_hues(std::array{glm::vec3(0)}, 1, 1);
  GlState state;
  state.use(program);
  textures.bind(state, program);
  program.set("u_rows", textures.rows());
  const Found found = feed_back(program, state, grid.u.size() * grid.v.size());
  Comparison comparison;
  for (std::size_t a = 0; a < grid.u.size(); ++a)
    for (std::size_t b = 0; b < grid.v.size(); ++b)
      comparison.look(found, a * grid.v.size() + b, surface.evaluate(grid.u[a], grid.v[b]), test.smooth);
  comparison.print(test.name);
}

/// The parameter that is `offset` steps of the finest interval away from a knot, however often it goes round, as the sheet
/// has it: in a coarser interval the grid's next one on the way back.
std::optional<double> sheet_parameter(const KnotVector& knots, const std::vector<double>& t,
                                      const std::vector<int>& starts, int finest, int knot, int offset) {
  const int intervals = static_cast<int>(starts.size()) - 1;
  const int whole = static_cast<int>(std::floor(static_cast<double>(offset) / finest));
  int interval = knot + whole, turns = 0;
  if (knots.closed()) {
    turns = static_cast<int>(std::floor(static_cast<double>(interval) / intervals));
    interval -= turns * intervals;
  } else if (interval < 0 || interval >= intervals) {
    return std::nullopt;  // drawn at the end
  }
  const auto at = static_cast<std::size_t>(interval);
  const int part = (offset - whole * finest) * (starts[at + 1] - starts[at]) / finest;
  return t[static_cast<std::size_t>(starts[at] + part)] + turns * knots.period();
}

/// Every local patch over its support.
void compare_sheets(const DrawProgram& program, const Case& test, const BlendingSurface& surface) {
  SurfaceTextures textures;
  const SampleGrid grid = upload(textures, surface, test);
  textures.upload_hues(std::array{glm::vec3(0)}, 1, 1);
  const glm::ivec2 steps = textures.finest_steps(), size = 2 * steps + 1;
  GlState state;
  state.use(program);
  textures.bind_sheets(state, program, sheet_directions(surface));
  program.set("u_rows", size.y);
  Comparison comparison;
  for (int i = 0; i < surface.knots_u().count(); ++i) {
    for (int j = 0; j < surface.knots_v().count(); ++j) {
      program.set("u_local", glm::ivec2(i, j));
      const Found found =
          feed_back(program, state, static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
      for (int a = 0; a < size.x; ++a) {
        const auto u = sheet_parameter(surface.knots_u(), grid.u, grid.starts_u, steps.x, i, a - steps.x);
        for (int b = 0; b < size.y; ++b) {
          const auto v = sheet_parameter(surface.knots_v(), grid.v, grid.starts_v, steps.y, j, b - steps.y);
          // Where a model's pieces meet, what a piece would be beyond its own domain is not what comes there.
          const bool inside = u && v && surface.knots_u().reduced(*u) == *u && surface.knots_v().reduced(*v) == *v;
          if (u && v && (test.smooth || inside))
            comparison.look(found, static_cast<std::size_t>(a * size.y + b), surface.evaluate_local(i, j, *u, *v),
                            test.smooth);
        }
      }
    }
  }
  comparison.print("sheets of " + test.name);
}

/// A surface that the CPU evaluates: points and normals come through as they are.
void compare_evaluated(const DrawProgram& program) {
  const ModelSurface model = make_catalogue_surface("sphere").value();
  const SurfaceDomain where = domain(model);
  const KnotVector u = even(5, Topology::closed, where.u), v = even(5, Topology::open, where.v);
  const BlendingSurface surface =
      BlendingSurface::make(model, u, v, BlendingFunction::make(BlendingKind::polynomial2).value(),
                            BlendingSurface::unmoved_locals(model, u, v))
          .value();
  const SurfaceTables tables = surface_tables(knotted_surface(surface), sample_grid(u, v, 60, 50, Seam::repeated));
  SurfaceTextures textures;
  textures.upload(tables);
  textures.upload_hues(std::array{glm::vec3(0)}, 1, 1);
  GlState state;
  state.use(program);
  textures.bind(state, program);
  program.set("u_rows", textures.rows());
  const auto rows = tables.grid.v.size();
  const Found found = feed_back(program, state, tables.grid.u.size() * rows);
  Comparison comparison;
  for (std::size_t a = 0; a < tables.grid.u.size(); ++a)
    for (std::size_t b = 0; b < rows; ++b)
      comparison.look(found, a * rows + b, surface.evaluate(tables.grid.u[a], tables.grid.v[b]), true);
  comparison.print("an evaluated sphere");
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
  const DrawProgram program =
      make_feedback_program({"blending.glsl"}, "", "SurfaceVertex found = surface_vertex(vertex);");
  const DrawProgram sheets = make_feedback_program({"blending.glsl", "sheet.glsl"}, "uniform ivec2 u_local;",
                                                   "SheetVertex found = sheet_vertex(u_local, vertex - u_steps);");
  for (const Case& test : all_cases()) {
    std::visit([&](const auto& surface) { compare(program, test, surface); }, test.surface);
    const auto* blending = std::get_if<knotwork::BlendingSurface>(&test.surface);
    if (blending && blending->knots_u().count() < 20) compare_sheets(sheets, test, *blending);
  }
  compare_evaluated(program);
  return 0;
}
