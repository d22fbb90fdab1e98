#pragma once
/// Gauss-Legendre quadrature on [0, 1].

#include <cmath>
#include <vector>

namespace pdr::test {

struct QuadraturePoint {
    double at, weight;
};

/// Exact for polynomials up to degree 2 n - 1. Roots by Newton's method.
inline std::vector<QuadraturePoint> gaussLegendre(int n) {
    std::vector<QuadraturePoint> points;
    for (int i = 0; i < n; ++i) {
        double x = std::cos(M_PI * (i + 0.75) / (n + 0.5)), slope = 0;
        for (int round = 0; round < 50; ++round) {
            double before = 1, here = x;
            for (int k = 2; k <= n; ++k) {
                const double next = ((2 * k - 1) * x * here - (k - 1) * before) / k;
                before = here;
                here = next;
            }
            slope = n * (x * here - before) / (x * x - 1);
            x -= here / slope;
        }
        points.push_back({(1 - x) / 2, 1 / ((1 - x * x) * slope * slope)});
    }
    return points;
}

}  // namespace pdr::test
