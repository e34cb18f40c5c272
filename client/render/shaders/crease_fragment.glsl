// For blending source x destination twice: half is no change. The square root as in to_screen().

in vec3 v_factor;
out vec4 o_colour;
void main() { o_colour = vec4(0.5 * sqrt(v_factor), 0.5); }
