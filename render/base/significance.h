#pragma once
/// What chance alone may do: p-values of normal and chi-square statistics, and the threshold for many comparisons.

namespace pdr {

/// Upper regularised incomplete gamma function Q(a, x), a > 0, by series or continued fraction (Lentz's method).
double gammaQ(double a, double x);

/// Probability that chi-square with `freedom` degrees of freedom exceeds `value`.
double chiSquareP(double value, double freedom);

/// Two-sided probability that a standard normal number lies farther from 0 than z.
double normalP(double z);

/// |z| that a standard normal number exceeds, to either side, with probability p in (0, 1]: the inverse of normalP.
double normalZ(double p);

/// Two-sided probability that Student's t with `freedom` >= 1 degrees of freedom lies farther from 0 than t.
/// Abramowitz & Stegun, 26.7.3 and 26.7.4.
double studentP(double t, int freedom);

/// |t| that Student's t exceeds, to either side, with probability p in [1e-6, 1]: the inverse of studentP.
double studentT(double p, int freedom);

/// |z| that one of `comparisons` independent truths exceeds with probability `alarmRate` in all (Sidak).
double allowedZ(int comparisons, double alarmRate = 1e-4);

}  // namespace pdr
