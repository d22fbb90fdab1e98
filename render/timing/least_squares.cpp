#include "render/timing/least_squares.h"

#include <algorithm>
#include <cmath>

namespace pdr {

namespace {

using Row = std::array<double, kMostUnknowns>;
using Matrix = std::array<Row, kMostUnknowns>;

constexpr double kSmallestPivot = 1e-12;  ///< for columns of length 1: below it a column depends on the others

/// Inverts the symmetric leading part of `matrix` by Gauss-Jordan; false where it is singular.
bool invert(Matrix& matrix, int size) {
    for (int k = 0; k < size; ++k) {
        const double pivot = matrix[k][k];
        if (!(pivot > kSmallestPivot))
            return false;
        matrix[k][k] = 1;
        for (int j = 0; j < size; ++j)
            matrix[k][j] /= pivot;
        for (int i = 0; i < size; ++i) {
            if (i == k)
                continue;
            const double factor = matrix[i][k];
            matrix[i][k] = 0;
            for (int j = 0; j < size; ++j)
                matrix[i][j] -= factor * matrix[k][j];
        }
    }
    return true;
}

/// Returns the lengths of the weighted columns, for scaling: unknowns differ by many powers of ten.
Row columnLengths(const std::vector<Equation>& equations) {
    Row lengths{};
    for (const Equation& equation : equations)
        for (int k = 0; k < kMostUnknowns; ++k)
            lengths[k] = std::hypot(lengths[k], equation.weight * equation.factors[k]);
    return lengths;
}

double squaresOf(const std::vector<Equation>& equations, const Row& unknowns) {
    double squares = 0;
    for (const Equation& equation : equations) {
        double residual = equation.value;
        for (int k = 0; k < kMostUnknowns; ++k)
            residual -= equation.factors[k] * unknowns[k];
        squares += equation.weight * residual * equation.weight * residual;
    }
    return squares;
}

}  // namespace

std::optional<Solution> leastSquares(const std::vector<Equation>& equations, unsigned used) {
    const Row lengths = columnLengths(equations);
    // Choose the columns of the used unknowns
    std::array<int, kMostUnknowns> column{};
    int size = 0;
    for (int k = 0; k < kMostUnknowns; ++k)
        if (used >> k & 1)
            column[size++] = k;
    // Build the normal equations of the scaled columns
    Matrix normal{};
    Row right{};
    for (const Equation& equation : equations)
        for (int i = 0; i < size; ++i) {
            const double factor = equation.weight * equation.factors[column[i]] / lengths[column[i]];
            right[i] += factor * equation.weight * equation.value;
            for (int j = 0; j < size; ++j)
                normal[i][j] += factor * equation.weight * equation.factors[column[j]] / lengths[column[j]];
        }
    if (!invert(normal, size))
        return std::nullopt;
    // Undo the scaling
    Solution solution;
    for (int i = 0; i < size; ++i)
        for (int j = 0; j < size; ++j) {
            solution.unknowns[column[i]] += normal[i][j] * right[j] / lengths[column[i]];
            solution.covariance[column[i]][column[j]] = normal[i][j] / (lengths[column[i]] * lengths[column[j]]);
        }
    solution.squares = squaresOf(equations, solution.unknowns);
    return solution;
}

std::optional<Solution> nonNegativeLeastSquares(const std::vector<Equation>& equations, unsigned used) {
    std::optional<Solution> best;
    for (unsigned subset = 1; subset <= used; ++subset) {
        if ((subset & ~used) != 0)
            continue;
        const std::optional<Solution> found = leastSquares(equations, subset);
        if (found && std::ranges::all_of(found->unknowns, [](double value) { return value >= 0; }) &&
            (!best || found->squares < best->squares))
            best = found;
    }
    return best;
}

}  // namespace pdr
