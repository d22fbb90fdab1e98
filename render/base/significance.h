#pragma once
/// Tests for significance: p-values of normal, chi-square and Student's t statistics, and the threshold for many
/// comparisons.

namespace pdr {

/// Returns the upper regularised incomplete gamma function Q(a, x), a > 0, by series or continued fraction (Lentz's
/// method).
double gammaQ(double a, double x);

/// Returns the probability that chi-square with `freedom` degrees of freedom exceeds `value`.
double chiSquareP(double value, double freedom);

/// Returns the two-sided probability that a standard normal number lies farther from 0 than z.
double normalP(double z);

/// Returns the |z| that a standard normal number exceeds, to either side, with probability p in (0, 1]: the inverse of
/// normalP.
double normalZ(double p);

/// Returns the two-sided probability that Student's t with `freedom` >= 1 degrees of freedom lies farther from 0 than
/// t. Abramowitz & Stegun, 26.7.3 and 26.7.4.
double studentP(double t, int freedom);

/// Returns the |t| that Student's t exceeds, to either side, with probability p in [1e-6, 1]: the inverse of studentP.
double studentT(double p, int freedom);

/// Returns the |z| that at least one of `comparisons` independent true hypotheses exceeds with probability `alarmRate`
/// (Sidak).
double allowedZ(int comparisons, double alarmRate = 1e-4);

}  // namespace pdr
