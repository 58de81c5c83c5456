#include "web/still.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "web/composition.h"
#include "web/curve_tools.h"
#include "web/figure_picture.h"
#include "web/stage_ornaments.h"
#include "web/still_surface.h"
#include "web/vectors.h"

namespace knotwork::web {
namespace {

/// Coordinates are written in half pixels, as whole numbers.
constexpr double grain = 2;
/// Pieces overlap by so many CSS pixels, or the paper would shine through between them.
constexpr double overlap = 0.45;
/// Ribbons are cut to this length, CSS pixels, where a surface may hide a part of them.
constexpr double longest_piece = 24;

std::string number(double value) { return std::to_string(static_cast<long long>(std::llround(value))); }

std::string hex(const glm::vec3& colour) {
  std::array<char, 8> text{};
  const auto byte = [](float c) { return static_cast<unsigned>(std::lround(255 * std::clamp(c, 0.0F, 1.0F))); };
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", byte(colour.r), byte(colour.g), byte(colour.b));
  return text.data();
}

std::string opacity(float alpha) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "%.2g", static_cast<double>(std::clamp(alpha, 0.0F, 1.0F)));
  return text.data();
}

std::string escaped(const std::string& words) {
  std::string text;
  for (const char letter : words) {
    if (letter == '<')
      text += "&lt;";
    else if (letter == '&')
      text += "&amp;";
    else
      text += letter;
  }
  return text;
}

/// Rules of the style sheet, each a colour in both schemes, named by number.
class Inks {
 public:
  /// The class for a property, as `stroke`, with one colour in the light scheme and another in the dark one.
  std::string name(const char* property, const glm::vec4& light, const glm::vec4& dark) {
    const std::string pair = rule(property, light) + "|" + rule(property, dark);
    const auto [found, added] = rules_.try_emplace(pair, static_cast<int>(rules_.size()));
    return "c" + std::to_string(found->second);
  }
  std::string style() const {
    std::string light, dark;
    for (const auto& [pair, index] : rules_) {
      const std::size_t bar = pair.find('|');
      const std::string name = ".c" + std::to_string(index);
      light += name + "{" + pair.substr(0, bar) + "}";
      dark += name + "{" + pair.substr(bar + 1) + "}";
    }
    return light + "@media(prefers-color-scheme:dark){#s{filter:brightness(.86)}" + dark + "}";
  }

 private:
  static std::string rule(const char* property, const glm::vec4& colour) {
    std::string text = std::string(property) + ":" + hex(glm::vec3(colour));
    if (colour.a < 0.995F) text += ";" + std::string(property) + "-opacity:" + opacity(colour.a);
    return text;
  }
  std::map<std::string, int> rules_;
};

struct Painter {
  const View& view;
  Inks inks;

  std::string move_to(glm::dvec2 at) const { return "M" + number(grain * at.x) + " " + number(grain * at.y); }

  /// Pieces of lines, those that touch put together.
  struct LinePath {
    const Painter& painter;
    std::string text;
    glm::dvec2 end{1e300};

    void add(glm::dvec2 from, glm::dvec2 to) {
      if (from != end) text += painter.move_to(from);
      text += "L" + number(grain * to.x) + " " + number(grain * to.y);
      end = to;
    }
  };

  /// The width in tenths: whole half pixels are too coarse for thin lines.
  std::string stroke(const std::string& path, const std::string& ink, double width) const {
    return "<path d=\"" + path + "\" class=\"" + ink + "\" stroke-width=\"" + number(grain * width * 10) + "e-1\"/>";
  }

