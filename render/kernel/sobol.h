#pragma once
/// Owen-scrambled Sobol points. Each coordinate of each point alone is as random as an independent number, but together
/// the points are so even that the mean of a smooth function over n of them has an error below 1 / sqrt(n).
///   matrices     Joe & Kuo 2008 (new-joe-kuo-6), the first kSobolDimensions dimensions
///   scrambling   nested uniform (Owen 1995), by hashing (Laine & Karras 2011; constants: Vegdahl 2021)
/// Coordinates are 32-bit fractions: k stands for (k + 1/2) 2^-32.

#include <cstdint>

#include "render/base/portable.h"

namespace pdr {

inline constexpr int kSobolDimensions = 18;

/// Look-up table of the points, by four bits of a point's number at a time: a coordinate is the exclusive or of as many
/// entries as the number has hexadecimal digits.
struct SobolTable {
    static constexpr int kDigits = 8;
    std::uint32_t of[kSobolDimensions][kDigits][16];
};

namespace sobol {

/// Recurrence of a dimension: a primitive polynomial over GF(2), given by its degree and its inner coefficients, and
/// the first columns of the matrix.
struct Recurrence {
    int degree;
    std::uint32_t coefficients, first[6];
};
/// Recurrences of all dimensions except the first, which is van der Corput's.
inline constexpr Recurrence kRecurrences[kSobolDimensions - 1] = {
    {1, 0, {1}},
    {2, 1, {1, 3}},
    {3, 1, {1, 3, 1}},
    {3, 2, {1, 1, 1}},
    {4, 1, {1, 1, 3, 3}},
    {4, 4, {1, 3, 5, 13}},
    {5, 2, {1, 1, 5, 5, 17}},
    {5, 4, {1, 1, 5, 5, 5}},
    {5, 7, {1, 1, 7, 11, 19}},
    {5, 11, {1, 1, 5, 1, 1}},
    {5, 13, {1, 1, 1, 3, 11}},
    {5, 14, {1, 3, 5, 5, 31}},
    {6, 1, {1, 3, 3, 9, 7, 49}},
    {6, 13, {1, 1, 1, 15, 21, 21}},
    {6, 16, {1, 3, 1, 13, 27, 49}},
    {6, 19, {1, 1, 1, 15, 7, 5}},
    {6, 22, {1, 3, 1, 15, 13, 25}},
};

/// The matrix of a dimension: column `bit` is what that bit of a point's number adds (exclusive or) to its coordinate.
struct Columns {
    std::uint32_t of[32];
};
constexpr Columns columns(int dimension) {
    Columns columns{};
    for (int bit = 0; bit < 32; ++bit) {
        std::uint32_t& column = columns.of[bit];
        if (dimension == 0) {
            column = 0x80000000u >> bit;
            continue;
        }
        const Recurrence& r = kRecurrences[dimension - 1];
        if (bit < r.degree) {
            column = r.first[bit] << (31 - bit);
            continue;
        }
        column = columns.of[bit - r.degree] ^ (columns.of[bit - r.degree] >> r.degree);
        for (int i = 1; i < r.degree; ++i)
            if ((r.coefficients >> (r.degree - 1 - i) & 1) != 0)
                column ^= columns.of[bit - i];
    }
    return columns;
}

constexpr SobolTable table() {
    SobolTable table{};
    for (int dimension = 0; dimension < kSobolDimensions; ++dimension) {
        const Columns matrix = columns(dimension);
        for (int digit = 0; digit < SobolTable::kDigits; ++digit)
            for (int value = 0; value < 16; ++value)
                for (int bit = 0; bit < 4; ++bit)
                    if ((value >> bit & 1) != 0)
                        table.of[dimension][digit][value] ^= matrix.of[4 * digit + bit];
    }
    return table;
}

}  // namespace sobol

inline constexpr SobolTable kSobolTable = sobol::table();

PDR_HD inline std::uint32_t sobolCoordinate(const SobolTable& table, int dimension, std::uint32_t point) {
    std::uint32_t coordinate = 0;
    for (int digit = 0; point != 0; ++digit, point >>= 4)
        coordinate ^= table.of[dimension][digit][point & 15];
    return coordinate;
}

PDR_HD inline std::uint32_t reversedBits(std::uint32_t x) {
    x = (x >> 16) | (x << 16);
    x = ((x & 0x00FF00FFu) << 8) | ((x >> 8) & 0x00FF00FFu);
    x = ((x & 0x0F0F0F0Fu) << 4) | ((x >> 4) & 0x0F0F0F0Fu);
    x = ((x & 0x33333333u) << 2) | ((x >> 2) & 0x33333333u);
    return ((x & 0x55555555u) << 1) | ((x >> 1) & 0x55555555u);
}

/// Permutes the fractions, differently for each `seed`. Every interval [k 2^-m, (k + 1) 2^-m) is mapped onto an
/// interval of this form.
PDR_HD inline std::uint32_t owenScrambled(std::uint32_t fraction, std::uint32_t seed) {
    std::uint32_t x = reversedBits(fraction);
    x ^= x * 0x3D20ADEAu;
    x += seed;
    x *= (seed >> 16) | 1;
    x ^= x * 0x05526C56u;
    x ^= x * 0x53A22864u;
    return reversedBits(x);
}

}  // namespace pdr
