// Numbers of 1280 bits through MPFR: what the maps are judged by. Enough for the square of 1e-75 beside 1, to
// double.
#pragma once

#include <mpfr.h>

#include <utility>

namespace tests {

class Exact
{
public:
    Exact(double number = 0)
    {
        mpfr_init2(value_, bits);
        mpfr_set_d(value_, number, MPFR_RNDN);
    }
    Exact(const Exact& other) : Exact() { mpfr_set(value_, other.value_, MPFR_RNDN); }
    Exact& operator=(const Exact& other)
    {
        mpfr_set(value_, other.value_, MPFR_RNDN);
        return *this;
    }
    ~Exact() { mpfr_clear(value_); }

    static Exact pi()
    {
        Exact result;
        mpfr_const_pi(result.value_, MPFR_RNDN);
        return result;
    }

    double rounded() const { return mpfr_get_d(value_, MPFR_RNDN); }

    friend Exact operator+(const Exact& a, const Exact& b) { return of(mpfr_add, a, b); }
    friend Exact operator-(const Exact& a, const Exact& b) { return of(mpfr_sub, a, b); }
    friend Exact operator*(const Exact& a, const Exact& b) { return of(mpfr_mul, a, b); }
    friend Exact operator/(const Exact& a, const Exact& b) { return of(mpfr_div, a, b); }
    friend Exact operator-(const Exact& a) { return of(mpfr_neg, a); }
    friend bool operator<(const Exact& a, const Exact& b) { return mpfr_less_p(a.value_, b.value_) != 0; }
    friend bool operator<=(const Exact& a, const Exact& b)
    {
        return mpfr_lessequal_p(a.value_, b.value_) != 0;
    }
    friend bool operator>(const Exact& a, const Exact& b) { return b < a; }
    friend bool operator>=(const Exact& a, const Exact& b) { return b <= a; }

    friend Exact sqrt(const Exact& a) { return of(mpfr_sqrt, a); }
    friend Exact abs(const Exact& a) { return of(mpfr_abs, a); }
    friend Exact asin(const Exact& a) { return of(mpfr_asin, a); }
    friend Exact atan(const Exact& a) { return of(mpfr_atan, a); }
    friend Exact sin(const Exact& a) { return of(mpfr_sin, a); }
    friend Exact atan2(const Exact& y, const Exact& x) { return of(mpfr_atan2, y, x); }

private:
    static constexpr mpfr_prec_t bits = 1280;

    using OneArgument = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);
    using TwoArguments = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);
    static Exact of(OneArgument function, const Exact& a)
    {
        Exact result;
        function(result.value_, a.value_, MPFR_RNDN);
        return result;
    }
    static Exact of(TwoArguments function, const Exact& a, const Exact& b)
    {
        Exact result;
        function(result.value_, a.value_, b.value_, MPFR_RNDN);
        return result;
    }

    mpfr_t value_;
};

} // namespace tests
