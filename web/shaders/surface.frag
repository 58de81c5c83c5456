centroid in vec3 v_point;
centroid in vec3 v_normal;
centroid in vec3 v_hue;
in vec3 v_place;
in vec2 v_grid;
in vec2 v_knot;
in float v_curvature;
out vec4 colour;

uniform vec3 u_eye;
uniform vec3 u_key_light;    // unit, towards the light
uniform vec3 u_fill_light;
uniform vec3 u_plain_hue;    // OKLab of the surface without patch colours
uniform float u_patch_colours;
uniform float u_knot_lines;  // opacity
uniform float u_wireframe;   // opacity
uniform vec3 u_line_colour;  // sRGB
uniform float u_pixel_ratio;
uniform float u_ambient;
uniform float u_lift;        // added lightness: ink hues of the light scheme are deep for a lit body
uniform float u_sheen;       // brightness of what the gloss reflects
uniform vec4 u_held_cells;   // knot range (u0, u1, v0, v1) of the held patch's support, in intervals
uniform vec2 u_knot_period;  // number of intervals in a closed direction, 0 in an open one
uniform float u_held;        // how strongly the support is lit
uniform float u_back_shade;  // how much the back differs from the front
uniform int u_shading;       // 0 a lit body, 1 a mirror under lamps, 2 lines of equal slope, 3 colours of a curvature
uniform float u_curvature_scale;  // where the scale of colours ends
uniform vec3 u_least_hue;    // OKLab of its ends and its middle
uniform vec3 u_zero_hue;
uniform vec3 u_greatest_hue;

// Coverage of lines at whole numbers of x, `width` CSS pixels wide, antialiased; fades where they would crowd.
float line_coverage(float x, float width) {
  float change = fwidth(x);
  float distance_in_pixels = abs(fract(x - 0.5) - 0.5) / max(change, 1e-7);
  float half_width = 0.5 * width * u_pixel_ratio;
  float cover = 1.0 - smoothstep(half_width - 0.6, half_width + 0.6, distance_in_pixels);
  return cover * (1.0 - smoothstep(0.12, 0.4, change * u_pixel_ratio));
}

// How much of a lamp is mirrored, 0 to 1: parallel to the x-axis there are 14 lamps round the surface, as wide as the
// gaps between them. Antialiased; grey where they would crowd.
float lamp(vec3 normal, vec3 to_eye) {
  const float lamps = 14.0;
  vec3 mirrored = reflect(-to_eye, normal);
  vec2 around = mirrored.yz / max(length(mirrored.yz), 1e-4);
  float change = lamps * (length(dFdx(around)) + length(dFdy(around)));
  float cover = clamp(0.5 + cos(lamps * atan(around.x, around.y)) / max(change, 1e-4), 0.0, 1.0);
  return mix(cover, 0.5, smoothstep(0.8, 2.4, change));
}

float inside_support(float x, float start, float end, float period) {
  float shifted = period > 0.0 ? x - period * floor((x - start) / period) : x;
  return step(start, shifted) * step(shifted, end);
}

void main() {
  vec3 normal = v_normal;
  if (dot(normal, normal) < 0.25) normal = cross(dFdx(v_place), dFdy(v_place));  // a pole: the facet's own normal
  normal = normalize(normal);
  float slope = acos(clamp(normal.z, -1.0, 1.0)) * 18.0 / 3.14159265;  // to the vertical, in steps of 10 degrees
  vec3 to_eye = normalize(u_eye - v_point);
  // The back is what faces away for certain: just behind a silhouette the smooth normal still looks at the reader.
  float back = gl_FrontFacing ? 0.0 : smoothstep(0.04, 0.22, -dot(normal, to_eye));
  if (back > 0.5) normal = -normal;
  if (dot(normal, to_eye) < 0.0) normal = normalize(normal - 1.02 * dot(normal, to_eye) * to_eye);

  vec3 hue = mix(u_plain_hue, v_hue, u_patch_colours);
  if (u_shading == 1) {
    hue = mix(vec3(0.30, 0.2 * hue.yz), vec3(0.97, 0.35 * hue.yz), lamp(normal, to_eye));
  } else if (u_shading == 3) {
    float share = clamp(v_curvature / u_curvature_scale, -1.0, 1.0);
    hue = mix(u_zero_hue, share > 0.0 ? u_greatest_hue : u_least_hue, abs(share));
  }
  hue = vec3(hue.x + u_lift, hue.yz * (1.0 + u_lift));
  hue = mix(hue, vec3(hue.x * 0.93, hue.yz * 0.72), back * u_back_shade);
  vec3 albedo = linear_from_oklab(hue);

  // A large soft key light from the upper left, a cool fill from the right, light from sky and floor; gloss on top.
  float key = smoothstep(-0.45, 1.0, dot(normal, u_key_light));
  float fill = 0.5 + 0.5 * dot(normal, u_fill_light);
  float sky = 0.5 + 0.5 * normal.z;
  vec3 light = vec3(1.00, 0.98, 0.95) * (0.74 * key * key + 0.20 * key) + vec3(0.90, 0.95, 1.0) * (0.16 * fill) +
               mix(vec3(0.95, 0.90, 0.85) * 0.62, vec3(0.97, 0.985, 1.0), sky) * u_ambient;
  // What is flat and faces the reader has nowhere to catch the key: a little light comes from where the reader is.
  float facing = max(dot(normal, to_eye), 0.0);
  light += 0.2 * facing * facing;
  vec3 half_key = normalize(u_key_light + to_eye);
  float fresnel = 0.04 + 0.6 * pow(1.0 - facing, 4.0);
  float glance = max(dot(normal, half_key), 0.0);
  float gloss = 0.30 * pow(glance, 90.0) + 0.10 * pow(glance, 18.0);
  vec3 reflected = mix(vec3(0.80, 0.76, 0.72), vec3(1.0, 1.0, 1.0), smoothstep(0.25, 0.9, sky)) * u_sheen;
  vec3 lit = albedo * light;
  lit = mix(lit, reflected, fresnel * 0.42 * (0.35 + 0.65 * sky)) + vec3(1.0, 0.99, 0.97) * gloss * u_sheen;
  if (u_held > 0.0) {
    float within = inside_support(v_knot.x, u_held_cells.x, u_held_cells.y, u_knot_period.x) *
                   inside_support(v_knot.y, u_held_cells.z, u_held_cells.w, u_knot_period.y);
    lit *= 1.0 - 0.16 * u_held * (1.0 - within);
  }
  lit = lit / (1.0 + max(max(lit.r, max(lit.g, lit.b)) - 0.92, 0.0));  // keep the hue where light overflows

  vec3 c = srgb_from_linear(lit);
  float wire = max(line_coverage(v_grid.x, 0.8), line_coverage(v_grid.y, 0.8)) * u_wireframe;
  float knots = max(line_coverage(v_knot.x, 1.25), line_coverage(v_knot.y, 1.25)) * u_knot_lines;
  // On what has one slope, or is curved alike everywhere, there are no lines.
  float lines = 0.0, quarters = 4.0 * v_curvature / u_curvature_scale;
  if (u_shading == 2) lines = 0.75 * line_coverage(slope, 1.8) * smoothstep(2e-4, 1e-3, fwidth(slope));
  if (u_shading == 3) lines = 0.3 * line_coverage(quarters, 1.0) * smoothstep(2e-4, 1e-3, fwidth(quarters));
  c = mix(c, u_line_colour, max(max(wire, knots), lines));
  colour = vec4(c + dither(gl_FragCoord.xy), 1.0);
}
