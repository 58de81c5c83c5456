in float v_height;
out vec4 colour;

uniform float u_fall_off;

void main() { colour = vec4(exp(-v_height * u_fall_off)); }