  std::string facet(const Facet& facet) const {
    glm::dvec2 middle(0);
    for (const glm::dvec2& corner : facet.corners) middle += corner / static_cast<double>(facet.corners.size());
    std::string path;
    glm::dvec2 last(0);
    for (const glm::dvec2& corner : facet.corners) {
      const glm::dvec2 away = corner - middle;
      const double length = glm::length(away);
      const glm::dvec2 wider = glm::round(grain * (length > 1e-9 ? corner + (overlap / length) * away : corner));
      const glm::dvec2 step = wider - last;
      path += path.empty() ? "M" : path.find('l') == std::string::npos ? "l" : step.x < 0 ? "" : " ";
      path += number(step.x) + (step.y < 0 ? "" : " ") + number(step.y);
      last = wider;
    }
    return "<path d=\"" + path + "z\" fill=\"" + hex(to_glm(facet.colour)) + "\"/>";
  }

  /// Both pictures hold the same ribbons, in the colours of both schemes. What touches and looks alike is one path.
  void ribbons(const std::vector<Ribbon>& light, const std::vector<Ribbon>& dark, std::string& out) {
    assert(light.size() == dark.size());
    std::string path, ink;
    glm::vec3 end(0);
    float width = 0;
    const auto flush = [&] {
      if (!path.empty()) out += stroke(path, ink, width);
      path.clear();
    };
    for (std::size_t k = 0; k < light.size(); ++k) {
      const Ribbon& ribbon = light[k];
      const std::optional<glm::dvec3> a = view.project(ribbon.start), b = view.project(ribbon.end);
      if (!a || !b) continue;
      const std::string own = inks.name("stroke", coarse(ribbon.colour), coarse(dark[k].colour));
      if (own != ink || ribbon.width != width || ribbon.start != end) {
        flush();
        path = move_to(glm::dvec2(*a));
      }
      path += "L" + number(grain * b->x) + " " + number(grain * b->y);
      ink = own;
      width = ribbon.width;
      end = ribbon.end;
    }
    flush();
  }

  /// The same without what a surface hides, told by short pieces. `hides` is asked about a point of the model.
  template <class Hides>
  void seen_ribbons(const std::vector<Ribbon>& light, const std::vector<Ribbon>& dark, Hides hides, std::string& out) {
    assert(light.size() == dark.size());
    for (std::size_t k = 0; k < light.size(); ++k) {
      const Ribbon& ribbon = light[k];
      const std::optional<glm::dvec3> first = view.project(ribbon.start), last = view.project(ribbon.end);
      if (!first || !last) continue;
      const double length = glm::distance(glm::dvec2(*first), glm::dvec2(*last));
      const int count = std::clamp(static_cast<int>(std::ceil(length / longest_piece)), 1, 40);
      const auto at = [&](double step) {
        return glm::mix(glm::dvec3(ribbon.start), glm::dvec3(ribbon.end), step / count);
      };
      LinePath path{*this, {}};
      for (int piece = 0; piece < count; ++piece) {
        const std::optional<glm::dvec3> a = view.project(at(piece)), b = view.project(at(piece + 1));
        if (a && b && !hides(at(piece + 0.5))) path.add(glm::dvec2(*a), glm::dvec2(*b));
      }
      if (path.text.empty()) continue;
      out += stroke(path.text, inks.name("stroke", coarse(ribbon.colour), coarse(dark[k].colour)), ribbon.width);
    }
  }

  /// The rim lies within the radius, as in shaders/disc.frag; SVG strokes to both sides of it.
  void disc(const Disc& light, const Disc& dark, bool hidden, std::string& out) {
    const std::optional<glm::dvec3> at = view.project(light.centre);
    if (!at) return;
    out += "<circle cx=\"" + number(grain * at->x) + "\" cy=\"" + number(grain * at->y) + "\" r=\"" +
           number(grain * (light.radius - 0.5 * light.rim_width)) + "\" class=\"" +
           inks.name("fill", light.fill, dark.fill) + " " + inks.name("stroke", {light.rim, 1}, {dark.rim, 1}) +
           "\" stroke-width=\"" + number(grain * light.rim_width) + "\"" + (hidden ? " opacity=\".3\"" : "") + "/>";
  }

