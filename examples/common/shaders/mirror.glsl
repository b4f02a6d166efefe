// What a reflector shows at a point of its surface: its own Phong colour mixed with what it mirrors, or the world
// position of what it mirrors, with w = 0 where that is nothing. The library's snippet is put before this text.
vec4 mirrorAt(vec3 position, vec3 unitNormal)
{
#if VIEW == 1
    return mirrorball_shownPosition(position, unitNormal, eyeInWorld);
#else
    vec4 own = vec4(phong(diffuse.rgb, position, unitNormal), 1.0);
    return mirrorball_material(own, mirrorball_reflection(position, unitNormal, eyeInWorld));
#endif
}
