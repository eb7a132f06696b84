// Integrals by adaptive Gauss-Kronrod quadrature (7 and 15 points, nodes and weights of QUADPACK) in long
// double: what closed forms are checked against.
#pragma once

#include <array>
#include <cmath>
#include <functional>

namespace driftbench::test {

using Integrand = std::function<long double(long double)>;

struct KronrodEstimate
{
    long double value;
    long double error;
};

inline KronrodEstimate kronrod(const Integrand &f, long double from, long double to)
{
    static constexpr std::array<long double, 8> kNodes{
        0.991455371120812639206854697526329L, 0.949107912342758524526189684047851L,
        0.864864423359769072789712788640926L, 0.741531185599394439863864773280788L,
        0.586087235467691130294144691258450L, 0.405845151377397166906606412076961L,
        0.207784955007898467600689403773245L, 0.0L};
    static constexpr std::array<long double, 8> kKronrodWeights{
        0.022935322010529224963732008058970L, 0.063092092629978553290700663189204L,
        0.104790010322250183839876322541518L, 0.140653259715525918745189590510238L,
        0.169004726639267902826583426598550L, 0.190350578064785409913256402421014L,
        0.204432940075298892414161999234649L, 0.209482141084727828012999174891714L};
    static constexpr std::array<long double, 4> kGaussWeights{
        0.129484966168869693270611432679082L, 0.279705391489276667901467771423780L,
        0.381830050505118944950369775488975L, 0.417959183673469387755102040816327L};
    const long double middle = (from + to) / 2;
    const long double half = (to - from) / 2;
    long double fine = f(middle) * kKronrodWeights[7];
    long double coarse = f(middle) * kGaussWeights[3];
    for (std::size_t i = 0; i < 7; ++i) {
        const long double both = f(middle - half * kNodes[i]) + f(middle + half * kNodes[i]);
        fine += both * kKronrodWeights[i];
        if (i % 2 == 1)
            coarse += both * kGaussWeights[i / 2];
    }
    return {fine * half, std::abs(fine - coarse) * half};
}

// To a relative error of about 1e-17 of an integrand of one sign; depth bounds the halvings.
inline long double integrate(const Integrand &f, long double from, long double to, int depth = 40)
{
    const KronrodEstimate whole = kronrod(f, from, to);
    // The 15 points are far better than their distance to the 7 says: its square root in digits.
    if (depth == 0 || whole.error <= 1e-11L * std::abs(whole.value))
        return whole.value;
    const long double middle = (from + to) / 2;
    return integrate(f, from, middle, depth - 1) + integrate(f, middle, to, depth - 1);
}

} // namespace driftbench::test
