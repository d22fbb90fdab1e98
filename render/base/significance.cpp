#include "render/base/significance.h"

#include <cmath>
#include <numbers>

namespace pdr {

double gammaQ(double a, double x) {
    if (x <= 0)
        return 1;
    const double front = std::exp(-x + a * std::log(x) - std::lgamma(a));
    if (x < a + 1) {
        double term = 1 / a, sum = term;
        for (double n = a + 1; std::fabs(term) > sum * 1e-15; ++n)
            sum += term *= x / n;
        return 1 - front * sum;
    }
    double b = x + 1 - a, c = 1e300, d = 1 / b, h = d;
    for (int i = 1; i < 10000; ++i) {
        const double an = -i * (i - a);
        b += 2;
        d = 1 / (an * d + b);
        c = b + an / c;
        h *= d * c;
        if (std::fabs(d * c - 1) < 1e-15)
            break;
    }
    return front * h;
}

double chiSquareP(double value, double freedom) {
    return gammaQ(freedom / 2, value / 2);
}

double normalP(double z) {
    return std::erfc(std::fabs(z) / std::sqrt(2.0));
}

double normalZ(double p) {
    double low = 0, high = 40;
    for (int i = 0; i < 100; ++i) {
        const double middle = (low + high) / 2;
        (normalP(middle) > p ? low : high) = middle;
    }
    return high;
}

double studentP(double t, int freedom) {
    const double angle = std::atan(std::fabs(t) / std::sqrt(double(freedom)));
    const double cosine = std::cos(angle), sine = std::sin(angle);
    const bool odd = freedom % 2 == 1;
    double term = odd ? cosine : 1, sum = 0;
    for (int k = odd ? 3 : 2; k <= freedom; k += 2) {
        sum += term;
        term *= cosine * cosine * (k - 1) / k;
    }
    return 1 - (odd ? (angle + sine * sum) * 2 / std::numbers::pi : sine * sum);
}

double studentT(double p, int freedom) {
    double low = 0, high = 1e8;
    for (int i = 0; i < 100; ++i) {
        const double middle = (low + high) / 2;
        (studentP(middle, freedom) > p ? low : high) = middle;
    }
    return high;
}

double allowedZ(int comparisons, double alarmRate) {
    return normalZ(-std::expm1(std::log1p(-alarmRate) / comparisons));
}

}  // namespace pdr
