#pragma once
/// What a random result may be: p-values and thresholds. Every test that draws numbers states its false-alarm rate.

#include <cmath>
#include <limits>
#include <span>
#include <vector>

namespace pdr::test {

/// Upper regularised incomplete gamma function Q(a, x), by series or continued fraction.
inline double gammaQ(double a, double x) {
    if (x <= 0)
        return 1;
    const double front = std::exp(-x + a * std::log(x) - std::lgamma(a));
    if (x < a + 1) {
        double term = 1 / a, sum = term;
        for (double n = a + 1; std::fabs(term) > sum * 1e-15; ++n)
            sum += term *= x / n;
        return 1 - front * sum;
    }
    double b = x + 1 - a, c = 1e300, d = 1 / b, h = d;  // Lentz's method
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

/// Probability that chi-square with `freedom` degrees exceeds `value`.
inline double chiSquareP(double value, double freedom) {
    return gammaQ(freedom / 2, value / 2);
}

/// p of counts against equal expectation.
inline double uniformP(std::span<const double> counts) {
    double total = 0, square = 0;
    for (double count : counts)
        total += count;
    const double expected = total / double(counts.size());
    for (double count : counts)
        square += (count - expected) * (count - expected) / expected;
    return chiSquareP(square, double(counts.size()) - 1);
}

/// Two-sided p of a standard normal z.
inline double normalP(double z) {
    return std::erfc(std::fabs(z) / std::sqrt(2.0));
}

/// Mean, and its standard error, of numbers added one by one (Welford).
class Sample {
  public:
    void add(double value) {
        ++count_;
        const double delta = value - mean_;
        mean_ += delta / count_;
        m2_ += delta * (value - mean_);
    }
    double mean() const { return mean_; }
    double variance() const { return m2_ / (count_ - 1); }
    double standardError() const { return std::sqrt(variance() / count_); }
    /// Distance from `truth` in standard errors.
    double z(double truth) const { return (mean_ - truth) / standardError(); }

  private:
    double count_ = 0, mean_ = 0, m2_ = 0;
};

/// |z| that one of `comparisons` independent truths exceeds with probability 1e-4 in all (Sidak), by bisection.
inline double allowedZ(int comparisons, double alarmRate = 1e-4) {
    const double single = -std::expm1(std::log1p(-alarmRate) / comparisons);
    double low = 0, high = 40;
    for (int i = 0; i < 100; ++i) {
        const double middle = (low + high) / 2;
        (normalP(middle) > single ? low : high) = middle;
    }
    return high;
}

}  // namespace pdr::test
