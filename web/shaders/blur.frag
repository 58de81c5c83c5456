in vec2 v_place;
out vec4 colour;

uniform sampler2D u_image;
uniform vec2 u_step;

void main() {
  float sum = 0.0;
  float weights = 0.0;
  for (int k = -4; k <= 4; ++k) {
    float weight = exp(-float(k * k) / 7.0);
    sum += weight * texture(u_image, v_place + float(k) * u_step).r;
    weights += weight;
  }
  colour = vec4(sum / weights);
}
