invariant gl_Position;  // the shading pass after it must agree to the last bit
layout(location = 0) in vec3 a_position;
void main() { gl_Position = u_world_to_clip * vec4(a_position, 1.0); }
