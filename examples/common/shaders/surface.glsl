// What is seen of a surface of the scene.
in vec3 positionInWorld;
in vec3 normalInWorld;
in vec2 uv;
uniform bool hasImage;
uniform sampler2D image;
uniform int firstTriangle;

vec4 surface()
{
    vec4 d = diffuse;
    if (hasImage)
        d *= texture(image, uv);
    if (d.a < 0.5)
        discard;
    vec3 n = normalize(normalInWorld);
#if VIEW == 1
    return vec4(positionInWorld, 1.0);
#elif VIEW == 2
    return vec4(dot(n, eyeInWorld - positionInWorld) < 0.0 ? -n : n, 1.0);
#elif VIEW == 3
    return vec4(float(firstTriangle + gl_PrimitiveID), 0.0, 0.0, 1.0);
#else
    return vec4(phong(d.rgb, positionInWorld, n), 1.0);
#endif
}
