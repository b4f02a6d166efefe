// CASE 0 compiles; every other case must not: a formula that branches in C++ would be decided once, while it
// is recorded or for one end of an interval, and never reach the shader.
#include <mirrorball/math/glsl_scalar.h>
#include <mirrorball/math/interval.h>

using mirrorball::GlslIndex;
using mirrorball::GlslScalar;
using mirrorball::IndexSet;
using mirrorball::Interval;

GlslScalar smaller(const GlslScalar& a, const GlslScalar& b)
{
#if CASE == 1
    if (a < b)
        return a;
#elif CASE == 2
    return a < b ? a : b;
#elif CASE == 3
    while (a < b)
        return a;
#elif CASE == 4
    const bool decided = static_cast<bool>(a < b);
    static_cast<void>(decided);
#elif CASE == 5
    const GlslScalar number = 1.0; // only GlslScalar(1.0) is a number
#elif CASE == 6
    return a + 1.0;
#endif
    return select(a < b, a, b);
}

Interval smaller(const Interval& a, const Interval& b)
{
#if CASE == 7
    if (a < b)
        return a;
#elif CASE == 8
    return a < b ? a : b;
#elif CASE == 9
    return a + 1.0;
#endif
    return select(a < b, a, b);
}

GlslScalar ofComponent(const GlslIndex& component, const GlslScalar& a, const GlslScalar& b)
{
#if CASE == 10
    if (component == 0)
        return a;
#elif CASE == 11
    const int number = component;
    static_cast<void>(number);
#endif
    return select(component == 0, a, b);
}

Interval ofComponent(const IndexSet& component, const Interval& a, const Interval& b)
{
#if CASE == 12
    if (component == 0)
        return a;
#endif
    return select(component == 0, a, b);
}
