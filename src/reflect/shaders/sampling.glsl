uniform vec4 mirrorball_textureFromSquare; // scale, offset: the colour texture may have guard texels round each layer

vec3 mirrorball_textureCoordinate(int component, vec2 uv)
{
    return vec3(clamp(uv, 0.0, 1.0) * mirrorball_textureFromSquare.xy + mirrorball_textureFromSquare.zw,
                float(component));
}

vec4 mirrorball_lookUpLevel(vec3 positionInWorld, vec3 directionInWorld, float level)
{
    vec4 shown = mirrorball_shown(positionInWorld, directionInWorld);
    vec3 v = mirrorball_regularDirection(shown.xyz);
#if MIRRORBALL_LAYERED
    if (shown.w > 0.5)
        return textureLod(mirrorball_hiddenColourMap, mirrorball_coordinateFromDirection(v), 0.0);
#endif
    int component = mirrorball_regular_componentOf(v);
    vec2 uv = mirrorball_regular_squareFromDirection(component, v);
    uv = mirrorball_withinSurface(vec3(uv, float(component)));
    return textureLod(mirrorball_colourMap, mirrorball_textureCoordinate(component, uv), level);
}

#if MIRRORBALL_DETAIL > 0
#if MIRRORBALL_DETAIL == 1
uniform vec2 mirrorball_texels; // of a layer, at level 0
#else
uniform float mirrorball_widest; // change of a coordinate, the whole texture: at a pole it is infinite
#endif

// The map's colour in the unit direction v, over a pixel across which v changes by alongX and alongY.
vec4 mirrorball_colourOver(vec3 v, vec3 alongX, vec3 alongY)
{
    int component = mirrorball_regular_componentOf(v);
    vec2 uv = mirrorball_regular_squareFromDirection(component, v);
    uv = mirrorball_withinSurface(vec3(uv, float(component)));
    vec3 coordinate = mirrorball_textureCoordinate(component, uv);
    vec4 change = mirrorball_squareDerivatives(component, v, alongX, alongY);
#if MIRRORBALL_DETAIL == 1
    // The longer axis in texels, squared; one texel in place of NaN. Not left to textureGrad, which may be approximate.
    change *= mirrorball_texels.xyxy;
    float longest = max(dot(change.xy, change.xy), dot(change.zw, change.zw));
    longest = longest >= 0.0 ? clamp(longest, 1e-30, 1e30) : 1.0;
    return textureLod(mirrorball_colourMap, coordinate, 0.5 * log2(longest));
#else
    change = clamp(change * mirrorball_textureFromSquare.xyxy, -mirrorball_widest, mirrorball_widest);
    return textureGrad(mirrorball_colourMap, coordinate, change.xy, change.zw);
#endif
}

// What the looked-up direction changes by when the ray does: shares of the change of its start and of its direction. It
// is the differential of the ray's point at a fixed distance (Igehy, "Tracing ray differentials", 1999), seen from the
// map's centre. What a slanted surface adds there is left out, and so neighbouring pixels that see different surfaces
// are not mistaken for wide ones. All vectors in world space, v and d of unit length.
vec2 mirrorball_shares(vec3 start, vec3 d, vec3 v)
{
#if MIRRORBALL_PARALLAX
    // v is (1 - s) p + s d up to its length, with p the unit vector to the ray's start. Where the three are the same it
    // is taken for the ray's end at infinity, s = 1.
    float radius = max(length(start), 1e-30);
    vec3 p = start / radius;
    float nearer = length(cross(v, d));
    float farther = length(cross(p, v)) + 1e-6; // above what rounding leaves of 0
    return vec2(nearer / radius, farther) / length(nearer * p + farther * d);
#else
    return vec2(0.0, 1.0);
#endif
}

// What v changes by, given the shares and both changes.
vec3 mirrorball_changeSeen(vec2 shares, vec3 d, vec3 startChange, vec3 directionChange)
{
    return mirrorball_mapFromWorld *
           (shares.x * startChange + shares.y * (directionChange - dot(directionChange, d) * d));
}

vec4 mirrorball_lookUpGradient(vec3 positionInWorld, vec3 directionInWorld, vec3 positionAlongX, vec3 positionAlongY,
                               vec3 directionAlongX, vec3 directionAlongY)
{
    vec4 shown = mirrorball_shown(positionInWorld, directionInWorld);
    vec3 v = normalize(mirrorball_regularDirection(shown.xyz));
#if MIRRORBALL_LAYERED
    if (shown.w > 0.5)
        return textureLod(mirrorball_hiddenColourMap, mirrorball_coordinateFromDirection(v), 0.0);
#endif
    float size = length(directionInWorld);
    vec3 d = directionInWorld / size;
    vec2 shares = mirrorball_shares(positionInWorld - mirrorball_centreInWorld, d, v * mirrorball_mapFromWorld);
    return mirrorball_colourOver(v, mirrorball_changeSeen(shares, d, positionAlongX, directionAlongX / size),
                                 mirrorball_changeSeen(shares, d, positionAlongY, directionAlongY / size));
}

vec4 mirrorball_lookUp(vec3 positionInWorld, vec3 directionInWorld)
{
    return mirrorball_lookUpGradient(positionInWorld, directionInWorld, dFdx(positionInWorld), dFdy(positionInWorld),
                                     dFdx(directionInWorld), dFdy(directionInWorld));
}
#else
vec4 mirrorball_lookUp(vec3 positionInWorld, vec3 directionInWorld)
{
    vec4 shown = mirrorball_shown(positionInWorld, directionInWorld);
    vec3 coordinate = mirrorball_coordinateFromDirection(shown.xyz);
#if MIRRORBALL_LAYERED
    if (shown.w > 0.5)
        return textureLod(mirrorball_hiddenColourMap, coordinate, 0.0);
#endif
    vec2 uv = mirrorball_withinSurface(coordinate);
    return textureLod(mirrorball_colourMap, mirrorball_textureCoordinate(int(coordinate.z), uv), 0.0);
}
#endif