  void label(const StageLabel& light, const StageLabel& dark, std::string& out) {
    out += "<text x=\"" + number(grain * light.place.x) + "\" y=\"" + number(grain * light.place.y) + "\" class=\"" +
           inks.name("fill", to_glm(light.colour, 1), to_glm(dark.colour, 1)) + "\">" + escaped(light.words) +
           "</text>";
  }

  /// A hue that runs along a curve changes in steps that the eye does not see.
  static glm::vec4 coarse(const glm::vec4& colour) { return {glm::round(24.0F * glm::vec3(colour)) / 24.0F, colour.a}; }
};

/// What is painted, and from where it is seen.
struct Subject {
  const scene::Document& document;
  Figure& figure;
  std::span<const Handle> handles;
  const CurveTools& tools;
  const View& view;

  Picture picture(bool dark) const {
    Picture picture;
    picture.view = view;
    picture.target = to_glm(document.camera.target);
    picture.theme = make_theme(dark);
    picture.display = document.display;
    const InteractionState untouched;
    add_to_picture(picture, figure, {document, untouched, handles, false});
    add_tools(picture, figure, tools);
    add_rings(picture);
    return picture;
  }

  std::vector<StageLabel> labels(bool dark) const {
    std::vector<StageLabel> names;
    const Theme theme = make_theme(dark);
    if (shows_names(figure, document.display)) names = labels_of(figure, handles, view, theme, {});
    add_tool_labels(names, figure, document.display, tools, view, theme);
    return names;
  }

  /// Whether the surface lies before a point of the model, by 8 pixels or more: what runs along it is seen.
  bool hides(const glm::dvec3& point) const {
    const std::optional<glm::dvec3> screen = view.project(point);
    if (!screen || !surface_of(figure) || !document.display.surface) return false;
    const std::optional<scene::SurfaceHit> hit = pick(figure, view.ray(glm::dvec2(*screen)));
    return hit && hit->distance < glm::distance(point, view.eye) - 8 * view.pixel_size(point);
  }
};

/// A soft shadow under a surface, on the floor.
std::string shadow(const std::vector<glm::dvec3>& points, const View& view) {
  glm::dvec3 low(1e300), high(-1e300);
  for (const glm::dvec3& point : points) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  const glm::dvec3 middle = 0.5 * (low + high);
  const double floor = low.z - 0.12 * glm::distance(low, high);
  if (view.eye.z < floor) return {};
  std::string path;
  constexpr int corners = 36;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * k / corners;
    const std::optional<glm::dvec3> at = view.project({middle.x + 0.42 * (high.x - low.x) * std::cos(angle),
                                                       middle.y + 0.42 * (high.y - low.y) * std::sin(angle), floor});
    if (!at) return {};
    path += (path.empty() ? "M" : "L") + number(grain * at->x) + " " + number(grain * at->y);
  }
  return "<path d=\"" + path + "z\" fill=\"#000\" fill-opacity=\".2\" filter=\"url(#b)\"/>";
}

/// The surface: pieces from back to front, evened out by a blur that keeps to their outline, with its knot lines.
std::string surface(Painter& painter, const Subject& subject, const StillSize& size) {
  SurfacePieces pieces = surface_pieces(subject.figure, subject.document, painter.view, size.pieces_u, size.pieces_v);
  std::stable_sort(pieces.facets.begin(), pieces.facets.end(),
                   [](const Facet& a, const Facet& b) { return a.depth > b.depth; });
  std::string out = "<g id=\"s\"><g filter=\"url(#e)\">";
  for (const Facet& facet : pieces.facets) out += painter.facet(facet);
  out += "</g></g>";
  Painter::LinePath lines{painter, {}};
  for (const FacetEdge& edge : pieces.knot_lines)
    if (!subject.hides(edge.middle)) lines.add(edge.start, edge.end);
  if (!lines.text.empty())
    out += painter.stroke(lines.text,
                          painter.inks.name("stroke", {0.12F, 0.13F, 0.15F, 0.42F}, {0.05F, 0.06F, 0.07F, 0.5F}), 1.2);
  return out;
}

}  // namespace

