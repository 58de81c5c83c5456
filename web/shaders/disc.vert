// A handle or knob: a disc that always faces the reader; an instance a disc.
layout(location = 0) in vec4 a_place;  // point, radius in CSS pixels
layout(location = 1) in vec4 a_fill;
layout(location = 2) in vec4 a_rim;    // rgb, rim width in CSS pixels

uniform mat4 u_view_projection;
uniform vec2 u_viewport;
uniform float u_pixel_ratio;
uniform vec3 u_eye;
uniform float u_pixel_size;  // model units a CSS pixel covers at the target

out vec2 v_offset;  // device pixels from the centre
flat out float v_radius;
flat out vec4 v_fill;
flat out vec4 v_rim;

void main() {
  vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)) * 2.0 - 1.0;
  vec4 place = u_view_projection * vec4(a_place.xyz, 1.0);
  v_radius = a_place.w * u_pixel_ratio;
  float reach = v_radius + 3.0 * u_pixel_ratio;
  v_offset = corner * reach;
  v_fill = a_fill;
  v_rim = vec4(a_rim.rgb, a_rim.w * u_pixel_ratio);
  place.xy += v_offset / (0.5 * u_viewport * u_pixel_ratio) * place.w;
  // Its depth is that of a point nearer to the reader, so that the surface does not cut its own handles.
  vec3 lifted = a_place.xyz + normalize(u_eye - a_place.xyz) * (4.0 * a_place.w * u_pixel_size);
  vec4 nearer = u_view_projection * vec4(lifted, 1.0);
  place.z = nearer.z / nearer.w * place.w;
  gl_Position = place;
}
