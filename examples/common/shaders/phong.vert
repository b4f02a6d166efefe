#version 330 core
layout(location = 0) in vec3 position; // world space, relative to the drawing origin
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 textureCoordinate;
uniform mat4 clipFromWorld;
out vec3 positionInWorld;
out vec3 normalInWorld;
out vec2 uv;

void main()
{
    positionInWorld = position;
    normalInWorld = normal;
    uv = textureCoordinate;
    gl_Position = clipFromWorld * vec4(position, 1.0);
}