std::string still(const scene::Document& document, const StillSize& wanted) {
  // Stripes are finer than hues, and their edges are sharp.
  const bool striped =
      document.display.shading == scene::Shading::zebra || document.display.shading == scene::Shading::isophotes;
  StillSize size = wanted;
  if (striped) {
    size.pieces_u *= 2;
    size.pieces_v *= 2;
  }
  const double evening_out = striped ? 0.12 : 0.4;  // share of a piece
  const scene::Shape& shape = scene::stage_shape(document);
  Figure figure = make_figure(shape, document.animation);
  std::vector<glm::dvec3> points = outline(figure);
  const CurveTools tools = curve_tools(figure, document.display);
  points.insert(points.end(), tools.tips.begin(), tools.tips.end());
  for (const Eigen::Vector3d& ring : document.display.rings) points.push_back(to_glm(ring));
  // A surface's shadow needs room below it.
  const std::array<std::array<double, 4>, 1> foot{{{0, 0.84 * size.height, size.width, 0.16 * size.height}}};
  const std::span<const std::array<double, 4>> below(foot.data(), surface_of(figure) ? 1 : 0);
  const Composition composition =
      compose(document.camera, {points, {}}, {.width = size.width, .height = size.height}, {below, {}});
  scene::Document seen = document;
  seen.camera = composition.camera;
  const View view = make_view(composition.camera, composition.viewport);
  std::vector<Handle> handles;
  take_handles(figure, shape, handles);
  for (Handle& handle : handles) handle.screen = view.project(handle.position);
  const Subject subject{seen, figure, handles, tools, view};
  const Picture light = subject.picture(false), dark = subject.picture(true);
  Painter painter{view, {}};

  std::string body;
  if (light.surface) {
    body += shadow(points, view);
    if (document.display.surface) body += surface(painter, subject, size);
    const auto hides = [&](const glm::dvec3& point) { return subject.hides(point); };
    painter.seen_ribbons(light.ribbons, dark.ribbons, hides, body);
    painter.ribbons(light.hidden_ribbons, dark.hidden_ribbons, body);
  } else {
    painter.ribbons(light.ribbons, dark.ribbons, body);
  }
  painter.ribbons(light.overlay_ribbons, dark.overlay_ribbons, body);
  for (std::size_t k = 0; k < light.discs.size(); ++k)
    painter.disc(light.discs[k], dark.discs[k], subject.hides(light.discs[k].centre), body);
  for (std::size_t k = 0; k < light.overlay_discs.size(); ++k)
    painter.disc(light.overlay_discs[k], dark.overlay_discs[k], false, body);
  const std::vector<StageLabel> names = subject.labels(false), dark_names = subject.labels(true);
  for (std::size_t k = 0; k < names.size(); ++k) painter.label(names[k], dark_names[k], body);

  const std::string width = number(size.width), height = number(size.height);
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" + height + "\" viewBox=\"0 0 " +
         number(grain * size.width) + " " + number(grain * size.height) +
         "\"><style>path[stroke-width]{fill:none;stroke-linecap:round;stroke-linejoin:round}"
         "text{font:24px Inter,system-ui,sans-serif;text-anchor:middle;dominant-baseline:central}" +
         painter.inks.style() +
         "</style><filter id=\"b\" x=\"-50%\" y=\"-100%\" width=\"200%\" height=\"300%\">"
         "<feGaussianBlur stdDeviation=\"26\"/></filter><filter id=\"e\"><feGaussianBlur stdDeviation=\"" +
         number(evening_out * grain * size.width / size.pieces_u) +
         "\"/>"
         "<feComponentTransfer><feFuncA type=\"linear\" slope=\"9\"/></feComponentTransfer>"
         "<feComposite operator=\"in\" in2=\"SourceAlpha\"/></filter>" +
         body + "</svg>\n";
}

}  // namespace knotwork::web
